//! The elastic constants of the body, inverted for the stiffnesses and cross sections of a pair.

use super::eq14_effective_radius::effective_radius;
use super::eq15_normal_cross_section::normal_cross_section;
use super::eq16_tangential_cross_section::tangential_cross_section;
use crate::equation::Equation;
use crate::{Real, equation};

/// **Eq. A.60**, Appendix A.2.2: stress per strain in the same direction.
///
/// ```math
/// C_{11} = \frac{\sqrt2}{5 r} (3 k_N + 2 k_T)
/// ```
///
/// # Reading
///
/// As printed. Averaged over all directions of contacts, with every particle displaced affinely: an upper bound for packings whose contacts have no preferred
/// direction. A crystal may exceed it along an axis: without tangential springs a face-centred cubic one has 10/9 of it along \[111\].
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | → `c_11` | $C_{11}$ | Pa | | elastic constant |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_energy_has_these_second_derivatives`
/// * `without_tangential_springs_the_ratio_is_three`
/// * `a_cubic_crystal_exceeds_it_by_a_ninth_along_its_diagonal`
#[inline(always)]
pub fn constant_11<R: Real>(r: R, k_n: R, k_t: R) -> R {
    R::lit(2.0).sqrt() / (R::lit(5.0) * r) * (R::lit(3.0) * k_n + R::lit(2.0) * k_t)
}

/// **Eq. A.61**, Appendix A.2.2: stress per transverse strain.
///
/// ```math
/// C_{12} = \frac{\sqrt2}{5 r} (k_N - k_T)
/// ```
///
/// # Reading
///
/// As printed.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius |
/// | `k_n` | $k_N$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | → `c_12` | $C_{12}$ | Pa | | elastic constant |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_energy_has_these_second_derivatives`
/// * `without_tangential_springs_the_ratio_is_three`
/// * `equal_springs_do_not_push_sideways`
#[inline(always)]
pub fn constant_12<R: Real>(r: R, k_n: R, k_t: R) -> R {
    R::lit(2.0).sqrt() / (R::lit(5.0) * r) * (k_n - k_t)
}

/// **Eq. A.62**, Appendix A.2.2: normal stiffness for desired elastic properties.
///
/// ```math
/// k_N = \frac{\sqrt2 E r}{2 (1 - 2\nu)}
/// ```
///
/// # Reading
///
/// As printed, for equal radii. As a cross section, through A.26, it is A.64, which is Eq. 15.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `r` | $r$ | m | > 0 | radius |
/// | `nu` | $\nu$ | 1 | (-1, 1/2) | Poisson's ratio |
/// | → `k_n` | $k_N$ | N/m | | normal stiffness |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_stiffnesses_reproduce_the_wanted_constants`
/// * `the_cross_sections_give_these_stiffnesses`
#[inline(always)]
pub fn normal_stiffness_of_body<R: Real>(e: R, r: R, nu: R) -> R {
    R::lit(2.0).sqrt() * e * r / (R::lit(2.0) * (R::one() - R::lit(2.0) * nu))
}

/// **Eq. A.63**, Appendix A.2.2: tangential stiffness for desired elastic properties.
///
/// ```math
/// k_T = \frac{\sqrt2 E r (1 - 4\nu)}{2 (1 + \nu) (1 - 2\nu)}
/// ```
///
/// # Reading
///
/// As printed, for equal radii; negative above a Poisson's ratio of 1/4, which the model therefore excludes. As a cross
/// section, through A.27, it is A.65, which is Eq. 16. A.66, which replaces the radius there, is Eq. 14.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `r` | $r$ | m | > 0 | radius |
/// | `nu` | $\nu$ | 1 | (-1, 1/4] | Poisson's ratio |
/// | → `k_t` | $k_T$ | N/m | | tangential stiffness |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_stiffnesses_reproduce_the_wanted_constants`
/// * `the_cross_sections_give_these_stiffnesses`
/// * `no_tangential_spring_at_a_poisson_ratio_of_one_quarter`
#[inline(always)]
pub fn tangential_stiffness_of_body<R: Real>(e: R, r: R, nu: R) -> R {
    let (one, two) = (R::one(), R::lit(2.0));
    two.sqrt() * e * r * (one - R::lit(4.0) * nu) / (two * (one + nu) * (one - two * nu))
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("wear/a60_elastic_constants.rs", "wear-A60", ["A60"], constant_11),
        equation!("wear/a60_elastic_constants.rs", "wear-A61", ["A61"], constant_12),
        equation!("wear/a60_elastic_constants.rs", "wear-A62", ["A62"], normal_stiffness_of_body),
        equation!("wear/a60_elastic_constants.rs", "wear-A63", ["A63"], tangential_stiffness_of_body),
        equation!("wear/eq15_normal_cross_section.rs", "wear-A64", ["A64"], normal_cross_section),
        equation!("wear/eq16_tangential_cross_section.rs", "wear-A65", ["A65"], tangential_cross_section),
        equation!("wear/eq14_effective_radius.rs", "wear-A66", ["A66"], effective_radius),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Vec3;
    use crate::wear::a56_body_energy::{close_packed_energy, close_packed_volume, surrounded_energy};
    use crate::wear::eq07_normal_stiffness::normal_stiffness;
    use crate::wear::eq08_tangential_stiffness::tangential_stiffness;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    const ROUNDING: f64 = 16.0 * f64::EPSILON;

    proptest! {
        /// The energy is a quadratic form: U'/V = C11/2 (x^2 + z^2) + C12 x z.
        #[test]
        fn the_energy_has_these_second_derivatives(r in 0.5..2.0, (k_n, k_t) in (0.1..2.0, 0.0..2.0)) {
            let density = |x, z| close_packed_energy(surrounded_energy(r, k_n, k_t, x, z)) / close_packed_volume(r);
            assert_relative_eq!(constant_11(r, k_n, k_t), 2.0 * density(1.0, 0.0), epsilon = 0.0, max_relative = ROUNDING);
            let mixed = density(1.0, 1.0) - density(1.0, 0.0) - density(0.0, 1.0);
            assert_relative_eq!(constant_12(r, k_n, k_t), mixed, epsilon = 64.0 * f64::EPSILON);
        }

        #[test]
        fn without_tangential_springs_the_ratio_is_three(r in 0.5..2.0, k_n in 0.1..2.0) {
            let (c_11, c_12) = (constant_11(r, k_n, 0.0), constant_12(r, k_n, 0.0));
            assert_relative_eq!(c_11, 3.0 * c_12, epsilon = 0.0, max_relative = ROUNDING);
        }

        #[test]
        fn equal_springs_do_not_push_sideways(r in 0.5..2.0, k in 0.1..2.0) {
            prop_assert_eq!(constant_12(r, k, k), 0.0);
        }

        #[test]
        fn the_stiffnesses_reproduce_the_wanted_constants(
            (e, r) in (0.1f64..10.0, 0.1f64..10.0), nu in -0.9f64..0.25,
        ) {
            let (k_n, k_t) = (normal_stiffness_of_body(e, r, nu), tangential_stiffness_of_body(e, r, nu));
            // Hooke's law of an isotropic body.
            let lame = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
            assert_relative_eq!(constant_11(r, k_n, k_t), lame * (1.0 - nu), epsilon = 0.0, max_relative = ROUNDING);
            assert_relative_eq!(constant_12(r, k_n, k_t), lame * nu, epsilon = ROUNDING * lame);
        }

        #[test]
        fn the_cross_sections_give_these_stiffnesses((e, r) in (0.1..10.0, 0.1..10.0), nu in -0.9..0.24) {
            let radius = effective_radius(r, r);
            let k_n = normal_stiffness(normal_cross_section(radius, nu), e, r, r);
            let k_t = tangential_stiffness(tangential_cross_section(radius, nu), e, r, r);
            assert_relative_eq!(normal_stiffness_of_body(e, r, nu), k_n, epsilon = 0.0, max_relative = ROUNDING);
            assert_relative_eq!(tangential_stiffness_of_body(e, r, nu), k_t, epsilon = 0.0, max_relative = ROUNDING);
        }
    }

    /// The twelve neighbours of a face-centred cubic crystal, stretched along a direction, with the energy $k (2 r \cos^2)^2 / 4$ of half a pair.
    fn stiffness_of_crystal(r: f64, k_n: f64, along: Vec3<f64>) -> f64 {
        let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let planes = |(a, b)| [Vec3::new(a, b, 0.0), Vec3::new(a, 0.0, b), Vec3::new(0.0, a, b)];
        let stretch = |n: Vec3<f64>| 2.0 * r * (n.dot(along) * n.dot(along)) / (2.0 * along.dot(along));
        let energy: f64 = signs.into_iter().flat_map(planes).map(|n| 0.25 * k_n * stretch(n) * stretch(n)).sum();
        2.0 * energy / close_packed_volume(r)
    }

    #[test]
    fn a_cubic_crystal_exceeds_it_by_a_ninth_along_its_diagonal() {
        let of_crystal = |x, y, z| stiffness_of_crystal(1.5, 0.7, Vec3::new(x, y, z)) / constant_11(1.5, 0.7, 0.0);
        assert_relative_eq!(of_crystal(1.0, 1.0, 1.0), 10.0 / 9.0, max_relative = ROUNDING);
        assert_relative_eq!(of_crystal(1.0, 0.0, 0.0), 5.0 / 6.0, max_relative = ROUNDING);
    }

    #[test]
    fn no_tangential_spring_at_a_poisson_ratio_of_one_quarter() {
        assert_eq!(tangential_stiffness_of_body(1.0, 1.0, 0.25), 0.0);
    }
}
