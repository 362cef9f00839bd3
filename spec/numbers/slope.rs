//! Bounds of a number and of its derivative with respect to one input: a sign of the derivative over a box proves that an
//! equation is monotonic there.

use crate::Real;
use crate::numbers::{Interval, Truth};
use num_traits::{One, Zero};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// All values over a box, and all slopes of secants along one input. Where two cases meet the number may jump, so that no slope
/// is known, unless the comparison does not depend on the input.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    /// Contains the values.
    pub value: Interval,
    /// Contains the slopes with respect to the variable; the whole line where none is known.
    pub slope: Interval,
}

/// The truth of a comparison over a box, and whether it may change with the variable.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    truth: Truth,
    changes: bool,
}

const LINE: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

impl Slope {
    /// Does not depend on the variable.
    pub fn constant(value: Interval) -> Self {
        Self { value, slope: Interval::zero() }
    }
    /// The variable itself.
    pub fn variable(value: Interval) -> Self {
        Self { value, slope: Interval::one() }
    }
    fn is_constant(self) -> bool {
        self.slope.is_zero()
    }
    fn of(value: Interval, slope: Interval) -> Self {
        let known = |x: Interval| !x.lo.is_nan() && !x.hi.is_nan();
        Self { value, slope: if known(slope) && known(value) && value != LINE { slope } else { LINE } }
    }
    /// Through a function with this value and derivative. A constant stays constant.
    fn chain(self, value: Interval, derivative: Interval) -> Self {
        let slope = if self.is_constant() { Interval::zero() } else { derivative * self.slope };
        Self::of(value, slope)
    }
    /// A function that has values in `domain` only.
    fn within(self, domain: Interval, image: impl Fn(Self) -> Self) -> Self {
        let inside = domain.lo <= self.value.lo && self.value.hi <= domain.hi;
        if inside { image(self) } else { Self { value: LINE, slope: LINE } }
    }
    /// One of two numbers; where either may be taken and they are equal where one follows the other.
    fn joined(self, other: Self, value: Interval) -> Self {
        Self::of(value, self.slope.hull(other.slope))
    }
}

impl Real for Slope {
    type Mask = Change;
    fn lit(value: f64) -> Self {
        Self::constant(Interval::point(value))
    }
    fn pi() -> Self {
        Self::constant(Interval::pi())
    }
    fn sqrt(self) -> Self {
        self.within(Interval { lo: 0.0, hi: f64::MAX }, |x| {
            let root = x.value.sqrt();
            // where the derivative becomes infinite it is still not negative
            let steepest = if root.lo > 0.0 { (Interval::point(0.5) / root).hi } else { f64::INFINITY };
            let derivative = Interval {
                lo: (Interval::point(0.5) / Interval::point(root.hi.max(f64::MIN_POSITIVE))).lo.max(0.0),
                hi: steepest,
            };
            x.chain(root, derivative)
        })
    }
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    fn ln(self) -> Self {
        self.within(Interval { lo: f64::from_bits(1), hi: f64::MAX }, |x| {
            x.chain(x.value.ln(), Interval::one() / x.value)
        })
    }
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }
    fn acos(self) -> Self {
        self.within(Interval { lo: -1.0, hi: 1.0 }, |x| {
            let sine = ((Interval::one() - x.value) * (Interval::one() + x.value)).sqrt();
            let steepest = if sine.lo > 0.0 { (Interval::one() / sine).hi } else { f64::INFINITY };
            x.chain(x.value.acos(), -Interval { lo: 1.0, hi: steepest })
        })
    }
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        let falls = (Interval::one() - value) * (Interval::one() + value);
        self.chain(value, Interval { lo: falls.lo.max(0.0), hi: falls.hi })
    }
    fn floor(self) -> Self {
        let value = self.value.floor();
        let slope = if self.is_constant() || value.lo == value.hi { Interval::zero() } else { LINE };
        Self { value, slope }
    }
    fn entry(list: &[f64], place: Self) -> Self {
        let inside = place.value.lo >= 0.0 && place.value.hi < list.len() as f64;
        let all = Interval { lo: 0.0, hi: list.len() as f64 - 1.0 };
        let value = Interval::entry(list, if inside { place.value } else { all });
        let slope = if place.is_constant() || value.lo == value.hi { Interval::zero() } else { LINE };
        Self { value, slope }
    }
    fn lt(self, other: Self) -> Change {
        Change { truth: self.value.lt(other.value), changes: !(self - other).is_constant() }
    }
    fn le(self, other: Self) -> Change {
        Change { truth: self.value.le(other.value), changes: !(self - other).is_constant() }
    }
    fn select(mask: Change, yes: Self, no: Self) -> Self {
        match mask.truth {
            Truth::Always => yes,
            Truth::Never => no,
            Truth::Sometimes if mask.changes => Self::of(yes.value.hull(no.value), LINE),
            Truth::Sometimes => yes.joined(no, yes.value.hull(no.value)),
        }
    }
    fn abs(self) -> Self {
        match Truth::Always {
            truth if self.value.ge(Interval::zero()) == truth => self,
            truth if self.value.le(Interval::zero()) == truth => -self,
            _ => self.joined(-self, self.value.abs()),
        }
    }
    fn min(self, other: Self) -> Self {
        match self.value.lt(other.value) {
            Truth::Always => self,
            Truth::Never => other,
            Truth::Sometimes => self.joined(other, self.value.min(other.value)),
        }
    }
    fn max(self, other: Self) -> Self {
        match self.value.gt(other.value) {
            Truth::Always => self,
            Truth::Never => other,
            Truth::Sometimes => self.joined(other, self.value.max(other.value)),
        }
    }
    fn squared(self) -> Self {
        self.chain(self.value.squared(), Interval::point(2.0) * self.value)
    }
}

impl Zero for Slope {
    fn zero() -> Self {
        Self::constant(Interval::zero())
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.is_constant()
    }
}
impl One for Slope {
    fn one() -> Self {
        Self::constant(Interval::one())
    }
}
impl Add for Slope {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let slope = if self.is_constant() {
            other.slope
        } else if other.is_constant() {
            self.slope
        } else {
            self.slope + other.slope
        };
        Self::of(self.value + other.value, slope)
    }
}
impl Sub for Slope {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for Slope {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.slope * other.value, other.slope * self.value);
        let slope = if self.is_constant() {
            b
        } else if other.is_constant() {
            a
        } else {
            a + b
        };
        Self::of(self.value * other.value, slope)
    }
}
impl Div for Slope {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slope = if other.is_constant() {
            if self.is_constant() { Interval::zero() } else { self.slope / other.value }
        } else if self.is_constant() {
            -(value * other.slope / other.value)
        } else {
            (self.slope - value * other.slope) / other.value
        };
        Self::of(value, slope)
    }
}
impl Neg for Slope {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}
impl BitAnd for Change {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self { truth: self.truth & other.truth, changes: self.changes || other.changes }
    }
}
impl BitOr for Change {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        !(!self & !other)
    }
}
impl Not for Change {
    type Output = Self;
    fn not(self) -> Self {
        Self { truth: !self.truth, ..self }
    }
}
