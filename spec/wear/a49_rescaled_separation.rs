//! The rescaled fracture separation of large spheres.

use super::eq18_critical_diameter::critical_diameter;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.49**, Appendix A.2.1: fracture separation of spheres larger than the critical diameter of A.48, which is Eq. 18.
///
/// ```math
/// \delta'_f = \delta_e \left(\frac{r_i + r_j}{d_c}\right)^{-s}
/// ```
///
/// # Reading
///
/// As printed, for `r_i + r_j > d_c`: the second case of Eq. 10. The power is $e^{-s \ln(\cdot)}$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `d_c` | $d_c$ | m | > 0 | critical diameter |
/// | `s` | $s$ | 1 | >= 0 | scaling parameter |
/// | → `delta_f` | $\delta'_f$ | m | | fracture separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_fracture_separation_of_large_spheres`
/// * `without_scaling_the_elastic_limit_is_matched`
/// * `a_scaling_of_one_half_matches_the_surface_energy`
/// * `no_scaling_at_all_would_match_neither`
#[inline(always)]
pub fn rescaled_separation<R: Real>(delta_e: R, r_i: R, r_j: R, d_c: R, s: R) -> R {
    delta_e * (-s * ((r_i + r_j) / d_c).ln()).exp()
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/eq18_critical_diameter.rs", "wear-A48", ["A48"], critical_diameter),
        equation!("wear/a49_rescaled_separation.rs", "wear-A49", ["A49"], rescaled_separation),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::a31_fracture_energy::{surface_energy, work_of_separation};
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq09_elastic_separation::elastic_separation;
    use crate::wear::eq10_fracture_separation::fracture_separation;
    use crate::wear::eq19_minimum_diameter::minimum_diameter;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 32.0 * f64::EPSILON;
    const E: f64 = 1.0;
    const SIGMA: f64 = 0.2;
    const GAMMA: f64 = 1.5;

    /// Radius, critical diameter and elastic separation of spheres `size` times as large as the critical diameter.
    fn spheres(size: f64) -> (f64, f64, f64) {
        let d_c = critical_diameter(GAMMA, E, SIGMA);
        let r = 0.5 * size * d_c;
        (r, d_c, elastic_separation(r, r, SIGMA, E))
    }
    /// Surface energy of these spheres for a given fracture separation.
    fn matched(r: f64, delta_e: f64, delta_f: f64) -> f64 {
        surface_energy(work_of_separation(normal_stiffness(1.0, E, r, r), delta_e, delta_f), 1.0)
    }

    proptest! {
        #[test]
        fn is_the_fracture_separation_of_large_spheres(size in 1.01..100.0, s in 0.0..2.0) {
            let (r, d_c, delta_e) = spheres(size);
            let eq_10 = fracture_separation(GAMMA, SIGMA, r, r, d_c, delta_e, s);
            assert_relative_eq!(rescaled_separation(delta_e, r, r, d_c, s), eq_10, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn without_scaling_the_elastic_limit_is_matched(size in 1.0..100.0) {
            let (r, d_c, delta_e) = spheres(size);
            prop_assert_eq!(rescaled_separation(delta_e, r, r, d_c, 0.0), delta_e);
        }

        #[test]
        fn a_scaling_of_one_half_matches_the_surface_energy(size in 1.0..100.0) {
            let (r, d_c, delta_e) = spheres(size);
            let delta_f = rescaled_separation(delta_e, r, r, d_c, 0.5);
            assert_relative_eq!(matched(r, delta_e, delta_f), GAMMA, epsilon = 0.0, max_relative = ROUNDING);
        }

        /// Figure A.1: with A.34 for large spheres too, the force breaks off early and the energy is too small.
        #[test]
        fn no_scaling_at_all_would_match_neither(size in 1.01..100.0) {
            let (r, _, delta_e) = spheres(size);
            let delta_f = minimum_diameter(GAMMA, SIGMA);
            prop_assert!(delta_f < delta_e);
            assert_relative_eq!(matched(r, delta_e, delta_f), GAMMA / size, epsilon = 0.0, max_relative = ROUNDING);
        }
    }
}
