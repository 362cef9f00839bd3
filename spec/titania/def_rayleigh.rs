//! The time step.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 2.5**, unnumbered: Rayleigh time of a sphere.
///
/// ```math
/// T_R = \frac{\pi R \sqrt{\rho / G}}{0.1631 \, \nu + 0.8766}
/// ```
///
/// # Reading
///
/// The time of a surface wave across half the sphere, with the customary coefficients, which the paper does not print. For rutile and the
/// smallest particles of 3 nm it is the 1 ps of the paper, half of which is the time step.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $R$ | m | > 0 | radius |
/// | `rho` | $\rho$ | kg/m^3 | > 0 | density |
/// | `g` | $G$ | Pa | > 0 | shear modulus |
/// | `nu` | $\nu$ | 1 | (-1, 1/2] | Poisson's ratio |
/// | → `t_r` | $T_R$ | s | | Rayleigh time |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_a_picosecond_for_the_smallest_particles`
/// * `half_the_way_round_takes_as_long_as_the_wave_of_rayleigh`
/// * `the_customary_line_has_its_four_digits`
#[inline(always)]
pub fn rayleigh_time<R: Real>(r: R, rho: R, g: R, nu: R) -> R {
    let coefficient = (R::lit(1631.0) * nu + R::lit(8766.0)) / R::lit(10000.0);
    R::pi() * r * (rho / g).sqrt() / coefficient
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/def_rayleigh.rs", "titania-rayleigh", [], rayleigh_time)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    /// Speed of the wave over that of shear waves: the root of Rayleigh's equation, by bisection.
    fn wave(nu: f64) -> f64 {
        let q = (1.0 - 2.0 * nu) / (2.0 - 2.0 * nu);
        let equation = |x: f64| x * x * x - 8.0 * x * x + (24.0 - 16.0 * q) * x - 16.0 * (1.0 - q);
        let (mut low, mut high) = (0.3, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if equation(middle) < 0.0 { low = middle } else { high = middle }
        }
        low.sqrt()
    }

    proptest! {
        #[test]
        fn half_the_way_round_takes_as_long_as_the_wave_of_rayleigh(r in 0.1..10.0, rho in 0.1..10.0f64, g in 0.1..10.0f64, nu in 0.0..0.5) {
            let speed = std::f64::consts::PI * r / rayleigh_time(r, rho, g, nu);
            // the customary line deviates from the root by a third of a percent
            prop_assert!((speed / (g / rho).sqrt() / wave(nu) - 1.0).abs() < 4e-3);
        }
    }

    #[test]
    fn is_a_picosecond_for_the_smallest_particles() {
        assert!((rayleigh_time(1.5e-9, 4230.0, 111e9, 0.27) - 1e-12f64).abs() < 1e-14);
    }

    #[test]
    fn the_customary_line_has_its_four_digits() {
        for (nu, line) in [(0.0, 0.8766), (0.5, 0.95815)] {
            assert!((rayleigh_time(3.0, 4.0, 16.0, nu) * line / (1.5 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
        }
    }
}
