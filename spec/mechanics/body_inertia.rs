//! Inertia of a rigid aggregate.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use crate::equation::Equation;
use crate::mechanics::sphere::moment_of_inertia;
use crate::{Real, Tensor, Vec3, equation};

/// **Section 5.3**, unnumbered: contribution of a sphere to the inertia tensor of its aggregate.
///
/// ```math
/// \mathbf{I} = \frac{2}{5} m r^2 \, \mathbf{1} + m \left(x^2 \, \mathbf{1} - \mathbf{x} \mathbf{x}\right)
/// ```
///
/// # Reading
///
/// "Rigid aggregates": the parallel-axis theorem. The spheres of an aggregate hardly overlap, and overlaps are ignored. The sum over the spheres, about
/// the centre of mass, is the tensor of the aggregate; its eigenvalues are the principal moments.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass of the sphere |
/// | `r` | $r$ | m | > 0 | radius of the sphere |
/// | `x` | $\mathbf{x}$ | m (3) | any | its centre, from the centre of mass of the aggregate |
/// | → `inertia` | $\mathbf{I}$ | kg m^2 (9) | | inertia tensor about that centre of mass |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_kinetic_energy_of_a_turning_dumbbell_is_half_the_product_with_the_tensor`
/// * `a_sphere_at_the_centre_has_its_own_moment`
/// * `turning_the_place_turns_the_tensor`
#[inline(always)]
pub fn member_inertia<R: Real>(m: R, r: R, x: Vec3<R>) -> Tensor<R> {
    let own = moment_of_inertia(m, r);
    let [a, b, c] = x.0;
    let off = |u: R, v: R| -(m * u * v);
    [
        Vec3::new(own + m * (b * b + c * c), off(a, b), off(a, c)),
        Vec3::new(off(a, b), own + m * (a * a + c * c), off(b, c)),
        Vec3::new(off(a, c), off(b, c), own + m * (a * a + b * b)),
    ]
}

/// **Section 5.3**, unnumbered: contribution of a sphere to the angular momentum of its aggregate.
///
/// ```math
/// \mathbf{L} = m \, \mathbf{x} \times \mathbf{v} + \frac{2}{5} m r^2 \, \boldsymbol{\omega}
/// ```
///
/// # Reading
///
/// Spheres that become rigid while they move keep the sum of their angular momenta about the centre of mass, as they keep that of their momenta.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass of the sphere |
/// | `r` | $r$ | m | > 0 | radius of the sphere |
/// | `x` | $\mathbf{x}$ | m (3) | any | its centre, from the centre of mass of the aggregate |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | its velocity |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | its angular velocity |
/// | → `l` | $\mathbf{L}$ | kg m^2/s (3) | | angular momentum about that centre of mass |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_momentum_of_a_turning_body_is_the_product_with_the_tensor`
#[inline(always)]
pub fn member_momentum<R: Real>(m: R, r: R, x: Vec3<R>, v: Vec3<R>, omega: Vec3<R>) -> Vec3<R> {
    x.cross(v) * m + omega * moment_of_inertia(m, r)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/body_inertia.rs", "titania-inertia", [], member_inertia),
        equation!("mechanics/body_inertia.rs", "titania-angular-momentum", [], member_momentum),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }
    fn times(tensor: Tensor<f64>, v: Vec3<f64>) -> Vec3<f64> {
        Vec3(tensor.map(|row| row.dot(v)))
    }

    proptest! {
        #[test]
        fn the_momentum_of_a_turning_body_is_the_product_with_the_tensor(m in 0.1..2.0, r in 0.1..1.0, x in vector(), omega in vector()) {
            let l = member_momentum(m, r, x, omega.cross(x), omega);
            prop_assert!((l - times(member_inertia(m, r, x), omega)).norm() < 1e-13);
        }

        #[test]
        fn the_kinetic_energy_of_a_turning_dumbbell_is_half_the_product_with_the_tensor(
            x in vector(), omega in vector(), m in 0.1..2.0, ratio in 0.1..2.0, r in 0.1..1.0,
        ) {
            // masses m and ratio m, centre of mass at the origin
            let spheres = [(m, x), (ratio * m, x * (-1.0 / ratio))];
            let (mut of_tensor, mut of_motion) = (0.0, 0.0);
            for (m, x) in spheres {
                of_tensor += 0.5 * omega.dot(times(member_inertia(m, r, x), omega));
                let v = omega.cross(x);
                of_motion += 0.5 * m * v.dot(v) + 0.5 * moment_of_inertia(m, r) * omega.dot(omega);
            }
            prop_assert!((of_tensor - of_motion).abs() < 1e-12 * (1.0 + of_motion));
        }

        #[test]
        fn a_sphere_at_the_centre_has_its_own_moment(m in 0.1..2.0, r in 0.1..1.0, omega in vector()) {
            let l = times(member_inertia(m, r, Vec3::zero()), omega);
            prop_assert_eq!(l, omega * moment_of_inertia(m, r));
        }

        #[test]
        fn turning_the_place_turns_the_tensor(x in vector(), omega in vector(), m in 0.1..2.0) {
            // a quarter turn about the third axis
            let turn = |v: Vec3<f64>| Vec3::new(-v.0[1], v.0[0], v.0[2]);
            let (before, after) = (times(member_inertia(m, 0.3, x), omega), times(member_inertia(m, 0.3, turn(x)), turn(omega)));
            prop_assert!((turn(before) - after).norm() < 1e-14);
        }
    }
}
