//! Kinetic energy of a sphere, a rigid body and a wall, and its error in a time step.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Kinetic energy of translation and rotation of a sphere.
///
/// ```math
/// K = \frac{1}{2} \left(m v^2 + I \omega^2\right)
/// ```
///
/// # Reading
///
/// Evaluated with the changes of both velocities in a kick, it is the energy by which the kick exceeds the work of force and torque at the
/// velocities before it, see [`excess_of_a_kick`].
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | angular velocity |
/// | → `energy` | $K$ | J |  | kinetic energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_force_changes_it_by_its_work`
#[inline(always)]
pub fn kinetic_energy<R: Real>(m: R, v: Vec3<R>, i: R, omega: Vec3<R>) -> R {
    R::lit(0.5) * (m * v.dot(v) + i * omega.dot(omega))
}

/// Kinetic energy of a centre of mass.
///
/// ```math
/// K = \frac{1}{2} m v^2
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | → `energy` | $K$ | J |  | kinetic energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `it_is_that_of_a_sphere_without_spin`
#[inline(always)]
pub fn translational_energy<R: Real>(m: R, v: Vec3<R>) -> R {
    R::lit(0.5) * m * v.dot(v)
}

/// Kinetic energy of motion along one axis.
///
/// ```math
/// K_a = \frac{1}{2} m v_a^2
/// ```
///
/// # Reading
///
/// For a wall driven by a load along some axes, with prescribed motion along the others.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `v_a` | $v_a$ | m/s | any | velocity along the axis |
/// | → `energy` | $K_a$ | J |  | kinetic energy |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `those_along_the_three_axes_are_the_whole`
#[inline(always)]
pub fn axial_energy<R: Real>(m: R, v_a: R) -> R {
    R::lit(0.5) * m * v_a * v_a
}

/// Kinetic energy by which a kick exceeds the work of its force at the velocity before.
///
/// ```math
/// K(\mathbf{v} + \mathbf{F} \Delta t / m) - K(\mathbf{v}) - \mathbf{F} \cdot \mathbf{v} \, \Delta t = \frac{F^2 \Delta t^2}{2 m}
/// ```
///
/// # Reading
///
/// Of first order in the time step over many steps: the effect on an energy balance of velocities half a step behind the positions.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `force` | $\mathbf{F}$ | N (3) | any | force |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `excess` | $\Delta K$ | J |  | excess |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_kick_exceeds_the_work_by_it`
#[inline(always)]
pub fn excess_of_a_kick<R: Real>(force: Vec3<R>, m: R, dt: R) -> R {
    R::lit(0.5) * force.dot(force) / m * dt * dt
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/kinetic_energy.rs", "mechanics-kinetic-energy", [], kinetic_energy),
        equation!("mechanics/kinetic_energy.rs", "mechanics-translational-energy", [], translational_energy),
        equation!("mechanics/kinetic_energy.rs", "mechanics-axial-energy", [], axial_energy),
        equation!("mechanics/kinetic_energy.rs", "mechanics-kick-excess", [], excess_of_a_kick),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::kick_and_drift::kick;
    use crate::mechanics::samples::vector;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_force_changes_it_by_its_work(m in 0.1..10.0f64, v in vector(), i in 0.1..10.0f64, omega in vector(), force in vector(), torque in vector()) {
            // Over an infinitesimal time the energy grows at the power of force and torque.
            let constant = |u: Vec3<f64>| Vec3(u.0.map(Dual::lit));
            let dt = Dual::variable(0.0);
            let (m_, i_) = (Dual::lit(m), Dual::lit(i));
            let energy = kinetic_energy(m_, kick(constant(v), constant(force), m_, dt), i_, kick(constant(omega), constant(torque), i_, dt));
            prop_assert!((energy.slope - (force.dot(v) + torque.dot(omega))).abs() < 1e-13);
        }

        #[test]
        fn it_is_that_of_a_sphere_without_spin(m in 0.1..10.0f64, v in vector(), i in 0.1..10.0) {
            prop_assert_eq!(translational_energy(m, v), kinetic_energy(m, v, i, Vec3::zero()));
        }

        #[test]
        fn those_along_the_three_axes_are_the_whole(m in 0.1..10.0f64, v in vector()) {
            let sum: f64 = v.0.into_iter().map(|v_a| axial_energy(m, v_a)).sum();
            prop_assert!((sum - translational_energy(m, v)).abs() < 1e-14 * m);
        }

        #[test]
        fn a_kick_exceeds_the_work_by_it(m in 0.1..10.0f64, v in vector(), force in vector(), dt in 0.01..1.0) {
            let gained = translational_energy(m, kick(v, force, m, dt)) - translational_energy(m, v);
            prop_assert!((gained - force.dot(v) * dt - excess_of_a_kick(force, m, dt)).abs() < 1e-13 * (1.0 + 1.0 / m + m));
            let jump = kick(v, force, m, dt) - v;
            prop_assert!((translational_energy(m, jump) - excess_of_a_kick(force, m, dt)).abs() < 1e-13 * (1.0 + 1.0 / m + m));
        }
    }
}
