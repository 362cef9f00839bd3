//! The effective radius of a pair.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 14**, Section 2.2: effective radius of a pair.
///
/// ```math
/// r_{\mathrm{eff}} = \min(r_i, r_j)
/// ```
///
/// # Reading
///
/// As printed, and again in Eq. A.66: a choice.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `r_eff` | $r_{\mathrm{eff}}$ | m | | effective radius |
///
/// Rounding: at most 0 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_changes_nothing`
/// * `is_the_radius_of_equal_spheres`
/// * `no_larger_than_either_and_equal_to_one`
#[inline(always)]
pub fn effective_radius<R: Real>(r_i: R, r_j: R) -> R {
    r_i.min(r_j)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq14_effective_radius.rs", "wear-14", ["14"], effective_radius)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn swapping_the_particles_changes_nothing(r_i in 0.1..10.0, r_j in 0.1..10.0) {
            prop_assert_eq!(effective_radius(r_i, r_j), effective_radius(r_j, r_i));
        }

        #[test]
        fn is_the_radius_of_equal_spheres(r in 0.1..10.0) {
            prop_assert_eq!(effective_radius(r, r), r);
        }

        #[test]
        fn no_larger_than_either_and_equal_to_one(r_i in 0.1..10.0, r_j in 0.1..10.0) {
            let r_eff = effective_radius(r_i, r_j);
            prop_assert!(r_eff <= r_i && r_eff <= r_j && (r_eff == r_i || r_eff == r_j));
        }
    }
}
