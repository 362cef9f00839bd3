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
/// * `a_body_of_such_pairs_has_the_young_s_modulus_of_the_material`
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
    use crate::wear::a60_elastic_constants::{constant_11, constant_12};
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq08_tangential_stiffness::tangential_stiffness;
    use crate::wear::eq14_effective_radius::effective_radius;
    use crate::wear::eq16_tangential_cross_section::tangential_cross_section;
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
        fn a_body_of_such_pairs_has_the_young_s_modulus_of_the_material(e in 0.1..10.0f64, r in 0.1..10.0, nu in -0.9..0.24) {
            let r_eff = effective_radius(r, r);
            let k_n = normal_stiffness(normal_cross_section(r_eff, nu), e, r, r);
            let k_t = tangential_stiffness(tangential_cross_section(r_eff, nu), e, r, r);
            let (c_11, c_12) = (constant_11(r, k_n, k_t), constant_12(r, k_n, k_t));
            let young = (c_11 - c_12) * (c_11 + 2.0 * c_12) / (c_11 + c_12);
            prop_assert!(relative_eq!(young, e, max_relative = 1e-12));
        }

        #[test]
        fn grows_with_poisson_s_ratio(nu in -0.9..0.2, more in 0.001..0.05) {
            prop_assert!(normal_cross_section(1.0, nu + more) > normal_cross_section(1.0, nu));
        }
    }
}
