//! The tangential stiffness of a pair.

use crate::equation::Equation;
use crate::wear::eq07_normal_stiffness::normal_stiffness;
use crate::{Real, equation};

/// **Eq. 8**, Section 2.2: tangential stiffness of a pair.
///
/// ```math
/// k_T = \frac{A_T E}{r_i + r_j}
/// ```
///
/// # Reading
///
/// Eq. 7 with the tangential cross section. It contains Young's modulus, not the shear modulus: the cross section of
/// Eq. 16 compensates for this.
///
/// Eq. A.27 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_t` | $A_T$ | m^2 | >= 0 | tangential cross section |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `k_t` | $k_T$ | N/m | | tangential stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `its_ratio_to_the_normal_stiffness_depends_on_poisson_s_ratio_alone`
/// * `swapping_the_particles_changes_nothing`
#[inline(always)]
pub fn tangential_stiffness<R: Real>(a_t: R, e: R, r_i: R, r_j: R) -> R {
    normal_stiffness(a_t, e, r_i, r_j)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq08_tangential_stiffness.rs", "wear-8", ["8"], tangential_stiffness)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq15_normal_cross_section::normal_cross_section;
    use crate::wear::eq16_tangential_cross_section::tangential_cross_section;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn its_ratio_to_the_normal_stiffness_depends_on_poisson_s_ratio_alone(
            nu in -0.5..0.25, e in 0.1..10.0, r_i in 0.1..10.0, r_j in 0.1..10.0,
        ) {
            let r_eff: f64 = f64::min(r_i, r_j);
            let k_t = tangential_stiffness(tangential_cross_section(r_eff, nu), e, r_i, r_j);
            let k_n = normal_stiffness(normal_cross_section(r_eff, nu), e, r_i, r_j);
            prop_assert!(relative_eq!(k_t / k_n, (1.0 - 4.0 * nu) / (1.0 + nu), max_relative = 1e-13));
        }

        #[test]
        fn swapping_the_particles_changes_nothing(a_t in 0.1..10.0, e in 0.1..10.0, r_i in 0.1..10.0, r_j in 0.1..10.0) {
            prop_assert_eq!(tangential_stiffness(a_t, e, r_i, r_j), tangential_stiffness(a_t, e, r_j, r_i));
        }
    }
}
