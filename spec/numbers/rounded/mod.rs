//! Bounds of a number and of its rounding error in `f64`: one evaluation is a theorem about a whole box of inputs.
//!
//! The inputs are doubles inside a box. Every number knows an interval that contains its exact value, and a bound of the
//! distance of what `f64` computes from that value, rounded upwards through every operation. Where a comparison is undecided,
//! both cases count; where rounding may make `f64` take the other case, the error contains the distance of the two.

mod bound;
#[cfg(test)]
mod laws;
mod operators;
mod signs;
mod upper;

use crate::Real;
use crate::numbers::{Interval, Truth};
use bound::{Bound, ROUNDING, UNDERFLOW, largest, smallest};
use signs::Sign;
use std::cell::Cell;
use std::ops::{BitAnd, BitOr, Not};
use std::sync::atomic::{AtomicU64, Ordering};
use upper::Upper;

/// All values that a number has over a box of inputs, and how far from them `f64` may be.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    exact: Interval,
    computed: Interval,
    error: Upper,
    bound: Bound,
    trouble: Option<Trouble>,
    /// Copies of one number have the same: a product of two is a square.
    origin: u64,
}

/// The next thread's first origin, and how many a thread has.
static THREADS: AtomicU64 = AtomicU64::new(0);
const PER_THREAD: u64 = 1 << 48;
thread_local! {
    static NEXT: Cell<u64> = Cell::new(THREADS.fetch_add(PER_THREAD, Ordering::Relaxed));
}
fn new_origin() -> u64 {
    NEXT.replace(NEXT.get() + 1)
}

/// Why a number may have no finite value somewhere in a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// A denominator may be zero.
    Denominator,
    /// A root, logarithm or inverse cosine may have no value.
    Domain,
    /// A number may be beyond the largest double.
    Overflow,
}

/// The truth of a comparison over a box, and whether `f64` finds the same as exact numbers do.
#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    truth: Truth,
    same: bool,
}

/// Units of the last place: largest errors of the transcendental functions, in relative terms. `exp` is this project's own;
/// the others are those of `libm`, for which its authors state one unit, and two for `tanh`.
const ONE_ULP: Upper = Upper(f64::EPSILON);
const TANH: Upper = Upper(2.0 * f64::EPSILON);

impl Rounded {
    /// Input number `k` of an equation, which may be any double in an interval; up to 128 are told apart.
    pub fn input(k: usize, values: Interval) -> Self {
        Self {
            exact: values,
            computed: values,
            error: Upper::ZERO,
            bound: Bound::input(k, values),
            trouble: None,
            origin: new_origin(),
        }
    }
    /// Contains the exact values.
    pub fn exact(self) -> Interval {
        self.exact
    }
    /// Contains what `f64` computes.
    pub fn computed(self) -> Interval {
        self.computed
    }
    /// Largest distance of the `f64` from the exact value.
    pub fn error(self) -> f64 {
        self.error.0
    }
    /// What may leave the number without a finite value; nothing if it has one everywhere in the box.
    pub fn trouble(self) -> Option<Trouble> {
        self.trouble
    }
    /// The error is at most `ulps eps (|f| + sum_k |x_k df/dx_k|) + rest` everywhere in the box. The rest has what is of
    /// second order, and underflow. It is known that `sum_k |x_k df/dx_k| >= conditioned |f|`.
    pub fn ulps(self, conditioned: f64) -> Ulps {
        let (Bound { value, inputs, rest, .. }, least) = (self.bound, self.bound.least.max(conditioned));
        let at = |ratio: f64| {
            if ratio.is_finite() { (value + inputs * Upper(ratio)) / (1.0 + ratio).next_down() } else { inputs }
        };
        Ulps { first_order: at(least).max(at(self.bound.most.0.max(least))).0 / f64::EPSILON, rest: rest.0 }
    }
    /// Lower bound of `sum_k |x_k df/dx_k|` over `|f|`.
    pub fn conditioned(self) -> f64 {
        self.bound.least
    }

    /// A number of the specification: known exactly.
    fn constant(value: f64) -> Self {
        let point = Interval::point(value);
        Self {
            exact: point,
            computed: point,
            error: Upper::ZERO,
            bound: Bound::CONSTANT,
            trouble: None,
            origin: new_origin(),
        }
    }
    /// No value is known.
    fn lost(trouble: Trouble) -> Self {
        let line = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
        let bound = Bound::CONSTANT.unknown(Upper::UNKNOWN, 0.0);
        Self {
            exact: line,
            computed: line,
            error: Upper::UNKNOWN,
            bound: bound.free(),
            trouble: Some(trouble),
            origin: new_origin(),
        }
    }
    /// The result of an operation on these numbers, if they have a value: bounds of exact values and of what `f64` computes,
    /// the error by intervals, and by shares.
    fn result(operands: &[Self], [exact, computed]: [Interval; 2], error: Upper, bound: Bound) -> Self {
        if let Some(trouble) = operands.iter().find_map(|x| x.trouble) {
            return Self::lost(trouble);
        }
        let error = error.min(bound.error(largest(exact)));
        let mut bound = if bound.is_known() { bound } else { bound.unknown(error, smallest(exact)) };
        bound.signs = bound.signs.settled(exact);
        let near = Interval { lo: (exact.lo - error.0).next_down(), hi: (exact.hi + error.0).next_up() };
        let near = if error == Upper::ZERO { exact } else { near };
        let computed = Interval { lo: computed.lo.max(near.lo), hi: computed.hi.min(near.hi) };
        let finite = computed.lo >= -f64::MAX && computed.hi <= f64::MAX && error.is_known();
        if finite {
            Self { exact, computed, error, bound, trouble: None, origin: new_origin() }
        } else {
            Self::lost(Trouble::Overflow)
        }
    }
    /// The images of the exact and of the computed values.
    fn images(self, f: impl Fn(Interval) -> Interval) -> [Interval; 2] {
        [f(self.exact), f(self.computed)]
    }
    /// The images of pairs of exact and of computed values.
    fn images_of(self, other: Self, f: impl Fn(Interval, Interval) -> Interval) -> [Interval; 2] {
        [f(self.exact, other.exact), f(self.computed, other.computed)]
    }
    /// Whether it is one number that everybody knows exactly, a power of two: factors that round nothing.
    fn is_power_of_two(self) -> bool {
        let bits = self.exact.lo.abs().to_bits();
        self.exact.lo == self.exact.hi
            && self.error == Upper::ZERO
            && self.exact.lo.is_normal()
            && bits & ((1 << 52) - 1) == 0
    }
    /// The error after a rounding by this relative error.
    fn error_rounded(error: Upper, exact: Interval, by: Upper) -> Upper {
        error + by * (Upper(largest(exact)) + error) + UNDERFLOW
    }
    /// After a smooth function whose slope is at most `slope` between exact and computed operands.
    fn smooth(self, images: [Interval; 2], slope: Upper, bound: Bound, by: Upper) -> Self {
        let error = Self::error_rounded(slope * self.error, images[0], by);
        Self::result(&[self], images, error, bound.rounded(by))
    }
    /// Sine or cosine with its derivative over the computed operands.
    fn wave(self, images: [Interval; 2], slope: Interval) -> Self {
        let exact = images[0];
        let (size, of_slope) = (largest(self.exact), largest(slope));
        let [value_by, rest_by] = [Upper(size) * Upper(of_slope) / smallest(exact), Upper(of_slope)];
        let ratios = [smallest(self.exact) * smallest(slope) / largest(exact), value_by.0];
        let mut bound = self.bound.through(value_by, rest_by, ratios);
        bound.rest = bound.rest + Upper(0.5) * self.error * self.error;
        bound.signs = self.bound.signs.through(Sign::of(slope));
        self.smooth(images, Upper(of_slope), bound, ONE_ULP)
    }
    /// The larger or smaller of two numbers.
    fn extreme(self, other: Self, images: [Interval; 2], decided: Verdict) -> Self {
        match decided {
            Verdict { truth: Truth::Always, same: true } => return self,
            Verdict { truth: Truth::Never, same: true } => return other,
            _ => {}
        }
        let errors = self.error + other.error;
        let bound =
            if decided.same { self.bound.either(&other.bound) } else { self.bound.nearly_either(&other.bound, errors) };
        Self::result(&[self, other], images, self.error.max(other.error), bound)
    }
}

/// A rounding error in the measure of the specification.
#[derive(Clone, Copy, Debug)]
pub struct Ulps {
    /// Roundings of the result or of any of the inputs.
    pub first_order: f64,
    /// What is left, in the unit of the result.
    pub rest: f64,
}

impl Real for Rounded {
    type Mask = Verdict;
    fn lit(value: f64) -> Self {
        Self::constant(value)
    }
    fn pi() -> Self {
        let bound = Bound { value: ROUNDING, ..Bound::CONSTANT };
        Self::result(&[], [Interval::pi(); 2], Upper(f64::EPSILON), bound)
    }
    fn sqrt(self) -> Self {
        if self.computed.lo < 0.0 {
            return Self::lost(self.trouble.unwrap_or(Trouble::Domain));
        }
        let images = self.images(Interval::sqrt);
        let exact = images[0];
        let bound = if self.bound.inputs == Upper::ZERO && self.bound.value < Upper(0.25) {
            // 1 - sqrt(1 - x) <= x/2 + x^2/2
            let value = Upper(0.5) * self.bound.value;
            let rest = self.bound.rest.sqrt().min(self.bound.rest / smallest(exact));
            Bound { rest, ..self.bound.times(Upper::ONE + Upper(2.0) * value) }.halved(rest)
        } else {
            let relative = self.error / smallest(self.exact);
            let near = relative < Upper(0.25);
            let factor = if near { Upper::ONE + relative } else { Upper(2.0) };
            let rest = self.bound.rest.sqrt().min(self.bound.rest / smallest(exact));
            self.bound.times(factor).halved(rest)
        };
        let error = self.error.sqrt().min(self.error / smallest(exact));
        let bound = Bound { signs: self.bound.signs, ..bound }.rounded(ROUNDING);
        Self::result(&[self], images, Self::error_rounded(error, exact, ROUNDING), bound)
    }
    fn exp(self) -> Self {
        let images = self.images(Interval::exp);
        let exact = images[0];
        if self.error > Upper(1e-3) || !exact.hi.is_finite() {
            return Self::lost(self.trouble.unwrap_or(Trouble::Overflow));
        }
        // e^x - 1 <= x (1 + x) below one
        let (factor, size) = (Upper::ONE + self.error, Upper(largest(self.exact)));
        let ratios = [smallest(self.exact), largest(self.exact)];
        let mut bound = self.bound.times(factor).through(size, Upper(exact.hi), ratios);
        bound.signs = self.bound.signs.through(Sign::NotNegative);
        self.smooth(images, Upper(exact.hi) * factor, bound, ONE_ULP)
    }
    fn ln(self) -> Self {
        let (lo, relative) = (smallest(self.exact), self.error / smallest(self.exact));
        if self.computed.lo <= 0.0 || relative > Upper(0.25) {
            return Self::lost(self.trouble.unwrap_or(Trouble::Domain));
        }
        let images = self.images(Interval::ln);
        let exact = images[0];
        // ln(1 + x) is within x (1 + 2 |x|) of zero for x above -1/4
        let factor = Upper::ONE + Upper(2.0) * relative;
        let by = Upper::ONE / smallest(exact);
        let ratios = [1.0 / largest(exact), by.0];
        let mut bound = self.bound.times(factor).through(by, Upper::ONE / lo, ratios);
        bound.signs = self.bound.signs.through(Sign::NotNegative);
        self.smooth(images, factor / lo, bound, ONE_ULP)
    }
    fn sin(self) -> Self {
        self.wave(self.images(Interval::sin), self.computed.cos())
    }
    fn cos(self) -> Self {
        self.wave(self.images(Interval::cos), -self.computed.sin())
    }
    fn acos(self) -> Self {
        let computed = self.computed;
        if computed.lo < -1.0 || computed.hi > 1.0 {
            return Self::lost(self.trouble.unwrap_or(Trouble::Domain));
        }
        let images = self.images(Interval::acos);
        let exact = images[0];
        let steepest = (Interval::point(1.0) - computed.squared()).sqrt().lo;
        let slope = Upper::ONE / steepest;
        // near the ends it is a root: acos(1 - x) = sqrt(2 x) (1 + O(x)), and at most pi/2 sqrt(x)
        let error = (slope * self.error).min(Upper(1.6) * (Upper(2.0) * self.error).sqrt());
        let bound =
            Bound { signs: self.bound.signs.through(Sign::NotPositive), ..self.bound.unknown(error, smallest(exact)) };
        let bound = Bound { least: 0.0, most: Upper::UNKNOWN, ..bound }.rounded(ONE_ULP);
        Self::result(&[self], images, Self::error_rounded(error, exact, ONE_ULP), bound)
    }
    fn tanh(self) -> Self {
        if self.error > Upper(1e-3) {
            return Self::lost(self.trouble.unwrap_or(Trouble::Overflow));
        }
        let images = self.images(Interval::tanh);

        // the slope changes by less than e^(2 x) over x, and is at most tanh(x)/x
        let (factor, twice) = (Upper::ONE + Upper(4.0) * self.error, 2.0 * largest(self.exact));
        let shrinks = if twice < 300.0 && twice > 0.0 { (twice / libm::sinh(twice)) * (1.0 - 1e-12) } else { 0.0 };
        let mut bound = self.bound.times(factor).through(Upper::ONE, Upper::ONE, [shrinks.min(1.0), 1.0]);
        bound.signs = self.bound.signs.through(Sign::NotNegative);
        self.smooth(images, Upper::ONE, bound, TANH)
    }
    fn floor(self) -> Self {
        let images = self.images(Interval::floor);
        let [exact, computed] = images;
        let step = if self.error < Upper::ONE { 1.0 } else { f64::INFINITY };
        let error = if self.error == Upper::ZERO { 0.0 } else { step.min(computed.hi - computed.lo) };
        Self::result(&[self], images, Upper(error), Bound::CONSTANT.unknown(Upper(error), smallest(exact)))
    }
    fn entry(list: &[f64], place: Self) -> Self {
        let Interval { lo, hi } = place.computed;
        let inside = lo >= 0.0 && hi < list.len() as f64;
        let all = Interval { lo: 0.0, hi: list.len() as f64 - 1.0 };
        let exact = Interval::entry(list, if inside { place.computed } else { all });
        let error = if place.error == Upper::ZERO { 0.0 } else { (exact.hi - exact.lo).next_up() };
        Self::result(&[place], [exact; 2], Upper(error), Bound::CONSTANT.unknown(Upper(error), smallest(exact)))
    }
    fn lt(self, other: Self) -> Verdict {
        Verdict::of(self, other, Interval::lt)
    }
    fn le(self, other: Self) -> Verdict {
        Verdict::of(self, other, Interval::le)
    }
    fn select(mask: Verdict, yes: Self, no: Self) -> Self {
        match mask {
            Verdict { truth: Truth::Always, same: true } => return yes,
            Verdict { truth: Truth::Never, same: true } => return no,
            _ => {}
        }
        let exact = Interval::select(mask.truth, yes.exact, no.exact);
        let of_double = if mask.same { mask.truth } else { Truth::Sometimes };
        let images = [exact, Interval::select(of_double, yes.computed, no.computed)];
        let (mut error, mut bound) = (yes.error.max(no.error), yes.bound.either(&no.bound));
        if !mask.same {
            let apart = Upper((yes.exact.hi - no.exact.lo).max(no.exact.hi - yes.exact.lo).max(0.0).next_up());
            error = error + apart;
            bound.rest = bound.rest.max(error);
        }
        Self::result(&[yes, no], images, error, bound)
    }
    fn abs(self) -> Self {
        let bound = Bound { signs: self.bound.signs.size(), ..self.bound };
        Self::result(&[self], self.images(Interval::abs), self.error, bound)
    }
    fn min(self, other: Self) -> Self {
        self.extreme(other, self.images_of(other, Interval::min), self.lt(other))
    }
    fn max(self, other: Self) -> Self {
        self.extreme(other, self.images_of(other, Interval::max), self.gt(other))
    }
    fn squared(self) -> Self {
        let images = self.images(Interval::squared);
        let (exact, size) = (images[0], largest(self.exact));
        let error = (Upper(2.0 * size) + self.error) * self.error;
        let bound = self.bound.square(size, self.error).rounded(ROUNDING);
        Self::result(&[self], images, Self::error_rounded(error, exact, ROUNDING), bound)
    }
}

impl Verdict {
    fn of(a: Rounded, b: Rounded, compare: impl Fn(Interval, Interval) -> Truth) -> Self {
        let truth = compare(a.exact, b.exact);
        let exact = a.error == Upper::ZERO && b.error == Upper::ZERO;
        let lost = a.trouble.or(b.trouble).is_some();
        let decided = truth != Truth::Sometimes && compare(a.computed, b.computed) == truth;
        Self { truth: if lost { Truth::Sometimes } else { truth }, same: !lost && (exact || decided) }
    }
}
impl BitAnd for Verdict {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        let truth = self.truth & other.truth;
        let one_settles = |one: Self| truth == Truth::Never && one.same && one.truth == Truth::Never;
        Self { truth, same: self.same && other.same || one_settles(self) || one_settles(other) }
    }
}
impl BitOr for Verdict {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        !(!self & !other)
    }
}
impl Not for Verdict {
    type Output = Self;
    fn not(self) -> Self {
        Self { truth: !self.truth, ..self }
    }
}
