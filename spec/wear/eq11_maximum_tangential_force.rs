//! The largest tangential force of a pair in contact.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 11**, Section 2.2: largest tangential force of a pair in contact.
///
/// ```math
/// F_{m,T} = A_T \sigma_{m,T}
/// ```
///
/// # Reading
///
/// As printed; Eq. A.30 repeats it.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_t` | $A_T$ | m^2 | >= 0 | tangential cross section |
/// | `sigma_mt` | $\sigma_{m,T}$ | Pa | >= 0 | shear strength |
/// | → `f_mt` | $F_{m,T}$ | N | | largest tangential force in contact |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_cross_section_carries_the_shear_strength`
/// * `none_is_left_at_a_poisson_s_ratio_of_one_quarter`
#[inline(always)]
pub fn maximum_tangential_force<R: Real>(a_t: R, sigma_mt: R) -> R {
    a_t * sigma_mt
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq11_maximum_tangential_force.rs", "wear-11", ["11"], maximum_tangential_force)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::eq16_tangential_cross_section::tangential_cross_section;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_cross_section_carries_the_shear_strength(a_t in 0.1..10.0, sigma_mt in 0.0..10.0) {
            prop_assert!(relative_eq!(maximum_tangential_force(a_t, sigma_mt) / a_t, sigma_mt));
        }

        #[test]
        fn none_is_left_at_a_poisson_s_ratio_of_one_quarter(r in 0.1..10.0, sigma_mt in 0.1..10.0) {
            prop_assert_eq!(maximum_tangential_force(tangential_cross_section(r, 0.25), sigma_mt), 0.0);
        }
    }
}
