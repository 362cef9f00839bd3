//! The fracture energy of a pair, and the fracture separation at which it equals twice the surface energy.

use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.31**, Appendix A.2: work to separate two touching spheres.
///
/// ```math
/// U_\gamma = \frac12 \delta_f k_N \delta_e
/// ```
///
/// # Reading
///
/// Erratum: the area under Eq. 3 is this triangle only if `delta_f >= delta_e`. Otherwise the force ends at `delta_f`, before
/// the peak, and the triangle is $\frac12 k_N \delta_f^2$. Both cases are $\frac12 \delta_f k_N \min(\delta_e, \delta_f)$.
///
/// Effect: for spheres larger than the critical diameter the printed energy is too large, by $\delta_e / \delta_f$.
///
/// Proof: `the_printed_area_is_too_large_when_the_force_is_cut_off`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_n` | $k_N$ | N/m | > 0 | normal stiffness |
/// | `delta_e` | $\delta_e$ | m | > 0 | elastic separation |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation |
/// | → `u_gamma` | $U_\gamma$ | J | | work of separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `is_the_area_under_the_force`
/// * `the_printed_area_is_too_large_when_the_force_is_cut_off`
/// * `is_the_depth_of_the_potential`
#[inline(always)]
pub fn work_of_separation<R: Real>(k_n: R, delta_e: R, delta_f: R) -> R {
    R::lit(0.5) * delta_f * k_n * delta_e.min(delta_f)
}

/// **Eq. A.32**, Appendix A.2: the same work in terms of the strength.
///
/// ```math
/// U_\gamma = \frac{A_N \sigma_{m,N} \delta_f}{2}
/// ```
///
/// # Reading
///
/// As printed; like A.31 as printed it needs `delta_f >= delta_e`.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_n` | $A_N$ | m^2 | > 0 | cross section in the normal direction |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `delta_f` | $\delta_f$ | m | > 0 | fracture separation, at least the elastic one |
/// | → `u_gamma` | $U_\gamma$ | J | | work of separation |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `strength_and_stiffness_give_one_work`
#[inline(always)]
pub fn work_of_strength<R: Real>(a_n: R, sigma_mn: R, delta_f: R) -> R {
    a_n * sigma_mn * delta_f / R::lit(2.0)
}

/// **Eq. A.33**, Appendix A.2: surface energy of a broken pair.
///
/// ```math
/// \gamma = \frac{U_\gamma}{2 A_N}
/// ```
///
/// # Reading
///
/// As printed: fracture creates two surfaces. Solved for the separation it is A.34,
/// $\delta_f = 4 \gamma / \sigma_{m,N}$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `u_gamma` | $U_\gamma$ | J | >= 0 | work of separation |
/// | `a_n` | $A_N$ | m^2 | > 0 | cross section in the normal direction |
/// | → `gamma` | $\gamma$ | J/m^2 | | surface energy |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_fracture_separation_gives_back_the_surface_energy`
#[inline(always)]
pub fn surface_energy<R: Real>(u_gamma: R, a_n: R) -> R {
    u_gamma / (R::lit(2.0) * a_n)
}

/// **Eq. A.34**, Appendix A.2: fracture separation for a desired surface energy.
///
/// ```math
/// \delta_f = \frac{4 \gamma}{\sigma_{m,N}}
/// ```
///
/// # Reading
///
/// As printed: A.32 and A.33 solved for the separation. Eq. 19 takes the same length as a diameter, at which the range of a particle is its size.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | → `delta_f` | $\delta_f$ | m | | separation at which the pair breaks |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_fracture_separation_gives_back_the_surface_energy`
#[inline(always)]
pub fn separation_of_surface_energy<R: Real>(gamma: R, sigma_mn: R) -> R {
    R::lit(4.0) * gamma / sigma_mn
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a31_fracture_energy.rs", "wear-A31", ["A31"], work_of_separation),
        equation!("wear/a31_fracture_energy.rs", "wear-A32", ["A32"], work_of_strength),
        equation!("wear/a31_fracture_energy.rs", "wear-A33", ["A33"], surface_energy),
        equation!("wear/a31_fracture_energy.rs", "wear-A34", ["A34"], separation_of_surface_energy),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::wear::def_potential::potential;
    use crate::wear::eq03_normal_force::normal_force;
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq09_elastic_separation::elastic_separation;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 16.0 * f64::EPSILON;

    /// Area under Eq. 3 from touching to `delta_f`: trapezoids between its corners, exact because it is linear there.
    fn area(k_n: f64, delta_e: f64, delta_f: f64) -> f64 {
        let force = |delta: f64| normal_force(k_n, delta_e, delta_f, delta);
        let corner = delta_e.min(delta_f);
        0.5 * corner * (force(0.0) + force(corner)) + 0.5 * (delta_f - corner) * (force(corner) + force(delta_f))
    }

    proptest! {
        #[test]
        fn is_the_area_under_the_force(k_n in 0.1..10.0, delta_e in 0.1..2.0, delta_f in 0.1..2.0) {
            let work = work_of_separation(k_n, delta_e, delta_f);
            assert_relative_eq!(work, area(k_n, delta_e, delta_f), epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn the_printed_area_is_too_large_when_the_force_is_cut_off(k_n in 0.1..10.0, delta_f in 0.1..2.0, more in 0.1..2.0) {
            let delta_e = delta_f + more;
            let printed = 0.5 * delta_f * k_n * delta_e;
            prop_assert!(printed > (1.0 + 0.9 * more / delta_f) * area(k_n, delta_e, delta_f));
        }

        #[test]
        fn is_the_depth_of_the_potential(k_n in 0.1..10.0, delta_e in 0.1..2.0, delta_f in 0.1..2.0) {
            let depth = -potential(k_n, delta_e, delta_f, 0.0);
            assert_relative_eq!(work_of_separation(k_n, delta_e, delta_f), depth, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn strength_and_stiffness_give_one_work(
            (a_n, e, sigma) in (0.1..10.0, 0.1..10.0, 0.01..1.0), (r_i, r_j) in (0.1..1.0, 0.1..1.0), more in 0.0..2.0,
        ) {
            let delta_e = elastic_separation(r_i, r_j, sigma, e);
            let work = work_of_separation(normal_stiffness(a_n, e, r_i, r_j), delta_e, delta_e + more);
            assert_relative_eq!(work_of_strength(a_n, sigma, delta_e + more), work, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn the_fracture_separation_gives_back_the_surface_energy(
            (gamma, sigma, a_n) in (0.1..10.0, 0.01..1.0, 0.1..10.0),
        ) {
            let work = work_of_strength(a_n, sigma, separation_of_surface_energy(gamma, sigma));
            assert_relative_eq!(surface_energy(work, a_n), gamma, epsilon = 0.0, max_relative = ROUNDING);
        }
    }
}
