//! A spring in the contact plane of a pair that spins about its normal.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Not in the papers: a spring in the contact plane after the pair has spun about its normal for a step.
///
/// ```math
/// \boldsymbol{\xi} = \boldsymbol{\xi}' + \frac{\theta}{2} \, \mathbf{n} \times (\boldsymbol{\xi} + \boldsymbol{\xi}'), \quad
/// \theta = \frac{\boldsymbol{\omega}_i + \boldsymbol{\omega}_j}{2} \cdot \mathbf{n} \, \Delta t
/// ```
///
/// # Reading
///
/// The papers project a spring into the contact plane. It then follows the normal, but not a spin of the pair about it: the bodies turn, and the spring between them stays fixed in
/// space. A pair that turns as a body carries its spring only if the spring turns with the mean spin of the two spheres, which is how YADE transports it.
/// The midpoint rule turns it by $2 \arctan(\theta/2)$, which differs from $\theta$ in third order, keeps its length, and needs no sine. With $\mathbf{b} = \mathbf{n} \times \boldsymbol{\xi}'$
/// its solution is
///
/// ```math
/// \boldsymbol{\xi} = \boldsymbol{\xi}' + \frac{\theta}{1 + \theta^2/4} \left(\mathbf{b} + \tfrac{\theta}{2} \, \mathbf{n} \times \mathbf{b}\right)
/// ```
///
/// What lies along the normal does not change, so it makes no difference whether a spring is turned before or after it is projected.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}'$ | m (3) | any | spring before |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal, in either direction |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `carried` | $\boldsymbol{\xi}$ | m (3) | | spring now, as long as before |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_pair_that_spins_as_a_body_carries_its_spring`
/// * `a_spring_keeps_its_length_and_what_lies_along_the_normal`
/// * `it_solves_the_midpoint_rule`
/// * `opposite_spins_leave_the_spring`
/// * `swapping_i_and_j_changes_nothing`
/// * `turning_before_projecting_is_turning_afterwards`
#[inline(always)]
pub fn carried_spring<R: Real>(xi: Vec3<R>, n: Vec3<R>, omega_i: Vec3<R>, omega_j: Vec3<R>, dt: R) -> Vec3<R> {
    let half = (omega_i + omega_j).dot(n) * (R::lit(0.25) * dt);
    let b = n.cross(xi);
    xi + (b + n.cross(b) * half) * ((half + half) / (R::one() + half.squared()))
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/carried_spring.rs", "mechanics-carried-spring", [], carried_spring)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{rotated, unit, vector};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_pair_that_spins_as_a_body_carries_its_spring(xi in vector(), n in unit(), across in vector(), spin in -2.0..2.0f64) {
            // One turn of the body, in small steps; what does not lie along the normal turns the normal and not the spring about it.
            let (omega, steps) = (n * spin + across.perpendicular_to(n), 1000);
            let dt = 1.0 / f64::from(steps);
            let end = (0..steps).fold(xi, |xi, _| carried_spring(xi, n, omega, omega, dt));
            let allowed = 1e-12 + spin.abs().powi(3) * dt * dt / 12.0;
            prop_assert!((end - rotated(xi, n, spin)).norm() < allowed * xi.norm().max(1.0));
        }

        #[test]
        fn a_spring_keeps_its_length_and_what_lies_along_the_normal(xi in vector(), n in unit(), omega_i in vector(), omega_j in vector(), dt in 0.0..9.0) {
            let carried = carried_spring(xi, n, omega_i, omega_j, dt);
            prop_assert!((carried.norm() - xi.norm()).abs() < 1e-15 * 4.0);
            prop_assert!((carried.dot(n) - xi.dot(n)).abs() < 1e-15 * 4.0);
        }

        #[test]
        fn it_solves_the_midpoint_rule(xi in vector(), n in unit(), omega_i in vector(), omega_j in vector(), dt in 0.0..9.0) {
            let carried = carried_spring(xi, n, omega_i, omega_j, dt);
            let half = 0.25 * (omega_i + omega_j).dot(n) * dt;
            prop_assert!((carried - xi - n.cross(carried + xi) * half).norm() < 1e-14);
        }

        #[test]
        fn opposite_spins_leave_the_spring(xi in vector(), n in unit(), omega in vector(), dt in 0.0..9.0) {
            prop_assert_eq!(carried_spring(xi, n, omega, -omega, dt), xi);
        }

        #[test]
        fn swapping_i_and_j_changes_nothing(xi in vector(), n in unit(), omega_i in vector(), omega_j in vector(), dt in 0.0..9.0) {
            let (here, there) = (carried_spring(xi, n, omega_i, omega_j, dt), carried_spring(-xi, -n, omega_j, omega_i, dt));
            prop_assert!((here + there).norm() < 1e-15);
        }

        #[test]
        fn turning_before_projecting_is_turning_afterwards(xi in vector(), n in unit(), omega in vector(), dt in 0.0..9.0) {
            let turn = |xi| carried_spring(xi, n, omega, omega, dt);
            prop_assert!((turn(xi).perpendicular_to(n) - turn(xi.perpendicular_to(n))).norm() < 1e-14);
        }
    }
}
