//! The fracture separation of a pair.

use crate::equation::Equation;
use crate::wear::a31_fracture_energy::separation_of_surface_energy;
use crate::{Real, equation, piecewise};

/// **Eq. 10**, Section 2.2: separation at which the interaction of a pair ends.
///
/// ```math
/// \delta_f = \begin{cases} \dfrac{4 \gamma}{\sigma_{m,N}} & r_i + r_j \le d_c \\
///   \delta_e \left(\dfrac{r_i + r_j}{d_c}\right)^{-s} & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// The power is $e^{-s \ln(\cdot)}$. For large particles and `s > 0` the fracture separation is smaller than the elastic
/// one: the pair then breaks while the force of Eq. 3 is still increasing.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `d_c` | $d_c$ | m | > 0 | critical diameter |
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `s` | $s$ | 1 | >= 0 | scaling parameter |
/// | → `delta_f` | $\delta_f$ | m | | fracture separation |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `continuous_at_the_critical_diameter_for_every_scaling`
/// * `of_small_particles_does_not_depend_on_their_size`
/// * `of_large_particles_is_the_elastic_separation_if_nothing_scales`
/// * `of_large_particles_grows_with_the_root_of_the_size_for_a_scaling_of_one_half`
/// * `of_large_particles_does_not_depend_on_their_size_for_a_scaling_of_one`
/// * `the_work_of_separation_is_twice_the_surface_energy_for_a_scaling_of_one_half`
#[inline(always)]
pub fn fracture_separation<R: Real>(gamma: R, sigma_mn: R, r_i: R, r_j: R, d_c: R, delta_e: R, s: R) -> R {
    let size = (r_i + r_j) / d_c;
    let small = separation_of_surface_energy(gamma, sigma_mn);
    piecewise([((r_i + r_j).le(d_c), small)], delta_e * (-s * size.ln()).exp())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq10_fracture_separation.rs", "wear-10", ["10"], fracture_separation)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_potential::potential;
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq09_elastic_separation::elastic_separation;
    use crate::wear::eq18_critical_diameter::critical_diameter;
    use approx::relative_eq;
    use proptest::prelude::*;

    const GAMMA: f64 = 1.5;
    const SIGMA: f64 = 0.2;
    const E: f64 = 1.0;

    /// The elastic and the fracture separation of two spheres of radius `r`, in units of the critical diameter.
    fn separations(r: f64, s: f64) -> (f64, f64) {
        let d_c = critical_diameter(GAMMA, E, SIGMA);
        let delta_e = elastic_separation(r * d_c, r * d_c, SIGMA, E);
        (delta_e, fracture_separation(GAMMA, SIGMA, r * d_c, r * d_c, d_c, delta_e, s))
    }

    proptest! {
        #[test]
        fn continuous_at_the_critical_diameter_for_every_scaling(s in 0.0..2.0) {
            let (below, above) = (separations(0.5 - 1e-12, s).1, separations(0.5 + 1e-12, s).1);
            prop_assert!(relative_eq!(below, above, max_relative = 1e-11));
        }

        #[test]
        fn of_small_particles_does_not_depend_on_their_size(r in 0.01..0.499, s in 0.0..2.0) {
            prop_assert_eq!(separations(r, s).1, separations(0.25, 0.0).1);
        }

        #[test]
        fn of_large_particles_is_the_elastic_separation_if_nothing_scales(r in 0.501..100.0) {
            let (delta_e, delta_f) = separations(r, 0.0);
            prop_assert_eq!(delta_e, delta_f);
        }

        #[test]
        fn of_large_particles_grows_with_the_root_of_the_size_for_a_scaling_of_one_half(r in 0.501..100.0) {
            prop_assert!(relative_eq!(separations(4.0 * r, 0.5).1, 2.0 * separations(r, 0.5).1, max_relative = 1e-14));
        }

        #[test]
        fn of_large_particles_does_not_depend_on_their_size_for_a_scaling_of_one(r in 0.501..100.0) {
            prop_assert!(relative_eq!(separations(r, 1.0).1, separations(0.4, 1.0).1, max_relative = 1e-14));
        }

        #[test]
        fn the_work_of_separation_is_twice_the_surface_energy_for_a_scaling_of_one_half(r in 0.501..100.0) {
            let (delta_e, delta_f) = separations(r, 0.5);
            let d_c = critical_diameter(GAMMA, E, SIGMA);
            let k_n = normal_stiffness(1.0, E, r * d_c, r * d_c);
            let work = -potential(k_n, delta_e, delta_f, 0.0);
            prop_assert!(relative_eq!(work, 2.0 * GAMMA, max_relative = 1e-13));
        }
    }
}
