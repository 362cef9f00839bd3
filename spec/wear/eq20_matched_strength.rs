//! The tensile strength of large particles.

use crate::equation::Equation;
use crate::{Real, equation, piecewise};

/// **Eq. 20**, Section 2.2: tensile strength that is matched.
///
/// ```math
/// \sigma'_{m,N} = \sigma_{m,N} \left(\frac{r_i + r_j}{d_c}\right)^{-s}
/// ```
///
/// # Reading
///
/// Stated for particles beyond the critical diameter; below it the strength itself is matched, and the function returns
/// it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `d_c` | $d_c$ | m | > 0 | critical diameter |
/// | `s` | $s$ | 1 | >= 0 | scaling parameter |
/// | → `sigma_mn_matched` | $\sigma'_{m,N}$ | Pa | | matched tensile strength |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_largest_force_on_the_cross_section_only_if_large_particles_break_while_elastic`
/// * `continuous_at_the_critical_diameter`
/// * `falls_with_the_size_by_the_power_of_the_scaling`
#[inline(always)]
pub fn matched_strength<R: Real>(sigma_mn: R, r_i: R, r_j: R, d_c: R, s: R) -> R {
    let size = (r_i + r_j) / d_c;
    piecewise([((r_i + r_j).le(d_c), sigma_mn)], sigma_mn * (-s * size.ln()).exp())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq20_matched_strength.rs", "wear-20", ["20"], matched_strength)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq03_normal_force::normal_force;
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq09_elastic_separation::elastic_separation;
    use crate::wear::eq10_fracture_separation::fracture_separation;
    use crate::wear::eq18_critical_diameter::critical_diameter;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_the_largest_force_on_the_cross_section_only_if_large_particles_break_while_elastic(
            size in 1.1..80.0, s in 0.1..1.0,
        ) {
            let (gamma, e, sigma_mn, a_n) = (1.5, 1.0, 0.2, 1.0);
            let d_c = critical_diameter(gamma, e, sigma_mn);
            let r = 0.5 * size * d_c;
            let delta_e = elastic_separation(r, r, sigma_mn, e);
            let delta_f = fracture_separation(gamma, sigma_mn, r, r, d_c, delta_e, s);
            let k_n = normal_stiffness(a_n, e, r, r);
            let matched = matched_strength(sigma_mn, r, r, d_c, s);
            let largest = normal_force(k_n, delta_e, delta_f, delta_f);
            prop_assert!(relative_eq!(largest / a_n, matched, max_relative = 1e-13));
            // Eq. 3 as printed continues to the elastic separation.
            let printed = k_n * delta_e;
            prop_assert!(printed / a_n > 1.005 * matched);
        }

        #[test]
        fn continuous_at_the_critical_diameter(sigma_mn in 0.1..10.0, d_c in 0.1..10.0, s in 0.0..2.0) {
            let strength = |size: f64| matched_strength(sigma_mn, 0.5 * size * d_c, 0.5 * size * d_c, d_c, s);
            prop_assert!(relative_eq!(strength(1.0 - 1e-12), strength(1.0 + 1e-12), max_relative = 1e-11));
        }

        #[test]
        fn falls_with_the_size_by_the_power_of_the_scaling(r in 0.6..10.0, s in 0.0..2.0) {
            let strength = |r: f64| matched_strength(1.0, r, r, 1.0, s);
            prop_assert!(relative_eq!((strength(r) / strength(4.0 * r)).ln(), s * f64::ln(4.0), max_relative = 1e-12, epsilon = 1e-14));
        }
    }
}
