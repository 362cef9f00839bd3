//! From the measured stiffness coefficients to Young's modulus and Poisson's ratio.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 3**, unnumbered: moduli of a cubic or isotropic solid from the stresses of a confined sample.
///
/// ```math
/// \nu = \frac{C_{12}}{C_{11} + C_{12}}, \quad E = \frac{(C_{11} - C_{12})(C_{11} + 2 C_{12})}{C_{11} + C_{12}}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `c11` | $C_{11}$ | Pa | > 0 | stress over strain along the load |
/// | `c12` | $C_{12}$ | Pa | any | stress across the load over the same strain |
/// | → `nu` | $\nu$ | 1 | | Poisson's ratio |
/// | → `e` | $E$ | Pa | | Young's modulus |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `hooke_s_law_gives_the_coefficients_back`
/// * `a_sample_that_does_not_push_sideways_has_no_lateral_contraction`
#[inline(always)]
pub fn elastic_moduli<R: Real>(c11: R, c12: R) -> (R, R) {
    let sum = c11 + c12;
    (c12 / sum, (c11 - c12) * (sum + c12) / sum)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/def_elastic_constants.rs", "wear-EnuFromC", [], elastic_moduli)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn hooke_s_law_gives_the_coefficients_back(c11 in 1.0..2.0, c12 in -0.3..0.9) {
            // A confined sample under a unit strain: the strains that Hooke's law derives from the stresses.
            let (nu, e) = elastic_moduli(c11, c12);
            let along = (c11 - nu * (c12 + c12)) / e;
            let across: f64 = (c12 - nu * (c11 + c12)) / e;
            prop_assert!(relative_eq!(along, 1.0, max_relative = 1e-13));
            prop_assert!(across.abs() < 1e-14 * (1.0 + c11 / e));
        }

        #[test]
        fn a_sample_that_does_not_push_sideways_has_no_lateral_contraction(c11 in 0.1..10.0) {
            let (nu, e) = elastic_moduli(c11, 0.0);
            prop_assert!(nu == 0.0 && relative_eq!(e, c11));
        }
    }
}
