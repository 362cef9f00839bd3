//! Sums, products and quotients.

use super::bound::{Bound, ROUNDING, largest, smallest};
use super::upper::Upper;
use super::{Rounded, Trouble, new_origin};
use crate::Real;
use crate::numbers::Interval;
use num_traits::{One, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

impl Rounded {
    /// Whether it is zero, for exact numbers and for `f64`.
    fn is_nothing(self) -> bool {
        self.exact.is_zero() && self.error == Upper::ZERO
    }
}

impl Zero for Rounded {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        self.is_nothing()
    }
}
impl One for Rounded {
    fn one() -> Self {
        Self::constant(1.0)
    }
}
impl Add for Rounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if other.is_nothing() {
            return self;
        }
        if self.is_nothing() {
            return other;
        }
        let images = self.images_of(other, Add::add);
        let exact = images[0];
        let before = self.error + other.error;
        // a sum does not underflow: where it is subnormal it is exact
        let error = before + ROUNDING * (Upper(largest(exact)) + before);
        let bound = self.bound.sum(self.exact, &other.bound, other.exact, exact);
        let bound = Bound { rest: bound.rest * (Upper::ONE + ROUNDING), ..bound.rounded(ROUNDING) };
        Self::result(&[self, other], images, error, bound)
    }
}
impl Sub for Rounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for Rounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if let (true, None) = (self.is_nothing() || other.is_nothing(), self.trouble.or(other.trouble)) {
            return Self::zero();
        }
        if self.origin == other.origin {
            return self.squared();
        }
        let images = self.images_of(other, Mul::mul);
        let exact = images[0];
        let (a, b) = (Upper(largest(self.exact)), Upper(largest(other.exact)));
        let both = self.error * other.error;
        let error = a * other.error + b * self.error + both;
        let rest = a * other.bound.rest + b * self.bound.rest + both;
        let bound = self.bound.product(self.exact, &other.bound, other.exact, rest);
        let by = if self.is_power_of_two() || other.is_power_of_two() { Upper::ZERO } else { ROUNDING };
        Self::result(&[self, other], images, Self::error_rounded(error, exact, by), bound.rounded(by))
    }
}
impl Div for Rounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let smallest_b = smallest(other.exact);
        let relative = other.bound.relative(smallest_b).min(other.error / smallest_b);
        if other.computed.contains(0.0) || relative >= Upper(0.5) {
            return Self::lost(self.trouble.or(other.trouble).unwrap_or(Trouble::Denominator));
        }
        if self.is_nothing() {
            return Self::zero();
        }
        // |b'| >= |b| (1 - relative)
        let factor = Upper::ONE / (1.0 - relative.0).next_down();
        let images = self.images_of(other, Div::div);
        let (exact, one_over) = (images[0], Interval::point(1.0) / other.exact);
        let quotient = Upper(largest(exact));
        let error = factor * (self.error / smallest_b + quotient * (other.error / smallest_b));
        let rest = self.bound.rest / smallest_b + quotient * (other.bound.rest / smallest_b);
        let inverse = Bound { signs: other.bound.signs.inverse(one_over), ..other.bound };
        let bound = self.bound.product(self.exact, &inverse, one_over, rest).times(factor);
        let by = if other.is_power_of_two() { Upper::ZERO } else { ROUNDING };
        Self::result(&[self, other], images, Self::error_rounded(error, exact, by), bound.rounded(by))
    }
}
impl Neg for Rounded {
    type Output = Self;
    fn neg(self) -> Self {
        let bound = Bound { signs: self.bound.signs.negated(), ..self.bound };
        Self { exact: -self.exact, computed: -self.computed, bound, origin: new_origin(), ..self }
    }
}
