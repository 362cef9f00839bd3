//! The masses of a solid sphere.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 2**, unnumbered: mass of a sphere.
///
/// ```math
/// m = \frac{4}{3} \pi \rho r^3
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `rho` | $\rho$ | kg/m^3 | > 0 | density |
/// | `r` | $r$ | m | > 0 | radius |
/// | → `m` | $m$ | kg | | mass |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `eight_times_the_mass_for_twice_the_radius`
/// * `sums_the_shells_of_the_sphere`
#[inline(always)]
pub fn sphere_mass<R: Real>(rho: R, r: R) -> R {
    R::lit(4.0) / R::lit(3.0) * R::pi() * rho * (r * r * r)
}

/// **Section 2**, unnumbered: moment of inertia of a solid sphere about its centre.
///
/// ```math
/// I = \frac{2}{5} m r^2
/// ```
///
/// # Reading
///
/// Missing in Eq. 1. The paper's particles are solid spheres of the material.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m` | $m$ | kg | > 0 | mass |
/// | `r` | $r$ | m | > 0 | radius |
/// | → `i` | $I$ | kg m^2 | | moment of inertia |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `sums_the_shells_of_the_sphere`
#[inline(always)]
pub fn moment_of_inertia<R: Real>(m: R, r: R) -> R {
    R::lit(2.0) / R::lit(5.0) * m * r.squared()
}

/// **Appendix A.1**, unnumbered: mass that resists the sliding of two equal solid spheres over each other.
///
/// ```math
/// m_T = \frac{2}{7} m_{\mathrm{eff}}
/// ```
///
/// # Reading
///
/// The paper uses the effective mass of Eq. 17 for sliding. But a force on the surface of a sphere also rotates it, and the surface moves with
/// $1/m + r^2/I = 7/(2m)$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_eff` | $m_{\mathrm{eff}}$ | kg | > 0 | effective mass |
/// | → `m_t` | $m_T$ | kg | | mass that slides |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_what_a_force_on_the_two_surfaces_accelerates`
#[inline(always)]
pub fn sliding_mass<R: Real>(m_eff: R) -> R {
    R::lit(2.0) / R::lit(7.0) * m_eff
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/sphere.rs", "wear-sphere-mass", [], sphere_mass),
        equation!("mechanics/sphere.rs", "wear-inertia", [], moment_of_inertia),
        equation!("mechanics/sphere.rs", "wear-sliding-mass", [], sliding_mass),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::reduced_mass::effective_mass;
    use approx::relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn eight_times_the_mass_for_twice_the_radius(rho in 0.1..10.0, r in 0.1..10.0) {
            prop_assert_eq!(sphere_mass(rho, 2.0 * r), 8.0 * sphere_mass(rho, r));
        }

        #[test]
        fn sums_the_shells_of_the_sphere(rho in 0.1..10.0, r in 0.1..10.0) {
            // A shell of radius u has 2/3 of its mass times u^2; midpoint rule.
            let shells = 1000;
            let du = r / f64::from(shells);
            let sum: f64 = (0..shells)
                .map(|k| (f64::from(k) + 0.5) * du)
                .map(|u| 2.0 / 3.0 * u * u * (4.0 * std::f64::consts::PI * rho * u * u * du))
                .sum();
            prop_assert!(relative_eq!(moment_of_inertia(sphere_mass(rho, r), r), sum, max_relative = 1e-5));
        }

        #[test]
        fn is_what_a_force_on_the_two_surfaces_accelerates(m in 0.1..10.0, r in 0.1..10.0) {
            let per_sphere = 1.0 / m + r * r / moment_of_inertia(m, r);
            prop_assert!(relative_eq!(1.0 / sliding_mass(effective_mass(m, m)), 2.0 * per_sphere, max_relative = 1e-14));
        }
    }
}
