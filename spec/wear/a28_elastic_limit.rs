//! The elastic limit of a pair.

use super::eq09_elastic_separation::elastic_separation;
use super::eq11_maximum_tangential_force::maximum_tangential_force;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.28**, Appendix A.2: elastic limit as a strain.
///
/// ```math
/// \varepsilon_e = \frac{\sigma_{m,N}}{E}
/// ```
///
/// # Reading
///
/// As printed. Multiplied by the distance between the centres it is A.29, which is Eq. 9; the limit of the tangential force,
/// A.30, is Eq. 11.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | → `epsilon_e` | $\varepsilon_e$ | 1 | | elastic strain |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_strain_of_the_elastic_separation`
/// * `the_stress_there_is_the_tensile_strength`
#[inline(always)]
pub fn elastic_strain<R: Real>(sigma_mn: R, e: R) -> R {
    sigma_mn / e
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a28_elastic_limit.rs", "wear-A28", ["A28"], elastic_strain),
        equation!("wear/eq09_elastic_separation.rs", "wear-A29", ["A29"], elastic_separation),
        equation!("wear/eq11_maximum_tangential_force.rs", "wear-A30", ["A30"], maximum_tangential_force),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a20_stress::{elastic_stress, normal_strain};
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 8.0 * f64::EPSILON;

    proptest! {
        #[test]
        fn is_the_strain_of_the_elastic_separation(
            (sigma, e) in (0.01..1.0, 0.1..10.0), (r_i, r_j) in (0.1..10.0, 0.1..10.0),
        ) {
            let strain = normal_strain(elastic_separation(r_i, r_j, sigma, e), r_i, r_j);
            assert_relative_eq!(elastic_strain(sigma, e), strain, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn the_stress_there_is_the_tensile_strength((sigma, e) in (0.01..1.0, 0.1..10.0)) {
            let stress = elastic_stress(e, elastic_strain(sigma, e));
            assert_relative_eq!(stress, sigma, epsilon = 0.0, max_relative = ROUNDING);
        }
    }
}
