//! From a material to the force parameters of a pair.

use super::eq07_normal_stiffness::normal_stiffness;
use super::eq08_tangential_stiffness::tangential_stiffness;
use super::eq09_elastic_separation::elastic_separation;
use super::eq10_fracture_separation::fracture_separation;
use super::eq11_maximum_tangential_force::maximum_tangential_force;
use super::eq12_normal_damping::normal_damping;
use super::eq13_tangential_damping::tangential_damping;
use super::eq14_effective_radius::effective_radius;
use super::eq15_normal_cross_section::normal_cross_section;
use super::eq16_tangential_cross_section::tangential_cross_section;
use super::eq17_effective_mass::effective_mass;
use super::eq18_critical_diameter::critical_diameter;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Table 2** and Section 2.2, Eqs. 7 to 18 in sequence: the force parameters of a pair that match a given material.
///
/// ```math
/// (E, \nu, \sigma_{m,N}, \sigma_{m,T}, \gamma, \eta, s; \; r_i, r_j, m_i, m_j) \mapsto (k_N, k_T, \delta_e, \delta_f, F_{m,T}, c_N, c_T)
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `nu` | $\nu$ | 1 | (-1, 1/4] | Poisson's ratio |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `sigma_mt` | $\sigma_{m,T}$ | Pa | >= 0 | shear strength |
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `eta` | $\eta$ | 1 | [0, 1] | restitution coefficient |
/// | `s` | $s$ | 1 | >= 0 | scaling parameter |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `m_i` | $m_i$ | kg | > 0 | mass of i |
/// | `m_j` | $m_j$ | kg | > 0 | mass of j |
/// | → `k_n` | $k_N$ | N/m | | normal stiffness |
/// | → `k_t` | $k_T$ | N/m | | tangential stiffness |
/// | → `delta_e` | $\delta_e$ | m | | elastic separation |
/// | → `delta_f` | $\delta_f$ | m | | fracture separation |
/// | → `f_mt` | $F_{m,T}$ | N | | largest tangential force in contact |
/// | → `c_n` | $c_N$ | kg/s | | normal damping factor |
/// | → `c_t` | $c_T$ | kg/s | | tangential damping factor |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_changes_nothing`
/// * `of_small_particles_the_work_of_separation_is_twice_the_surface_energy`
/// * `a_larger_material_of_larger_particles_is_the_same_material`
#[inline(always)]
pub fn force_parameters<R: Real>(
    e: R,
    nu: R,
    sigma_mn: R,
    sigma_mt: R,
    gamma: R,
    eta: R,
    s: R,
    r_i: R,
    r_j: R,
    m_i: R,
    m_j: R,
) -> (R, R, R, R, R, R, R) {
    let (r_eff, m_eff) = (effective_radius(r_i, r_j), effective_mass(m_i, m_j));
    let (a_n, a_t) = (normal_cross_section(r_eff, nu), tangential_cross_section(r_eff, nu));
    let (k_n, k_t) = (normal_stiffness(a_n, e, r_i, r_j), tangential_stiffness(a_t, e, r_i, r_j));
    let delta_e = elastic_separation(r_i, r_j, sigma_mn, e);
    let d_c = critical_diameter(gamma, e, sigma_mn);
    let delta_f = fracture_separation(gamma, sigma_mn, r_i, r_j, d_c, delta_e, s);
    let f_mt = maximum_tangential_force(a_t, sigma_mt);
    (k_n, k_t, delta_e, delta_f, f_mt, normal_damping(eta, k_n, m_eff), tangential_damping(eta, k_t, m_eff))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/def_parameters.rs", "wear-parameters", [], force_parameters)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_potential::potential;
    use approx::relative_eq;
    use proptest::prelude::*;

    /// The material of the patch tests.
    fn patch(r_i: f64, r_j: f64, m_i: f64, m_j: f64, s: f64) -> (f64, f64, f64, f64, f64, f64, f64) {
        force_parameters(1.0, 0.15, 0.2, 0.1, 1.5, 0.95, s, r_i, r_j, m_i, m_j)
    }

    proptest! {
        #[test]
        fn swapping_the_particles_changes_nothing(r_i in 1.0..1000.0, r_j in 1.0..1000.0, m_i in 0.1..10.0, m_j in 0.1..10.0) {
            prop_assert_eq!(patch(r_i, r_j, m_i, m_j, 0.5), patch(r_j, r_i, m_j, m_i, 0.5));
        }

        #[test]
        fn of_small_particles_the_work_of_separation_is_twice_the_surface_energy(r_i in 1.0..74.0, r_j in 1.0..74.0, s in 0.0..1.0) {
            let (k_n, _, delta_e, delta_f, ..) = patch(r_i, r_j, 1.0, 1.0, s);
            let work = -potential(k_n, delta_e, delta_f, 0.0);
            let a_n = normal_cross_section(f64::min(r_i, r_j), 0.15);
            prop_assert!(relative_eq!(work, 2.0 * 1.5 * a_n, max_relative = 1e-13));
        }

        #[test]
        fn a_larger_material_of_larger_particles_is_the_same_material(r in 1.0..1000.0, factor in 0.5..4.0, s in 0.0..1.0) {
            // Scaling all lengths and the surface energy scales all separations by the same factor and preserves all
            // stresses.
            let at = |f: f64| force_parameters(1.0, 0.15, 0.2, 0.1, 1.5 * f, 0.95, s, r * f, r * f, 1.0, 1.0);
            let ((k_n, k_t, delta_e, delta_f, f_mt, ..), large) = (at(1.0), at(factor));
            for (got, expected) in [
                (large.0, factor * k_n),
                (large.1, factor * k_t),
                (large.2, factor * delta_e),
                (large.3, factor * delta_f),
                (large.4, factor * factor * f_mt),
            ] {
                prop_assert!(relative_eq!(got, expected, max_relative = 1e-13));
            }
        }
    }
}
