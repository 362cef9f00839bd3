//! Rolling displacement of two surfaces.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Path by which two spheres roll over each other in a time step.
///
/// ```math
/// \Delta \mathbf{s} = r \, (\boldsymbol{\omega}_i - \boldsymbol{\omega}_j) \times \mathbf{n} \, \Delta t
/// ```
///
/// # Reading
///
/// For equal spheres the effective radius is half their radius; in general it is the radius of the relative curvature.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `n` | $\mathbf{n}$ | 1 (3) | unit | normal, from j to i |
/// | `r` | $r$ | m | > 0 | effective radius |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `path` | $\Delta \mathbf{s}$ | m (3) |  | path |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `turning_together_is_no_rolling`
/// * `a_sphere_on_a_plane_rolls_by_its_radius_times_the_angle`
#[inline(always)]
pub fn rolled_path<R: Real>(omega_i: Vec3<R>, omega_j: Vec3<R>, n: Vec3<R>, r: R, dt: R) -> Vec3<R> {
    (omega_i - omega_j).cross(n) * (r * dt)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/rolling.rs", "mechanics-rolled-path", [], rolled_path)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{unit, vector};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn turning_together_is_no_rolling(omega in vector(), n in unit(), r in 0.1..10.0f64, dt in 0.01..1.0) {
            prop_assert_eq!(rolled_path(omega, omega, n, r, dt), Vec3::zero());
        }

        #[test]
        fn a_sphere_on_a_plane_rolls_by_its_radius_times_the_angle(omega in -3.0..3.0f64, r in 0.1..10.0f64, dt in 0.01..1.0f64) {
            // The sphere above the plane turns about x; rolling without sliding, its centre moves along y.
            let way = rolled_path(Vec3::new(omega, 0.0, 0.0), Vec3::zero(), Vec3::new(0.0, 0.0, 1.0), r, dt);
            prop_assert!((way - Vec3::new(0.0, -omega * r * dt, 0.0)).norm() < 1e-14 * r);
        }
    }
}
