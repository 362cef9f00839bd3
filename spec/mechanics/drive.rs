//! Drives and drag.
//!
//! Equations and sections are numbered as in Laube et al. 2018.

use super::drag::global_damping;
use crate::equation::Equation;
use crate::{Real, Vec3, equation, piecewise};

/// **Section 5.4**, unnumbered: motion of the tip after the setpoint.
///
/// ```math
/// v(t) = \begin{cases} -v_0 & t \le 0 \\ v_0 (2t/T - 1) & 0 < t \le T \\ v_0 & t > T \end{cases}, \quad z(t) = \int_0^t v \, dt
/// ```
///
/// # Reading
///
/// "Slowly decreased, reversed, and then again increased" within 0.2 µs: linearly, the simplest reading. At $t = 0$ the force reaches its setpoint. The
/// tip continues by $v_0 T / 4$, 25 nm, before it returns.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `v_0` | $v_0$ | m/s | >= 0 | speed of approach and retraction, 0.5 m/s |
/// | `t_turn` | $T$ | s | > 0 | duration of the reversal, 0.2 µs |
/// | `t` | $t$ | s | any | time since the setpoint |
/// | → `v` | $v$ | m/s | | velocity |
/// | → `z` | $z$ | m | | height relative to the setpoint |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_velocity_of_the_tip_is_the_rate_of_its_height`
/// * `the_tip_goes_on_by_a_quarter_of_speed_times_duration`
#[inline(always)]
pub fn tip<R: Real>(v_0: R, t_turn: R, t: R) -> (R, R) {
    let (zero, one, two) = (R::zero(), R::one(), R::lit(2.0));
    let (before, during, share) = (t.le(zero), t.le(t_turn), t / t_turn);
    let v = piecewise([(before, -v_0), (during, v_0 * (two * share - one))], v_0);
    let z = piecewise([(before, -(v_0 * t)), (during, v_0 * t * (share - one))], v_0 * (t - t_turn));
    (v, z)
}

/// **Section 3.1**, unnumbered: harmonic constraint that pulls an agglomerate.
///
/// ```math
/// F = -k (z - z_0 - v t)
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k` | $k$ | N/m | >= 0 | stiffness, 160 N/m |
/// | `z` | $z$ | m | any | place of the centre of mass |
/// | `z_0` | $z_0$ | m | any | its place at the start |
/// | `v` | $v$ | m/s | any | velocity of the constraint, 5 m/s |
/// | `t` | $t$ | s | >= 0 | time |
/// | → `f` | $F$ | N | | force on the group |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_group_that_moves_with_the_constraint_feels_nothing`
/// * `the_constraint_has_its_stiffness`
#[inline(always)]
pub fn steering<R: Real>(k: R, z: R, z_0: R, v: R, t: R) -> R {
    -(k * (z - z_0 - v * t))
}

/// **Section 3.1**, unnumbered: time for which a constraint of full velocity has moved as far as one whose velocity grows.
///
/// ```math
/// \tau(t) = \begin{cases} t^2 / 2T & t < T \\ t - T/2 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// The paper pulls at full velocity from the beginning, $T = 0$ and $\tau = t$. A velocity that grows linearly makes less of an oscillation.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `t` | $t$ | s | >= 0 | time |
/// | `ramp` | $T$ | s | >= 0 | time in which the velocity grows |
/// | → `tau` | $\tau$ | s | | displacement over full velocity |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `the_velocity_grows_to_its_full_value`
#[inline(always)]
pub fn ramped_time<R: Real>(t: R, ramp: R) -> R {
    let half = R::lit(0.5);
    R::select(t.lt(ramp), half * t * t / ramp, t - half * ramp)
}

/// **Section 5.4**, unnumbered: environmental viscosity of the first relaxation.
///
/// ```math
/// \mathbf{F} = -\eta \mathbf{v}
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `eta` | $\eta$ | kg/s | >= 0 | drag coefficient of each particle, 10 pN s/m |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity of the particle |
/// | → `force` | $\mathbf{F}$ | N (3) | | force on the particle |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `drag_takes_power`
#[inline(always)]
pub fn drag<R: Real>(eta: R, v: Vec3<R>) -> Vec3<R> {
    global_damping(eta, v)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/drive.rs", "titania-tip-linear", [], tip),
        equation!("mechanics/drive.rs", "titania-harmonic", [], steering),
        equation!("mechanics/drive.rs", "titania-ramp", [], ramped_time),
        equation!("mechanics/drive.rs", "titania-viscous", [], drag),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::Dual;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_velocity_of_the_tip_is_the_rate_of_its_height(v_0 in 0.1..1.0, t_turn in 0.1..1.0, t in -1.0..2.0) {
            let (v, z) = tip(Dual::constant(v_0), Dual::constant(t_turn), Dual::variable(t));
            prop_assert!((z.slope - v.value).abs() < 1e-12);
        }

        #[test]
        fn a_group_that_moves_with_the_constraint_feels_nothing(z_0 in -1.0..1.0, v in -1.0..1.0, t in 0.0..9.0) {
            prop_assert!(steering(160.0, z_0 + v * t, z_0, v, t).abs() < 1e-12);
            prop_assert!(steering(160.0, z_0 + v * t + 0.1, z_0, v, t) < 0.0);
        }

        #[test]
        fn the_constraint_has_its_stiffness(k in 0.1..200.0, z in -1.0..1.0, v in -1.0..1.0, t in 0.0..9.0) {
            let [k_, z_0, v, t] = [k, 0.3, v, t].map(Dual::constant);
            prop_assert_eq!(steering(k_, Dual::variable(z), z_0, v, t).slope, -k);
        }

        #[test]
        fn the_velocity_grows_to_its_full_value(ramp in 0.5..2.0f64, t in 0.0..4.0f64) {
            let tau = ramped_time(Dual::variable(t), Dual::constant(ramp));
            prop_assert!((tau.slope - (t / ramp).min(1.0)).abs() < 1e-12);
            prop_assert!((ramped_time(ramp, ramp) - 0.5 * ramp).abs() < 1e-15);
            prop_assert_eq!(ramped_time(t, 0.0), t);
        }

        #[test]
        fn drag_takes_power(x in -1.0..1.0, y in -1.0..1.0, eta in 0.1..1.0) {
            let v = Vec3::new(x, y, 0.5);
            prop_assert!((drag(eta, v).dot(v) + eta * v.dot(v)).abs() < 1e-15);
            prop_assert!(drag(eta, v).cross(v).norm() < 1e-15);
        }
    }

    #[test]
    fn the_tip_goes_on_by_a_quarter_of_speed_times_duration() {
        let (v, z) = tip(0.5, 0.2e-6, 0.1e-6);
        assert_eq!(v, 0.0);
        assert!((z + 25e-9f64).abs() < 1e-22);
        assert_eq!(tip(0.5, 0.2e-6, 0.2e-6), (0.5, 0.0));
        // from there it leaves as it came
        assert_eq!(tip(0.5, 2.0, 3.0), (0.5, 0.5));
        assert_eq!(tip(0.5, 2.0, -1.0), (-0.5, 0.5));
    }
}
