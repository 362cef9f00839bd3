//! Sizes of aggregates.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Section 5.3**, unnumbered: number of particles in an aggregate of a given diameter of gyration.
///
/// ```math
/// N_p = k_f \left(\frac{d_g}{\bar{d}_s}\right)^{D_f}
/// ```
///
/// # Reading
///
/// As printed, with $k_f$ = 1.0 and $D_f$ = 1.8.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_f` | $k_f$ | 1 | > 0 | fractal prefactor |
/// | `d_g` | $d_g$ | m | > 0 | diameter of gyration |
/// | `d_s` | $\bar{d}_s$ | m | > 0 | Sauter diameter of the particles |
/// | `d_f` | $D_f$ | 1 | > 0 | fractal dimension |
/// | → `n_p` | $N_p$ | 1 | | number of particles |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `one_particle_has_its_own_diameter`
#[inline]
pub fn fractal_number<R: Real>(k_f: R, d_g: R, d_s: R, d_f: R) -> R {
    k_f * (d_f * (d_g / d_s).ln()).exp()
}

/// **Section 5.3**, unnumbered: diameter of gyration of an aggregate of a given number of particles.
///
/// ```math
/// d_g = \bar{d}_s \left(\frac{N_p}{k_f}\right)^{1/D_f}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_f` | $k_f$ | 1 | > 0 | fractal prefactor |
/// | `n_p` | $N_p$ | 1 | > 0 | number of particles |
/// | `d_s` | $\bar{d}_s$ | m | > 0 | Sauter diameter of the particles |
/// | `d_f` | $D_f$ | 1 | > 0 | fractal dimension |
/// | → `d_g` | $d_g$ | m | | diameter of gyration |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `number_and_diameter_of_gyration_are_inverse`
#[inline]
pub fn fractal_diameter<R: Real>(k_f: R, n_p: R, d_s: R, d_f: R) -> R {
    d_s * ((n_p / k_f).ln() / d_f).exp()
}

/// **Section 5.3**, unnumbered: number of particles in an aggregate of a given mobility diameter.
///
/// ```math
/// N_p = k_m \left(\frac{d_m}{\bar{d}_s}\right)^{D_{fm}}
/// ```
///
/// # Reading
///
/// As printed, with $k_m$ = 1.0 and $D_{fm}$ = 2.15.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_m` | $k_m$ | 1 | > 0 | mass mobility prefactor |
/// | `d_m` | $d_m$ | m | > 0 | mobility diameter |
/// | `d_s` | $\bar{d}_s$ | m | > 0 | Sauter diameter of the particles |
/// | `d_fm` | $D_{fm}$ | 1 | > 0 | mass mobility dimension |
/// | → `n_p` | $N_p$ | 1 | | number of particles |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `at_the_same_diameter_a_mobility_sphere_holds_more`
#[inline]
pub fn mobility_number<R: Real>(k_m: R, d_m: R, d_s: R, d_fm: R) -> R {
    fractal_number(k_m, d_m, d_s, d_fm)
}

/// **Section 5.3**, unnumbered: Sauter diameter of a collection of particles.
///
/// ```math
/// \bar{d}_s = \frac{6 V_{p,tot}}{A_{p,tot}} = \frac{\sum d^3}{\sum d^2}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_tot` | $V_{p,tot}$ | m^3 | > 0 | volume of all particles |
/// | `a_tot` | $A_{p,tot}$ | m^2 | > 0 | surface of all particles |
/// | → `d_s` | $\bar{d}_s$ | m | | Sauter diameter |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_sauter_diameter_lies_between_the_mean_and_the_largest`
/// * `mixtures_of_spheres_have_the_diameter_of_the_independent_values`
#[inline]
pub fn sauter_diameter<R: Real>(v_tot: R, a_tot: R) -> R {
    R::lit(6.0) * v_tot / a_tot
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/def_aggregate.rs", "titania-kf", [], fractal_number),
        equation!("titania/def_aggregate.rs", "titania-kf-inv", [], fractal_diameter),
        equation!("titania/def_aggregate.rs", "titania-km", [], mobility_number),
        equation!("titania/def_aggregate.rs", "titania-sauter", [], sauter_diameter),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn of_spheres(diameters: &[f64]) -> f64 {
        let sum = |power| diameters.iter().map(|d| d.powi(power)).sum::<f64>();
        sauter_diameter(PI / 6.0 * sum(3), PI * sum(2))
    }

    proptest! {
        #[test]
        fn one_particle_has_its_own_diameter(d in 0.1..10.0, d_f in 1.0..3.0) {
            prop_assert_eq!(fractal_number(1.0, d, d, d_f), 1.0);
        }

        #[test]
        fn number_and_diameter_of_gyration_are_inverse(k_f in 0.5..2.0, n in 1.0..200.0, d_s in 0.1..10.0, d_f in 1.0..3.0) {
            let back = fractal_number(k_f, fractal_diameter(k_f, n, d_s, d_f), d_s, d_f);
            prop_assert!(relative_eq!(back, n, max_relative = 1e-13));
        }

        #[test]
        fn at_the_same_diameter_a_mobility_sphere_holds_more(ratio in 1.01..20.0) {
            prop_assert!(mobility_number(1.0, ratio, 1.0, 2.15) > fractal_number(1.0, ratio, 1.0, 1.8));
            prop_assert_eq!(mobility_number(1.4, ratio, ratio, 2.15), 1.4);
        }

        #[test]
        fn the_sauter_diameter_lies_between_the_mean_and_the_largest(diameters in prop::collection::vec(3.0..23.0f64, 1..20)) {
            let mean = diameters.iter().sum::<f64>() / diameters.len() as f64;
            let largest = diameters.iter().fold(0.0, |a: f64, b| a.max(*b));
            let d_s = of_spheres(&diameters);
            prop_assert!(d_s >= mean * (1.0 - 1e-14) && d_s <= largest * (1.0 + 1e-14));
        }
    }

    #[test]
    fn mixtures_of_spheres_have_the_diameter_of_the_independent_values() {
        let mixed = [vec![3.0; 10], vec![23.0]].concat();
        for (diameters, d_s) in [
            (vec![9.0], 9.0),
            (mixed, 20.092084006462036),
            (vec![8.0, 9.0, 10.0], 9.146938775510204),
            (vec![5.0, 5.0, 5.0, 15.0, 15.0], 13.57142857142857),
        ] {
            assert!(relative_eq!(of_spheres(&diameters), d_s, max_relative = 1e-15));
        }
    }
}
