//! The moments of inertia of primary particles.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::mechanics::sphere::moment_of_inertia;
use crate::{Real, equation};

/// **Section 2.1**, unnumbered: moment of inertia of a solid primary particle.
///
/// ```math
/// I = \frac{2}{5} m r^2
/// ```
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
/// * `a_solid_sphere_is_a_pile_of_hollow_ones`
#[inline(always)]
pub fn solid_inertia<R: Real>(m: R, r: R) -> R {
    moment_of_inertia(m, r)
}

/// **Section 2.1**, unnumbered: moment of inertia of a hollow primary particle, such as soot oxidised from within.
///
/// ```math
/// I = \frac{2}{3} m r^2
/// ```
///
/// # Reading
///
/// The wall is thin. A wall of finite thickness lies between this and the solid sphere.
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
/// * `averages_the_squared_distance_from_the_axis`
#[inline(always)]
pub fn hollow_inertia<R: Real>(m: R, r: R) -> R {
    R::lit(2.0) / R::lit(3.0) * m * r.squared()
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/primary_particle.rs", "soot-solid-inertia", [], solid_inertia),
        equation!("mechanics/primary_particle.rs", "soot-hollow-inertia", [], hollow_inertia),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_solid_sphere_is_a_pile_of_hollow_ones(m in 0.1..10.0f64, r in 0.1..10.0f64) {
            // Shells at the middles of 1000 layers; their mass is as the square of the radius.
            let shells = 1000;
            let middle = |k: i32| (f64::from(k) + 0.5) / f64::from(shells);
            let pile: f64 = (0..shells)
                .map(|k| hollow_inertia(3.0 * m * middle(k) * middle(k) / f64::from(shells), r * middle(k)))
                .sum();
            prop_assert!((pile / solid_inertia(m, r) - 1.0).abs() < 1e-5);
        }

        #[test]
        fn averages_the_squared_distance_from_the_axis(m in 0.1..10.0f64, r in 0.1..10.0f64) {
            // The three moments about perpendicular axes add up to twice that about the centre.
            prop_assert!((3.0 * hollow_inertia(m, r) / (2.0 * m * r * r) - 1.0).abs() < 1e-15);
        }
    }
}
