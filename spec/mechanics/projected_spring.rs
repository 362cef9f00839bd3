//! The tangential spring: the slid distance of Eq. 4 as a vector.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Section 2**, unnumbered: the tangential spring after a step of sliding.
///
/// ```math
/// \boldsymbol{\xi} := \boldsymbol{\xi} - (\boldsymbol{\xi} \cdot \mathbf{n}_N) \, \mathbf{n}_N + \mathbf{v}_T \Delta t
/// ```
///
/// # Reading
///
/// The paper keeps a distance $\delta_T \ge 0$ and a direction $\mathbf{n}_T$ "computed using the evolution of the rolling velocity". Together they
/// are one vector in the contact plane, $\boldsymbol{\xi} = \delta_T \mathbf{n}_T$. It follows the rotating plane by projection; the length lost by
/// projection is of second order in the angle and not restored. A spin of the pair about its normal does not rotate it.
/// Where $|\boldsymbol{\xi}|$ exceeds its cap, it slips, as defined by the contact law.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring before |
/// | `n` | $\mathbf{n}_N$ | 1 (3) | unit | normal now |
/// | `v_t` | $\mathbf{v}_T$ | m/s (3) | any | sliding velocity |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `xi_next` | $\boldsymbol{\xi}$ | m (3) | | spring now, before it slips |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_spring_stays_in_the_contact_plane`
/// * `a_pair_at_rest_keeps_its_spring`
/// * `sliding_back_relaxes_it`
#[inline(always)]
pub fn stretched_spring<R: Real>(xi: Vec3<R>, n: Vec3<R>, v_t: Vec3<R>, dt: R) -> Vec3<R> {
    xi.perpendicular_to(n) + v_t * dt
}

/// **Section 2.1**, unnumbered: energy stored in the tangential spring.
///
/// ```math
/// U_T = \frac{1}{2} k_T \, |\boldsymbol{\xi}|^2
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k_t` | $k_T$ | N/m | >= 0 | tangential stiffness |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring |
/// | → `u_t` | $U_T$ | J | | energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `is_the_work_of_stretching_it`
#[inline(always)]
pub fn spring_energy<R: Real>(k_t: R, xi: Vec3<R>) -> R {
    R::lit(0.5) * k_t * xi.dot(xi)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/projected_spring.rs", "wear-spring", [], stretched_spring),
        equation!("mechanics/projected_spring.rs", "wear-spring-energy", [], spring_energy),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn a_spring_stays_in_the_contact_plane(xi in vector(), axis in vector(), v in vector(), dt in 0.01..0.1) {
            prop_assume!(axis.norm() > 0.1);
            let n = axis * (1.0 / axis.norm());
            prop_assert!(stretched_spring(xi, n, v.perpendicular_to(n), dt).dot(n).abs() < 1e-14);
        }

        #[test]
        fn a_pair_at_rest_keeps_its_spring(x in -3.0..3.0, y in -3.0..3.0, dt in 0.01..0.1) {
            let (xi, n) = (Vec3::new(x, y, 0.0), Vec3::new(0.0, 0.0, 1.0));
            prop_assert_eq!(stretched_spring(xi, n, Vec3::zero(), dt), xi);
        }

        #[test]
        fn sliding_back_relaxes_it(v in vector(), dt in 0.01..0.1) {
            let n = Vec3::new(0.0, 0.0, 1.0);
            let v_t = v.perpendicular_to(n);
            let there = stretched_spring(Vec3::zero(), n, v_t, dt);
            prop_assert_eq!(stretched_spring(there, n, -v_t, dt), Vec3::zero());
        }

        #[test]
        fn is_the_work_of_stretching_it(k_t in 0.1..10.0, length in 0.1..2.0) {
            // The force is linear: the midpoint rule is exact.
            let steps = 10;
            let ds = length / f64::from(steps);
            let work: f64 = (0..steps).map(|step| k_t * (f64::from(step) + 0.5) * ds * ds).sum();
            prop_assert!(relative_eq!(spring_energy(k_t, Vec3::new(0.6 * length, 0.0, 0.8 * length)), work, max_relative = 1e-14));
        }
    }
}
