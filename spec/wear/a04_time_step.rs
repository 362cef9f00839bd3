//! The symplectic Euler step of the separation: as the scheme is written, and made explicit.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.4**, Appendix A.1.1: one step of Eq. 1 for two undamped spheres.
///
/// ```math
/// v_{n+1} = v_n - \frac{k_N x_n}{m_{\text{eff}}} \Delta t, \qquad x_{n+1} = x_n + v_{n+1} \Delta t
/// ```
///
/// # Reading
///
/// As printed: kick, then drift with the new velocity.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | `x` | $x_n$ | m | any | separation |
/// | `v` | $v_n$ | m/s | any | rate of separation |
/// | → `v_next` | $v_{n+1}$ | m/s | | rate of separation after the step |
/// | → `x_next` | $x_{n+1}$ | m | | separation after the step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_free_pair_drifts`
/// * `drifting_back_and_kicking_back_undoes_a_step`
#[inline(always)]
pub fn kick_and_drift<R: Real>(k_n: R, m_eff: R, dt: R, x: R, v: R) -> (R, R) {
    let v_next = v - k_n * x / m_eff * dt;
    (v_next, x + v_next * dt)
}

/// **Eq. A.5**, Appendix A.1.1: the same step with the new velocity eliminated.
///
/// ```math
/// v_{n+1} = v_n - \frac{k_N}{m_{\text{eff}}} \Delta t\, x_n, \qquad
/// x_{n+1} = \left(1 - \frac{k_N}{m_{\text{eff}}} \Delta t^2\right) x_n + \Delta t\, v_n
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | `x` | $x_n$ | m | any | separation |
/// | `v` | $v_n$ | m/s | any | rate of separation |
/// | → `v_next` | $v_{n+1}$ | m/s | | rate of separation after the step |
/// | → `x_next` | $x_{n+1}$ | m | | separation after the step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_same_step`
#[inline(always)]
pub fn explicit_step<R: Real>(k_n: R, m_eff: R, dt: R, x: R, v: R) -> (R, R) {
    let v_next = v - k_n / m_eff * dt * x;
    (v_next, (R::one() - k_n / m_eff * dt.squared()) * x + dt * v)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a04_time_step.rs", "wear-A4", ["A4"], kick_and_drift),
        equation!("wear/a04_time_step.rs", "wear-A5", ["A5"], explicit_step),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    /// Rounding of sums whose terms are below 8 in size.
    const ROUNDING: f64 = 32.0 * f64::EPSILON;

    proptest! {
        #[test]
        fn a_free_pair_drifts(dt in 0.01..1.0, x in -1.0..1.0, v in -1.0..1.0) {
            prop_assert_eq!(kick_and_drift(0.0, 1.0, dt, x, v), (v, x + v * dt));
        }

        #[test]
        fn drifting_back_and_kicking_back_undoes_a_step(
            (k, m) in (0.5..2.0, 0.5..2.0), dt in 0.01..1.0, x in -1.0..1.0, v in -1.0..1.0,
        ) {
            let (v_next, x_next) = kick_and_drift(k, m, dt, x, v);
            let x_back = x_next - v_next * dt;
            assert_abs_diff_eq!(x_back, x, epsilon = ROUNDING);
            assert_abs_diff_eq!(v_next + k * x_back / m * dt, v, epsilon = ROUNDING);
        }

        #[test]
        fn is_the_same_step((k, m) in (0.5..2.0, 0.5..2.0), dt in 0.01..1.0, x in -1.0..1.0, v in -1.0..1.0) {
            let (v_next, x_next) = kick_and_drift(k, m, dt, x, v);
            let (v_explicit, x_explicit) = explicit_step(k, m, dt, x, v);
            assert_abs_diff_eq!(v_next, v_explicit, epsilon = ROUNDING);
            assert_abs_diff_eq!(x_next, x_explicit, epsilon = ROUNDING);
        }
    }
}
