//! The short-range repulsion of compressed water layers.

use super::def_radius::effective_radius;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. 8**, Section 2.3: repulsion of overlapping particles, with its slope and its energy.
///
/// ```math
/// F_{nr} = k_n \delta_n^{3/2} \sqrt{0.5 (R + h_n)^*}
/// ```
///
/// # Reading
///
/// As printed; zero without overlap. The stiffness is that of Hertz, $\frac{4}{3} E^*$, a pressure. The law is fitted to forces below 5 nN.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_n$ | Pa | > 0 | contact stiffness, Eq. 9 |
/// | `delta_n` | $\delta_n$ | m | any | overlap |
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | → `rhn_star` | $(R + h_n)^*$ | m | | effective radius of the contact spheres |
/// | → `f_nr` | $F_{nr}$ | N | | force, positive when it repels |
/// | → `stiffness` | $dF_{nr}/d\delta_n$ | N/m | | slope of the force |
/// | → `energy` | $V_{nr}$ | J | | energy stored |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `sets_in_smoothly_at_first_touch`
/// * `is_minus_the_gradient_of_the_energy`
/// * `the_stiffness_is_the_slope`
/// * `grows_with_the_power_three_halves_of_the_overlap`
/// * `does_not_depend_on_which_particle_is_first`
/// * `a_plane_is_an_infinite_sphere`
#[inline(always)]
pub fn repulsion<R: Real>(k_n: R, delta_n: R, r_i: R, r_j: R, h_n: R) -> (R, R, R, R) {
    let (rhn_star, r_eff) = effective_radius(r_i + h_n, r_j + h_n);
    let (f_nr, stiffness, energy) = hertz(k_n, delta_n, r_eff);
    (rhn_star, f_nr, stiffness, energy)
}

/// Eq. 8 with half the effective radius, $0.5 (R + h_n)^*$: force, slope and energy.
#[inline(always)]
pub(super) fn hertz<R: Real>(k_n: R, delta_n: R, r_eff: R) -> (R, R, R) {
    let delta = delta_n.max(R::zero());
    let slope = k_n * (delta * r_eff).sqrt();
    let force = slope * delta;
    (force, R::lit(1.5) * slope, R::lit(2.0) * force * delta / R::lit(5.0))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq08_repulsion.rs", "titania-8", ["8"], repulsion)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use approx::relative_eq;
    use proptest::prelude::*;

    fn moving(delta: f64) -> [Dual; 3] {
        let c = Dual::constant;
        let (_, force, stiffness, energy) = repulsion(c(24.5), Dual::variable(delta), c(4.0), c(2.5), c(0.36));
        [force, stiffness, energy]
    }

    proptest! {
        #[test]
        fn sets_in_smoothly_at_first_touch(apart in 0.0..1.0f64, tiny in 1e-12..1e-8) {
            prop_assert_eq!(repulsion(24.5, -apart, 4.0, 4.0, 0.36).1, 0.0);
            let (_, force, stiffness, _) = repulsion(24.5, tiny, 4.0, 4.0, 0.36);
            prop_assert!(force < 1e-10 && stiffness < 0.01);
        }

        #[test]
        fn is_minus_the_gradient_of_the_energy(delta in 0.01..0.5) {
            let [force, _, energy] = moving(delta);
            prop_assert!(relative_eq!(energy.slope, force.value, max_relative = 1e-14));
        }

        #[test]
        fn the_stiffness_is_the_slope(delta in 0.01..0.5) {
            let [force, stiffness, _] = moving(delta);
            prop_assert!(relative_eq!(force.slope, stiffness.value, max_relative = 1e-14));
        }

        #[test]
        fn grows_with_the_power_three_halves_of_the_overlap(delta in 0.01..0.5, factor in 0.1..10.0f64) {
            let grown = repulsion(24.5, factor * delta, 4.0, 4.0, 0.36).1;
            let expected = factor * factor.sqrt() * repulsion(24.5, delta, 4.0, 4.0, 0.36).1;
            prop_assert!(relative_eq!(grown, expected, max_relative = 1e-14));
        }

        #[test]
        fn does_not_depend_on_which_particle_is_first(r_i in 0.5..10.0, r_j in 0.5..10.0) {
            prop_assert_eq!(repulsion(24.5, 0.15, r_i, r_j, 0.36), repulsion(24.5, 0.15, r_j, r_i, 0.36));
        }

        #[test]
        fn a_plane_is_an_infinite_sphere(delta in 0.01..0.5f64, r in 1.0..10.0f64) {
            let on_plane = 24.5 * delta * delta.sqrt() * (r + 0.36).sqrt();
            prop_assert!(relative_eq!(repulsion(24.5, delta, r, 1e13, 0.36).1, on_plane, max_relative = 1e-11));
        }
    }
}
