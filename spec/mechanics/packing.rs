//! Volume fraction and mass of a packing.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 3.2**, unnumbered: volume fraction of spheres in a box.
///
/// ```math
/// \phi = \frac{1}{V} \frac{\pi}{6} \sum d^3
/// ```
///
/// # Reading
///
/// Overlaps count twice: a sample is filled to 0.75 before it is relaxed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `sum_d3` | $\sum d^3$ | m^3 | >= 0 | sum of the cubes of the diameters |
/// | `volume` | $V$ | m^3 | > 0 | volume of the box |
/// | → `phi` | $\phi$ | 1 | | volume fraction |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `of_close_packed_spheres_is_0_74`
#[inline(always)]
pub fn volume_fraction<R: Real>(sum_d3: R, volume: R) -> R {
    R::pi() / R::lit(6.0) * sum_d3 / volume
}

/// **Section 3.2**, unnumbered: factor by which all masses are changed after the relaxation.
///
/// ```math
/// \alpha = \frac{\rho V}{\sum m}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rho` | $\rho$ | kg/m^3 | > 0 | density of the material |
/// | `volume` | $V$ | m^3 | > 0 | volume of the system |
/// | `sum_m` | $\sum m$ | kg | > 0 | mass of all particles |
/// | → `alpha` | $\alpha$ | 1 | | factor of the masses |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `gives_the_system_the_density_of_the_material`
/// * `of_spheres_of_the_material_is_the_inverse_volume_fraction`
#[inline(always)]
pub fn mass_factor<R: Real>(rho: R, volume: R, sum_m: R) -> R {
    rho * volume / sum_m
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/packing.rs", "wear-volume-fraction", [], volume_fraction),
        equation!("mechanics/packing.rs", "wear-mass-factor", [], mass_factor),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::sphere::sphere_mass;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn of_close_packed_spheres_is_0_74(d in 0.1..10.0f64) {
            // A hexagonal prism of two layers: one sphere per d * d sqrt(3)/2 * d sqrt(2/3).
            let volume = d * (d * 3f64.sqrt() / 2.0) * (d * (2.0f64 / 3.0).sqrt());
            prop_assert!(relative_eq!(volume_fraction(d * d * d, volume), 0.7404804896930609, max_relative = 1e-14));
        }

        #[test]
        fn gives_the_system_the_density_of_the_material(rho in 0.1..10.0, volume in 0.1..10.0, sum_m in 0.1..10.0) {
            prop_assert!(relative_eq!(mass_factor(rho, volume, sum_m) * sum_m / volume, rho, max_relative = 1e-14));
        }

        #[test]
        fn of_spheres_of_the_material_is_the_inverse_volume_fraction(rho in 0.1..10.0, volume in 0.1..10.0, r in 0.1..10.0) {
            let product = mass_factor(rho, volume, sphere_mass(rho, r)) * volume_fraction(8.0 * r * r * r, volume);
            prop_assert!(relative_eq!(product, 1.0, max_relative = 1e-14));
        }
    }
}
