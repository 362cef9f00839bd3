//! A sphere against a wall: the substrate, a facet of the tip.

use crate::equation::Equation;
use crate::mechanics::contact_kinematics::ContactKinematics;
use crate::mechanics::four_springs::{Friction, Memory, Springs, SpringsOutcome, never};
use crate::{Real, Vec3, equation};

/// **Section 3.1**, unnumbered: frictional contact of a sphere with a wall of given velocity.
///
/// ```math
/// \mathbf{n}, \delta, \mathbf{v}, \boldsymbol{\omega}, r, \; (k, \eta)_{\mathrm{n,t,r,o}}, \; \mu, \; \boldsymbol{\xi}_{\mathrm{t,r,o}}, \; \Delta t \mapsto
/// \mathbf{f}, \boldsymbol{\tau}, \boldsymbol{\xi}_{\mathrm{t,r,o}}
/// ```
///
/// # Reading
///
/// In the paper substrate and tip exert the forces of a contact and never move under them. Normal and gap come from the geometry: the closest point of the wall. The partner is not
/// a sphere of infinite radius in every respect: the contact point is on the wall, so that the arm is $r + \delta$ and not $r + \delta/2$, also for rolling. A sphere that rolls on the
/// wall is not slowed down by the tangential spring. Springs are in the convention of the paper, with the normal from the sphere to the wall.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `n` | $-\mathbf{n}$ | 1 (3) | unit | normal from the wall to the sphere |
/// | `delta` | $\delta$ | m | any | gap, negative for an overlap |
/// | `v` | $\mathbf{v}$ | m/s (3) | any | velocity of the sphere relative to the wall at the contact point |
/// | `omega` | $\boldsymbol{\omega}$ | rad/s (3) | any | angular velocity of the sphere |
/// | `r` | $r$ | m | > 0 | radius |
/// | `k_n` | $k_\mathrm{n}$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_\mathrm{t}$ | N/m | >= 0 | tangential stiffness |
/// | `k_r` | $k_\mathrm{r}$ | N/m | >= 0 | rolling stiffness |
/// | `k_o` | $k_\mathrm{o}$ | N/m | >= 0 | torsional stiffness |
/// | `eta_n` | $\eta_\mathrm{n}$ | kg/s | >= 0 | normal damping |
/// | `eta_t` | $\eta_\mathrm{t}$ | kg/s | >= 0 | tangential damping |
/// | `eta_r` | $\eta_\mathrm{r}$ | kg/s | >= 0 | rolling damping |
/// | `eta_o` | $\eta_\mathrm{o}$ | kg/s | >= 0 | torsional damping |
/// | `mu_t` | $\mu_\mathrm{s}$ | 1 | >= 0 | static friction coefficient of sliding |
/// | `mu_r` | $\mu_\mathrm{s,r}$ | 1 | >= 0 | of rolling |
/// | `mu_o` | $\mu_\mathrm{s,o}$ | 1 | >= 0 | of torsion |
/// | `phi` | $\mu_\mathrm{d} / \mu_\mathrm{s}$ | 1 | [0, 1] | ratio of the dynamic to the static coefficients |
/// | `xi_t` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | any | tangential spring before |
/// | `xi_r` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | any | rolling spring before |
/// | `xi_o` | $\xi_\mathrm{o}$ | m | any | torsion spring before, along the normal |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `force` | $\mathbf{f}$ | N (3) | | force on the sphere |
/// | → `torque` | $\boldsymbol{\tau}$ | N m (3) | | torque on the sphere about its centre |
/// | → `xi_t_next` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | | tangential spring now |
/// | → `xi_r_next` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | | rolling spring now |
/// | → `xi_o_next` | $\xi_\mathrm{o}$ | m | | torsion spring now |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `a_sphere_that_rolls_on_a_wall_does_not_slide`
/// * `gross_sliding_takes_the_tangential_velocity_and_gives_the_spin_of_the_closed_form`
/// * `a_sliding_sphere_rolls_with_five_sevenths_of_its_velocity`
/// * `a_spinning_sphere_comes_to_rest_in_the_time_of_its_torsional_friction`
/// * `a_rolling_sphere_slows_down_as_its_rolling_friction_says`
#[inline(always)]
pub fn wall_contact<R: Real>(
    n: Vec3<R>,
    delta: R,
    v: Vec3<R>,
    omega: Vec3<R>,
    r: R,
    k_n: R,
    k_t: R,
    k_r: R,
    k_o: R,
    eta_n: R,
    eta_t: R,
    eta_r: R,
    eta_o: R,
    mu_t: R,
    mu_r: R,
    mu_o: R,
    phi: R,
    xi_t: Vec3<R>,
    xi_r: Vec3<R>,
    xi_o: R,
    dt: R,
) -> (Vec3<R>, Vec3<R>, Vec3<R>, Vec3<R>, R) {
    let springs = Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o };
    let memory = Memory { tangential: xi_t, rolling: xi_r, torsion: xi_o, rest: R::zero() };
    let at = ContactKinematics::of_wall(n, delta, v, omega, r);
    let SpringsOutcome { wrench, memory, .. } =
        springs.evaluate(&Friction::from_ratio([mu_t, mu_r, mu_o], phi), never::<R>(), &at, memory, dt);
    (wrench.force, wrench.torque_i, memory.tangential, memory.rolling, memory.torsion)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("soot/def_wall.rs", "soot-wall", [], wall_contact)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::primary_particle::solid_inertia;
    use crate::mechanics::samples::{unit, vector};
    use crate::mechanics::verlet::half_step;
    use proptest::prelude::*;

    const NONE: Vec3<f64> = Vec3([0.0; 3]);
    const UP: Vec3<f64> = Vec3([0.0, 0.0, 1.0]);

    /// A unit sphere of unit mass above the plane z = 0, with springs that are stiff compared with its weight.
    struct Ball {
        mu: [f64; 3],
        weight: f64,
        x: Vec3<f64>,
        v: Vec3<f64>,
        omega: Vec3<f64>,
        memory: Memory<f64>,
        damping: f64,
    }
    const STIFFNESS: f64 = 1e4;

    impl Ball {
        /// Pressed down by its weight, at rest along the normal.
        fn lying(mu: [f64; 3], weight: f64) -> Self {
            let x = UP * (1.0 - weight / STIFFNESS);
            Self { mu, weight, x, v: NONE, omega: NONE, memory: Memory::zero(), damping: 5.0 }
        }
        fn step(&mut self, dt: f64) {
            let (k, eta, m) = (STIFFNESS, self.damping, self.memory);
            let [mu_t, mu_r, mu_o] = self.mu;
            let (force, torque, tangential, rolling, torsion) = wall_contact(
                UP,
                self.x.0[2] - 1.0,
                self.v,
                self.omega,
                1.0,
                k,
                k,
                k,
                k,
                eta,
                eta,
                eta,
                eta,
                mu_t,
                mu_r,
                mu_o,
                1.0,
                m.tangential,
                m.rolling,
                m.torsion,
                dt,
            );
            self.memory = Memory { tangential, rolling, torsion, ..Memory::zero() };
            (self.v, self.x, self.omega) = half_step(
                self.x,
                self.v,
                self.omega,
                force - UP * self.weight,
                torque,
                1.0,
                solid_inertia(1.0, 1.0),
                dt,
            );
        }
        fn run(&mut self, time: f64, dt: f64) {
            (0..(time / dt) as usize).for_each(|_| self.step(dt));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        #[test]
        fn a_sphere_that_rolls_on_a_wall_does_not_slide(n in unit(), omega in vector(), gap in -0.2..0.0) {
            let (r, k) = (1.0, 1.0);
            let v = omega.cross(n) * (r + gap);
            let (force, ..) = wall_contact(n, gap, v, omega, r, k, k, k, k, k, k, k, k, 9.0, 9.0, 9.0, 1.0, NONE, NONE, 0.0, 0.1);
            prop_assert!(force.perpendicular_to(n).norm() < 1e-14);
        }

        #[test]
        fn gross_sliding_takes_the_tangential_velocity_and_gives_the_spin_of_the_closed_form(mu in 0.05..0.2f64, speed in 0.1..0.3f64) {
            // An impact that slides to its end: the tangential impulse is mu times the normal one, (1 + e) m v_n with e = 1.
            let mut ball = Ball { x: UP, v: Vec3::new(3.0 * speed, 0.0, -speed), damping: 0.0, ..Ball::lying([mu, 0.0, 0.0], 0.0) };
            let dt = 1e-5;
            ball.step(dt);
            while ball.x.0[2] < 1.0 {
                ball.step(dt);
            }
            let impulse = 2.0 * mu * speed;
            prop_assert!((ball.v.0[2] / speed - 1.0).abs() < 2e-3);
            prop_assert!((ball.v.0[0] - 3.0 * speed + impulse).abs() < 5e-3 * speed);
            prop_assert!((ball.omega.0[1] - 2.5 * impulse).abs() < 5e-2 * speed);
        }

        #[test]
        fn a_sliding_sphere_rolls_with_five_sevenths_of_its_velocity(mu in 0.1..0.5, speed in 0.5..1.0) {
            let mut ball = Ball { v: Vec3::new(speed, 0.0, 0.0), ..Ball::lying([mu, 0.0, 0.0], 1.0) };
            let until_it_rolls = 2.0 * speed / (7.0 * mu);
            ball.run(0.5 * until_it_rolls, 1e-4);
            prop_assert!((ball.v.0[0] - (speed - 0.5 * mu * until_it_rolls)).abs() < 2e-3);
            ball.run(until_it_rolls, 1e-4);
            // What is left is the swing of the tangential spring.
            prop_assert!((ball.v.0[0] / speed - 5.0 / 7.0).abs() < 1e-2 && (ball.omega.0[1] / ball.v.0[0] - 1.0).abs() < 1e-2);
        }

        #[test]
        fn a_spinning_sphere_comes_to_rest_in_the_time_of_its_torsional_friction(mu in 0.1..0.5, spin in 0.5..2.0) {
            let mut ball = Ball { omega: UP * spin, ..Ball::lying([0.0, 0.0, mu], 1.0) };
            let stop = spin / (2.5 * mu);
            ball.run(0.5 * stop, 1e-4);
            prop_assert!((ball.omega.0[2] - 0.5 * spin).abs() < 5e-3);
            ball.run(stop, 1e-4);
            prop_assert!(ball.omega.0[2].abs() < 2e-2 * spin);
        }

        #[test]
        fn a_rolling_sphere_slows_down_as_its_rolling_friction_says(mu in 0.02..0.1, speed in 0.5..1.0) {
            // The rolling torque mu N r slows the spin; friction slows the centre so that it goes on rolling: 7/5 m a = mu N.
            let mut ball = Ball { v: Vec3::new(speed, 0.0, 0.0), omega: Vec3::new(0.0, speed, 0.0), ..Ball::lying([9.0, mu, 0.0], 1.0) };
            let time = 0.5 * speed * 1.4 / mu;
            ball.run(time, 1e-4);
            prop_assert!((ball.v.0[0] / speed - 0.5).abs() < 1e-2 && (ball.omega.0[1] / speed - 0.5).abs() < 1e-2);
        }
    }
}
