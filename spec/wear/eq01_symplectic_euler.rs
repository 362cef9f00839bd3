//! The integrator: velocities first, positions with the new velocities.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 1**, Section 2: one step of the symplectic Euler method for a particle.
///
/// ```math
/// \mathbf{v}_{n+1} = \mathbf{v}_n + \frac{\mathbf{F}_n}{m} \Delta t, \quad
/// \mathbf{x}_{n+1} = \mathbf{x}_n + \mathbf{v}_{n+1} \Delta t, \quad
/// \boldsymbol{\omega}_{n+1} = \boldsymbol{\omega}_n + \mathbf{T}_n \Delta t
/// ```
///
/// # Reading
///
/// Erratum: the third line lacks the moment of inertia, a torque times a time is no angular velocity. It is
/// $\boldsymbol{\omega}_{n+1} = \boldsymbol{\omega}_n + (\mathbf{T}_n / I) \Delta t$ with [`moment_of_inertia`](super::def_sphere::moment_of_inertia).
/// Force and torque are those at the positions and velocities of step `n`, dashpots included.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x` | $\mathbf{x}_n$ | m (3) | any | position |
/// | `v` | $\mathbf{v}_n$ | m/s (3) | any | velocity |
/// | `omega` | $\boldsymbol{\omega}_n$ | rad/s (3) | any | angular velocity |
/// | `force` | $\mathbf{F}_n$ | N (3) | any | force on the particle |
/// | `torque` | $\mathbf{T}_n$ | N m (3) | any | torque on the particle about its centre |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `v_next` | $\mathbf{v}_{n+1}$ | m/s (3) | | velocity one step later |
/// | → `x_next` | $\mathbf{x}_{n+1}$ | m (3) | | position one step later |
/// | → `omega_next` | $\boldsymbol{\omega}_{n+1}$ | rad/s (3) | | angular velocity one step later |
///
/// # Laws
///
/// * `exact_for_a_constant_force_up_to_half_a_step`
#[inline(always)]
pub fn symplectic_euler<R: Real>(
    x: Vec3<R>,
    v: Vec3<R>,
    omega: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>, Vec3<R>) {
    let v = kick(v, force, m, dt);
    (v, drift(x, v, dt), kick(omega, torque, i, dt))
}

/// The first and the third line of Eq. 1: the velocity (or the angular velocity) after a force (a torque) acted on
/// a mass (a moment of inertia) for a time step.
#[inline(always)]
pub fn kick<R: Real>(v: Vec3<R>, force: Vec3<R>, m: R, dt: R) -> Vec3<R> {
    v + force * (dt / m)
}

/// The second line of Eq. 1: the position after a time step at the new velocity.
#[inline(always)]
pub fn drift<R: Real>(x: Vec3<R>, v: Vec3<R>, dt: R) -> Vec3<R> {
    x + v * dt
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq01_symplectic_euler.rs", "wear-1", ["1"], symplectic_euler)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn exact_for_a_constant_force_up_to_half_a_step(v in -2.0..2.0, f in -2.0..2.0, m in 0.1..10.0, dt in 0.01..0.1) {
            let force = Vec3::new(0.0, 0.0, f);
            let mut now = (Vec3::new(0.0, 0.0, v), Vec3::zero(), Vec3::zero());
            let steps = 50;
            for _ in 0..steps {
                now = symplectic_euler(now.1, now.0, now.2, force, Vec3::zero(), m, 1.0, dt);
            }
            let n = f64::from(steps);
            let exact = n * dt * v + 0.5 * n * (n + 1.0) * dt * dt * f / m;
            prop_assert!(relative_eq!(now.1.0[2], exact, max_relative = 1e-12, epsilon = 1e-12));
        }
    }
}
