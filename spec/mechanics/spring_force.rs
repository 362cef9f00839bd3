//! The force of a spring and its dashpot, and the forces and torques of four of them on two spheres.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::pair_geometry::{arm, gap, mean_arm, normal};
use super::rotated_spring::{Span, Twist};
use crate::equation::Equation;
use crate::{Real, Vec3, equation};

/// **Eq. 12**, Section 2.1.2: force of a spring and its dashpot on i.
///
/// ```math
/// \mathbf{f} = k \boldsymbol{\xi} + \eta \dot{\boldsymbol{\xi}}
/// ```
///
/// # Reading
///
/// On i, with the velocity of j relative to i: the spring pulls i after j. For the normal spring, $\boldsymbol{\xi} = \delta \mathbf{n}$: a neck is at rest where the
/// surfaces touch, whatever the gap at which it was made. The dashpot acts from the onset of a contact, discontinuously.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k` | $k$ | N/m | >= 0 | stiffness |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring |
/// | `eta` | $\eta$ | kg/s | >= 0 | damping coefficient |
/// | `xi_dot` | $\dot{\boldsymbol{\xi}}$ | m/s (3) | any | rate |
/// | → `f` | $\mathbf{f}$ | N (3) | | force on i |
///
/// Rounding: at most 0.5 ULP.
///
/// # Laws
///
/// * `a_spring_returns_its_work_and_a_dashpot_does_not`
#[inline(always)]
pub fn spring_force<R: Real>(k: R, xi: Vec3<R>, eta: R, xi_dot: Vec3<R>) -> Vec3<R> {
    force(k, xi, eta, xi_dot)
}

/// Eq. 12 for a spring of any kind.
#[inline(always)]
pub fn force<R: Real, S: Span<R>>(k: R, xi: S, eta: R, xi_dot: S) -> S {
    xi * k + xi_dot * eta
}

/// **Section 2.1.2**, unnumbered: energy stored in a spring.
///
/// ```math
/// U = \frac{1}{2} k \, |\boldsymbol{\xi}|^2
/// ```
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `k` | $k$ | N/m | >= 0 | stiffness |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | spring |
/// | → `u` | $U$ | J | | energy |
///
/// Rounding: at most 1 ULP.
///
/// # Laws
///
/// * `a_spring_returns_its_work_and_a_dashpot_does_not`
#[inline(always)]
pub fn spring_energy<R: Real>(k: R, xi: Vec3<R>) -> R {
    energy(k, xi)
}

/// The energy of a spring of any kind.
#[inline(always)]
pub fn energy<R: Real, S: Span<R>>(k: R, xi: S) -> R {
    R::lit(0.5) * k * xi.square()
}

/// **Section 2.1.2**, unnumbered: torques of the tangential force and of the rolling and torsion quasi-forces.
///
/// ```math
/// \boldsymbol{\tau}_i = a_i \mathbf{n} \times \mathbf{f}_\mathrm{t} + \mathbf{m}, \quad
/// \boldsymbol{\tau}_j = a_j \mathbf{n} \times \mathbf{f}_\mathrm{t} - \mathbf{m}, \quad
/// \mathbf{m} = a \mathbf{n} \times \mathbf{f}_\mathrm{r} + r \, (\mathbf{f}_\mathrm{o} \cdot \mathbf{n}) \, \mathbf{n}
/// ```
///
/// # Reading
///
/// The paper gives no formula. The tangential force acts on both surfaces at the contact point, in opposite directions and at opposite arms: its torques have the same sign and balance the
/// couple of the two forces. Rolling and torsion are pure torques. Their arms are those of their rates, so that their power is
/// $-\mathbf{f} \cdot \dot{\boldsymbol{\xi}}$; for unequal spheres $a$ and $r$ are the [`mean_arm`]s.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `f_t` | $\mathbf{f}_\mathrm{t}$ | N (3) | any | tangential force on i |
/// | `f_r` | $\mathbf{f}_\mathrm{r}$ | N (3) | any | rolling quasi-force |
/// | `f_o` | $\mathbf{f}_\mathrm{o}$ | N (3) | any | torsion quasi-force |
/// | → `tau_i` | $\boldsymbol{\tau}_i$ | N m (3) | | torque on i about its centre |
/// | → `tau_j` | $\boldsymbol{\tau}_j$ | N m (3) | | torque on j about its centre |
///
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `torques_balance_the_couple_of_the_tangential_force`
/// * `the_power_of_torques_and_forces_is_that_of_the_springs`
#[inline(always)]
pub fn contact_torques<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    r_i: R,
    r_j: R,
    f_t: Vec3<R>,
    f_r: Vec3<R>,
    f_o: Vec3<R>,
) -> (Vec3<R>, Vec3<R>) {
    let (n, delta) = (normal(x_i, x_j), gap(x_i, x_j, r_i, r_j));
    let (a_i, a_j) = (arm(r_i, delta), arm(r_j, delta));
    let turning = turning_torque(n, mean_arm(a_i, a_j), f_r, mean_arm(r_i, r_j), f_o.dot(n));
    let sliding = n.cross(f_t);
    (sliding * a_i + turning, sliding * a_j - turning)
}

/// The torque on i of rolling and torsion, for given arms.
#[inline(always)]
pub fn turning_torque<R: Real>(n: Vec3<R>, a: R, f_r: Vec3<R>, r: R, f_o: impl Twist<R>) -> Vec3<R> {
    n.cross(f_r) * a + f_o.torque(n, r)
}

pub(crate) fn equations() -> Vec<Equation> {
    vec![
        equation!("mechanics/spring_force.rs", "soot-12", ["12"], spring_force),
        equation!("mechanics/spring_force.rs", "soot-spring-energy", [], spring_energy),
        equation!("mechanics/spring_force.rs", "soot-torques", [], contact_torques),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::relative_spin::turning_rates;
    use crate::mechanics::relative_velocity::tangential_velocity;
    use crate::mechanics::samples::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_spring_returns_its_work_and_a_dashpot_does_not(k in 0.1..10.0f64, eta in 0.0..3.0f64, to in vector(), speed in 0.1..2.0f64) {
            // Stretched at constant speed to its end; the force of the spring is linear, that of the dashpot constant.
            let (middle, rate) = (to * 0.5, to * (speed / to.norm()));
            let work = spring_force(k, middle, eta, rate).dot(to);
            let lost = eta * speed * to.norm();
            prop_assert!((work - spring_energy(k, to) - lost).abs() < 1e-13 * (1.0 + work));
        }

        #[test]
        fn torques_balance_the_couple_of_the_tangential_force(
            x in vector(), r_i in 0.1..0.3, r_j in 0.1..0.3, f_t in vector(), f_r in vector(), f_o in vector(),
        ) {
            prop_assume!(x.norm() > 0.1);
            let (tau_i, tau_j) = contact_torques(Vec3::zero(), x, r_i, r_j, f_t, f_r, f_o);
            prop_assert!((tau_i + tau_j - x.cross(f_t)).norm() < 1e-13);
        }

        #[test]
        fn the_power_of_torques_and_forces_is_that_of_the_springs(
            x in vector(), v in vector(), omega_i in vector(), omega_j in vector(), r_i in 0.1..0.3, r_j in 0.1..0.3,
            f_t in vector(), f_r in vector(), f_o in vector(),
        ) {
            prop_assume!(x.norm() > 0.1);
            let zero = Vec3::zero();
            let n = normal(zero, x);
            let f_t = f_t.perpendicular_to(n);
            let (tau_i, tau_j) = contact_torques(zero, x, r_i, r_j, f_t, f_r, f_o);
            let to_the_spheres = tau_i.dot(omega_i) + tau_j.dot(omega_j) - f_t.dot(v);
            let (rolling, torsion) = turning_rates(zero, x, omega_i, omega_j, r_i, r_j);
            let sliding = tangential_velocity(zero, x, zero, v, omega_i, omega_j, r_i, r_j);
            let to_the_springs = f_t.dot(sliding) + f_r.dot(rolling) + f_o.dot(torsion);
            prop_assert!((to_the_spheres + to_the_springs).abs() < 1e-13);
        }
    }
}
