//! Several `f64` in one vector: the number type of the engine's pair loop.
//!
//! Plain arrays and element-wise loops. The compiler turns them into whatever vector instructions it is allowed to use;
//! because no operation is fused or reordered, every lane has the bits of the same calculation in `f64`.

use crate::Real;
use num_traits::{One, Zero};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// `N` numbers, treated alike.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const N: usize>(pub [f64; N]);

/// `N` truths.
#[derive(Clone, Copy, Debug)]
pub struct LaneMask<const N: usize>([bool; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = f(*x);
        }
        Self(out)
    }
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = self.0;
        for k in 0..N {
            out[k] = f(out[k], other.0[k]);
        }
        Self(out)
    }
    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(f64, f64) -> bool) -> LaneMask<N> {
        let mut out = [false; N];
        for k in 0..N {
            out[k] = f(self.0[k], other.0[k]);
        }
        LaneMask(out)
    }
}

impl<const N: usize> LaneMask<N> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(bool, bool) -> bool) -> Self {
        let mut out = self.0;
        for k in 0..N {
            out[k] = f(out[k], other.0[k]);
        }
        Self(out)
    }
}

impl<const N: usize> Real for Lanes<N> {
    type Mask = LaneMask<N>;
    #[inline(always)]
    fn lit(value: f64) -> Self {
        Self([value; N])
    }
    #[inline(always)]
    fn pi() -> Self {
        Self::lit(f64::pi())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(Real::sqrt)
    }
    #[inline]
    fn exp(self) -> Self {
        self.map(Real::exp)
    }
    #[inline]
    fn ln(self) -> Self {
        self.map(Real::ln)
    }
    #[inline]
    fn sin(self) -> Self {
        self.map(Real::sin)
    }
    #[inline]
    fn cos(self) -> Self {
        self.map(Real::cos)
    }
    #[inline]
    fn acos(self) -> Self {
        self.map(Real::acos)
    }
    #[inline]
    fn tanh(self) -> Self {
        self.map(Real::tanh)
    }
    #[inline(always)]
    fn floor(self) -> Self {
        self.map(Real::floor)
    }
    #[inline(always)]
    fn entry(list: &[f64], place: Self) -> Self {
        place.map(|place| Real::entry(list, place))
    }
    #[inline(always)]
    fn entries<const M: usize>(list: &[[f64; M]], place: Self) -> [Self; M] {
        let rows = place.0.map(|place| f64::entries(list, place));
        std::array::from_fn(|k| Self(rows.map(|numbers| numbers[k])))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> LaneMask<N> {
        self.compare(other, |a, b| a < b)
    }
    #[inline(always)]
    fn le(self, other: Self) -> LaneMask<N> {
        self.compare(other, |a, b| a <= b)
    }
    #[inline(always)]
    fn select(mask: LaneMask<N>, yes: Self, no: Self) -> Self {
        let mut out = [0.0; N];
        for k in 0..N {
            out[k] = if mask.0[k] { yes.0[k] } else { no.0[k] };
        }
        Self(out)
    }
}

impl<const N: usize> Zero for Lanes<N> {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; N])
    }
    fn is_zero(&self) -> bool {
        self.0.iter().all(Zero::is_zero)
    }
}
impl<const N: usize> One for Lanes<N> {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; N])
    }
}

macro_rules! elementwise {
    ($($trait:ident $method:ident $op:tt),*) => {$(
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $op b)
            }
        }
    )*};
}
elementwise!(Add add +, Sub sub -, Mul mul *, Div div /);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}
impl<const N: usize> BitAnd for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }
}
impl<const N: usize> BitOr for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }
}
impl<const N: usize> Not for LaneMask<N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(|a| !a))
    }
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn lanes_are_compared_one_by_one() {
        let (a, b) = (Lanes([1.0, 2.0, 3.0, f64::NAN]), Lanes([2.0, 2.0, 2.0, 2.0]));
        let ones = |mask| Lanes::select(mask, Lanes::one(), Lanes::zero()).0;
        assert_eq!([ones(a.lt(b)), ones(a.le(b))], [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]]);
        assert_eq!([ones(a.gt(b)), ones(a.ge(b))], [[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 1.0, 0.0]]);
    }
}
