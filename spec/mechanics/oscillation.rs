//! A mass on a spring, and a mass that falls.

use crate::equation::Equation;
use crate::{Real, equation};

/// Period of the free oscillation of a mass on a spring.
///
/// ```math
/// T = 2 \pi \sqrt{\frac{m}{k}}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `k` | $k$ | N/m | > 0 | stiffness |
/// | → `t` | $T$ | s |  | period |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `an_oscillator_returns_after_its_period`
#[inline(always)]
pub fn period<R: Real>(m: R, k: R) -> R {
    R::lit(2.0) * R::pi() * (m / k).sqrt()
}

/// Speed of a mass that was released from rest, by conservation of energy.
///
/// ```math
/// v = \sqrt{\frac{2 (U_0 - U)}{m}}
/// ```
///
/// # Reading
///
/// The mass is the reduced mass of two bodies that fall towards each other; the speed is then the relative one.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `u_0` | $U_0$ | J | any | potential energy at the start |
/// | `u` | $U$ | J | any | potential energy now, not above it |
/// | → `v` | $v$ | m/s |  | speed |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_constant_force_gives_the_speed_of_uniform_acceleration`
#[inline(always)]
pub fn speed_of_fall<R: Real>(m: R, u_0: R, u: R) -> R {
    (R::lit(2.0) * (u_0 - u) / m).sqrt()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/oscillation.rs", "mechanics-period", [], period),
        equation!("mechanics/oscillation.rs", "mechanics-speed-of-fall", [], speed_of_fall),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Vec3;
    use crate::mechanics::kick_and_drift::{drift, kick};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_oscillator_returns_after_its_period(m in 0.1..10.0f64, k in 0.1..10.0f64, phase in 0.0..6.0f64) {
            // Positions a sixth of a step late, velocities half a step before them: the error is of second order.
            let steps = 2000;
            let dt = period(m, k) / f64::from(steps);
            let along = |x: f64| Vec3::new(x, 0.0, 0.0);
            let omega = (k / m).sqrt();
            let (x_0, v_0) = (phase.cos(), -omega * (phase - 0.5 * omega * dt).sin());
            let (mut x, mut v) = (along(x_0), along(v_0));
            for step in 0..steps {
                if 2 * step == steps {
                    // half way it is on the other side
                    prop_assert!(dt > 0.0 && (x.0[0] + x_0).abs() < 1e-4 && (v.0[0] + v_0).abs() < 1e-4 * omega);
                }
                v = kick(v, -(x * k), m, dt);
                x = drift(x, v, dt);
            }
            prop_assert!((x.0[0] - x_0).abs() < 1e-4 && (v.0[0] - v_0).abs() < 1e-4 * omega);
        }

        #[test]
        fn a_constant_force_gives_the_speed_of_uniform_acceleration(m in 0.1..10.0f64, f in 0.1..10.0f64, t in 0.1..10.0f64) {
            let way = 0.5 * f / m * t * t;
            prop_assert!((speed_of_fall(m, f * way, 0.0) / (f / m * t) - 1.0).abs() < 1e-14);
            // the zero of the energy is arbitrary
            prop_assert!((speed_of_fall(m, 0.0, -f * way) / (f / m * t) - 1.0).abs() < 1e-14);
        }
    }
}
