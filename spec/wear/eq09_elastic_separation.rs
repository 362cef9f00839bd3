//! The elastic separation of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 9**, Section 2.2: separation up to which a pair is elastic.
///
/// ```math
/// \delta_e = \frac{(r_i + r_j) \sigma_{m,N}}{E}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.29 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | → `delta_e` | $\delta_e$ | m | | elastic separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `there_the_cross_section_carries_the_tensile_strength`
/// * `grows_with_the_size_of_the_particles`
#[inline(always)]
pub fn elastic_separation<R: Real>(r_i: R, r_j: R, sigma_mn: R, e: R) -> R {
    (r_i + r_j) * sigma_mn / e
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq09_elastic_separation.rs", "wear-9", ["9"], elastic_separation)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn there_the_cross_section_carries_the_tensile_strength(
            a_n in 0.1..10.0, e in 0.1..10.0, r_i in 0.1..10.0, r_j in 0.1..10.0, sigma_mn in 0.1..10.0,
        ) {
            let force = normal_stiffness(a_n, e, r_i, r_j) * elastic_separation(r_i, r_j, sigma_mn, e);
            prop_assert!(relative_eq!(force / a_n, sigma_mn, max_relative = 1e-14));
        }

        #[test]
        fn grows_with_the_size_of_the_particles(r_i in 0.1..10.0, r_j in 0.1..10.0, factor in 0.5..4.0) {
            let (small, large) = (elastic_separation(r_i, r_j, 0.2, 1.0), elastic_separation(factor * r_i, factor * r_j, 0.2, 1.0));
            prop_assert!(relative_eq!(large, factor * small, max_relative = 1e-14));
        }
    }
}
