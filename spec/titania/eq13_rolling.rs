//! The rolling resistance.

use super::def_radius::effective_radius;
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// Rolling resistance in a step in which it would reverse the rolling of a particle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rolling {
    /// The particle stops.
    Stopping,
    /// The particle rolls back, as in the authors' program: a particle that should be at rest reverses its spin in every step.
    Unlimited,
}

/// The angular velocity over whose length the rolling torque is spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RollingOver {
    /// That of rolling.
    Rolling,
    /// The whole relative one, with the twist about the normal, as in the authors' program: [`rolling_share`].
    Spin,
}

/// **Eq. 13**, Section 2.4: magnitude of the rolling torque.
///
/// ```math
/// \mathbf{M}_r = 0.5 (R + h_n)^* \tau_R A_{ij}
/// ```
///
/// # Reading
///
/// Ambiguous: the left side is a vector and the right side is not. This is the magnitude, [`rolling_torque`] gives the direction.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `r_i` | $R_i$ | m | > 0 | bare radius of i |
/// | `r_j` | $R_j$ | m | > 0 | bare radius of j |
/// | `h_n` | $h_n$ | m | >= 0 | thickness of the compressed layer |
/// | `tau_r` | $\tau_R$ | Pa | >= 0 | shear strength of rolling |
/// | `a` | $A_{ij}$ | m^2 | >= 0 | contact area |
/// | → `m_r` | $M_r$ | N m | | magnitude of the rolling torque |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `on_a_plane_the_arm_is_the_radius`
/// * `the_arms_of_two_spheres_on_a_plane_add_up_inversely`
#[inline(always)]
pub fn rolling_resistance<R: Real>(r_i: R, r_j: R, h_n: R, tau_r: R, a: R) -> R {
    effective_radius(r_i + h_n, r_j + h_n).1 * tau_r * a
}

/// **Eq. 13** with a direction: rolling torque on i over a step.
///
/// ```math
/// -\mathbf{M}_r = -\min\left(M_r, \frac{I |\boldsymbol{\omega}_r|}{\Delta t}\right) \hat{\boldsymbol{\omega}}_r, \quad
/// \boldsymbol{\omega}_r = (\boldsymbol{\omega}_i - \boldsymbol{\omega}_j)_{\perp \mathbf{n}}, \quad
/// \frac{1}{I} = \frac{1}{I_i} + \frac{1}{I_j}
/// ```
///
/// # Reading
///
/// Ambiguous: a "pure slider" has no value at rest. The torque opposes the relative rolling velocity, which excludes the spin about the normal,
/// and is zero at rest. A step of constant torque may stop the rolling but not reverse it: without the limit the
/// spin would change its sign every step ([`Rolling::Unlimited`]: an infinite moment of inertia). The authors' program has no limit and divides by the length of the whole
/// relative angular velocity, so that twisting weakens its resistance to rolling.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `m_r` | $M_r$ | N m | >= 0 | magnitude, Eq. 13 |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `n` | $\mathbf{n}_{ij}$ | 1 (3) | unit | normal, from j to i |
/// | `inertia` | $I$ | kg m^2 | > 0 | reduced moment of inertia of the two |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `torque` | $-\mathbf{M}_r$ | N m (3) | | torque on i; the torque on j is its negative |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `opposes_rolling_and_ignores_twisting`
/// * `a_step_stops_rolling_and_never_reverses_it_which_the_torque_without_limit_does`
/// * `is_zero_at_rest`
#[inline(always)]
pub fn rolling_torque<R: Real>(m_r: R, omega_i: Vec3<R>, omega_j: Vec3<R>, n: Vec3<R>, inertia: R, dt: R) -> Vec3<R> {
    let omega_r = (omega_i - omega_j).perpendicular_to(n);
    let speed = omega_r.norm();
    // no more than takes the whole spin in one step
    let per_speed = (m_r / speed).min(inertia * (R::one() / dt));
    omega_r * -R::select(speed.gt(R::zero()), per_speed, R::zero())
}

/// **Eq. 13** in the authors' program: the share of rolling in a relative spin, by which twisting weakens the resistance to rolling.
///
/// ```math
/// \frac{|\boldsymbol{\omega}_r|}{|\boldsymbol{\omega}_i - \boldsymbol{\omega}_j|}
/// ```
///
/// # Reading
///
/// The paper does not define the direction of the torque. The program divides the rolling part of the relative angular velocity by the length of the whole. One at rest, where there is no torque.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `n` | $\mathbf{n}_{ij}$ | 1 (3) | unit | normal, from j to i |
/// | → `share` | $s$ | 1 | | factor of the rolling torque |
///
/// Rounding: at most 1.5 ULP.
///
/// # Laws
///
/// * `twisting_weakens_the_resistance_of_the_program`
#[inline(always)]
pub fn rolling_share<R: Real>(omega_i: Vec3<R>, omega_j: Vec3<R>, n: Vec3<R>) -> R {
    let omega = omega_i - omega_j;
    let whole = omega.norm();
    R::select(whole.gt(R::zero()), omega.perpendicular_to(n).norm() / whole, R::one())
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("titania/eq13_rolling.rs", "titania-13", ["13"], rolling_resistance),
        equation!("titania/eq13_rolling.rs", "titania-13-torque", [], rolling_torque),
        equation!("titania/eq13_rolling.rs", "titania-13-share", [], rolling_share),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use approx::relative_eq;
    use proptest::prelude::*;

    const N: Vec3<f64> = Vec3([0.48, 0.6, 0.64]);

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-3.0..3.0).prop_map(Vec3)
    }

    proptest! {
        #[test]
        fn on_a_plane_the_arm_is_the_radius(r in 1.0..12.0) {
            prop_assert!(relative_eq!(rolling_resistance(r, 1e13, 0.36, 0.25, 1.9), (r + 0.36) * 0.25 * 1.9, max_relative = 1e-11));
        }

        #[test]
        fn the_arms_of_two_spheres_on_a_plane_add_up_inversely(r_i in 1.0..12.0, r_j in 1.0..12.0, h_n in 0.0..1.0, (tau_r, a) in (0.1..9.0, 0.1..9.0)) {
            let torque = |r_i, r_j| rolling_resistance(r_i, r_j, h_n, tau_r, a);
            let (both, plane) = (torque(r_i, r_j), 1e15);
            prop_assert!(relative_eq!(1.0 / both, 1.0 / torque(r_i, plane) + 1.0 / torque(plane, r_j), max_relative = 1e-12));
            prop_assert!(relative_eq!(both, torque(r_j, r_i), max_relative = 1e-15));
        }

        #[test]
        fn opposes_rolling_and_ignores_twisting(omega_i in vector(), omega_j in vector(), twist in -3.0..3.0) {
            let torque = rolling_torque(0.3, omega_i, omega_j, N, 1.0, 0.0);
            prop_assume!((omega_i - omega_j).perpendicular_to(N).norm() > 0.01);
            prop_assert!(torque.dot(omega_i - omega_j) < 0.0);
            prop_assert!((torque.norm() - 0.3).abs() < 1e-14);
            prop_assert!((torque - rolling_torque(0.3, omega_i + N * twist, omega_j, N, 1.0, 0.0)).norm() < 1e-12);
        }

        #[test]
        fn a_step_stops_rolling_and_never_reverses_it_which_the_torque_without_limit_does(
            omega in vector(), m_r in 0.01..3.0, i_i in 0.1..2.0, i_j in 0.1..2.0, dt in 0.01..10.0,
        ) {
            let torque = rolling_torque(m_r, omega, Vec3::zero(), N, i_i * i_j / (i_i + i_j), dt);
            let relative = |torque: Vec3<f64>| (omega + torque * (dt / i_i + dt / i_j)).perpendicular_to(N);
            let before = omega.perpendicular_to(N);
            prop_assume!(before.norm() > 0.1);
            prop_assert!(relative(torque).dot(before) >= -1e-13 && relative(torque).norm() <= before.norm());
            let unlimited = before * (-m_r / before.norm());
            prop_assert_eq!((torque - unlimited).norm() > 1e-12, relative(unlimited).dot(before) < -1e-10);
        }

        #[test]
        fn twisting_weakens_the_resistance_of_the_program(omega in vector(), twist in 0.1..3.0f64) {
            let rolled = omega.perpendicular_to(N);
            prop_assume!(rolled.norm() > 0.1);
            let expected = rolled.norm() / rolled.norm().hypot(twist);
            prop_assert!((rolling_share(rolled + N * twist, Vec3::zero(), N) - expected).abs() < 1e-13);
            prop_assert!((rolling_share(rolled, Vec3::zero(), N) - 1.0).abs() < 1e-14);
            prop_assert!(rolling_share(N * twist, Vec3::zero(), N) < 1e-14);
            prop_assert_eq!(rolling_share(omega, omega, N), 1.0);
        }

        #[test]
        fn is_zero_at_rest(omega in vector(), spin in -3.0..3.0, m_r in 0.0..2.0, dt in 0.0..1.0) {
            prop_assert_eq!(rolling_torque(m_r, omega, omega, N, 1.0, dt).norm(), 0.0);
            // where a step sets no limit
            for (inertia, dt) in [(1.0, 0.0), (f64::INFINITY, dt)] {
                prop_assert_eq!(rolling_torque(m_r, omega, omega, N, inertia, dt).norm(), 0.0);
            }
            prop_assert!(rolling_torque(m_r, omega + N * spin, omega, N, 1.0, 0.1).norm() < 1e-13);
        }
    }
}
