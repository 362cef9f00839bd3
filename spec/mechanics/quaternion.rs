//! Orientations: their product, the rotation between two of them, and the displacement of a point by it.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Product of two quaternions: one rotation after another.
///
/// ```math
/// (a_0, \mathbf{a}) (b_0, \mathbf{b}) = \left(a_0 b_0 - \mathbf{a} \cdot \mathbf{b}, \; a_0 \mathbf{b} + b_0 \mathbf{a} + \mathbf{a} \times \mathbf{b}\right)
/// ```
///
/// # Reading
///
/// The rotation of $b$ comes first. The inverse of a unit quaternion has the opposite vector part.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_0` | $a_0$ | 1 | any | scalar part of the left factor |
/// | `a` | $\mathbf{a}$ | 1 (3) | any | its vector part |
/// | `b_0` | $b_0$ | 1 | any | scalar part of the right factor |
/// | `b` | $\mathbf{b}$ | 1 (3) | any | its vector part |
/// | → `scalar` | $q_0$ | 1 |  | scalar part of the product |
/// | → `vector` | $\mathbf{q}$ | 1 (3) |  | vector part of the product |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_product_is_one_rotation_after_the_other`
/// * `the_length_of_the_product_is_the_product_of_the_lengths`
#[inline(always)]
pub fn product<R: Real>(a_0: R, a: Vec3<R>, b_0: R, b: Vec3<R>) -> (R, Vec3<R>) {
    (a_0 * b_0 - a.dot(b), b * a_0 + a * b_0 + a.cross(b))
}

/// The rotation vector between two nearly equal orientations.
///
/// ```math
/// \boldsymbol{\theta} = 2 \operatorname{sgn}(q_0) \, \mathbf{q}, \quad (q_0, \mathbf{q}) = (b_0, \mathbf{b}) (a_0, -\mathbf{a})
/// ```
///
/// # Reading
///
/// Along the axis, with the angle as length up to its third power: $2 \sin(\theta / 2)$. Both signs of a quaternion are the same orientation; the shorter way is taken.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_0` | $a_0$ | 1 | any | scalar part of the orientation before |
/// | `a` | $\mathbf{a}$ | 1 (3) | any | its vector part |
/// | `b_0` | $b_0$ | 1 | any | scalar part of the orientation after |
/// | `b` | $\mathbf{b}$ | 1 (3) | any | its vector part |
/// | → `theta` | $\boldsymbol{\theta}$ | rad (3) |  | rotation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_small_rotation_is_found_again_whatever_the_sign`
/// * `half_a_turn_goes_the_way_of_the_later_orientation`
#[inline(always)]
pub fn rotation_vector<R: Real>(a_0: R, a: Vec3<R>, b_0: R, b: Vec3<R>) -> Vec3<R> {
    let (scalar, vector) = product(b_0, b, a_0, -a);
    vector * R::select(scalar.lt(R::zero()), R::lit(-2.0), R::lit(2.0))
}

/// Largest displacement of a point of a body that has turned about its centre of mass.
///
/// ```math
/// d = 2 R \, |\mathbf{q}|, \quad (q_0, \mathbf{q}) = (b_0, \mathbf{b}) (a_0, -\mathbf{a})
/// ```
///
/// # Reading
///
/// A rotation by $\theta$ displaces a point at a distance $R$ from the axis by $2 R \sin(\theta / 2)$, and one that is nearer by less.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `b_0` | $b_0$ | 1 | any | scalar part of the orientation after |
/// | `b` | $\mathbf{b}$ | 1 (3) | any | its vector part |
/// | `a_0` | $a_0$ | 1 | any | scalar part of the orientation before |
/// | `a` | $\mathbf{a}$ | 1 (3) | any | its vector part |
/// | `extent` | $R$ | m | >= 0 | distance of the farthest point from the centre of mass |
/// | → `d` | $d$ | m |  | displacement |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `no_point_has_been_displaced_by_more_and_one_across_the_axis_by_as_much`
#[inline(always)]
pub fn largest_displacement<R: Real>(b_0: R, b: Vec3<R>, a_0: R, a: Vec3<R>, extent: R) -> R {
    let between = b * a_0 - a * b_0 - b.cross(a);
    R::lit(2.0) * between.norm() * extent
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/quaternion.rs", "mechanics-quaternion-product", [], product),
        equation!("mechanics/quaternion.rs", "mechanics-rotation-vector", [], rotation_vector),
        equation!("mechanics/quaternion.rs", "mechanics-turned-displacement", [], largest_displacement),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::rotation::to_space;
    use crate::mechanics::samples::{unit, vector};
    use proptest::prelude::*;

    fn about(axis: Vec3<f64>, angle: f64) -> (f64, Vec3<f64>) {
        ((0.5 * angle).cos(), axis * (0.5 * angle).sin())
    }

    proptest! {
        #[test]
        fn the_product_is_one_rotation_after_the_other(e in unit(), f in unit(), alpha in -3.0..3.0, beta in -3.0..3.0, x in vector()) {
            let ((a_0, a), (b_0, b)) = (about(e, alpha), about(f, beta));
            let (q_0, q) = product(a_0, a, b_0, b);
            prop_assert!((to_space(q_0, q, x) - to_space(a_0, a, to_space(b_0, b, x))).norm() < 1e-14);
        }

        #[test]
        fn the_length_of_the_product_is_the_product_of_the_lengths(a_0 in -1.0..1.0f64, a in vector(), b_0 in -1.0..1.0f64, b in vector()) {
            let square = |q_0: f64, q: Vec3<f64>| q_0 * q_0 + q.dot(q);
            let (q_0, q) = product(a_0, a, b_0, b);
            prop_assert!((square(q_0, q) - square(a_0, a) * square(b_0, b)).abs() < 1e-14);
            // with its conjugate it is the square of the length
            let (real, rest) = product(a_0, a, a_0, -a);
            prop_assert!((real - square(a_0, a)).abs() < 1e-14 && rest.norm() < 1e-14);
        }

        #[test]
        fn a_small_rotation_is_found_again_whatever_the_sign(e in unit(), alpha in -3.0..3.0, f in unit(), angle in -0.1..0.1f64) {
            let ((a_0, a), (t_0, t)) = (about(e, alpha), about(f, angle));
            let (b_0, b) = product(t_0, t, a_0, a);
            let expected = f * (2.0 * (0.5 * angle).sin());
            prop_assert!((rotation_vector(a_0, a, b_0, b) - expected).norm() < 1e-14);
            prop_assert!((rotation_vector(a_0, a, -b_0, -b) - expected).norm() < 1e-14);
            prop_assert!((expected - f * angle).norm() <= (angle * angle * angle / 24.0).abs() + 1e-15);
        }

        #[test]
        fn no_point_has_been_displaced_by_more_and_one_across_the_axis_by_as_much(e in unit(), alpha in -3.0..3.0, f in unit(), angle in -3.0..3.0f64, x in vector()) {
            let ((a_0, a), (t_0, t)) = (about(e, alpha), about(f, angle));
            let (b_0, b) = product(t_0, t, a_0, a);
            let way = |x: Vec3<f64>| (to_space(b_0, b, x) - to_space(a_0, a, x)).norm();
            prop_assert!(way(x) <= largest_displacement(b_0, b, a_0, a, x.norm()) + 1e-14);
            let across = to_space(a_0, -a, x.perpendicular_to(f));
            prop_assert!((way(across) - largest_displacement(b_0, b, a_0, a, across.norm())).abs() < 1e-14);
        }
    }

    #[test]
    fn half_a_turn_goes_the_way_of_the_later_orientation() {
        let (none, x) = (Vec3::zero(), Vec3::new(1.0, 0.0, 0.0));
        assert_eq!([rotation_vector(1.0, none, 0.0, x), rotation_vector(1.0, none, 0.0, -x)], [x * 2.0, x * -2.0]);
    }
}
