//! The geometry of a pair of spheres.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 3**, Section 2.1.1: unit normal of a pair.
///
/// ```math
/// \mathbf{n} = \frac{\mathbf{x}_j - \mathbf{x}_i}{\lVert \mathbf{x}_j - \mathbf{x}_i \rVert}
/// ```
///
/// # Reading
///
/// From i to j: the opposite of the normal of a [`Contact`](crate::Contact). All equations of this paper are in the convention of the
/// paper; [`ContactKinematics`](super::contact_kinematics::ContactKinematics) is the one place where one is turned into the other.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | → `n` | $\mathbf{n}$ | 1 (3) | | normal, from i to j |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `swapping_the_particles_turns_the_normal_round`
#[inline(always)]
pub fn normal<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>) -> Vec3<R> {
    let x = x_j - x_i;
    x * (R::one() / x.norm())
}

/// **Eq. 5**, Section 2.1.1: distance of the contact point from the centre of a particle.
///
/// ```math
/// a = r + \frac{1}{2} \delta
/// ```
///
/// # Reading
///
/// For unequal spheres each has its own, $a_i = r_i + \delta/2$ and $a_j = r_j + \delta/2$: the contact point lies halfway between the surfaces,
/// and the arms add up to the distance between the centres; otherwise no force in the contact plane could conserve angular momentum.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r` | $r$ | m | > 0 | radius of the particle |
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | → `a` | $a$ | m | | arm |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_arms_add_up_to_the_distance_of_the_centres`
#[inline(always)]
pub fn arm<R: Real>(r: R, delta: R) -> R {
    r + R::lit(0.5) * delta
}

/// **Eq. 6**, Section 2.1.1: gap between two surfaces.
///
/// ```math
/// \delta = \lVert \mathbf{x}_j - \mathbf{x}_i \rVert - 2r
/// ```
///
/// # Reading
///
/// Negative for an overlap. For unequal spheres $2r$ is $r_i + r_j$.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | → `delta` | $\delta$ | m | | gap, negative for an overlap |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_gap_closes_with_the_normal_velocity`
#[inline(always)]
pub fn gap<R: Real>(x_i: Vec3<R>, x_j: Vec3<R>, r_i: R, r_j: R) -> R {
    (x_j - x_i).norm() - r_i - r_j
}

/// **Section 2.1.1**, unnumbered: the radius that represents both spheres in rolling and torsion.
///
/// ```math
/// \bar{a} = \frac{2 a_i a_j}{a_i + a_j}
/// ```
///
/// # Reading
///
/// The paper has equal radii and writes $a$ and $r$. The rates of the rolling and the torsion spring must be the same seen from both particles, and
/// a torque and its reaction must be opposite, so one length has to serve both. The harmonic mean is the one for which the rolling spring measures twice the displacement
/// of the contact point over the surfaces, as it does for equal spheres.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `a_i` | $a_i$ | m | > 0 | arm or radius of i |
/// | `a_j` | $a_j$ | m | > 0 | arm or radius of j |
/// | → `a_mean` | $\bar{a}$ | m | | arm of the pair |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `equal_spheres_have_the_arm_of_the_paper`
/// * `the_rolling_spring_measures_twice_the_way_of_the_contact_point`
#[inline(always)]
pub fn mean_arm<R: Real>(a_i: R, a_j: R) -> R {
    R::lit(2.0) * a_i * a_j / (a_i + a_j)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/pair_geometry.rs", "soot-3", ["3"], normal),
        equation!("mechanics/pair_geometry.rs", "soot-5", ["5"], arm),
        equation!("mechanics/pair_geometry.rs", "soot-6", ["6"], gap),
        equation!("mechanics/pair_geometry.rs", "soot-mean-arm", [], mean_arm),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::relative_velocity::normal_velocity;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn swapping_the_particles_turns_the_normal_round(x_i in vector(), x_j in vector()) {
            prop_assume!((x_i - x_j).norm() > 0.1);
            let n = normal(x_i, x_j);
            prop_assert_eq!(normal(x_j, x_i), -n);
            prop_assert!((n.norm() - 1.0).abs() < 1e-15);
            prop_assert!(n.dot(x_j - x_i) > 0.0);
        }

        #[test]
        fn the_arms_add_up_to_the_distance_of_the_centres(x_i in vector(), x_j in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            let delta = gap(x_i, x_j, r_i, r_j);
            prop_assert!((arm(r_i, delta) + arm(r_j, delta) - (x_i - x_j).norm()).abs() < 1e-14);
        }

        #[test]
        fn the_gap_closes_with_the_normal_velocity(x in vector(), v in vector(), r_i in 0.1..2.0, r_j in 0.1..2.0) {
            prop_assume!(x.norm() > 0.5);
            let (h, zero) = (1e-6, Vec3::zero());
            let at = |t: f64| gap(zero, x + v * t, r_i, r_j);
            let v_n = normal_velocity(zero, x, zero, v, zero, zero, r_i, r_j).dot(normal(zero, x));
            prop_assert!(((at(h) - at(-h)) / (2.0 * h) - v_n).abs() < 1e-8);
        }

        #[test]
        fn equal_spheres_have_the_arm_of_the_paper(a in 0.1..10.0f64) {
            prop_assert!((mean_arm(a, a) / a - 1.0).abs() < 3e-16);
        }

        #[test]
        fn the_rolling_spring_measures_twice_the_way_of_the_contact_point(a_i in 0.1..10.0f64, a_j in 0.1..10.0f64, way in 0.1..2.0f64) {
            // Rolling without sliding: both surfaces pass the contact point by the same length, the spheres turn in opposite senses.
            let (turn_i, turn_j) = (way / a_i, -way / a_j);
            prop_assert!((mean_arm(a_i, a_j) * (turn_i - turn_j) - 2.0 * way).abs() < 1e-14 * way.max(1.0) * 4.0);
        }
    }
}
