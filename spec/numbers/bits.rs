//! Numbers of which the power of two can be seen and made: what exponential, logarithm and trigonometric functions need beyond arithmetic.

use crate::Real;

/// Added to a number of moderate size, leaves its nearest integer in the lowest bits.
pub(crate) const ROUND: f64 = 6_755_399_441_055_744.0; // 3/2 2^52
/// Bits of a number's mantissa.
const MANTISSA: u32 = 52;
/// Added to an exponent where it is stored.
const BIAS: u64 = 1023;

/// A number that is stored as a power of two and a mantissa.
pub trait Bits: Real {
    /// The largest whole number whose power of two is not above the absolute value of a normal number; of any other it is not defined.
    fn exponent(self) -> Self;
    /// Two to the power of a whole number, to which 3/2 2^52 has been added, if that is a normal number; otherwise not defined.
    fn power_of_two(self) -> Self;
}

impl Bits for f64 {
    #[inline(always)]
    fn exponent(self) -> Self {
        ((self.to_bits() >> MANTISSA & (2 * BIAS + 1)) as i64 - BIAS as i64) as f64
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        Self::from_bits(self.to_bits().wrapping_add(BIAS) << MANTISSA)
    }
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn powers_of_two_are_seen_and_made() {
        for k in [-1022, -1021, -52, -1, 0, 1, 2, 52, 1022, 1023] {
            let power = libm::ldexp(1.0, k);
            assert_eq!((f64::from(k) + ROUND).power_of_two(), power);
            for mantissa in [1.0, 1.25, 2.0f64.next_down(), -1.5] {
                assert_eq!((mantissa * power).exponent(), f64::from(k), "{mantissa} 2^{k}");
            }
        }
    }
}
