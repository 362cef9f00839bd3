//! The dissipation of a normal displacement.

use crate::equation::Equation;
use crate::{Contact, Real, Vec3, equation};

/// **Eq. 6**, Section 2.2: dashpot along the normal.
///
/// ```math
/// \mathbf{F}_{nd} = -\gamma_n \mathbf{v}_n
/// ```
///
/// # Reading
///
/// As printed, with $\mathbf{v}_n = ((\mathbf{v}_i - \mathbf{v}_j) \cdot \mathbf{n}) \mathbf{n}$. It acts in contact only, so it starts
/// discontinuously at first touch.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `gamma_n` | $\gamma_n$ | kg/s | >= 0 | damping coefficient, Eq. 7 |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | → `f_nd` | $\mathbf{F}_{nd}$ | N (3) | | force on i |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `never_delivers_power`
/// * `a_sphere_that_leaves_its_partner_is_pulled_by_the_coefficient_times_its_speed`
/// * `vanishes_for_a_rigid_motion_of_the_pair`
#[inline(always)]
pub fn normal_damping<R: Real>(gamma_n: R, v_i: Vec3<R>, v_j: Vec3<R>, x_i: Vec3<R>, x_j: Vec3<R>) -> Vec3<R> {
    let none = Vec3::zero();
    dashpot(gamma_n, &Contact::new(x_i - x_j, v_i - v_j, none, none, R::zero(), R::zero()))
}

/// Eq. 6 of a contact.
#[inline(always)]
pub(super) fn dashpot<R: Real>(gamma_n: R, c: &Contact<R>) -> Vec3<R> {
    c.n * -(gamma_n * c.normal_velocity())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("titania/eq06_normal_damping.rs", "titania-6", ["6"], normal_damping)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn never_delivers_power(x in vector(), v_i in vector(), v_j in vector(), gamma_n in 0.0..3.0) {
            prop_assume!(x.norm() > 0.1);
            prop_assert!(normal_damping(gamma_n, v_i, v_j, x, Vec3::zero()).dot(v_i - v_j) <= 0.0);
        }

        #[test]
        fn a_sphere_that_leaves_its_partner_is_pulled_by_the_coefficient_times_its_speed(
            x in vector(), drift in vector(), speed in -3.0..3.0, gamma_n in 0.1..3.0,
        ) {
            prop_assume!(x.norm() > 0.1);
            let n = x * (1.0 / x.norm());
            let force = normal_damping(gamma_n, drift + n * speed, drift, drift + x, drift);
            prop_assert!((force + n * (gamma_n * speed)).norm() < 1e-13);
        }

        #[test]
        fn vanishes_for_a_rigid_motion_of_the_pair(x in vector(), drift in vector(), omega in vector()) {
            prop_assume!(x.norm() > 0.1);
            let v_i = drift + omega.cross(x);
            prop_assert!(normal_damping(1.0, v_i, drift, x, Vec3::zero()).norm() < 1e-13);
        }
    }
}
