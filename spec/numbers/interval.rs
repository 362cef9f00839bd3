//! Bounds of a number: one evaluation proves a bound for a whole box of inputs.
//!
//! Every operation rounds outwards, so that the result contains both the exact result and that of `f64` for all numbers
//! inside the operands for which it has a value. A division by an interval that contains zero gives the whole line.

use crate::Real;
use crate::real::place_in;
use num_traits::{One, Zero};
use std::f64::consts::PI;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// All numbers from `lo` to `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower bound.
    pub lo: f64,
    /// Upper bound.
    pub hi: f64,
}

/// The truth of a comparison of intervals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// For no choice of numbers.
    Never,
    /// For some choices only.
    Sometimes,
    /// For every choice of numbers.
    Always,
}

/// Error of the transcendental functions of `libm`, in units of the last place, doubled for the two sides of a bound.
const MARGIN: usize = 4;
/// Beyond this angle the period of sine and cosine is no longer resolved to a thousandth.
const LARGEST_ANGLE: f64 = 1e12;

impl Interval {
    const LINE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// The numbers from `lo` to `hi`.
    ///
    /// # Panics
    ///
    /// If `lo` is above `hi`.
    pub fn new(lo: f64, hi: f64) -> Self {
        assert!(lo <= hi, "an interval goes from the smaller bound to the larger one, not from {lo} to {hi}");
        Self { lo, hi }
    }
    /// One number.
    pub fn point(value: f64) -> Self {
        Self { lo: value, hi: value }
    }
    /// Whether it contains `value`; the whole line contains everything, a NaN too.
    pub fn contains(self, value: f64) -> bool {
        self == Self::LINE || (self.lo <= value && value <= self.hi)
    }
    /// The smallest interval that contains both.
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }
    /// The interval with these bounds, moved outwards by `ulps`; the whole line if a bound has no value.
    fn outwards(lo: f64, hi: f64, ulps: usize) -> Self {
        if lo.is_nan() || hi.is_nan() {
            return Self::LINE;
        }
        let mut wide = Self { lo, hi };
        for _ in 0..ulps {
            wide = Self { lo: wide.lo.next_down(), hi: wide.hi.next_up() };
        }
        wide
    }
    /// The image under an increasing function of `libm`.
    fn increasing(self, f: impl Fn(f64) -> f64) -> Self {
        Self::outwards(f(self.lo), f(self.hi), MARGIN)
    }
    /// The hull of the four combinations of bounds; zero times infinity is zero there, a bound is never infinity itself.
    fn corners(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let values = [f(self.lo, other.lo), f(self.lo, other.hi), f(self.hi, other.lo), f(self.hi, other.hi)]
            .map(|value| if value.is_nan() { 0.0 } else { value });
        let (lo, hi) =
            values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
        let not_negative = self.lo >= 0.0 && other.lo >= 0.0 || self.hi <= 0.0 && other.hi <= 0.0;
        let not_positive = self.lo >= 0.0 && other.hi <= 0.0 || self.hi <= 0.0 && other.lo >= 0.0;
        Self::outwards(lo, hi, 1).signed(not_negative, not_positive)
    }
    /// Of numbers that are known not to be negative, or not positive: rounding outwards does not pass zero.
    fn signed(self, not_negative: bool, not_positive: bool) -> Self {
        Self {
            lo: if not_negative { self.lo.max(0.0) } else { self.lo },
            hi: if not_positive { self.hi.min(0.0) } else { self.hi },
        }
    }
    /// The largest absolute value.
    fn largest(self) -> f64 {
        self.hi.max(-self.lo)
    }
    /// Whether a point `offset + 2 pi k` may lie inside.
    fn may_contain_angle(self, offset: f64) -> bool {
        // a turn's number is known to a thousandth up to the largest angle: widened by that, it is never missed
        let turn = |x: f64| (x - offset) / (2.0 * PI);
        let slack = 1e-3 * (self.largest() / LARGEST_ANGLE) + 1e-12;
        (turn(self.lo) - slack).floor() != (turn(self.hi) + slack).floor()
    }
    fn wave(self, f: impl Fn(f64) -> f64, crest: f64) -> Self {
        if self.largest() > LARGEST_ANGLE {
            return Self { lo: -1.0, hi: 1.0 };
        }
        let (a, b) = (f(self.lo), f(self.hi));
        let ends = Self::outwards(a.min(b), a.max(b), MARGIN);
        let lo = if self.may_contain_angle(crest + PI) { -1.0 } else { ends.lo.max(-1.0) };
        let hi = if self.may_contain_angle(crest) { 1.0 } else { ends.hi.min(1.0) };
        Self { lo, hi }
    }
}

impl Real for Interval {
    type Mask = Truth;
    fn lit(value: f64) -> Self {
        Self::point(value)
    }
    fn pi() -> Self {
        Self { lo: PI, hi: PI.next_up() }
    }
    fn sqrt(self) -> Self {
        let wide = Self::outwards(self.lo.max(0.0).sqrt(), self.hi.sqrt(), 1);
        Self { lo: wide.lo.max(0.0), ..wide }
    }
    fn exp(self) -> Self {
        let wide = self.increasing(Real::exp);
        Self { lo: wide.lo.max(0.0), ..wide }
    }
    fn ln(self) -> Self {
        Self { lo: self.lo.max(0.0), ..self }.increasing(Real::ln)
    }
    fn sin(self) -> Self {
        self.wave(Real::sin, 0.5 * PI)
    }
    fn cos(self) -> Self {
        self.wave(Real::cos, 0.0)
    }
    fn acos(self) -> Self {
        let wide = Self::outwards(Real::acos(self.hi.min(1.0)), Real::acos(self.lo.max(-1.0)), MARGIN);
        Self { lo: wide.lo.max(0.0), ..wide }
    }
    fn tanh(self) -> Self {
        let wide = self.increasing(Real::tanh);
        Self { lo: wide.lo.max(-1.0), hi: wide.hi.min(1.0) }
    }
    fn floor(self) -> Self {
        Self { lo: Real::floor(self.lo), hi: Real::floor(self.hi) }
    }
    fn entry(list: &[f64], place: Self) -> Self {
        let entries = &list[place_in(list, place.lo)..=place_in(list, place.hi)];
        entries.iter().map(|&entry| Self::point(entry)).reduce(Self::hull).unwrap_or(Self::LINE)
    }
    fn lt(self, other: Self) -> Truth {
        if self == Self::LINE || other == Self::LINE {
            Truth::Sometimes
        } else if self.hi < other.lo {
            Truth::Always
        } else if self.lo >= other.hi {
            Truth::Never
        } else {
            Truth::Sometimes
        }
    }
    fn le(self, other: Self) -> Truth {
        !other.lt(self)
    }
    fn select(mask: Truth, yes: Self, no: Self) -> Self {
        match mask {
            Truth::Always => yes,
            Truth::Never => no,
            Truth::Sometimes => yes.hull(no),
        }
    }
    fn abs(self) -> Self {
        Self { lo: self.lo.max(-self.hi).max(0.0), hi: self.largest() }
    }
    fn min(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) }
    }
    fn max(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }
    fn squared(self) -> Self {
        let size = self.abs();
        let wide = Self::outwards(size.lo * size.lo, size.hi * size.hi, 1);
        Self { lo: wide.lo.max(0.0), ..wide }
    }
}

impl Zero for Interval {
    fn zero() -> Self {
        Self::point(0.0)
    }
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }
}
impl One for Interval {
    fn one() -> Self {
        Self::point(1.0)
    }
}
impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = Self::outwards(self.lo + other.lo, self.hi + other.hi, 1);
        sum.signed(self.lo >= 0.0 && other.lo >= 0.0, self.hi <= 0.0 && other.hi <= 0.0)
    }
}
impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() { Self::zero() } else { self.corners(other, |a, b| a * b) }
    }
}
impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.contains(0.0) { Self::LINE } else { self.corners(other, |a, b| a / b) }
    }
}
impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}
impl BitAnd for Truth {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        match (self, other) {
            (Truth::Never, _) | (_, Truth::Never) => Truth::Never,
            (Truth::Always, Truth::Always) => Truth::Always,
            _ => Truth::Sometimes,
        }
    }
}
impl BitOr for Truth {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        !(!self & !other)
    }
}
impl Not for Truth {
    type Output = Self;
    fn not(self) -> Self {
        match self {
            Truth::Never => Truth::Always,
            Truth::Sometimes => Truth::Sometimes,
            Truth::Always => Truth::Never,
        }
    }
}

#[cfg(test)]
mod laws;
