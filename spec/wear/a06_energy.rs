//! The energy that decides whether a step is stable.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.6**, Appendix A.1.1: energy of two spheres about their common centre of mass.
///
/// ```math
/// E_n = \frac12 k_N x_n^2 + \frac12 m_{\text{eff}} v_n^2
/// ```
///
/// # Reading
///
/// As printed. The scheme does not keep this energy constant: below the critical time step it oscillates about its mean.
/// One step of A.4 conserves `E - dt/2 k_n x v` instead.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `x` | $x_n$ | m | any | separation |
/// | `v` | $v_n$ | m/s | any | rate of separation |
/// | → `energy` | $E_n$ | J | | total energy |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `positive_except_at_rest`
/// * `a_step_conserves_it_but_for_half_a_kick`
/// * `a_step_does_not_conserve_it`
#[inline(always)]
pub fn pair_energy<R: Real>(k_n: R, m_eff: R, x: R, v: R) -> R {
    let half = R::lit(0.5);
    half * k_n * x.squared() + half * m_eff * v.squared()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/a06_energy.rs", "wear-A6", ["A6"], pair_energy)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a04_time_step::kick_and_drift;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn positive_except_at_rest((k, m) in (0.1..10.0, 0.1..10.0), x in -1.0..1.0, v in 0.1..1.0) {
            prop_assert!(pair_energy(k, m, x, v) > 0.0);
            prop_assert!(pair_energy(k, m, v, 0.0) > 0.0);
            prop_assert_eq!(pair_energy(k, m, 0.0, 0.0), 0.0);
        }

        #[test]
        fn a_step_conserves_it_but_for_half_a_kick(
            (k, m) in (0.5..2.0, 0.5..2.0), dt in 0.01..2.0, x in -1.0..1.0, v in -1.0..1.0,
        ) {
            let conserved = |x, v| pair_energy(k, m, x, v) - 0.5 * dt * k * x * v;
            let (v_next, x_next) = kick_and_drift(k, m, dt, x, v);
            // Each term stays below 1000 in this range.
            assert_abs_diff_eq!(conserved(x_next, v_next), conserved(x, v), epsilon = 2000.0 * f64::EPSILON);
        }

        #[test]
        fn a_step_does_not_conserve_it(dt in 0.01..1.0, v in 0.1..1.0) {
            let (v_next, x_next) = kick_and_drift(1.0, 1.0, dt, 0.0, v);
            // From x = 0 a step adds the energy of the new separation.
            assert_abs_diff_eq!(
                pair_energy(1.0, 1.0, x_next, v_next) - pair_energy(1.0, 1.0, 0.0, v),
                0.5 * (dt * v) * (dt * v),
                epsilon = 4.0 * f64::EPSILON
            );
        }
    }
}
