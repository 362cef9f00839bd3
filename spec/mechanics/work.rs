//! Work of forces and torques over a time step.

use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Work of a force and a torque on a body over a time step.
///
/// ```math
/// W = \left(\mathbf{F} \cdot \mathbf{v} + \mathbf{M} \cdot \boldsymbol{\omega}\right) \Delta t
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `force` | $\mathbf{F}$ | N (3) | any | force |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity of the point at which the force acts |
/// | `torque` | $\mathbf{M}$ | N m (3) | any | torque |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | angular velocity |
/// | `dt` | $\Delta t$ | s | any | time step |
/// | → `work` | $W$ | J |  | work |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `it_does_not_depend_on_the_point_of_reference`
/// * `those_along_the_three_axes_are_the_whole`
#[inline(always)]
pub fn work<R: Real>(force: Vec3<R>, v: Vec3<R>, torque: Vec3<R>, omega: Vec3<R>, dt: R) -> R {
    (force.dot(v) + torque.dot(omega)) * dt
}

/// Work of a force along one axis over a time step.
///
/// ```math
/// W = F_a v_a \, \Delta t
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `f_a` | $F_a$ | N | any | force along the axis |
/// | `v_a` | $v_a$ | m/s | any | velocity along the axis |
/// | `dt` | $\Delta t$ | s | any | time step |
/// | → `work` | $W$ | J |  | work |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `those_along_the_three_axes_are_the_whole`
#[inline(always)]
pub fn axial_work<R: Real>(f_a: R, v_a: R, dt: R) -> R {
    f_a * v_a * dt
}

/// Energy that a drag dissipates in a time step.
///
/// ```math
/// \Delta E = c v^2 \, \Delta t
/// ```
///
/// # Reading
///
/// Evaluated with the velocity before the step, with which [`global_damping`](super::drag::global_damping) acts.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `c` | $c$ | kg/s | >= 0 | coefficient of the drag |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `loss` | $\Delta E$ | J |  | energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_drag_takes_the_work_that_it_does`
#[inline(always)]
pub fn drag_loss<R: Real>(c: R, v: Vec3<R>, dt: R) -> R {
    c * v.dot(v) * dt
}

/// Work of a force along the path between two steps.
///
/// ```math
/// W = \frac{1}{2} \left(\mathbf{F}_n + \mathbf{F}_{n+1}\right) \cdot \left(\mathbf{x}_{n+1} - \mathbf{x}_n\right)
/// ```
///
/// # Reading
///
/// The trapezoidal rule: exact for a force that is linear in the position, such as that of a spring.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `before` | $\mathbf{F}_n$ | N (3) | any | force before |
/// | `after` | $\mathbf{F}_{n+1}$ | N (3) | any | force after |
/// | `path` | $\mathbf{x}_{n+1} - \mathbf{x}_n$ | m (3) | any | displacement in between |
/// | → `work` | $W$ | J |  | work |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_spring_gives_the_energy_that_it_held`
#[inline(always)]
pub fn path_work<R: Real>(before: Vec3<R>, after: Vec3<R>, path: Vec3<R>) -> R {
    R::lit(0.5) * (before + after).dot(path)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/work.rs", "mechanics-work", [], work),
        equation!("mechanics/work.rs", "mechanics-axial-work", [], axial_work),
        equation!("mechanics/work.rs", "mechanics-drag-loss", [], drag_loss),
        equation!("mechanics/work.rs", "mechanics-path-work", [], path_work),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::drag::global_damping;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_does_not_depend_on_the_point_of_reference(force in vector(), v in vector(), torque in vector(), omega in vector(), r in vector(), dt in 0.01..1.0f64) {
            let there = work(force, v + omega.cross(r), torque - r.cross(force), omega, dt);
            prop_assert!((there - work(force, v, torque, omega, dt)).abs() < 1e-13);
        }

        #[test]
        fn those_along_the_three_axes_are_the_whole(force in vector(), v in vector(), dt in 0.01..1.0f64) {
            let sum: f64 = (0..3).map(|a| axial_work(force.0[a], v.0[a], dt)).sum();
            prop_assert!((sum - work(force, v, Vec3::zero(), Vec3::zero(), dt)).abs() < 1e-14);
        }

        #[test]
        fn a_drag_takes_the_work_that_it_does(c in 0.1..10.0f64, v in vector(), dt in 0.01..1.0f64) {
            let done = work(global_damping(c, v), v, Vec3::zero(), Vec3::zero(), dt);
            prop_assert!((drag_loss(c, v, dt) + done).abs() < 1e-13 * c);
        }

        #[test]
        fn a_spring_gives_the_energy_that_it_held(k in 0.1..10.0f64, x in vector(), y in vector()) {
            let held = |x: Vec3<f64>| 0.5 * k * x.dot(x);
            prop_assert!((path_work(-x * k, -y * k, y - x) - (held(x) - held(y))).abs() < 1e-13 * k);
        }
    }
}
