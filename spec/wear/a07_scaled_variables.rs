//! Dimensionless position, velocity and time step: the pair is characterised by one number, the scaled step.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.7**, Appendix A.1.1: scaled position.
///
/// ```math
/// \hat x_n = \sqrt{\frac{k_N}{2 E_0}}\, x_n
/// ```
///
/// # Reading
///
/// As printed; the initial energy must not be zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `e_0` | $E_0$ | J | > 0 | initial energy |
/// | `x` | $x_n$ | m | any | separation |
/// | → `x_hat` | $\hat x_n$ | 1 | | scaled separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_start_lies_on_the_unit_circle`
/// * `the_squares_add_up_to_the_energy_ratio`
#[inline(always)]
pub fn scaled_position<R: Real>(k_n: R, e_0: R, x: R) -> R {
    (k_n / (R::lit(2.0) * e_0)).sqrt() * x
}

/// **Eq. A.8**, Appendix A.1.1: scaled velocity.
///
/// ```math
/// \hat v_n = \sqrt{\frac{m_{\text{eff}}}{2 E_0}}\, v_n
/// ```
///
/// # Reading
///
/// As printed; the initial energy must not be zero.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `e_0` | $E_0$ | J | > 0 | initial energy |
/// | `v` | $v_n$ | m/s | any | rate of separation |
/// | → `v_hat` | $\hat v_n$ | 1 | | scaled rate of separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_start_lies_on_the_unit_circle`
/// * `the_squares_add_up_to_the_energy_ratio`
#[inline(always)]
pub fn scaled_velocity<R: Real>(m_eff: R, e_0: R, v: R) -> R {
    (m_eff / (R::lit(2.0) * e_0)).sqrt() * v
}

/// **Eq. A.9**, Appendix A.1.1: the scaled initial energy.
///
/// ```math
/// 1 = \hat x_0^2 + \hat v_0^2
/// ```
///
/// # Reading
///
/// Evaluates the right-hand side; a law checks that it is one at the start.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_hat` | $\hat x_0$ | 1 | any | scaled separation |
/// | `v_hat` | $\hat v_0$ | 1 | any | scaled rate of separation |
/// | → `norm` | $\hat x_0^2 + \hat v_0^2$ | 1 | | energy as a multiple of the initial energy |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_start_lies_on_the_unit_circle`
/// * `the_squares_add_up_to_the_energy_ratio`
#[inline(always)]
pub fn scaled_energy<R: Real>(x_hat: R, v_hat: R) -> R {
    x_hat.squared() + v_hat.squared()
}

/// **Eq. A.10**, Appendix A.1.1: scaled time step.
///
/// ```math
/// \hat{\Delta t} = \sqrt{\frac{k_N}{m_{\text{eff}}}}\, \Delta t
/// ```
///
/// # Reading
///
/// As printed. It is called `h` in the rest of this appendix.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `h` | $\hat{\Delta t}$ | 1 | | scaled time step |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_phase_that_passes_in_a_step`
#[inline(always)]
pub fn scaled_time_step<R: Real>(k_n: R, m_eff: R, dt: R) -> R {
    (k_n / m_eff).sqrt() * dt
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a07_scaled_variables.rs", "wear-A7", ["A7"], scaled_position),
        equation!("wear/a07_scaled_variables.rs", "wear-A8", ["A8"], scaled_velocity),
        equation!("wear/a07_scaled_variables.rs", "wear-A9", ["A9"], scaled_energy),
        equation!("wear/a07_scaled_variables.rs", "wear-A10", ["A10"], scaled_time_step),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a06_energy::pair_energy;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 8.0 * f64::EPSILON;

    proptest! {
        #[test]
        fn the_start_lies_on_the_unit_circle((k, m) in (0.1..10.0, 0.1..10.0), x in -1.0..1.0, v in 0.1..1.0) {
            let e_0 = pair_energy(k, m, x, v);
            let norm = scaled_energy(scaled_position(k, e_0, x), scaled_velocity(m, e_0, v));
            assert_relative_eq!(norm, 1.0, epsilon = 0.0, max_relative = ROUNDING);
            prop_assert!(scaled_position(k, e_0, x) * x >= 0.0 && scaled_velocity(m, e_0, v) > 0.0);
        }

        #[test]
        fn the_squares_add_up_to_the_energy_ratio(
            (k, m) in (0.1..10.0, 0.1..10.0), e_0 in 0.1..10.0, x in -1.0..1.0, v in 0.1..1.0,
        ) {
            let ratio = scaled_energy(scaled_position(k, e_0, x), scaled_velocity(m, e_0, v));
            assert_relative_eq!(ratio, pair_energy(k, m, x, v) / e_0, epsilon = 0.0, max_relative = ROUNDING);
        }

        /// A period is `2 pi sqrt(m/k)` long.
        #[test]
        fn is_the_phase_that_passes_in_a_step((k, m) in (0.1f64..10.0, 0.1f64..10.0)) {
            let period = std::f64::consts::TAU * (m / k).sqrt();
            assert_relative_eq!(
                scaled_time_step(k, m, period),
                std::f64::consts::TAU,
                epsilon = 0.0,
                max_relative = ROUNDING
            );
        }
    }
}
