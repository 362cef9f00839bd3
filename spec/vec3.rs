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

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    /// Whole components, so that every result is exact.
    fn whole() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-99..100i32).prop_map(|v| Vec3(v.map(f64::from)))
    }

    proptest! {
        #[test]
        fn products_of_vectors_obey_the_identity_of_lagrange(a in whole(), b in whole()) {
            let (dot, cross) = (a.dot(b), a.cross(b));
            prop_assert_eq!(cross.dot(cross) + dot * dot, a.dot(a) * b.dot(b));
            prop_assert_eq!((cross.dot(a), cross.dot(b), b.cross(a)), (0.0, 0.0, -cross));
        }

        #[test]
        fn a_double_product_is_resolved_by_scalar_products(a in whole(), b in whole(), c in whole()) {
            prop_assert_eq!(a.cross(b.cross(c)), b * a.dot(c) - c * a.dot(b));
        }

        #[test]
        fn a_tensor_product_maps_a_vector_to_the_first_factor(a in whole(), b in whole(), c in whole()) {
            let image = Vec3(a.outer(b).map(|row| row.dot(c)));
            prop_assert_eq!(image, a * b.dot(c));
        }

        #[test]
        fn sums_and_multiples_are_linear(a in whole(), b in whole(), c in whole(), factor in -9..10i32) {
            let factor = f64::from(factor);
            prop_assert_eq!((a + b * factor).dot(c), a.dot(c) + factor * b.dot(c));
            prop_assert_eq!((a - b).dot(c) - a.dot(c), (-b).dot(c));
            prop_assert_eq!(a - a, Vec3::zero());
        }

        #[test]
        fn a_vector_is_its_parts_along_and_normal_to_a_direction(a in whole(), b in whole()) {
            prop_assume!(b.norm() > 0.0);
            let n = b * (1.0 / b.norm());
            let across = a.perpendicular_to(n);
            prop_assert!(across.dot(n).abs() < 1e-12 && (across + n * a.dot(n) - a).norm() < 1e-12);
        }
    }

    #[test]
    fn axes_are_right_handed_and_lengths_euclidean() {
        let (x, y, z) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
        assert_eq!((x.cross(y), y.cross(z), z.cross(x)), (z, x, y));
        assert_eq!(Vec3::new(3.0, 4.0, 12.0).norm(), 13.0);
        assert_eq!((Vec3::select(true, x, y), Vec3::select(false, x, y)), (x, y));
    }
}
