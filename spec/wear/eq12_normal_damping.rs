//! The normal damping of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 12**, Section 2.2: damping factor of the normal dashpot for a desired restitution coefficient.
///
/// ```math
/// c_N = \frac{2 (1 - \eta)}{\pi} \sqrt{k_N m_{\mathrm{eff}}}
/// ```
///
/// # Reading
///
/// Erratum: the formula holds for weak damping only, as it inverts the approximation A.44 and not A.42. It is used as printed;
/// [`damping_ratio`](super::def_restitution::damping_ratio) is exact.
///
/// Effect: the actual restitution exceeds `eta` by about $(1 - \eta)^2 / 2$: 0.9512 for 0.95, 0.603 for 0.5.
///
/// Proof: `more_comes_back_than_wanted_by_half_the_square_of_the_loss`.
///
/// Eq. A.45 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | 1 | [0, 1] | restitution coefficient wanted |
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `m_eff` | $m_{\mathrm{eff}}$ | kg | > 0 | effective mass |
/// | → `c_n` | $c_N$ | kg/s | | normal damping factor |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `nothing_is_damped_if_everything_comes_back`
/// * `the_damping_ratio_is_one_less_eta_over_pi`
/// * `more_comes_back_than_wanted_by_half_the_square_of_the_loss`
#[inline(always)]
pub fn normal_damping<R: Real>(eta: R, k_n: R, m_eff: R) -> R {
    R::lit(2.0) * (R::one() - eta) / R::pi() * (k_n * m_eff).sqrt()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq12_normal_damping.rs", "wear-12", ["12"], normal_damping)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_restitution::{damping_ratio_of, restitution};
    use approx::relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    proptest! {
        #[test]
        fn nothing_is_damped_if_everything_comes_back(k_n in 0.0..10.0, m_eff in 0.1..10.0) {
            prop_assert_eq!(normal_damping(1.0, k_n, m_eff), 0.0);
        }

        #[test]
        fn the_damping_ratio_is_one_less_eta_over_pi(eta in 0.0..1.0, k_n in 0.1..10.0, m_eff in 0.1..10.0) {
            let zeta = damping_ratio_of(normal_damping(eta, k_n, m_eff), k_n, m_eff);
            prop_assert!(relative_eq!(zeta, (1.0 - eta) / PI, max_relative = 1e-14));
        }

        #[test]
        fn more_comes_back_than_wanted_by_half_the_square_of_the_loss(eta in 0.8..0.999, k_n in 0.1..10.0, m_eff in 0.1..10.0) {
            let excess: f64 = restitution(damping_ratio_of(normal_damping(eta, k_n, m_eff), k_n, m_eff)) - eta;
            let loss: f64 = 1.0 - eta;
            prop_assert!(excess > 0.0);
            prop_assert!((excess - 0.5 * loss * loss).abs() <= loss * loss * loss);
        }
    }
}
