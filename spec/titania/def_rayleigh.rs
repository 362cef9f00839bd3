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

    #[test]
    fn is_a_picosecond_for_the_smallest_particles() {
        assert!((rayleigh_time(1.5e-9, 4230.0, 111e9, 0.27) - 1e-12f64).abs() < 1e-14);
    }
}
