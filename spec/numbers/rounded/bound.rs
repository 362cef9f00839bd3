//! A bound of a rounding error in the terms in which errors of equations are stated: shares of the number and of what the
//! inputs, each rounded once, would do to it.

use super::signs::{Sign, Signs};
use super::upper::Upper;
use crate::numbers::Interval;

/// Half a unit of the last place of one: the relative error of one rounding.
pub(super) const ROUNDING: Upper = Upper(0.5 * f64::EPSILON);
/// The absolute error of one operation whose result is subnormal; the exponential ends with two products.
pub(super) const UNDERFLOW: Upper = Upper(f64::from_bits(4));

/// The error of a number `v` is at most `value |v| + inputs S + rest` everywhere in a box, where `S = sum_k |x_k dv/dx_k|`
/// over the inputs. The sizes are those of the exact number.
///
/// Two parts of a formula add their errors, and their `S` too, unless an input that both contain changes them in opposite
/// directions; therefore the sign of each `x_k dv/dx_k` is kept. The rest has what is of second order, and underflow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    pub(super) value: Upper,
    pub(super) inputs: Upper,
    pub(super) rest: Upper,
    /// `S >= least |v|`.
    pub(super) least: f64,
    /// `S <= most |v|`.
    pub(super) most: Upper,
    pub(super) signs: Signs,
}

impl Bound {
    /// A number that does not depend on the inputs and has no error.
    pub(super) const CONSTANT: Self = Self {
        value: Upper::ZERO,
        inputs: Upper::ZERO,
        rest: Upper::ZERO,
        least: 0.0,
        most: Upper::ZERO,
        signs: Signs::NONE,
    };
    /// Input number `k`, whose values are these.
    pub(super) fn input(k: usize, x: Interval) -> Self {
        Self { least: 1.0, most: Upper::ONE, signs: Signs::input(k, x), ..Self::CONSTANT }
    }
    /// Only this much is known: an error, of a number not smaller than `smallest` in size.
    pub(super) fn unknown(self, error: Upper, smallest: f64) -> Self {
        let relative = error / smallest;
        let (value, rest) = if relative.is_known() { (relative, Upper::ZERO) } else { (Upper::ZERO, error) };
        Self { value, inputs: Upper::ZERO, rest, ..self }
    }
    /// The largest error of a number of at most this size.
    pub(super) fn error(&self, largest: f64) -> Upper {
        (self.value + self.inputs * self.most) * Upper(largest) + self.rest
    }
    /// The largest relative error of a number of at least this size.
    pub(super) fn relative(&self, smallest: f64) -> Upper {
        self.value + self.inputs * self.most + self.rest / smallest
    }
    pub(super) fn is_known(&self) -> bool {
        self.value.is_known() && self.inputs.is_known() && self.rest.is_known()
    }
    /// As a share of the number alone.
    fn of_value(&self) -> Upper {
        self.value + self.inputs * self.most
    }
    /// Each error times this factor.
    pub(super) fn times(self, factor: Upper) -> Self {
        Self { value: self.value * factor, inputs: self.inputs * factor, rest: self.rest * factor, ..self }
    }
    /// After a rounding by a relative error, which may underflow.
    pub(super) fn rounded(self, by: Upper) -> Self {
        let more = Upper::ONE + by;
        let (value, inputs) = (self.value * more + by, self.inputs * more);
        Self { value, inputs, rest: self.rest * more + UNDERFLOW, ..self }
    }
    /// Of a product of `a` and `b`. The rest is that of the product.
    pub(super) fn product(&self, a: Interval, other: &Self, b: Interval, rest: Upper) -> Self {
        let (signs, together) = self.signs.product(a, other.signs, b);
        let apart = (self.least - other.most.0).max(other.least - self.most.0);
        let (value, inputs, least) = if together {
            (self.value + other.value, self.inputs.max(other.inputs), self.least + other.least)
        } else {
            (self.of_value() + other.of_value(), Upper::ZERO, apart)
        };
        let least = (least * (1.0 - 1e-15)).max(0.0);
        Self { value, inputs, rest, least, most: self.most + other.most, signs }
    }
    /// Of the number times itself.
    pub(super) fn square(self, largest: f64, error: Upper) -> Self {
        let (two, rest) = (Upper(2.0), Upper(2.0 * largest) * self.rest + error * error);
        Self {
            value: two * self.value,
            rest,
            least: 2.0 * self.least,
            most: two * self.most,
            signs: self.signs.square(),
            ..self
        }
    }
    /// Of a sum of `a` and `b`, whose value is in `sum`.
    pub(super) fn sum(&self, a: Interval, other: &Self, b: Interval, sum: Interval) -> Self {
        let (signs, together) = self.signs.sum(other.signs, sum);
        let same_sign = Sign::of(a) != Sign::Either && Sign::of(a) == Sign::of(b);
        let times_sum = |part: Interval| {
            let ratio = Upper(largest(part)) / smallest(sum);
            if same_sign { ratio.min(Upper::ONE) } else { ratio }
        };
        let (share_a, share_b) = (times_sum(a), times_sum(b));
        let (value, inputs) = match (together, same_sign) {
            (true, true) => (self.value.max(other.value), self.inputs.max(other.inputs)),
            (true, false) => {
                let (value_a, inputs_a) = self.part_of_a_sum(share_a);
                let (value_b, inputs_b) = other.part_of_a_sum(share_b);
                (value_a + value_b, inputs_a.max(inputs_b))
            }
            (false, true) => (self.of_value().max(other.of_value()), Upper::ZERO),
            (false, false) => (self.of_value() * share_a + other.of_value() * share_b, Upper::ZERO),
        };
        let of_sum = |part: Interval| if largest(sum) > 0.0 { smallest(part) / largest(sum) } else { 0.0 };
        let by_parts = (self.least * of_sum(a) + other.least * of_sum(b)) * (1.0 - 1e-15);
        let least = if together { by_parts.max(self.least.min(other.least)) } else { 0.0 };
        let apart = self.most * share_a + other.most * share_b;
        let most = if same_sign { apart.min(self.most.max(other.most)) } else { apart };
        Self { value, inputs, rest: self.rest + other.rest, least, most, signs }
    }
    /// The error of a part of a sum: a share of the sum, or of the change of that part by its inputs, whichever is smaller.
    fn part_of_a_sum(&self, share: Upper) -> (Upper, Upper) {
        let (of_sum, of_inputs) = (self.value * share, self.value / self.least);
        if of_sum <= of_inputs { (of_sum, self.inputs) } else { (Upper::ZERO, self.inputs + of_inputs) }
    }

    /// Of either of two numbers, whichever is taken.
    pub(super) fn either(&self, other: &Self) -> Self {
        Self {
            value: self.value.max(other.value),
            inputs: self.inputs.max(other.inputs),
            rest: self.rest.max(other.rest),
            least: self.least.min(other.least),
            most: self.most.max(other.most),
            signs: self.signs.either(other.signs),
        }
    }
    /// With nothing known of its inputs.
    pub(super) fn free(self) -> Self {
        Self { least: 0.0, most: Upper::UNKNOWN, signs: Signs::UNKNOWN, ..self }
    }
    /// Of a root, whose relative errors are half of these.
    pub(super) fn halved(self, rest: Upper) -> Self {
        let half = Upper(0.5);
        Self { value: half * self.value, rest, least: 0.5 * self.least, most: half * self.most, ..self }
    }
    /// Of the larger or smaller of two numbers, of which `f64` may take the other one if they are close.
    pub(super) fn nearly_either(&self, other: &Self, errors: Upper) -> Self {
        let alone = |bound: &Self| Self { value: bound.of_value(), inputs: Upper::ZERO, ..*bound };
        let either = alone(self).either(&alone(other));
        Self { rest: either.rest + either.value * errors, ..either }
    }

    /// Of a function of one number: the share of the number becomes `value_by` of the result, or that of the inputs by
    /// `value_by / least`, whichever is known; `S / |v|` is multiplied by numbers from `shrinks` to `grows`.
    pub(super) fn through(self, value_by: Upper, rest_by: Upper, [shrinks, grows]: [f64; 2]) -> Self {
        let (of_value, of_inputs) = (self.value * value_by, self.value / self.least);
        let (value, inputs) =
            if of_value <= of_inputs { (of_value, self.inputs) } else { (Upper::ZERO, self.inputs + of_inputs) };
        let (least, most) = ((self.least * shrinks * (1.0 - 1e-15)).max(0.0), self.most * Upper(grows));
        Self { value, inputs, rest: self.rest * rest_by, least, most, ..self }
    }
}

/// The largest size of a number in an interval.
pub(super) fn largest(v: Interval) -> f64 {
    v.lo.abs().max(v.hi.abs())
}
/// The smallest size of a number in an interval.
pub(super) fn smallest(v: Interval) -> f64 {
    if v.lo <= 0.0 && v.hi >= 0.0 { 0.0 } else { v.lo.abs().min(v.hi.abs()) }
}
