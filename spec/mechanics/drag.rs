//! A drag on every particle.
//!
//! Equations and sections are numbered as in Pham-Ba & Molinari 2022.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Section 3**, unnumbered: global damping, a drag on every particle.
///
/// ```math
/// \mathbf{F} = -c \mathbf{v}
/// ```
///
/// # Reading
///
/// Not printed: the paper states the coefficient $c$ of a "global damping", in units of Eq. 21. It acts on velocities, not on spins.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `c` | $c$ | kg/s | >= 0 | coefficient of the drag |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | → `force` | $\mathbf{F}$ | N (3) | | force on the particle |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_drag_takes_power`
#[inline(always)]
pub fn global_damping<R: Real>(c: R, v: Vec3<R>) -> Vec3<R> {
    -(v * c)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![equation!("mechanics/drag.rs", "wear-global-damping", [], global_damping)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_drag_takes_power(c in 0.1..10.0, v in -3.0..3.0f64) {
            let v = Vec3::new(v, 1.0, -0.5 * v);
            prop_assert!((global_damping(c, v).dot(v) + c * v.dot(v)).abs() < 1e-13);
            prop_assert!(global_damping(c, v).cross(v).norm() < 1e-13);
        }
    }
}
