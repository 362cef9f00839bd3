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
pub(crate) fn place_in(list: &[f64], place: f64) -> usize {
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
mod tests {
    use super::Real;
    use proptest::prelude::*;

    proptest! {
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
}
