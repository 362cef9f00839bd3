//! The two integrators: velocities half a step behind positions, and velocity Verlet.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use crate::equation::Equation;
use crate::mechanics::newton::{acceleration, angular_acceleration};
use crate::{Real, Vec3, equation};

/// **Section 2.1**, unnumbered: one step of the half-step scheme for a particle.
///
/// ```math
/// \mathbf{v}_{n+1/2} = \mathbf{v}_{n-1/2} + \frac{\mathbf{f}_n}{m} \Delta t, \quad
/// \mathbf{x}_{n+1} = \mathbf{x}_n + \mathbf{v}_{n+1/2} \Delta t, \quad
/// \boldsymbol{\omega}_{n+1/2} = \boldsymbol{\omega}_{n-1/2} + \frac{\boldsymbol{\tau}_n}{I} \Delta t
/// ```
///
/// # Reading
///
/// The text leaves the integration of Eqs. 1 and 2 open; this is the scheme its results were computed with. Velocities are half a step behind the positions. Forces are evaluated
/// with $\mathbf{x}_n$ and $\mathbf{v}_{n-1/2}$: a spring that grows by $\dot{\boldsymbol{\xi}}_{n-1/2} \Delta t$ before it is used is then synchronous with the positions: its
/// length at $n$ is the displacement up to $\mathbf{x}_n$, and the dashpot is half a step late. A contact that exists at the start has springs longer by
/// $\dot{\boldsymbol{\xi}}_{-1/2} \Delta t$: the first step stretches them while the positions still are $\mathbf{x}_0$. The first velocity comes from [`half_step_start`]; a system
/// that starts at rest, or with one common velocity, may use the given velocity instead.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x` | $\mathbf{x}_n$ | m (3) | any | position |
/// | `v` | $\mathbf{v}_{n-1/2}$ | m/s (3) | any | velocity half a step before |
/// | `omega` | $\boldsymbol{\omega}_{n-1/2}$ | rad/s (3) | any | angular velocity half a step before |
/// | `force` | $\mathbf{f}_n$ | N (3) | any | force on the particle |
/// | `torque` | $\boldsymbol{\tau}_n$ | N m (3) | any | torque on the particle about its centre |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `v_next` | $\mathbf{v}_{n+1/2}$ | m/s (3) | | velocity half a step later |
/// | → `x_next` | $\mathbf{x}_{n+1}$ | m (3) | | position one step later |
/// | → `omega_next` | $\boldsymbol{\omega}_{n+1/2}$ | rad/s (3) | | angular velocity half a step later |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `the_half_step_scheme_undoes_itself_when_time_is_turned_round`
/// * `without_springs_both_schemes_lead_to_the_same_positions`
#[inline(always)]
pub fn half_step<R: Real>(
    x: Vec3<R>,
    v: Vec3<R>,
    omega: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>, Vec3<R>) {
    let v = v + acceleration(force, m) * dt;
    (v, x + v * dt, omega + angular_acceleration(torque, i) * dt)
}

/// **Section 2.1**, unnumbered: velocities half a step before the start.
///
/// ```math
/// \mathbf{v}_{-1/2} = \mathbf{v}_0 - \frac{\mathbf{f}_0}{2m} \Delta t, \quad
/// \boldsymbol{\omega}_{-1/2} = \boldsymbol{\omega}_0 - \frac{\boldsymbol{\tau}_0}{2I} \Delta t
/// ```
///
/// # Reading
///
/// The force is that at the start. It must not advance the springs: the springs of a contact that exists at the start would
/// otherwise be stretched by two steps of its initial velocity before anything has moved, instead of the one step of the first
/// [`half_step`].
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v` | $\mathbf{v}_0$ | m/s (3) | any | velocity at the start |
/// | `omega` | $\boldsymbol{\omega}_0$ | rad/s (3) | any | angular velocity at the start |
/// | `force` | $\mathbf{f}_0$ | N (3) | any | force at the start |
/// | `torque` | $\boldsymbol{\tau}_0$ | N m (3) | any | torque at the start |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `v_before` | $\mathbf{v}_{-1/2}$ | m/s (3) | | velocity half a step before |
/// | → `omega_before` | $\boldsymbol{\omega}_{-1/2}$ | rad/s (3) | | angular velocity half a step before |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `without_springs_both_schemes_lead_to_the_same_positions`
#[inline(always)]
pub fn half_step_start<R: Real>(
    v: Vec3<R>,
    omega: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>) {
    half_kick(v, omega, force, torque, m, i, -dt)
}

/// **Section 2.1**, unnumbered: first part of a step of velocity Verlet, up to the positions at which the next forces are evaluated.
///
/// ```math
/// \mathbf{v}_{n+1/2} = \mathbf{v}_n + \frac{\mathbf{f}_n}{2m} \Delta t, \quad
/// \mathbf{x}_{n+1} = \mathbf{x}_n + \mathbf{v}_{n+1/2} \Delta t, \quad
/// \boldsymbol{\omega}_{n+1/2} = \boldsymbol{\omega}_n + \frac{\boldsymbol{\tau}_n}{2I} \Delta t
/// ```
///
/// # Reading
///
/// An alternative to [`half_step`] with velocities at the full step. The next forces are evaluated with $\mathbf{x}_{n+1}$ and $\mathbf{v}_{n+1/2}$; a spring grows by
/// $\dot{\boldsymbol{\xi}}_{n+1/2} \Delta t$ before it is used, once per step. For forces without springs, and for contacts formed later, [`half_step`] evaluates the same: the positions are the
/// same, except for dashpots at the start, and only the velocity reported with a position differs. The forces at the start are evaluated with $\mathbf{x}_0$ and $\mathbf{v}_0$, and do not advance
/// the springs: the springs of a contact that exists at the start match the displacement, one step of their initial rate shorter than with [`half_step`]. Positions then differ in first order: for
/// an undamped spring by $\dot{\xi}_0 \Delta t \, (1 - \cos \omega t)$, at most by the displacement of two steps, and where it comes to rest by one. From rest, or with one common velocity, no
/// first-order difference remains.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x` | $\mathbf{x}_n$ | m (3) | any | position |
/// | `v` | $\mathbf{v}_n$ | m/s (3) | any | velocity |
/// | `omega` | $\boldsymbol{\omega}_n$ | rad/s (3) | any | angular velocity |
/// | `force` | $\mathbf{f}_n$ | N (3) | any | force on the particle |
/// | `torque` | $\boldsymbol{\tau}_n$ | N m (3) | any | torque on the particle about its centre |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `v_half` | $\mathbf{v}_{n+1/2}$ | m/s (3) | | velocity half a step later |
/// | → `x_next` | $\mathbf{x}_{n+1}$ | m (3) | | position one step later |
/// | → `omega_half` | $\boldsymbol{\omega}_{n+1/2}$ | rad/s (3) | | angular velocity half a step later |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `velocity_verlet_undoes_itself_when_time_is_turned_round`
/// * `a_spring_from_the_start_sets_the_schemes_apart_by_its_first_step`
/// * `the_energy_of_an_oscillator_stays_within_bounds_and_errs_in_second_order`
#[inline(always)]
pub fn verlet_begin<R: Real>(
    x: Vec3<R>,
    v: Vec3<R>,
    omega: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>, Vec3<R>) {
    let (v, omega) = half_kick(v, omega, force, torque, m, i, dt);
    (v, x + v * dt, omega)
}

/// **Section 2.1**, unnumbered: second part of a step of velocity Verlet, with the new forces.
///
/// ```math
/// \mathbf{v}_{n+1} = \mathbf{v}_{n+1/2} + \frac{\mathbf{f}_{n+1}}{2m} \Delta t, \quad
/// \boldsymbol{\omega}_{n+1} = \boldsymbol{\omega}_{n+1/2} + \frac{\boldsymbol{\tau}_{n+1}}{2I} \Delta t
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_half` | $\mathbf{v}_{n+1/2}$ | m/s (3) | any | velocity half a step before |
/// | `omega_half` | $\boldsymbol{\omega}_{n+1/2}$ | rad/s (3) | any | angular velocity half a step before |
/// | `force` | $\mathbf{f}_{n+1}$ | N (3) | any | force now |
/// | `torque` | $\boldsymbol{\tau}_{n+1}$ | N m (3) | any | torque now |
/// | `m` | $m$ | kg | > 0 | mass |
/// | `i` | $I$ | kg m^2 | > 0 | moment of inertia |
/// | `dt` | $\Delta t$ | s | > 0 | time step |
/// | → `v` | $\mathbf{v}_{n+1}$ | m/s (3) | | velocity |
/// | → `omega` | $\boldsymbol{\omega}_{n+1}$ | rad/s (3) | | angular velocity |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `velocity_verlet_undoes_itself_when_time_is_turned_round`
/// * `a_force_and_its_reaction_keep_momentum_and_angular_momentum`
#[inline(always)]
pub fn verlet_end<R: Real>(
    v_half: Vec3<R>,
    omega_half: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>) {
    half_kick(v_half, omega_half, force, torque, m, i, dt)
}

/// Half a time step of acceleration.
#[inline(always)]
fn half_kick<R: Real>(
    v: Vec3<R>,
    omega: Vec3<R>,
    force: Vec3<R>,
    torque: Vec3<R>,
    m: R,
    i: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>) {
    let half = R::lit(0.5) * dt;
    (v + acceleration(force, m) * half, omega + angular_acceleration(torque, i) * half)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/verlet.rs", "soot-half-step", [], half_step),
        equation!("mechanics/verlet.rs", "soot-half-step-start", [], half_step_start),
        equation!("mechanics/verlet.rs", "soot-verlet-begin", [], verlet_begin),
        equation!("mechanics/verlet.rs", "soot-verlet-end", [], verlet_end),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    const NONE: Vec3<f64> = Vec3([0.0; 3]);

    /// A step of a unit mass that is pulled to the origin with the force $-\mathbf{x} |\mathbf{x}|^2$, which does not depend on velocity.
    fn verlet(
        (x, v): (Vec3<f64>, Vec3<f64>),
        pull: impl Fn(Vec3<f64>) -> Vec3<f64>,
        dt: f64,
    ) -> (Vec3<f64>, Vec3<f64>) {
        let (v, x, _) = verlet_begin(x, v, NONE, pull(x), NONE, 1.0, 1.0, dt);
        (x, verlet_end(v, NONE, pull(x), NONE, 1.0, 1.0, dt).0)
    }
    fn cubic(x: Vec3<f64>) -> Vec3<f64> {
        -x * x.dot(x)
    }

    proptest! {
        #[test]
        fn the_half_step_scheme_undoes_itself_when_time_is_turned_round(x in vector(), v in vector(), dt in 0.001..0.05) {
            let mut now = (x, v);
            let step = |(x, v)| {
                let (v, x, _) = half_step(x, v, NONE, cubic(x), NONE, 1.0, 1.0, dt);
                (x, v)
            };
            (0..50).for_each(|_| now = step(now));
            // Reversed, the velocity half a step ahead is the velocity half a step behind of the backward motion, whose first step starts at the
            // next position.
            now = (now.0, -now.1);
            let back = |(x, v): (Vec3<f64>, Vec3<f64>)| {
                let x = x + v * dt;
                (x, half_step(x, v, NONE, cubic(x), NONE, 1.0, 1.0, dt).0)
            };
            (0..50).for_each(|_| now = back(now));
            prop_assert!((now.0 - x).norm() < 1e-12 && (now.1 + v).norm() < 1e-12);
        }

        #[test]
        fn without_springs_both_schemes_lead_to_the_same_positions(x in vector(), v in vector(), dt in 0.001..0.05) {
            let mut full = (x, v);
            let mut half = (x, half_step_start(v, NONE, cubic(x), NONE, 1.0, 1.0, dt).0);
            for _ in 0..50 {
                full = verlet(full, cubic, dt);
                let (v, x, _) = half_step(half.0, half.1, NONE, cubic(half.0), NONE, 1.0, 1.0, dt);
                half = (x, v);
            }
            prop_assert!((full.0 - half.0).norm() < 1e-12);
        }

        #[test]
        fn a_spring_from_the_start_sets_the_schemes_apart_by_its_first_step(v in vector(), dt in 0.001..0.01, steps in 1..600i32) {
            let zero = Vec3::zero();
            let (mut x, mut rate, mut spring) = (zero, half_step_start(v, NONE, zero, NONE, 1.0, 1.0, dt).0, zero);
            let (mut y, mut speed, mut other, mut force) = (zero, v, zero, zero);
            for _ in 0..steps {
                spring = spring + rate * dt;
                (rate, x, _) = half_step(x, rate, NONE, -spring, NONE, 1.0, 1.0, dt);
                (speed, y, _) = verlet_begin(y, speed, NONE, force, NONE, 1.0, 1.0, dt);
                other = other + speed * dt;
                force = -other;
                speed = verlet_end(speed, NONE, force, NONE, 1.0, 1.0, dt).0;
            }
            let apart = v * (dt * (1.0 - (f64::from(steps) * dt).cos()));
            prop_assert!((y - x - apart).norm() < v.norm() * dt * dt);
        }

        #[test]
        fn velocity_verlet_undoes_itself_when_time_is_turned_round(x in vector(), v in vector(), dt in 0.001..0.1) {
            let mut now = (x, v);
            (0..50).for_each(|_| now = verlet(now, cubic, dt));
            now = (now.0, -now.1);
            (0..50).for_each(|_| now = verlet(now, cubic, dt));
            prop_assert!((now.0 - x).norm() < 1e-12 && (now.1 + v).norm() < 1e-12);
        }

        #[test]
        fn the_energy_of_an_oscillator_stays_within_bounds_and_errs_in_second_order(phase in 0.0..6.0f64) {
            let worst = |dt: f64| {
                let mut now = (Vec3::new(phase.cos(), 0.0, 0.0), Vec3::new(phase.sin(), 0.0, 0.0));
                (0..(20.0 / dt) as usize)
                    .map(|_| {
                        now = verlet(now, |x| -x, dt);
                        (now.0.dot(now.0) + now.1.dot(now.1) - 1.0).abs()
                    })
                    .fold(0.0, f64::max)
            };
            prop_assert!(worst(0.02) < 0.5 * 0.02 * 0.02);
            prop_assert!((worst(0.02) / worst(0.01) - 4.0).abs() < 0.1);
        }

        #[test]
        fn a_force_and_its_reaction_keep_momentum_and_angular_momentum(
            x_i in vector(), x_j in vector(), v_i in vector(), v_j in vector(), f in vector(), share in 0.0..1.0, dt in 0.01..1.0,
        ) {
            let (m_i, m_j, i) = (2.0, 0.5, 0.3);
            let couple = (x_i - x_j).cross(f);
            let (w_i, spin_i) = verlet_end(v_i, NONE, f, -couple * share, m_i, i, dt);
            let (w_j, spin_j) = verlet_end(v_j, NONE, -f, -couple * (1.0 - share), m_j, i, dt);
            prop_assert!(((w_i - v_i) * m_i + (w_j - v_j) * m_j).norm() < 1e-14);
            let gained = x_i.cross(w_i - v_i) * m_i + x_j.cross(w_j - v_j) * m_j + (spin_i + spin_j) * i;
            prop_assert!(gained.norm() < 1e-14);
        }
    }
}
