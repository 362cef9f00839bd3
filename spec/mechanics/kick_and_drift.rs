//! The two halves of a time step: a force changes a velocity, a velocity changes a position.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Velocity after a constant force has acted on a mass for a time step.
///
/// ```math
/// \mathbf{v}_{n+1} = \mathbf{v}_n + \frac{\mathbf{F}}{m} \Delta t
/// ```
///
/// # Reading
///
/// An angular velocity changes in the same way, with the torque for the force and the moment of inertia for the mass. The time step is divided
/// by the mass first: one division serves the three components.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v` | $\mathbf{v}_n$ | m/s (3) | any | velocity before |
/// | `force` | $\mathbf{F}$ | N (3) | any | force |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `dt` | $\Delta t$ | s | any | time step |
/// | → `v_next` | $\mathbf{v}_{n+1}$ | m/s (3) | | velocity after |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_momentum_gains_force_times_time`
/// * `a_kick_back_in_time_undoes_a_kick`
#[inline(always)]
pub fn kick<R: Real>(v: Vec3<R>, force: Vec3<R>, m: R, dt: R) -> Vec3<R> {
    v + force * (dt / m)
}

/// Position after a time step at a constant velocity.
///
/// ```math
/// \mathbf{x}_{n+1} = \mathbf{x}_n + \mathbf{v} \Delta t
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x` | $\mathbf{x}_n$ | m (3) | any | position before |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | `dt` | $\Delta t$ | s | any | time step |
/// | → `x_next` | $\mathbf{x}_{n+1}$ | m (3) | | position after |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `two_drifts_of_half_a_step_are_one_of_a_whole_step`
/// * `the_rate_of_a_drift_is_the_velocity`
#[inline(always)]
pub fn drift<R: Real>(x: Vec3<R>, v: Vec3<R>, dt: R) -> Vec3<R> {
    x + v * dt
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/kick_and_drift.rs", "mechanics-kick", [], kick),
        equation!("mechanics/kick_and_drift.rs", "mechanics-drift", [], drift),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_momentum_gains_force_times_time(v in vector(), force in vector(), m in 0.1..10.0, dt in 0.01..1.0) {
            prop_assert!(((kick(v, force, m, dt) - v) * m - force * dt).norm() < 1e-13);
        }

        #[test]
        fn a_kick_back_in_time_undoes_a_kick(v in vector(), force in vector(), m in 0.1..10.0, dt in 0.01..1.0) {
            prop_assert!((kick(kick(v, force, m, dt), force, m, -dt) - v).norm() < 1e-14);
        }

        #[test]
        fn the_rate_of_a_drift_is_the_velocity(x in vector(), v in vector()) {
            let constant = |u: Vec3<f64>| Vec3(u.0.map(Dual::constant));
            let place = drift(constant(x), constant(v), Dual::variable(0.0));
            prop_assert!((0..3).all(|k| place.0[k].value == x.0[k] && place.0[k].slope == v.0[k]));
        }

        #[test]
        fn two_drifts_of_half_a_step_are_one_of_a_whole_step(x in vector(), v in vector(), dt in 0.01..1.0) {
            prop_assert!((drift(drift(x, v, 0.5 * dt), v, 0.5 * dt) - drift(x, v, dt)).norm() < 1e-15);
        }
    }
}
