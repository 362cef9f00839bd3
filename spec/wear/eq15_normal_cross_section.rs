//! The cross section that carries the normal force.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 15**, Section 2.2: effective cross section of a pair for the normal force.
///
/// ```math
/// A_N = \sqrt{2} \, r_{\mathrm{eff}}^2 \, \frac{1}{1 - 2\nu}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.64 derives it for equal radii.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_eff` | $r_{\mathrm{eff}}$ | m | > 0 | effective radius |
/// | `nu` | $\nu$ | 1 | (-1, 1/4] | Poisson's ratio |
/// | → `a_n` | $A_N$ | m^2 | | normal cross section |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `grows_with_the_square_of_the_radius`
/// * `doubles_from_a_poisson_s_ratio_of_zero_to_one_quarter`
/// * `grows_with_poisson_s_ratio`
#[inline(always)]
pub fn normal_cross_section<R: Real>(r_eff: R, nu: R) -> R {
    R::lit(2.0).sqrt() * r_eff.squared() / (R::one() - R::lit(2.0) * nu)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq15_normal_cross_section.rs", "wear-15", ["15"], normal_cross_section)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn grows_with_the_square_of_the_radius(r_eff in 0.1..10.0, nu in -0.9..0.25, factor in 0.5..4.0) {
            let (small, large) = (normal_cross_section(r_eff, nu), normal_cross_section(factor * r_eff, nu));
            prop_assert!(relative_eq!(large, factor * factor * small, max_relative = 1e-14));
        }

        #[test]
        fn doubles_from_a_poisson_s_ratio_of_zero_to_one_quarter(r_eff in 0.1..10.0) {
            prop_assert_eq!(normal_cross_section(r_eff, 0.25), 2.0 * normal_cross_section(r_eff, 0.0));
        }

        #[test]
        fn grows_with_poisson_s_ratio(nu in -0.9..0.2, more in 0.001..0.05) {
            prop_assert!(normal_cross_section(1.0, nu + more) > normal_cross_section(1.0, nu));
        }
    }
}
