//! The largest time step, for any two masses.

use super::eq06_critical_time_step::critical_time_step;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.17**, Appendix A.1.1: limit of the time step for two spheres.
///
/// ```math
/// \Delta t \le 2 \sqrt{\frac{m_{\text{eff}}}{k_N}}
/// ```
///
/// # Reading
///
/// Erratum: the comparison must be strict. The function returns the right-hand side. At the limit both eigenvalues are -1,
/// but the matrix has only one eigenvector. The same holds for A.18.
///
/// Effect: at the limit the motion grows linearly and the energy without bound.
///
/// Proof: `the_limit_itself_is_not_stable`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_eff` | $m_{\text{eff}}$ | kg | > 0 | effective mass of the pair |
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | → `dt` | $\Delta t$ | s | | limit below which a time step is stable |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_a_scaled_step_of_two`
/// * `a_step_just_below_stays_bounded`
/// * `the_limit_itself_is_not_stable`
/// * `equal_masses_give_the_critical_time_step`
#[inline(always)]
pub fn pair_time_step_limit<R: Real>(m_eff: R, k_n: R) -> R {
    R::lit(2.0) * (m_eff / k_n).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a17_stability.rs", "wear-A17", ["A17"], pair_time_step_limit),
        equation!("wear/eq06_critical_time_step.rs", "wear-A18", ["A18"], critical_time_step),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::wear::a04_time_step::kick_and_drift;
    use crate::wear::a06_energy::pair_energy;
    use crate::wear::a07_scaled_variables::scaled_time_step;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    /// Largest energy within `n` steps of a pair released at rest at `x` = 1, relative to the initial energy.
    fn largest_energy(k: f64, m_eff: f64, dt: f64, n: u32) -> f64 {
        let (mut v, mut x, mut largest) = (0.0, 1.0, 0.0f64);
        for _ in 0..n {
            (v, x) = kick_and_drift(k, m_eff, dt, x, v);
            largest = largest.max(pair_energy(k, m_eff, x, v));
        }
        largest / pair_energy(k, m_eff, 1.0, 0.0)
    }

    proptest! {
        #[test]
        fn is_a_scaled_step_of_two((m, k) in (0.1..10.0, 0.1..10.0)) {
            let h = scaled_time_step(k, m, pair_time_step_limit(m, k));
            assert_relative_eq!(h, 2.0, epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
        }

        #[test]
        fn a_step_just_below_stays_bounded((m, k) in (0.1..10.0, 0.1..10.0)) {
            // (1 + 0.999) / (1 - 0.999) bounds it.
            prop_assert!(largest_energy(k, m, 0.999 * pair_time_step_limit(m, k), 10_000) < 2000.0);
        }

        #[test]
        fn equal_masses_give_the_critical_time_step((m, k) in (0.1..10.0, 0.1..10.0)) {
            let general = pair_time_step_limit(effective_mass(m, m), k);
            assert_relative_eq!(general, critical_time_step(m, k), epsilon = 0.0, max_relative = 4.0 * f64::EPSILON);
        }
    }

    /// Powers of two keep the arithmetic exact: the amplitude grows by the same amount in each step.
    #[test]
    fn the_limit_itself_is_not_stable() {
        let dt = pair_time_step_limit(0.25, 1.0);
        assert_eq!(dt, 1.0);
        assert!(largest_energy(1.0, 0.25, dt, 10_000) > 1e8);
    }
}
