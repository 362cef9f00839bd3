//! The smallest reasonable particle diameter.

use super::a31_fracture_energy::separation_of_surface_energy;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 19**, Section 2.2: smallest reasonable diameter, at which the range of a particle equals its diameter.
///
/// ```math
/// d_{\min} = \frac{4 \gamma}{\sigma_{m,N}}
/// ```
///
/// # Reading
///
/// As printed: the separation of A.34, at which small particles break, as a diameter.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | → `d_min` | $d_{\min}$ | m | | smallest diameter |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_to_the_critical_diameter_as_the_strength_to_young_s_modulus`
/// * `is_the_range_of_small_particles`
/// * `of_the_patch_tests_is_30_and_of_silica_0_375_nm`
#[inline(always)]
pub fn minimum_diameter<R: Real>(gamma: R, sigma_mn: R) -> R {
    separation_of_surface_energy(gamma, sigma_mn)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq19_minimum_diameter.rs", "wear-19", ["19"], minimum_diameter)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq10_fracture_separation::fracture_separation;
    use crate::wear::eq18_critical_diameter::critical_diameter;
    use approx::{assert_relative_eq, relative_eq};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn is_to_the_critical_diameter_as_the_strength_to_young_s_modulus(
            gamma in 0.1..10.0, e in 0.1..10.0, sigma_mn in 0.1..10.0,
        ) {
            let ratio = critical_diameter(gamma, e, sigma_mn) / minimum_diameter(gamma, sigma_mn);
            prop_assert!(relative_eq!(ratio, e / sigma_mn, max_relative = 1e-14));
        }

        #[test]
        fn is_the_range_of_small_particles(gamma in 0.1..10.0, sigma_mn in 0.1..10.0, s in 0.0..2.0) {
            let delta_f = fracture_separation(gamma, sigma_mn, 0.1, 0.1, 1.0, 0.05, s);
            prop_assert_eq!(delta_f, minimum_diameter(gamma, sigma_mn));
        }
    }

    #[test]
    fn of_the_patch_tests_is_30_and_of_silica_0_375_nm() {
        assert_relative_eq!(minimum_diameter(1.5, 0.2), 30.0, max_relative = 1e-15);
        assert_relative_eq!(minimum_diameter(1.5, 16e9), 0.375e-9, max_relative = 1e-15);
    }
}
