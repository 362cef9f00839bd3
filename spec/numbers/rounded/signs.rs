//! In which direction each input changes a number.

use crate::numbers::Interval;

/// What is known of the sign of a number over a box.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sign {
    NotNegative,
    NotPositive,
    Either,
}

impl Sign {
    pub(super) fn of(v: Interval) -> Self {
        match (v.lo >= 0.0, v.hi <= 0.0) {
            (true, _) => Self::NotNegative,
            (_, true) => Self::NotPositive,
            _ => Self::Either,
        }
    }
}

/// For each input `x_k` of a number `v` one bit; two that contradict each other are both true of an input on which `v` does not depend.
#[derive(Clone, Copy, Debug)]
pub(super) struct Signs {
    /// `w_k = x_k dv/dx_k >= 0`.
    rises: u128,
    /// `w_k <= 0`.
    falls: u128,
    /// `w_k v >= 0`: the size of `v` rises.
    along: u128,
    /// `w_k v <= 0`.
    against: u128,
}

impl Signs {
    /// Of a number that depends on no input.
    pub(super) const NONE: Self = Self { rises: !0, falls: !0, along: !0, against: !0 };

    /// Of a number of which nothing is known.
    pub(super) const UNKNOWN: Self = Self { rises: 0, falls: 0, along: 0, against: 0 };

    /// Of input number `k`, whose values are these.
    pub(super) fn input(k: usize, x: Interval) -> Self {
        let others = !(1 << k);
        Self { rises: others, falls: others, along: !0, against: others }.settled(x)
    }
    /// With what follows from the sign of the number.
    pub(super) fn settled(self, v: Interval) -> Self {
        let mut signs = self;
        match Sign::of(v) {
            Sign::NotNegative => {
                signs.along |= signs.rises;
                signs.against |= signs.falls;
            }
            Sign::NotPositive => {
                signs.along |= signs.falls;
                signs.against |= signs.rises;
            }
            Sign::Either => {}
        }
        if v.lo > 0.0 {
            signs.rises |= signs.along;
            signs.falls |= signs.against;
        } else if v.hi < 0.0 {
            signs.rises |= signs.against;
            signs.falls |= signs.along;
        }
        signs
    }
    /// Of a number whose slope with this one has a sign. How its size changes is not known.
    pub(super) fn through(self, slope: Sign) -> Self {
        let none = self.rises & self.falls;
        let (rises, falls) = match slope {
            Sign::NotNegative => (self.rises, self.falls),
            Sign::NotPositive => (self.falls, self.rises),
            Sign::Either => (none, none),
        };
        Self { rises, falls, along: none, against: none }
    }
    /// Of minus this number.
    pub(super) fn negated(self) -> Self {
        Self { rises: self.falls, falls: self.rises, ..self }
    }
    /// Of one over this number.
    pub(super) fn inverse(self, v: Interval) -> Self {
        let through = self.through(Sign::NotPositive);
        Self { along: self.against, against: self.along, ..through }.settled(v)
    }
    /// Of the size of this number.
    pub(super) fn size(self) -> Self {
        Self { rises: self.along, falls: self.against, ..self }
    }
    /// Of this number times itself.
    pub(super) fn square(self) -> Self {
        self.size()
    }
    /// Of a number that takes the values of either.
    pub(super) fn either(self, other: Self) -> Self {
        Self {
            rises: self.rises & other.rises,
            falls: self.falls & other.falls,
            along: self.along & other.along,
            against: self.against & other.against,
        }
    }
    /// The inputs on which the number does not depend.
    fn none(self) -> u128 {
        self.rises & self.falls
    }
    /// Of a sum, and whether no input changes the parts in opposite directions.
    pub(super) fn sum(self, other: Self, sum: Interval) -> (Self, bool) {
        let (rises, falls) = (self.rises & other.rises, self.falls & other.falls);
        let none = rises & falls;
        let together = rises | falls | self.none() | other.none();
        (Self { rises, falls, along: none, against: none }.settled(sum), together == !0)
    }
    /// Of a product of `a` and `b`, and whether no input changes the factors in opposite directions.
    pub(super) fn product(self, a: Interval, other: Self, b: Interval) -> (Self, bool) {
        let (along, against) = (self.along & other.along, self.against & other.against);
        let (of_a, of_b) = (self.through(Sign::of(b)), other.through(Sign::of(a)));
        let (rises, falls) = (of_a.rises & of_b.rises, of_a.falls & of_b.falls);
        let together = along | against | rises | falls | self.none() | other.none();
        (Self { rises, falls, along, against }, together == !0)
    }
}
