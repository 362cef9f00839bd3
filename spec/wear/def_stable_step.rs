//! The limits of the time step that Eq. 6 omits.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Appendix A.1**, unnumbered: stability limit of a damped pair, as a fraction of Eq. 6.
///
/// ```math
/// \frac{\Delta t_{\max}}{\Delta t_c} = \sqrt{1 + \zeta^2} - \zeta
/// ```
///
/// # Reading
///
/// The dashpot of Eq. 2 acts with the old velocity, which lowers the limit. Evaluated as $1 / (\sqrt{1 + \zeta^2} + \zeta)$,
/// which avoids cancellation.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `zeta` | $\zeta$ | 1 | >= 0 | damping ratio |
/// | → `ratio` | $\Delta t_{\max} / \Delta t_c$ | 1 | | largest stable fraction |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `no_damping_no_reduction`
/// * `is_the_damped_fraction_of_eq_6`
#[inline(always)]
pub fn damped_limit<R: Real>(zeta: R) -> R {
    R::one() / ((R::one() + zeta.squared()).sqrt() + zeta)
}

/// **Appendix A.1**, unnumbered: stability limit of two equal solid spheres that slide and rotate, as a fraction of Eq. 6.
///
/// ```math
/// \frac{\Delta t_{\max}}{\Delta t_c} = \left(\frac{7}{2} \frac{k_T}{k_N}\right)^{-1/2}, \quad \frac{k_T}{k_N} = \frac{1 - 4\nu}{1 + \nu}
/// ```
///
/// # Reading
///
/// The effective mass of the tangential spring is 2/7 of the pair's. Below a Poisson's ratio of 1/6 this is the
/// tighter limit.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `nu` | $\nu$ | 1 | (-1, 1/4) | Poisson's ratio |
/// | → `ratio` | $\Delta t_{\max} / \Delta t_c$ | 1 | | largest stable fraction |
/// | → `k_ratio` | $k_T / k_N$ | 1 | | ratio of the stiffnesses |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `tighter_than_eq_6_below_one_sixth`
/// * `is_the_sliding_fraction_of_eq_6`
#[inline(always)]
pub fn sliding_limit<R: Real>(nu: R) -> (R, R) {
    let k_ratio = (R::one() - R::lit(4.0) * nu) / (R::one() + nu);
    (R::one() / (R::lit(3.5) * k_ratio).sqrt(), k_ratio)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/def_stable_step.rs", "wear-dtlim-damped", [], damped_limit),
        equation!("wear/def_stable_step.rs", "wear-dtlim-tang", [], sliding_limit),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::mechanics::sphere::sliding_mass;
    use crate::mechanics::stable_step::stable_time_step;
    use crate::wear::def_restitution::damping_ratio_of;
    use crate::wear::eq06_critical_time_step::critical_time_step;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_damped_fraction_of_eq_6(m in 0.1..10.0, k in 0.1..10.0, c in 0.0..10.0) {
            let m_eff = effective_mass(m, m);
            let fraction = stable_time_step(m_eff, k, c) / critical_time_step(m, k);
            prop_assert!(relative_eq!(fraction, damped_limit(damping_ratio_of(c, k, m_eff)), max_relative = 1e-14));
        }

        #[test]
        fn is_the_sliding_fraction_of_eq_6(m in 0.1..10.0, k_n in 0.1..10.0, nu in -0.9..0.24) {
            let (ratio, k_ratio) = sliding_limit(nu);
            let fraction = stable_time_step(sliding_mass(effective_mass(m, m)), k_ratio * k_n, 0.0) / critical_time_step(m, k_n);
            prop_assert!(relative_eq!(fraction, ratio, max_relative = 1e-14));
        }

        #[test]
        fn tighter_than_eq_6_below_one_sixth(nu in -0.9..0.24) {
            prop_assert_eq!(sliding_limit(nu).0 < 1.0, nu < 1.0 / 6.0);
        }
    }

    #[test]
    fn no_damping_no_reduction() {
        assert_eq!(damped_limit(0.0), 1.0);
    }
}
