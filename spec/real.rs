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
                <$float>::floor(self)
            }
            #[inline(always)]
            fn entry(list: &[f64], place: Self) -> Self {
                // without a panic, which would keep a loop from being done several numbers at a time
                list.get(place_in(list, f64::from(place))).map_or(<$float>::NAN, |&entry| entry as $float)
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

/// The place as an index that needs no check: added to 2^52, a whole number is in the lowest bits.
#[inline(always)]
pub(crate) fn place_in(list: &[f64], place: f64) -> usize {
    (place + 4_503_599_627_370_496.0).to_bits() as usize & list.len().wrapping_sub(1)
}

mod double {
    pub(super) use crate::numbers::exponential::exp;
    pub(super) use libm::{acos, cos, log, sin, tanh};
}
mod single {
    pub(super) use libm::{acosf as acos, cosf as cos, expf as exp, logf as log, sinf as sin, tanhf as tanh};
}
native!(f64, double);
native!(f32, single);
