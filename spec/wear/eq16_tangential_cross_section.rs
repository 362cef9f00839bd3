//! The cross section that carries the tangential force.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 16**, Section 2.2: effective cross section of a pair for the tangential force.
///
/// ```math
/// A_T = \sqrt{2} \, r_{\mathrm{eff}}^2 \, \frac{1 - 4\nu}{(1 - 2\nu)(1 + \nu)}
/// ```
///
/// # Reading
///
/// Negative above a Poisson's ratio of 1/4, where the model ends, as the paper says. Eq. A.65 derives it for equal
/// radii.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $r_{\mathrm{eff}}$ | m | > 0 | effective radius |
/// | `nu` | $\nu$ | 1 | (-1, 1/4] | Poisson's ratio |
/// | → `a_t` | $A_T$ | m^2 | | tangential cross section |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `equals_the_normal_one_without_lateral_contraction`
/// * `vanishes_at_one_quarter_and_is_negative_beyond`
/// * `shrinks_as_poisson_s_ratio_grows`
#[inline(always)]
pub fn tangential_cross_section<R: Real>(r_eff: R, nu: R) -> R {
    let one = R::one();
    R::lit(2.0).sqrt() * r_eff.squared() * (one - R::lit(4.0) * nu) / ((one - R::lit(2.0) * nu) * (one + nu))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq16_tangential_cross_section.rs", "wear-16", ["16"], tangential_cross_section)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq15_normal_cross_section::normal_cross_section;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equals_the_normal_one_without_lateral_contraction(r_eff in 0.1..10.0) {
            prop_assert_eq!(tangential_cross_section(r_eff, 0.0), normal_cross_section(r_eff, 0.0));
        }

        #[test]
        fn vanishes_at_one_quarter_and_is_negative_beyond(r_eff in 0.1..10.0, beyond in 1e-3..0.2) {
            prop_assert_eq!(tangential_cross_section(r_eff, 0.25), 0.0);
            prop_assert!(tangential_cross_section(r_eff, 0.25 + beyond) < 0.0);
        }

        #[test]
        fn shrinks_as_poisson_s_ratio_grows(nu in -0.9..0.2, more in 0.001..0.05) {
            prop_assert!(tangential_cross_section(1.0, nu + more) < tangential_cross_section(1.0, nu));
        }
    }
}
