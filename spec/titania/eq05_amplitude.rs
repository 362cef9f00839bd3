//! Growth of the solvation force with the particle size.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 5**, Section 2.1: amplitude of the solvation force.
///
/// ```math
/// F_{solv}^0 = -11 \, \text{nN} - R^* \cdot 2.4 \, \text{nN/nm}
/// ```
///
/// # Reading
///
/// As printed, fitted for bare radii of 4 to 8 nm. The two constants carry units and are arguments: -11 nN and -2.4 nN/nm.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_star` | $R^*$ | m | > 0 | effective radius of the bare particles |
/// | `f_00` | $F_{00}$ | N | any | amplitude of vanishing particles, -11 nN |
/// | `slope` | $F_{01}$ | N/m | any | growth with the effective radius, -2.4 nN/nm |
/// | → `f_0` | $F_{solv}^0$ | N | | amplitude |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_20_6_and_30_2_nanonewton_for_4_and_8_nanometre`
/// * `grows_with_the_particles`
#[inline(always)]
pub fn amplitude<R: Real>(r_star: R, f_00: R, slope: R) -> R {
    f_00 + slope * r_star
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq05_amplitude.rs", "titania-5", ["5"], amplitude)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn is_20_6_and_30_2_nanonewton_for_4_and_8_nanometre() {
        for (r_star, f_0) in [(4e-9, -20.6e-9), (8e-9, -30.2e-9), (1.15e-8, -3.86e-8), (2e-8, -5.9e-8)] {
            assert!((amplitude(r_star, -11e-9, -2.4) - f_0).abs() < 1e-23);
        }
    }

    proptest! {
        #[test]
        fn grows_with_the_particles(r_star in 0.5..10.0, more in 0.1..1.0) {
            prop_assert!(amplitude(r_star + more, -11.0, -2.4) < amplitude(r_star, -11.0, -2.4));
        }
    }
}
