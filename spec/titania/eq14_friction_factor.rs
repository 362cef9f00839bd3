//! The drag of the carrier gas on an aggregate.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 14**, Section 5.3: friction factor of an aggregate in a gas.
///
/// ```math
/// f = \frac{6\pi\mu R_H}{C_C\left(\frac{\lambda\pi R_H}{PA}\right)}
/// ```
///
/// # Reading
///
/// Ambiguous: $C_C$ is a function of the Knudsen number in the parentheses, not a factor. The paper does not give it; with the coefficients of Davies,
/// $C_C = 1 + \text{Kn} (1.257 + 0.4 \, e^{-1.1/\text{Kn}})$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `mu` | $\mu$ | Pa s | > 0 | viscosity of the gas |
/// | `lam` | $\lambda$ | m | > 0 | mean free path of the gas |
/// | `r_h` | $R_H$ | m | > 0 | hydrodynamic radius |
/// | `pa` | $PA$ | m^2 | > 0 | mean projected area |
/// | → `kn` | $\text{Kn}$ | 1 | | Knudsen number |
/// | → `cc` | $C_C$ | 1 | | slip correction |
/// | → `f` | $f$ | kg/s | | friction factor |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `of_a_sphere_the_knudsen_number_is_the_free_path_over_the_radius`
/// * `in_a_dense_gas_it_is_the_drag_of_stokes`
/// * `in_a_thin_gas_it_depends_on_the_projected_area_alone`
/// * `between_thin_and_dense_gas_the_slip_is_that_of_cunningham`
#[inline(always)]
pub fn friction_factor<R: Real>(mu: R, lam: R, r_h: R, pa: R) -> (R, R, R) {
    let decimal = |digits: f64, power: f64| R::lit(digits) / R::lit(power);
    let kn = lam * R::pi() * r_h / pa;
    let cc = R::one() + kn * (decimal(1257.0, 1000.0) + decimal(4.0, 10.0) * (-(decimal(11.0, 10.0) / kn)).exp());
    (kn, cc, R::lit(6.0) * R::pi() * mu * r_h / cc)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq14_friction_factor.rs", "titania-14", ["14"], friction_factor)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    proptest! {
        #[test]
        fn of_a_sphere_the_knudsen_number_is_the_free_path_over_the_radius(r in 0.1..10.0, lam in 0.1..10.0) {
            prop_assert!(relative_eq!(friction_factor(1.0, lam, r, PI * r * r).0, lam / r, max_relative = 1e-14));
        }

        #[test]
        fn in_a_dense_gas_it_is_the_drag_of_stokes(mu in 0.1..10.0, r in 0.1..10.0) {
            prop_assert!(relative_eq!(friction_factor(mu, 1e-9, r, PI * r * r).2, 6.0 * PI * mu * r, max_relative = 1e-6));
        }

        #[test]
        fn in_a_thin_gas_it_depends_on_the_projected_area_alone(r in 0.1..10.0, pa in 0.1..10.0) {
            let (lam, mu) = (1e9, 2.0);
            prop_assert!(relative_eq!(friction_factor(mu, lam, r, pa).2, 6.0 * mu * pa / (1.657 * lam), max_relative = 1e-6));
        }
    }

    #[test]
    fn between_thin_and_dense_gas_the_slip_is_that_of_cunningham() {
        for (kn, slip) in [(0.5, 0.5 * (1.257 + 0.4 * f64::exp(-2.2))), (2.0, 2.0 * (1.257 + 0.4 * f64::exp(-0.55)))] {
            let (found, cc, f) = friction_factor(3.0, kn, 1.0, PI);
            assert!(
                relative_eq!(found, kn, max_relative = 1e-15) && relative_eq!(cc, 1.0 + slip, max_relative = 1e-14)
            );
            assert!(relative_eq!(f, 18.0 * PI / (1.0 + slip), max_relative = 1e-14));
        }
    }
}
