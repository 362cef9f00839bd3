//! The critical diameter, above which strength and surface energy cannot both be matched.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 18**, Section 2.2: critical diameter of the particles.
///
/// ```math
/// d_c = \frac{4 \gamma E}{\sigma_{m,N}^2}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.48 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | → `d_c` | $d_c$ | m | | critical diameter |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `there_the_elastic_separation_is_the_range`
/// * `of_the_patch_tests_is_150_and_of_silica_1_7_nm`
#[inline(always)]
pub fn critical_diameter<R: Real>(gamma: R, e: R, sigma_mn: R) -> R {
    R::lit(4.0) * gamma * e / sigma_mn.squared()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq18_critical_diameter.rs", "wear-18", ["18"], critical_diameter)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq09_elastic_separation::elastic_separation;
    use crate::wear::eq19_minimum_diameter::minimum_diameter;
    use approx::{assert_relative_eq, relative_eq};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn there_the_elastic_separation_is_the_range(gamma in 0.1..10.0, e in 0.1..10.0, sigma_mn in 0.1..10.0) {
            let r = 0.5 * critical_diameter(gamma, e, sigma_mn);
            prop_assert!(relative_eq!(elastic_separation(r, r, sigma_mn, e), minimum_diameter(gamma, sigma_mn), max_relative = 1e-14));
        }
    }

    #[test]
    fn of_the_patch_tests_is_150_and_of_silica_1_7_nm() {
        assert_relative_eq!(critical_diameter(1.5, 1.0, 0.2), 150.0, max_relative = 1e-15);
        assert_relative_eq!(critical_diameter(1.5, 73e9, 16e9), 1.7109375e-9, max_relative = 1e-15);
    }
}
