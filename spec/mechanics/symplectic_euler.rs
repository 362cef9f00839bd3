//! The integrator: velocities first, positions with the new velocities.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use super::kick_and_drift::{drift, kick};
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
/// Erratum: the third line lacks the moment of inertia; a torque times a time is not an angular velocity. It is
/// $\boldsymbol{\omega}_{n+1} = \boldsymbol{\omega}_n + (\mathbf{T}_n / I) \Delta t$ with [`moment_of_inertia`](crate::mechanics::sphere::moment_of_inertia).
/// Force and torque are those at the positions and velocities of step `n`, dashpots included.
///
/// Effect: the units of the printed line do not balance. Taken in SI it would hardly turn spheres of nanometres, whose moments of inertia are about $10^{-42}$ kg m².
///
/// Proof: `the_spin_gains_torque_times_time_which_the_printed_line_gets_wrong`.
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
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `exact_for_a_constant_force_up_to_half_a_step`
/// * `the_spin_gains_torque_times_time_which_the_printed_line_gets_wrong`
/// * `the_oscillator_conserves_its_invariant_and_keeps_its_energy_within_bounds`
/// * `the_energy_error_is_of_first_order_in_the_time_step`
/// * `areas_of_phase_space_are_kept`
/// * `six_steps_of_half_the_critical_one_return_to_the_start`
/// * `two_particles_keep_momentum_and_angular_momentum_for_any_time_step`
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

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/symplectic_euler.rs", "wear-1", ["1"], symplectic_euler)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::{assert_relative_eq, relative_eq};
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }

    /// A step of `h` of a unit mass on a unit spring, through Eq. 1.
    fn oscillate((x, v): (f64, f64), h: f64) -> (f64, f64) {
        let along = |x: f64| Vec3::new(x, 0.0, 0.0);
        let (v, x, _) = symplectic_euler(along(x), along(v), along(0.0), along(-x), along(0.0), 1.0, 1.0, h);
        (x.0[0], v.0[0])
    }

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

        #[test]
        fn the_spin_gains_torque_times_time_which_the_printed_line_gets_wrong(
            omega in vector(), torque in vector(), i in 2.0..10.0, dt in 0.1..1.0,
        ) {
            prop_assume!(torque.norm() > 0.1);
            let zero = Vec3::zero();
            let after = symplectic_euler(zero, zero, omega, zero, torque, 1.0, i, dt).2;
            prop_assert!(((after - omega) * i - torque * dt).norm() < 1e-13);
            let printed = omega + torque * dt;
            prop_assert!(((printed - omega) * i - torque * dt).norm() > 0.009);
        }

        #[test]
        fn the_oscillator_conserves_its_invariant_and_keeps_its_energy_within_bounds(x in -1.0..1.0, v in -1.0..1.0, h in 0.01..1.9) {
            prop_assume!(x * x + v * v > 0.1);
            let (energy, invariant) = (|(x, v): (f64, f64)| x * x + v * v, |(x, v): (f64, f64)| x * x + v * v - h * x * v);
            let start = (x, v);
            let mut now = start;
            for _ in 0..500 {
                now = oscillate(now, h);
                prop_assert!(relative_eq!(invariant(now), invariant(start), max_relative = 1e-11));
                prop_assert!(energy(now) <= energy(start) * (1.0 + 0.5 * h) / (1.0 - 0.5 * h) * (1.0 + 1e-11));
            }
        }

        #[test]
        fn the_energy_error_is_of_first_order_in_the_time_step(phase in 0.0..6.0f64) {
            let worst = |h: f64| {
                let mut now = (phase.cos(), phase.sin());
                (0..(7.0 / h) as usize)
                    .map(|_| {
                        now = oscillate(now, h);
                        (now.0 * now.0 + now.1 * now.1 - 1.0).abs()
                    })
                    .fold(0.0, f64::max)
            };
            let ratio = worst(2e-3) / worst(1e-3);
            prop_assert!((ratio - 2.0).abs() < 0.02);
        }

        #[test]
        fn areas_of_phase_space_are_kept(h in 0.01..3.0) {
            let ((a, c), (b, d)) = (oscillate((1.0, 0.0), h), oscillate((0.0, 1.0), h));
            prop_assert!(relative_eq!(a * d - b * c, 1.0, max_relative = 1e-13));
        }

        #[test]
        fn two_particles_keep_momentum_and_angular_momentum_for_any_time_step(
            x_i in vector(), x_j in vector(), v_i in vector(), v_j in vector(), omega in vector(), f in vector(), share in 0.0..1.0, dt in 0.01..10.0,
        ) {
            // A force and its reaction, and torques that balance their couple: what every contact law gives.
            let couple = (x_i - x_j).cross(f);
            let (m_i, m_j, i) = (2.0, 0.5, 0.3);
            let (w_i, y_i, spin_i) = symplectic_euler(x_i, v_i, omega, f, -couple * share, m_i, i, dt);
            let (w_j, y_j, spin_j) = symplectic_euler(x_j, v_j, omega, -f, -couple * (1.0 - share), m_j, i, dt);
            let momentum = (w_i - v_i) * m_i + (w_j - v_j) * m_j;
            prop_assert!(momentum.norm() < 1e-13 * (1.0 + dt));
            let before = x_i.cross(v_i) * m_i + x_j.cross(v_j) * m_j + (omega + omega) * i;
            let after = y_i.cross(w_i) * m_i + y_j.cross(w_j) * m_j + (spin_i + spin_j) * i;
            prop_assert!((after - before).norm() < 1e-12 * (1.0 + dt * dt * dt));
        }
    }

    #[test]
    fn six_steps_of_half_the_critical_one_return_to_the_start() {
        let mut now = (0.6, 0.8);
        for _ in 0..6 {
            now = oscillate(now, 1.0);
        }
        assert_relative_eq!(now.0, 0.6, max_relative = 1e-15);
        assert_relative_eq!(now.1, 0.8, max_relative = 1e-15);
    }
}
