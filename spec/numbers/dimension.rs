//! A number that is only its physical dimension: evaluating an equation with it checks the unit of every term.

use crate::Real;
use crate::unit::{Exponents, WHOLE};
use num_traits::{One, Zero};
use std::fmt;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The dimension of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Of a literal zero, which is a zero of every dimension.
    Any,
    /// Of a proper quantity.
    Of(Exponents),
    /// Of nothing: an operation that has no meaning was tried.
    Wrong(Fault),
}

/// The first operation that had no meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    operation: &'static str,
    left: Exponents,
    right: Exponents,
}

/// The dimension of a ratio, an angle, a count.
pub const DIMENSIONLESS: Dimension = Dimension::Of([0; 3]);

impl Dimension {
    /// The dimension `kg^kg m^m s^s`.
    pub fn new(kg: i16, m: i16, s: i16) -> Self {
        Self::Of([kg * WHOLE, m * WHOLE, s * WHOLE])
    }
    /// The dimension raised to `numerator / denominator`, or nothing when that power cannot be represented.
    pub fn power(self, numerator: i16, denominator: i16) -> Option<Self> {
        match self {
            Self::Of(e) if e.iter().all(|x| (x * numerator) % denominator == 0) => {
                Some(Self::Of(e.map(|x| x * numerator / denominator)))
            }
            _ => None,
        }
    }
    fn combine(self, other: Self, exponents: impl Fn(i16, i16) -> i16) -> Self {
        match (self, other) {
            (Self::Wrong(fault), _) | (_, Self::Wrong(fault)) => Self::Wrong(fault),
            (Self::Any, _) | (_, Self::Any) => Self::Any,
            (Self::Of(a), Self::Of(b)) => Self::Of(std::array::from_fn(|k| exponents(a[k], b[k]))),
        }
    }
    fn same(self, other: Self, operation: &'static str) -> Self {
        match (self, other) {
            (Self::Wrong(fault), _) | (_, Self::Wrong(fault)) => Self::Wrong(fault),
            (Self::Any, that) | (that, Self::Any) => that,
            (Self::Of(left), Self::Of(right)) if left == right => self,
            (Self::Of(left), Self::Of(right)) => Self::Wrong(Fault { operation, left, right }),
        }
    }
    fn dimensionless(self, operation: &'static str) -> Self {
        match self {
            Self::Any => DIMENSIONLESS,
            _ => self.same(DIMENSIONLESS, operation),
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Any => write!(f, "any dimension"),
            Self::Of(exponents) => write_exponents(f, *exponents),
            Self::Wrong(fault) => {
                write!(f, "{} of ", fault.operation)?;
                write_exponents(f, fault.left)?;
                write!(f, " and ")?;
                write_exponents(f, fault.right)
            }
        }
    }
}

fn write_exponents(f: &mut fmt::Formatter, exponents: Exponents) -> fmt::Result {
    let mut space = "";
    for (name, quarters) in ["kg", "m", "s"].into_iter().zip(exponents) {
        match (quarters, quarters % WHOLE) {
            (0, _) => continue,
            (WHOLE, _) => write!(f, "{space}{name}")?,
            (_, 0) => write!(f, "{space}{name}^{}", quarters / WHOLE)?,
            (_, 2 | -2) => write!(f, "{space}{name}^({}/2)", quarters / 2)?,
            _ => write!(f, "{space}{name}^({quarters}/4)")?,
        }
        space = " ";
    }
    if space.is_empty() { write!(f, "1") } else { Ok(()) }
}

/// A comparison of dimensions is neither true nor false; it can only be wrong.
#[derive(Clone, Copy, Debug)]
pub struct Compared(Dimension);

impl Real for Dimension {
    type Mask = Compared;
    fn lit(_: f64) -> Self {
        DIMENSIONLESS
    }
    fn pi() -> Self {
        DIMENSIONLESS
    }
    fn sqrt(self) -> Self {
        match self {
            Self::Of(e) => {
                self.power(1, 2).unwrap_or(Self::Wrong(Fault { operation: "square root", left: e, right: e }))
            }
            _ => self,
        }
    }
    fn exp(self) -> Self {
        self.dimensionless("exponential")
    }
    fn ln(self) -> Self {
        self.dimensionless("logarithm")
    }
    fn sin(self) -> Self {
        self.dimensionless("sine")
    }
    fn cos(self) -> Self {
        self.dimensionless("cosine")
    }
    fn acos(self) -> Self {
        self.dimensionless("inverse cosine")
    }
    fn tanh(self) -> Self {
        self.dimensionless("hyperbolic tangent")
    }
    fn floor(self) -> Self {
        self.dimensionless("floor")
    }
    fn entry(_: &[f64], place: Self) -> Self {
        place.dimensionless("entry")
    }
    fn lt(self, other: Self) -> Compared {
        Compared(self.same(other, "comparison"))
    }
    fn le(self, other: Self) -> Compared {
        self.lt(other)
    }
    fn select(mask: Compared, yes: Self, no: Self) -> Self {
        match mask.0 {
            Self::Wrong(_) => mask.0,
            _ => yes.same(no, "choice"),
        }
    }
}

impl Zero for Dimension {
    fn zero() -> Self {
        Self::Any
    }
    fn is_zero(&self) -> bool {
        *self == Self::Any
    }
}
impl One for Dimension {
    fn one() -> Self {
        DIMENSIONLESS
    }
}
impl Add for Dimension {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.same(other, "sum")
    }
}
impl Sub for Dimension {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.same(other, "difference")
    }
}
impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, |a, b| a + b)
    }
}
impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.combine(other, |a, b| a - b)
    }
}
impl Neg for Dimension {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}
impl BitAnd for Compared {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        if matches!(self.0, Dimension::Wrong(_)) { self } else { other }
    }
}
impl BitOr for Compared {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        self.bitand(other)
    }
}
impl Not for Compared {
    type Output = Self;
    fn not(self) -> Self {
        self
    }
}

#[cfg(test)]
mod laws {
    use super::*;

    const LENGTH: Dimension = Dimension::Of([0, WHOLE, 0]);
    const TIME: Dimension = Dimension::Of([0, 0, WHOLE]);

    fn wrong(dimension: Dimension) -> String {
        assert!(matches!(dimension, Dimension::Wrong(_)), "{dimension} was accepted");
        dimension.to_string()
    }

    #[test]
    fn products_and_quotients_add_exponents() {
        assert_eq!((LENGTH / TIME).squared(), Dimension::new(0, 2, -2));
        assert_eq!((LENGTH / TIME).squared().to_string(), "m^2 s^-2");
        assert_eq!(LENGTH / LENGTH, DIMENSIONLESS);
        let many = Dimension::new(3, -1, 1);
        assert_eq!(many, Dimension::Of([3 * WHOLE, -WHOLE, WHOLE]));
        assert_eq!((many.to_string(), Dimension::one().to_string()), ("kg^3 m^-1 s".into(), "1".into()));
    }

    #[test]
    fn powers_are_those_that_quarters_can_say() {
        let many = Dimension::new(2, 0, -1);
        assert_eq!(many.power(3, 2), Some(Dimension::Of([3 * WHOLE, 0, -WHOLE * 3 / 2])));
        assert_eq!(many.power(3, 2).map(|power| power.to_string()), Some("kg^3 s^(-3/2)".into()));
        assert_eq!(many.power(1, 4).map(|power| power.to_string()), Some("kg^(1/2) s^(-1/4)".into()));
        assert_eq!([many.power(1, 8), many.power(1, 3), Dimension::zero().power(1, 2)], [None; 3]);
    }

    #[test]
    fn roots_halve_exponents() {
        assert_eq!((LENGTH * LENGTH).sqrt(), LENGTH);
        assert_eq!(LENGTH.sqrt().to_string(), "m^(1/2)");
        assert_eq!(LENGTH.sqrt().squared(), LENGTH);
        assert!(wrong(LENGTH.sqrt().sqrt().sqrt()).starts_with("square root"));
    }

    #[test]
    fn unlike_quantities_are_neither_added_nor_compared_nor_chosen_between() {
        assert_eq!(wrong(LENGTH + TIME), "sum of m and s");
        assert_eq!(wrong(LENGTH - Dimension::one()), "difference of m and 1");
        let chosen = Dimension::select(LENGTH.lt(LENGTH), LENGTH, TIME);
        assert_eq!(wrong(chosen), "choice of m and s");
        let compared = Dimension::select(!(LENGTH.lt(LENGTH) & LENGTH.le(TIME)), LENGTH, LENGTH);
        assert_eq!(wrong(compared), "comparison of m and s");
        assert_eq!(wrong(LENGTH.max(TIME)), "comparison of s and m");
    }

    #[test]
    fn functions_want_pure_numbers() {
        for f in [Real::exp, Real::ln, Real::sin, Real::cos, Real::acos, Real::tanh, Real::floor] {
            wrong(f(LENGTH));
            assert_eq!(f(LENGTH / LENGTH), DIMENSIONLESS);
            assert_eq!(f(Dimension::zero()), DIMENSIONLESS);
        }
    }

    #[test]
    fn zero_has_every_dimension() {
        assert_eq!(LENGTH + Dimension::zero(), LENGTH);
        assert_eq!([Dimension::zero(), Dimension::one(), LENGTH].map(|number| number.is_zero()), [true, false, false]);
        assert_eq!(Dimension::select(LENGTH.ge(Dimension::zero()), Dimension::zero(), TIME), TIME);
    }

    #[test]
    fn the_first_fault_survives_all_that_follows() {
        let fault = LENGTH + TIME;
        assert_eq!((fault * LENGTH).sqrt() - TIME, fault);
        assert_eq!(Dimension::select(fault.lt(TIME), TIME, TIME), fault);
    }
}
