//! The numerical vocabulary of every equation, on one page.
//!
//! An equation is written once over [`Real`]. The number type determines the meaning of its evaluation:
//! `f64` gives its value, [`Lanes`](crate::numbers::Lanes) eight values at once, and the checking numbers its
//! derivative, its dimension, its exact value or its bounds.
//!
//! A kernel never branches on a number: it compares to a mask and selects. [`piecewise`] reads like the cases of a paper.

use num_traits::{One, Zero};
use std::fmt::Debug;
use std::ops::{BitAnd, BitOr, Div, Neg, Not, Sub};

/// A number that equations can be evaluated with.
///
/// Addition and multiplication come from `num-traits` with their neutral elements; all other functions are here.
/// Transcendental functions come from one pinned pure-Rust implementation, so that the bits do not depend on the platform.
pub trait Real:
    Copy + Debug + Zero + One + Sub<Output = Self> + Div<Output = Self> + Neg<Output = Self> + Send + Sync + 'static
{
    /// The truth of a comparison: one `bool` per value the number holds.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// A dimensionless literal of the formula, exact.
    fn lit(value: f64) -> Self;
    /// The ratio of a circle's circumference to its diameter.
    fn pi() -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Exponential.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// The angle in radians, from zero to pi, with this cosine.
    fn acos(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Largest integer not above the number.
    fn floor(self) -> Self;

    /// The entry of a list at a place, a whole number below its length, which is a power of two.
    fn entry(list: &[f64], place: Self) -> Self;
    /// The numbers at such a place of a list of several numbers each.
    fn entries<const N: usize>(list: &[[f64; N]], place: Self) -> [Self; N] {
        let column = |k: usize| list.iter().map(|numbers| numbers[k]).collect::<Vec<_>>();
        std::array::from_fn(|k| Self::entry(&column(k), place))
    }

    /// `self < other`; false for a NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`; false for a NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `self > other`; false for a NaN.
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// `self >= other`; false for a NaN.
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
    /// The same truth for every value: which reading of a law is asked for.
    fn always(truth: bool) -> Self::Mask {
        Self::lit(f64::from(u8::from(truth))).gt(Self::zero())
    }
    /// `yes` where the mask is true, `no` elsewhere; both have been evaluated.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Absolute value.
    fn abs(self) -> Self {
        Self::select(self.lt(Self::zero()), -self, self)
    }
    /// The smaller of two numbers.
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// The larger of two numbers.
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }
    /// The number times itself.
    fn squared(self) -> Self {
        self * self
    }
}

/// The value of the first case whose condition holds, or `otherwise`.
#[inline(always)]
pub fn piecewise<R: Real, const N: usize>(cases: [(R::Mask, R); N], otherwise: R) -> R {
    let mut value = otherwise;
    for (condition, case) in cases.into_iter().rev() {
        value = R::select(condition, case, value);
    }
    value
}

macro_rules! native {
    ($float:ty, $suffix:ident) => {
        impl Real for $float {
            type Mask = bool;
            #[inline(always)]
            fn lit(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn pi() -> Self {
                std::f64::consts::PI as $float
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                $suffix::exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                $suffix::log(self)
            }
            #[inline]
            fn sin(self) -> Self {
                $suffix::sin(self)
            }
            #[inline]
            fn cos(self) -> Self {
                $suffix::cos(self)
            }
            #[inline]
            fn acos(self) -> Self {
                $suffix::acos(self)
            }
            #[inline]
            fn tanh(self) -> Self {
                $suffix::tanh(self)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                $suffix::floor(self)
            }
            #[inline(always)]
            fn entry(list: &[f64], place: Self) -> Self {
                // the choice of an address instead of a branch: a loop loads several entries at a time whatever the instruction set
                *list.get(place_in(list, f64::from(place))).unwrap_or(&f64::NAN) as $float
            }
            #[inline(always)]
            fn entries<const N: usize>(list: &[[f64; N]], place: Self) -> [Self; N] {
                // one address for all the numbers
                list.get(place_in(list, f64::from(place))).unwrap_or(&[f64::NAN; N]).map(|number| number as $float)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
        }
    };
}

/// $\ln(1 + x)$ of a number that is not negative, without loss for a small one: the error of `w` is that of the denominator.
#[inline(always)]
pub(crate) fn ln_one_plus<R: Real>(x: R) -> R {
    let w = R::one() + x;
    R::select(w.gt(R::one()), x * w.ln() / (w - R::one()), x)
}

/// 2^52: from here on doubles are whole numbers.
const UNIT_SPACED: f64 = 4_503_599_627_370_496.0;

/// The place as an index below the length of the list: added to 2^52, a whole number is in the lowest bits.
#[inline(always)]
pub(crate) fn place_in<T>(list: &[T], place: f64) -> usize {
    (place + UNIT_SPACED).to_bits() as usize & list.len().wrapping_sub(1)
}

mod double {
    use super::UNIT_SPACED;
    pub(super) use crate::numbers::exponential::exp;
    pub(super) use libm::{acos, cos, log, sin, tanh};

    /// Has the bits of `f64::floor`, which is a call where the processor has no instruction for it and keeps a loop from being done several numbers at a time.
    #[inline(always)]
    pub(super) fn floor(x: f64) -> f64 {
        let nearest = ((x.abs() + UNIT_SPACED) - UNIT_SPACED).copysign(x);
        let whole = nearest - if nearest > x { 1.0 } else { 0.0 };
        if x.abs() < UNIT_SPACED { whole } else { x }
    }
}
mod single {
    pub(super) use libm::{
        acosf as acos, cosf as cos, expf as exp, floorf as floor, logf as log, sinf as sin, tanhf as tanh,
    };
}
native!(f64, double);
native!(f32, single);

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Lanes, Reference};
    use proptest::prelude::*;

    #[test]
    fn the_first_case_that_holds_decides() {
        let value = |x: f64| piecewise([(x.lt(1.0), 10.0), (x.lt(2.0), 20.0)], 30.0);
        assert_eq!([0.5, 1.0, 1.5, 2.0].map(value), [10.0, 20.0, 20.0, 30.0]);
    }

    #[test]
    fn no_comparison_holds_for_a_nan_and_equals_are_neither_less_nor_greater() {
        for (a, b) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
            assert!(!(a.lt(b) | Real::le(a, b) | a.gt(b) | Real::ge(a, b)));
        }
        assert_eq!((1.0.lt(1.0), Real::le(1.0, 1.0), 1.0.gt(1.0), Real::ge(1.0, 1.0)), (false, true, false, true));
        assert_eq!((<f64 as Real>::always(true), <f64 as Real>::always(false)), (true, false));
    }

    #[test]
    fn the_entry_of_a_list_is_at_its_place() {
        let list = [3.0, 1.0, 4.0, 1.5];
        assert_eq!([0.0, 1.0, 2.0, 3.0].map(|place| <f64 as Real>::entry(&list, place)), list);
        let list = [[3.0, 1.0, 4.0], [1.5, 9.0, 2.0]];
        assert_eq!([0.0, 1.0].map(|place| <f64 as Real>::entries(&list, place)), list);
        assert_eq!(Real::entries(&list, Lanes([1.0, 0.0])), [[1.5, 3.0], [9.0, 1.0], [2.0, 4.0]].map(Lanes));
    }

    /// Every function of `Real` once, as lists of numbers.
    fn all<R: Real>(x: R, y: R) -> [R; 20] {
        let size = x.abs();
        let list = [2.0, 7.0, 1.0, 8.0];
        [
            [x + y, x - y, x * y, x / y, -x],
            [size.sqrt(), x.exp(), size.ln(), x.sin(), x.cos()],
            [x.tanh().acos(), x.tanh(), x.floor(), x.min(y), x.max(y)],
            [x.squared(), size, R::pi(), R::entry(&list, size.min(R::lit(3.0)).floor()), {
                let mask = x.lt(y) & !y.le(R::zero()) | x.ge(R::one()) & x.gt(R::lit(2.0));
                R::select(mask, R::one(), R::zero())
            }],
        ]
        .concat()
        .try_into()
        .expect("twenty numbers")
    }

    proptest! {
        #[test]
        fn every_lane_has_the_bits_of_a_double(x in prop::array::uniform4(-9.0..9.0f64), y in prop::array::uniform4(-9.0..9.0f64)) {
            let lanes = all(Lanes(x), Lanes(y));
            for k in 0..4 {
                let double = all(x[k], y[k]);
                for (lane, double) in lanes.iter().zip(double) {
                    prop_assert_eq!(lane.0[k].to_bits(), double.to_bits());
                }
            }
        }

        #[test]
        fn the_smaller_and_the_larger_are_the_two(x in -9.0..9.0f64, y in -9.0..9.0f64) {
            let (least, most) = (Real::min(x, y), Real::max(x, y));
            prop_assert!(least <= most && [(x, y), (y, x)].contains(&(least, most)));
            prop_assert_eq!((Real::abs(x), x.squared()), (Real::max(x, -x), x * x));
        }

        #[test]
        fn the_logarithm_of_one_plus_a_number_loses_nothing(exponent in -60.0..4.0f64) {
            let x = exponent.exp2();
            let exact = (Reference::one() + Reference::exact(x)).ln().to_f64();
            prop_assert!((ln_one_plus(x) / exact - 1.0).abs() < 1e-15);
        }

        #[test]
        fn floor_has_the_bits_of_the_standard_library(x in prop::num::f64::ANY) {
            let (ours, standard) = (Real::floor(x), x.floor());
            prop_assert!(ours.to_bits() == standard.to_bits() || x.is_nan() && ours.is_nan(), "{x}: {ours} {standard}");
        }

        #[test]
        fn floor_has_the_bits_of_the_standard_library_near_whole_numbers(whole in -9..9i8, ulps in -3..4i64) {
            let x = f64::from(whole);
            let x = f64::from_bits(x.to_bits().wrapping_add_signed(ulps));
            prop_assert!(x.is_nan() || Real::floor(x).to_bits() == x.floor().to_bits(), "{x}");
        }
    }

    #[test]
    fn where_doubles_are_whole_floor_leaves_them() {
        // from spacings of a half to spacings of four
        for power in 51..55 {
            for step in -9..9 {
                let x = f64::from_bits(libm::ldexp(1.0, power).to_bits().wrapping_add_signed(step));
                assert_eq!([x, -x].map(Real::floor), [x.floor(), (-x).floor()], "{x}");
            }
        }
    }
}
