//! A value and its derivative with respect to one input: a force can be compared with the gradient of its energy exactly.

use crate::Real;
use num_traits::{One, Zero};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and one derivative. Comparisons and selections look at the value only.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number that does not depend on the variable.
    pub fn constant(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }
    /// The variable itself.
    pub fn variable(value: f64) -> Self {
        Self { value, slope: 1.0 }
    }
    /// A function of `self` with the given value and derivative. A constant stays constant even where the derivative is
    /// infinite, as that of the square root at zero.
    fn chain(self, value: f64, derivative: f64) -> Self {
        let slope = if self.slope == 0.0 { 0.0 } else { derivative * self.slope };
        Self { value, slope }
    }
}

impl Real for Dual {
    type Mask = bool;
    fn lit(value: f64) -> Self {
        Self::constant(value)
    }
    fn pi() -> Self {
        Self::constant(f64::pi())
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn exp(self) -> Self {
        let value = Real::exp(self.value);
        self.chain(value, value)
    }
    fn ln(self) -> Self {
        self.chain(Real::ln(self.value), 1.0 / self.value)
    }
    fn sin(self) -> Self {
        self.chain(Real::sin(self.value), Real::cos(self.value))
    }
    fn cos(self) -> Self {
        self.chain(Real::cos(self.value), -Real::sin(self.value))
    }
    fn acos(self) -> Self {
        self.chain(Real::acos(self.value), -1.0 / ((1.0 - self.value) * (1.0 + self.value)).sqrt())
    }
    fn tanh(self) -> Self {
        let value = Real::tanh(self.value);
        self.chain(value, (1.0 - value) * (1.0 + value))
    }
    fn floor(self) -> Self {
        Self::constant(Real::floor(self.value))
    }
    fn entry(list: &[f64], place: Self) -> Self {
        Self::constant(Real::entry(list, place.value))
    }
    fn entries<const N: usize>(list: &[[f64; N]], place: Self) -> [Self; N] {
        f64::entries(list, place.value).map(Self::constant)
    }
    fn lt(self, other: Self) -> bool {
        self.value < other.value
    }
    fn le(self, other: Self) -> bool {
        self.value <= other.value
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

impl Zero for Dual {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0 && self.slope == 0.0
    }
}
impl One for Dual {
    fn one() -> Self {
        Self::constant(1.0)
    }
}
impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}
impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}
impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}
impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}
impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    /// Every operation once, smooth for positive arguments.
    fn composite<R: Real>(x: R, y: R) -> R {
        let waves = (x * y).sin() + (x - y).cos() * (x / y).tanh() + (x / (x + y)).acos();
        waves * (-x).exp() + (x + y).ln() / (x.squared() + R::one()).sqrt() + x.max(y) * x.floor()
    }

    proptest! {
        #[test]
        fn the_slope_is_the_limit_of_central_differences(x in 0.1..3.0f64, y in 0.1..3.0f64) {
            let h = 1e-5;
            // away from the kinks of `max` and the steps of `floor`
            prop_assume!((x - y).abs() > 2.0 * h && (x - x.round()).abs() > 2.0 * h);
            let difference = (composite(x + h, y) - composite(x - h, y)) / (2.0 * h);
            let dual = composite(Dual::variable(x), Dual::constant(y));
            prop_assert_eq!(dual.value, composite(x, y));
            // truncation h^2 f'''/6 and cancellation eps/h, both with f of order 10
            prop_assert!((dual.slope - difference).abs() <= 1e-7 * (1.0 + difference.abs()), "{} {}", dual.slope, difference);
        }

        #[test]
        fn the_case_that_is_not_taken_leaves_no_trace(x in 0.1..3.0f64) {
            let absent = Dual::variable(x) / Dual::constant(0.0);
            let taken = Dual::select(Dual::variable(x).lt(Dual::zero()), absent, Dual::variable(x).squared());
            prop_assert_eq!(taken.slope, 2.0 * x);
        }
    }

    #[test]
    fn equal_values_are_neither_less_nor_greater_and_zero_does_not_change() {
        let (a, b) = (Dual::variable(1.0), Dual::constant(1.0));
        assert_eq!((a.lt(b), a.le(b), b.gt(a), b.ge(a)), (false, true, false, true));
        assert_eq!([Dual::zero(), Dual::variable(0.0), b].map(|number| number.is_zero()), [true, false, false]);
    }

    #[test]
    fn the_root_of_a_constant_zero_is_constant() {
        assert_eq!(Dual::constant(0.0).sqrt().slope, 0.0);
        assert_eq!(Dual::variable(0.0).sqrt().slope, f64::INFINITY);
    }
}
