//! Three-vectors over [`Real`], written out by component, because the pair loop uses them and must be inlined completely.

use crate::Real;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector of space, in Cartesian components.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vec3<R>(pub [R; 3]);

/// A second-rank tensor, rows first.
pub type Tensor<R> = [Vec3<R>; 3];

impl<R: Real> Vec3<R> {
    /// The vector with the given components.
    #[inline(always)]
    pub fn new(x: R, y: R, z: R) -> Self {
        Self([x, y, z])
    }
    /// The null vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([R::zero(); 3])
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }
    /// Vector product.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }
    /// Euclidean length.
    #[inline(always)]
    pub fn norm(self) -> R {
        self.dot(self).sqrt()
    }
    /// The part of the vector normal to the unit vector `n`.
    #[inline(always)]
    pub fn perpendicular_to(self, n: Self) -> Self {
        self - n * self.dot(n)
    }
    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (yes.0, no.0);
        Self([R::select(mask, a, x), R::select(mask, b, y), R::select(mask, c, z)])
    }
    /// All nine products of components: the tensor with rows `self`.
    #[inline(always)]
    pub fn outer(self, other: Self) -> Tensor<R> {
        let [a, b, c] = self.0;
        [other * a, other * b, other * c]
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}
impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}
impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let [a, b, c] = self.0;
        Self([-a, -b, -c])
    }
}
impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        let [a, b, c] = self.0;
        Self([a * factor, b * factor, c * factor])
    }
}
