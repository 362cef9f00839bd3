//! The functions of [`Real`](crate::Real) written out in arithmetic, so that a program without this library has their bits.
//!
//! Logarithm, sine, cosine, inverse cosine and hyperbolic tangent are those of FreeBSD's msun, as the crate `libm` has them, without branches:
//!
//! Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunPro, a Sun Microsystems, Inc. business. Permission to use,
//! copy, modify, and distribute this software is freely granted, provided that this notice is preserved.

use super::bits::{Bits, ROUND};
use super::exponential;
use crate::piecewise;

mod circular;

pub use circular::{LARGEST_ANGLE, cos, sin};

/// `c[0] + x (c[1] + x (c[2] + ...))`.
fn polynomial<R: Bits, const N: usize>(x: R, coefficients: [f64; N]) -> R {
    let last = R::lit(coefficients[N - 1]);
    coefficients[..N - 1].iter().rev().fold(last, |sum, coefficient| R::lit(*coefficient) + x * sum)
}

/// Two to the power of a whole number.
fn power_of_two<R: Bits>(whole: R) -> R {
    (whole + R::lit(ROUND)).power_of_two()
}

/// Exponential function.
pub fn exp<R: Bits>(x: R) -> R {
    exponential::exp(x)
}

/// `ln 2` in two parts, of which the first ends in zeros.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// Natural logarithm.
pub fn ln<R: Bits>(x: R) -> R {
    let (zero, one) = (R::zero(), R::one());
    // Far below one, so that a number that is not normal becomes normal.
    let small = x.lt(R::lit(f64::MIN_POSITIVE * 18_014_398_509_481_984.0)); // 2^54
    let scaled = R::select(small, x * R::lit(18_014_398_509_481_984.0), x);
    let exponent = scaled.exponent();
    // In two factors: two to the power of minus the largest exponent is not a normal number.
    let mantissa = R::lit(0.5) * scaled * power_of_two(one - exponent);
    // The first twenty bits decide which side of the square root of two it is on.
    let upper = mantissa.ge(R::lit(1.414_213_180_541_992_2));
    let k = R::select(upper, exponent + one, exponent);
    let k = R::select(small, k - R::lit(54.0), k);
    let f = R::select(upper, R::lit(0.5) * mantissa, mantissa) - one;
    let half_square = R::lit(0.5) * f * f;
    let s = f / (R::lit(2.0) + f);
    let z = s * s;
    let w = z * z;
    let t_1 = w * polynomial(w, [3.999_999_999_940_942e-1, 2.222_219_843_214_978_4e-1, 1.531_383_769_920_937_3e-1]);
    let t_2 = z * polynomial(
        w,
        [6.666_666_666_666_735e-1, 2.857_142_874_366_239e-1, 1.818_357_216_161_805e-1, 1.479_819_860_511_658_6e-1],
    );
    let value = s * (half_square + (t_2 + t_1)) + k * R::lit(LN_2[1]) - half_square + f + k * R::lit(LN_2[0]);
    let cases =
        [(x.lt(zero), R::lit(f64::NAN)), (x.le(zero), R::lit(f64::NEG_INFINITY)), (x.lt(R::lit(f64::INFINITY)), value)];
    piecewise(cases, x)
}

const HALF_PI: [f64; 2] = [std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17];

/// The angle, from zero to pi, with this cosine.
pub fn acos<R: Bits>(x: R) -> R {
    let (zero, one, two, half) = (R::zero(), R::one(), R::lit(2.0), R::lit(0.5));
    let [pi_high, pi_low] = HALF_PI.map(R::lit);
    let ratio = |z: R| {
        let p = z * polynomial(
            z,
            [
                1.666_666_666_666_666_6e-1,
                -3.255_658_186_224_009e-1,
                2.012_125_321_348_629_3e-1,
                -4.005_553_450_067_941e-2,
                7.915_349_942_898_145e-4,
                3.479_331_075_960_212e-5,
            ],
        );
        let q = polynomial(
            z,
            [1.0, -2.403_394_911_734_414, 2.020_945_760_233_505_7, -6.882_839_716_054_533e-1, 7.703_815_055_590_194e-2],
        );
        p / q
    };
    let middle = pi_high - (x - (pi_low - x * ratio(x * x)));
    let z = (one + x) * half;
    let s = z.sqrt();
    let left = two * (pi_high - (s + (ratio(z) * s - pi_low)));
    let z = (one - x) * half;
    let s = z.sqrt();
    // The root with its first twenty bits alone, whose square is exact.
    let unit = power_of_two(s.exponent() - R::lit(20.0));
    let head = (s / unit).floor() * unit;
    let tail = (z - head * head) / (s + head);
    let right = two * (head + (ratio(z) * s + tail));
    let size = x.abs();
    let cases = [
        (size.lt(R::lit(6.938_900_521_352_129e-18)), pi_high),
        (size.lt(half), middle),
        (size.lt(one) & x.lt(zero), left),
        (size.lt(one), right),
        (x.le(-one) & x.ge(-one), R::pi()),
        (x.le(one) & x.ge(one), zero),
    ];
    piecewise(cases, R::lit(f64::NAN))
}

/// Hyperbolic tangent.
pub fn tanh<R: Bits>(x: R) -> R {
    let (one, two) = (R::one(), R::lit(2.0));
    let size = x.abs();
    let up = exp_minus_one(two * size);
    let down = exp_minus_one(-two * size);
    let cases = [
        (size.ge(R::lit(20.000_015_258_789_062)), one),
        (size.ge(R::lit(0.549_306_392_669_677_7)), one - two / (up + two)),
        (size.ge(R::lit(0.255_412_817_001_342_8)), up / (up + two)),
        (size.ge(R::lit(f64::MIN_POSITIVE)), -down / (down + two)),
    ];
    let value = piecewise(cases, size);
    R::select(x.lt(R::zero()), -value, value)
}

/// `e` to the power of `x` minus one, for `x` from -1 to 41.
fn exp_minus_one<R: Bits>(x: R) -> R {
    let (zero, one, two, half) = (R::zero(), R::one(), R::lit(2.0), R::lit(0.5));
    let size = x.abs();
    let whole = (R::lit(std::f64::consts::LOG2_E) * x + half).floor();
    let nearest = R::select(x.lt(zero), -one, one);
    let k = piecewise(
        [(size.lt(R::lit(0.346_573_591_232_299_8)), zero), (size.lt(R::lit(1.039_720_535_278_320_3)), nearest)],
        whole,
    );
    let (high, low) = (x - k * R::lit(LN_2[0]), k * R::lit(LN_2[1]));
    let y = high - low;
    let c = (high - y) - low;
    let half_y = half * y;
    let half_square = y * half_y;
    let r = polynomial(
        half_square,
        [
            1.0,
            -3.333_333_333_333_313e-2,
            1.587_301_587_254_814_6e-3,
            -7.936_507_578_674_88e-5,
            4.008_217_827_329_362e-6,
            -2.010_992_181_836_243_7e-7,
        ],
    );
    let t = R::lit(3.0) - r * half_y;
    let e = half_square * ((r - t) / (R::lit(6.0) - y * t));
    let unscaled = y - (y * e - half_square);
    let e = y * (e - c) - c - half_square;
    let (power, inverse) = (power_of_two(k), power_of_two(-k));
    let doubled = R::select(y.lt(R::lit(-0.25)), -two * (e - (y + half)), one + two * (y - e));
    let cases = [
        (size.lt(R::lit(5.551_115_123_125_783e-17)), x),
        (k.lt(zero), half * (y - e) - half),
        (k.lt(one), unscaled),
        (k.lt(two), doubled),
        (k.lt(R::lit(20.0)), (y - e + (one - inverse)) * power),
        (k.le(R::lit(56.0)), (y - (e + inverse) + one) * power),
    ];
    piecewise(cases, (y - e + one) * power - one)
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Real;
    use proptest::prelude::*;

    fn same(x: f64, ours: fn(f64) -> f64, library: fn(f64) -> f64) -> Result<(), TestCaseError> {
        let (ours, library) = (ours(x), library(x));
        prop_assert!(
            ours.to_bits() == library.to_bits() || ours.is_nan() && library.is_nan(),
            "{x:?}: {ours:?} {library:?}"
        );
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn logarithms_have_the_bits_of_the_library(x in any::<f64>(), y in 0.5..2.0f64) {
            same(x, ln, Real::ln)?;
            same(y, ln, Real::ln)?;
        }

        #[test]
        fn angles_have_the_bits_of_the_library(x in any::<f64>(), y in -1.0..=1.0f64) {
            same(x, acos, Real::acos)?;
            same(y, acos, Real::acos)?;
        }

        #[test]
        fn hyperbolic_tangents_have_the_bits_of_the_library(x in any::<f64>(), y in -25.0..25.0f64, z in -1.0..1.0f64) {
            same(x, tanh, Real::tanh)?;
            same(y, tanh, Real::tanh)?;
            same(z, tanh, Real::tanh)?;
        }

        #[test]
        fn sines_and_cosines_have_the_bits_of_the_library(x in any::<f64>(), y in -10.0..10.0f64, z in -LARGEST_ANGLE..LARGEST_ANGLE, n in -200_000..200_000i32, ulps in -3..4i64) {
            let multiple = f64::from_bits((f64::from(n) * std::f64::consts::FRAC_PI_4).to_bits().wrapping_add_signed(ulps));
            for x in [x, y, z, multiple].into_iter().filter(|x| x.is_nan() || x.abs() < LARGEST_ANGLE) {
                same(x, sin, Real::sin)?;
                same(x, cos, Real::cos)?;
            }
        }
    }

    #[test]
    #[expect(clippy::approx_constant, reason = "the borders of the library are near these constants, not at them")]
    fn ends_and_borders_have_the_bits_of_the_library() {
        let borders = [
            0.0,
            0.255_412_817,
            0.346_573_591,
            0.5,
            0.549_306_392,
            0.785_398_48,
            1.0,
            1.414_213_2,
            1.570_796_3,
            3.141_592,
            4.712_39,
            6.283_18,
            7.07,
            20.0,
            1e-18,
            5e-324,
            1e-310,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ];
        for x in borders.into_iter().flat_map(|x: f64| [x, -x, x.next_up(), -x.next_down()]) {
            for (ours, library) in
                [(ln as fn(f64) -> f64, Real::ln as fn(f64) -> f64), (acos, Real::acos), (tanh, Real::tanh)]
            {
                same(x, ours, library).unwrap();
            }
            if x.abs() < LARGEST_ANGLE {
                same(x, sin, Real::sin).unwrap();
                same(x, cos, Real::cos).unwrap();
            }
        }
    }
}
