//! Newton's law for a sphere.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 1**, Section 2.1: acceleration of a particle.
///
/// ```math
/// m \ddot{\mathbf{x}} = \mathbf{f}
/// ```
///
/// # Reading
///
/// Solved for the acceleration. The force is the sum over all partners.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `force` | $\mathbf{f}$ | N (3) | any | force on the particle |
/// | `m` | $m$ | kg | > 0 | mass |
/// | → `a` | $\ddot{\mathbf{x}}$ | m/s^2 (3) | | acceleration |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_force_and_its_reaction_keep_the_momentum`
/// * `the_power_of_a_force_is_the_rate_of_the_kinetic_energy`
#[inline(always)]
pub fn acceleration<R: Real>(force: Vec3<R>, m: R) -> Vec3<R> {
    force * (R::one() / m)
}

/// **Eq. 2**, Section 2.1: angular acceleration of a particle.
///
/// ```math
/// I \ddot{\boldsymbol{\theta}} = \boldsymbol{\tau}
/// ```
///
/// # Reading
///
/// A sphere has the same moment of inertia about every axis, so there is no gyroscopic term, and no force depends on its
/// orientation: the angular velocity is all that needs to be integrated. The moment of inertia is that of
/// [`primary_particle`](super::primary_particle).
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `torque` | $\boldsymbol{\tau}$ | N m (3) | any | torque on the particle about its centre |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | → `alpha` | $\ddot{\boldsymbol{\theta}}$ | rad/s^2 (3) | | angular acceleration |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_torque_turns_a_hollow_sphere_more_slowly`
/// * `the_power_of_a_torque_is_the_rate_of_the_kinetic_energy`
#[inline(always)]
pub fn angular_acceleration<R: Real>(torque: Vec3<R>, i: R) -> Vec3<R> {
    torque * (R::one() / i)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/newton.rs", "soot-1", ["1"], acceleration),
        equation!("mechanics/newton.rs", "soot-2", ["2"], angular_acceleration),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::kinetic_energy::translational_energy;
    use crate::mechanics::primary_particle::{hollow_inertia, solid_inertia};
    use crate::mechanics::samples::vector;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_force_and_its_reaction_keep_the_momentum(f in vector(), m_i in 0.1..10.0, m_j in 0.1..10.0) {
            prop_assert!((acceleration(f, m_i) * m_i + acceleration(-f, m_j) * m_j).norm() < 1e-15);
        }

        #[test]
        fn the_power_of_a_force_is_the_rate_of_the_kinetic_energy(f in vector(), v in vector(), m in 0.1..10.0) {
            let motion = |f: [f64; 3], v: [f64; 3]| Vec3([0, 1, 2].map(|k| Dual { value: v[k], slope: acceleration(Vec3(f), m).0[k] }));
            let energy = translational_energy(Dual::constant(m), motion(f.0, v.0));
            prop_assert!((energy.slope - f.dot(v)).abs() < 1e-14);
        }

        #[test]
        fn the_power_of_a_torque_is_the_rate_of_the_kinetic_energy(torque in vector(), omega in vector(), i in 0.1..10.0) {
            let motion = |torque: [f64; 3], omega: [f64; 3]| {
                Vec3([0, 1, 2].map(|k| Dual { value: omega[k], slope: angular_acceleration(Vec3(torque), i).0[k] }))
            };
            let energy = translational_energy(Dual::constant(i), motion(torque.0, omega.0));
            prop_assert!((energy.slope - torque.dot(omega)).abs() < 1e-14);
        }

        #[test]
        fn a_torque_turns_a_hollow_sphere_more_slowly(torque in vector(), m in 0.1..10.0, r in 0.1..10.0) {
            let (solid, hollow) = (angular_acceleration(torque, solid_inertia(m, r)), angular_acceleration(torque, hollow_inertia(m, r)));
            prop_assert!((solid * 0.6 - hollow).norm() <= 1e-14 * solid.norm());
        }
    }
}
