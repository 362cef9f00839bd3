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
        if self == Self::LINE {
            return self;
        }
        Self {
            lo: if not_negative { self.lo.max(0.0) } else { self.lo },
            hi: if not_positive { self.hi.min(0.0) } else { self.hi },
        }
    }
    /// Whether a point `offset + 2 pi k` may lie inside.
    fn may_contain_angle(self, offset: f64) -> bool {
        // a turn's number is known to a thousandth up to the largest angle: widened by that, it is never missed
        let turn = |x: f64| (x - offset) / (2.0 * PI);
        let slack = 1e-3 * (self.lo.abs().max(self.hi.abs()) / LARGEST_ANGLE) + 1e-12;
        (turn(self.lo) - slack).floor() != (turn(self.hi) + slack).floor()
    }
    fn wave(self, f: impl Fn(f64) -> f64, crest: f64) -> Self {
        let bounded = |lo: f64, hi: f64| Self { lo: lo.max(-1.0), hi: hi.min(1.0) };
        if self.lo.abs().max(self.hi.abs()) > LARGEST_ANGLE || self.hi - self.lo >= 2.0 * PI {
            return bounded(-1.0, 1.0);
        }
        let (a, b) = (f(self.lo), f(self.hi));
        let ends = Self::outwards(a.min(b), a.max(b), MARGIN);
        let lo = if self.may_contain_angle(crest + PI) { -1.0 } else { ends.lo };
        let hi = if self.may_contain_angle(crest) { 1.0 } else { ends.hi };
        bounded(lo, hi)
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
        let (a, b) = (self.lo.abs(), self.hi.abs());
        let straddles = self.lo < 0.0 && self.hi > 0.0;
        Self { lo: if straddles { 0.0 } else { a.min(b) }, hi: a.max(b) }
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
mod laws {
    use super::*;
    use crate::numbers::Reference;
    use proptest::prelude::*;

    /// Every operation once.
    fn composite<R: Real>(x: R, y: R) -> R {
        let waves = (x * y).sin() + (x - y).cos() * (x / y).tanh();
        let chosen = R::select(x.lt(y) & x.ge(R::lit(0.5)) | y.gt(R::lit(2.0)), x.squared(), -y.abs());
        waves * (-x).exp() + (x + y).abs().ln() / (x.squared() + R::pi()).sqrt() + x.max(y) * x.floor().min(y) + chosen
    }
    fn one_of(interval: Interval, place: f64) -> f64 {
        (interval.lo + place * (interval.hi - interval.lo)).clamp(interval.lo, interval.hi)
    }

    prop_compose! {
        fn intervals(largest: f64)(lo in -largest..largest, width in prop_oneof![Just(0.0), 0.0..1e-9, 0.0..10.0]) -> Interval {
            Interval::new(lo, lo + width)
        }
    }

    /// One function over two numbers.
    type Bounded = (fn(Interval) -> Interval, fn(f64) -> f64);

    /// One function over three numbers.
    type Function = (fn(Interval) -> Interval, fn(f64) -> f64, fn(Reference) -> Reference);

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn it_contains_the_double_and_the_exact_result(a in intervals(20.0), b in intervals(20.0), s in 0.0..=1.0, t in 0.0..=1.0) {
            let (x, y) = (one_of(a, s), one_of(b, t));
            let bounds = composite(a, b);
            let exact = composite(Reference::exact(x), Reference::exact(y));
            prop_assert!(bounds.contains(composite(x, y)), "{bounds:?} {}", composite(x, y));
            prop_assert!(bounds == Interval::LINE || exact.ge(Reference::exact(bounds.lo)) && exact.le(Reference::exact(bounds.hi)));
        }

        #[test]
        fn it_contains_every_transcendental_function(a in intervals(30.0), s in 0.0..=1.0) {
            let x = one_of(a, s);
            let functions: [Function; 6] = [
                (Real::exp, Real::exp, Real::exp),
                (Real::sin, Real::sin, Real::sin),
                (Real::cos, Real::cos, Real::cos),
                (Real::tanh, Real::tanh, Real::tanh),
                (|x| x.tanh().acos(), |x| Real::acos(Real::tanh(x)), |x| x.tanh().acos()),
                (|x| x.squared().ln(), |x| Real::ln(x.squared()), |x| x.squared().ln()),
            ];
            for (bounds, double, exact) in functions {
                let bounds = bounds(a);
                prop_assert!(bounds.contains(double(x)) && bounds.contains(exact(Reference::exact(x)).to_f64()), "{a:?} {x} {bounds:?}");
            }
        }

        #[test]
        fn a_point_stays_narrow(x in 0.1..10.0, y in 0.1..10.0) {
            let bounds = Interval::point(x) * Interval::point(y) + Interval::point(x).sqrt();
            // three roundings, each one unit of the last place to both sides
            prop_assert!(bounds.hi - bounds.lo <= 8.0 * f64::EPSILON * bounds.hi);
        }
    }

    #[test]
    fn a_square_is_not_negative_and_a_wave_not_above_one() {
        let x = Interval::new(-2.0, 3.0);
        assert_eq!(x.squared().lo, 0.0);
        assert_eq!(x.abs(), Interval::new(0.0, 3.0));
        assert_eq!(x.sin(), Interval::new(-1.0, 1.0));
        assert_eq!(Interval::new(1.0, 2.0).sin().hi, 1.0);
        assert!(Interval::new(1.0, 1.5).sin().hi < 1.0);
    }

    proptest! {
        /// Both bounds are attained, up to the margin: a bound that is always true proves nothing.
        #[test]
        fn bounds_are_tight(lo in -8.0..8.0, width in prop_oneof![Just(0.0), 0.0..1e-6, 0.0..9.0]) {
            let x = Interval::new(lo, lo + width);
            let places: Vec<f64> = (0..=2000).map(|k| one_of(x, f64::from(k) / 2000.0)).collect();
            let functions: [Bounded; 8] = [
                (Real::sin, Real::sin),
                (Real::cos, Real::cos),
                (Real::exp, Real::exp),
                (Real::tanh, Real::tanh),
                (Real::squared, Real::squared),
                (Real::floor, Real::floor),
                (|x| (x * Interval::lit(0.05)).acos(), |x| Real::acos(x * 0.05)),
                (|x| (x.exp() + Interval::one()).ln().sqrt(), |x| Real::ln(Real::exp(x) + 1.0).sqrt()),
            ];
            for (k, (bounds, double)) in functions.into_iter().enumerate() {
                let (bounds, values) = (bounds(x), places.iter().map(|&place| double(place)));
                let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
                // between two of the places a wave rises above both by less than the square of their distance
                let slack = 1e-13 * (1.0 + most.abs()) + (width / 2000.0) * (width / 2000.0);
                prop_assert!(least - bounds.lo <= slack && bounds.hi - most <= slack, "{k}: {x:?} {bounds:?} {least} {most}");
            }
        }

        #[test]
        fn bounds_of_products_and_quotients_are_attained_at_corners(a in intervals(20.0), b in intervals(20.0)) {
            let corners = |f: fn(f64, f64) -> f64| {
                let values = [f(a.lo, b.lo), f(a.lo, b.hi), f(a.hi, b.lo), f(a.hi, b.hi)];
                (values.into_iter().fold(f64::INFINITY, f64::min), values.into_iter().fold(f64::NEG_INFINITY, f64::max))
            };
            let close = |bounds: Interval, (least, most): (f64, f64)| {
                let slack = 4.0 * f64::EPSILON * (least.abs() + most.abs());
                least - bounds.lo <= slack && bounds.hi - most <= slack
            };
            prop_assert!(close(a + b, corners(|x, y| x + y)) && close(a - b, corners(|x, y| x - y)));
            prop_assert!(close(a * b, corners(|x, y| x * y)));
            prop_assert!(b.contains(0.0) || close(a / b, corners(|x, y| x / y)));
        }
    }

    #[test]
    fn a_comparison_may_be_undecided() {
        let (a, b, c) = (Interval::new(0.0, 1.0), Interval::new(0.5, 2.0), Interval::new(2.0, 3.0));
        assert_eq!((a.lt(c), c.lt(a), a.lt(b)), (Truth::Always, Truth::Never, Truth::Sometimes));
        assert_eq!(b.le(c), Truth::Always);
        assert_eq!(Interval::select(a.lt(b), Interval::point(-1.0), Interval::point(4.0)), Interval::new(-1.0, 4.0));
        assert_eq!((a / a, Interval::one() / b == Interval::LINE), (Interval::LINE, false));
    }
}
