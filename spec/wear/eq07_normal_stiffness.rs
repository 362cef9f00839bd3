//! The normal stiffness of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 7**, Section 2.2: normal stiffness of a pair, equal to the stiffness of a bar of its cross-section between the two centres.
///
/// ```math
/// k_N = \frac{A_N E}{r_i + r_j}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.26 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_n` | $A_N$ | m^2 | > 0 | normal cross section |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `k_n` | $k_N$ | N/m | | normal stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_changes_nothing`
/// * `the_stress_on_the_cross_section_is_young_s_modulus_times_the_strain`
/// * `of_equal_spheres_grows_with_the_radius`
#[inline(always)]
pub fn normal_stiffness<R: Real>(a_n: R, e: R, r_i: R, r_j: R) -> R {
    a_n * e / (r_i + r_j)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq07_normal_stiffness.rs", "wear-7", ["7"], normal_stiffness)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq15_normal_cross_section::normal_cross_section;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn swapping_the_particles_changes_nothing(a_n in 0.1..10.0, e in 0.1..10.0, r_i in 0.1..10.0, r_j in 0.1..10.0) {
            prop_assert_eq!(normal_stiffness(a_n, e, r_i, r_j), normal_stiffness(a_n, e, r_j, r_i));
        }

        #[test]
        fn the_stress_on_the_cross_section_is_young_s_modulus_times_the_strain(
            a_n in 0.1..10.0, e in 0.1..10.0, r_i in 0.1..10.0, r_j in 0.1..10.0, delta_n in 0.01..1.0,
        ) {
            let stress = normal_stiffness(a_n, e, r_i, r_j) * delta_n / a_n;
            prop_assert!(relative_eq!(stress, e * (delta_n / (r_i + r_j)), max_relative = 1e-14));
        }

        #[test]
        fn of_equal_spheres_grows_with_the_radius(e in 0.1..10.0, r in 0.1..10.0, factor in 0.5..4.0) {
            let k_n = |r: f64| normal_stiffness(normal_cross_section(r, 0.15), e, r, r);
            prop_assert!(relative_eq!(k_n(factor * r), factor * k_n(r), max_relative = 1e-14));
        }
    }
}
