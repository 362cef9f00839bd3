//! The force between two particles.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 2**, Section 2.1: force on i in the pair of i and j.
///
/// ```math
/// \mathbf{F} = -(F_N + c_N v_N) \mathbf{n}_N - (F_T + c_T v_T) \mathbf{n}_T
/// ```
///
/// # Reading
///
/// The normal points from j to i, so that a positive (cohesive) $F_N$ pulls i towards j, and the force acts on i; $v_N$ is the rate
/// of the separation. In the printed form the spring and the sliding velocity share one direction. In general they do not: the pair
/// law adds [`normal_part`] and [`tangential_part`], and this function is their sum for the shared direction. The cap of Eq. 5
/// limits only $F_T$, as printed, not the parallel dashpot.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_n` | $F_N$ | N | any | normal force, positive when it attracts |
/// | `c_n` | $c_N$ | kg/s | >= 0 | normal damping factor |
/// | `v_n` | $v_N$ | m/s | any | rate of the separation |
/// | `n_n` | $\mathbf{n}_N$ | 1 (3) | unit | normal, from j to i |
/// | `f_t` | $F_T$ | N | >= 0 | tangential force |
/// | `c_t` | $c_T$ | kg/s | >= 0 | tangential damping factor |
/// | `v_t` | $v_T$ | m/s | any | sliding velocity |
/// | `n_t` | $\mathbf{n}_T$ | 1 (3) | any | unit vector of sliding, or zero for a pair at rest |
/// | → `force` | $\mathbf{F}$ | N (3) | | force on i |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `reversing_the_normal_reverses_the_normal_part`
/// * `an_overlap_pushes_i_away_from_j`
/// * `dashpots_never_deliver_power`
#[inline(always)]
pub fn pair_force<R: Real>(f_n: R, c_n: R, v_n: R, n_n: Vec3<R>, f_t: R, c_t: R, v_t: R, n_t: Vec3<R>) -> Vec3<R> {
    normal_part(f_n, c_n, v_n, n_n) + tangential_part(n_t * f_t, c_t, n_t * v_t)
}

/// The first term of Eq. 2: the force on i along the normal.
#[inline(always)]
pub fn normal_part<R: Real>(f_n: R, c_n: R, v_n: R, n_n: Vec3<R>) -> Vec3<R> {
    -(n_n * (f_n + c_n * v_n))
}

/// The second term of Eq. 2 for a spring force and a sliding velocity in any two directions: the force on i in the contact plane.
#[inline(always)]
pub fn tangential_part<R: Real>(f_t: Vec3<R>, c_t: R, v_t: Vec3<R>) -> Vec3<R> {
    -(f_t + v_t * c_t)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/eq02_pair_force.rs", "wear-2", ["2"], pair_force)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    fn unit(theta: f64, phi: f64) -> Vec3<f64> {
        Vec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos())
    }

    proptest! {
        #[test]
        fn reversing_the_normal_reverses_the_normal_part(
            f_n in -2.0..2.0, c_n in 0.0..2.0, v_n in -2.0..2.0, theta in 0.0..3.0, phi in 0.0..6.0,
        ) {
            // Swapping i and j reverses the normal and leaves the separation and its rate unchanged.
            let n = unit(theta, phi);
            prop_assert_eq!(normal_part(f_n, c_n, v_n, -n), -normal_part(f_n, c_n, v_n, n));
        }

        #[test]
        fn an_overlap_pushes_i_away_from_j(k_n in 0.1..10.0f64, overlap in 0.01..1.0, theta in 0.0..3.0, phi in 0.0..6.0) {
            let n = unit(theta, phi);
            let force = pair_force(-k_n * overlap, 0.0, 0.3, n, 0.0, 0.0, 0.0, Vec3::zero());
            prop_assert!(force.dot(n) > 0.0);
        }

        #[test]
        fn dashpots_never_deliver_power(
            c_n in 0.0..2.0, v_n in -2.0..2.0, c_t in 0.0..2.0, v_t in -2.0..2.0, phi in 0.0..6.0,
        ) {
            let (n, t) = (Vec3::new(0.0, 0.0, 1.0), unit(0.5 * std::f64::consts::PI, phi));
            let force = pair_force(0.0, c_n, v_n, n, 0.0, c_t, v_t, t);
            prop_assert!((force.dot(n * v_n + t * v_t) + c_n * v_n * v_n + c_t * v_t * v_t).abs() < 1e-14);
        }
    }
}
