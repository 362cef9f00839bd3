//! The exponential function without a branch: a pair loop that calls it can still be vectorised.
//!
//! Plain additions and multiplications, so every instruction set gives the same bits. At most 1 ULP from the exact value
//! where that is a normal number.

use super::bits::{Bits, ROUND};

/// `ln 2` in two parts; the first ends in zeros, so that its product with a whole number of eleven bits is exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
/// `1 / k!` from the second on: Taylor's series, whose next term is below 1e-17 of the sum for arguments up to `ln 2 / 2`.
const INVERSE_FACTORIAL: [f64; 12] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5_040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
];

/// `e` to the power of `x`: infinite above 709.8, zero below -745.2.
#[inline(always)]
pub(crate) fn exp<R: Bits>(x: R) -> R {
    let (highest, lowest, round) = (R::lit(710.0), R::lit(-746.0), R::lit(ROUND));
    let x = R::select(x.gt(highest), highest, x);
    let x = R::select(x.lt(lowest), lowest, x);
    let whole = x * R::lit(std::f64::consts::LOG2_E) + round;
    let k = whole - round;
    let r = (x - k * R::lit(LN_2[0])) - k * R::lit(LN_2[1]);
    let mut series = R::lit(INVERSE_FACTORIAL[11]);
    for coefficient in INVERSE_FACTORIAL[..11].iter().rev() {
        series = series * r + R::lit(*coefficient);
    }
    let value = R::one() + (r + r * r * series);
    // In two halves: the whole power of two may not be a normal number.
    let half = k * R::lit(0.5) + round;
    value * half.power_of_two() * (k - (half - round) + round).power_of_two()
}

#[cfg(test)]
mod tests {
    use super::exp;
    use crate::Real;
    use crate::numbers::Reference;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_within_one_unit_of_the_last_place(x in -700.0..709.0) {
            let exact = Reference::exact(x).exp();
            let here = exp(x);
            let error = (Reference::exact(here) - exact).to_f64().abs();
            prop_assert!(error <= here.next_up() - here, "{x}: {here}, off by {error}");
        }
    }

    #[test]
    fn the_ends_of_the_line() {
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(f64::INFINITY), f64::INFINITY);
        assert_eq!(exp(710.0), f64::INFINITY);
        assert_eq!(exp(f64::NEG_INFINITY), 0.0);
        assert_eq!(exp(-746.0), 0.0);
        assert!(exp(-744.0) > 0.0);
        assert!(exp(f64::NAN).is_nan());
    }
}
