//! Arithmetic of bounds: every operation rounds upwards.

use std::ops::{Add, Div, Mul};

/// A bound from above of something that is not negative; infinite where nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Upper(pub(super) f64);

impl Upper {
    pub(super) const ZERO: Self = Self(0.0);
    pub(super) const ONE: Self = Self(1.0);
    pub(super) const UNKNOWN: Self = Self(f64::INFINITY);

    pub(super) fn is_known(self) -> bool {
        self.0 < f64::INFINITY
    }
    pub(super) fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    pub(super) fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    pub(super) fn sqrt(self) -> Self {
        if self.0 == 0.0 { self } else { Self(self.0.sqrt().next_up()) }
    }
}

impl Add for Upper {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self.0, other.0) {
            (0.0, _) => other,
            (_, 0.0) => self,
            (a, b) => Self((a + b).next_up()),
        }
    }
}
/// Zero times what is not known is zero.
impl Mul for Upper {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self.0, other.0) {
            (0.0, _) | (_, 0.0) => Self::ZERO,
            (1.0, _) => other,
            (_, 1.0) => self,
            (a, b) => Self((a * b).next_up()),
        }
    }
}
/// By a bound from below.
impl Div<f64> for Upper {
    type Output = Self;
    fn div(self, least: f64) -> Self {
        match (self.0, least) {
            (0.0, _) => self,
            (_, 1.0) => self,
            (a, b) if b > 0.0 => Self((a / b).next_up()),
            _ => Self::UNKNOWN,
        }
    }
}
