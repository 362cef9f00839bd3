//! The contact law: all forces and torques between two particles in a step.

use super::def_kinematics::{contact_torque, moment_arm};
use super::def_parameters::force_parameters;
use super::eq02_pair_force::{normal_part, tangential_part};
use super::eq03_normal_force::normal_force;
use super::eq04_tangential_force::kept_fraction;
use super::eq05_rescaled_maximum::rescaled_maximum;
use crate::equation::Equation;
use crate::mechanics::projected_spring::{spring_energy, stretched_spring};
use crate::{Contact, Outcome, Real, Vec3, Wrench, equation, flat_struct};

flat_struct! {
    /// The force parameters of a pair: Table 2 of the paper.
    pub struct Parameters {
        /// Normal stiffness, N/m.
        pub k_n,
        /// Tangential stiffness, N/m.
        pub k_t,
        /// Elastic separation, m.
        pub delta_e,
        /// Fracture separation, m.
        pub delta_f,
        /// Largest tangential force in contact, N.
        pub f_mt,
        /// Normal damping factor, kg/s.
        pub c_n,
        /// Tangential damping factor, kg/s.
        pub c_t,
    }
}

flat_struct! {
    /// Energy that a pair dissipates in one time step, J.
    pub struct Losses {
        /// In the dashpot along the normal.
        pub normal_damping,
        /// In the dashpot in the contact plane.
        pub tangential_damping,
        /// By springs that slipped or were released.
        pub slip,
    }
}

impl<R: Real> Parameters<R> {
    /// Eqs. 2 to 5 composed: the force and the torques of a contact, its spring advanced by `dt`, and the energy lost.
    /// Beyond the fracture separation everything is zero, and the spring is reset.
    #[inline(always)]
    pub fn act(&self, c: &Contact<R>, spring: Vec3<R>, dt: R) -> Outcome<R, Vec3<R>, Losses<R>> {
        let in_range = c.gap.le(self.delta_f);
        let (arm_i, arm_j) = (moment_arm(c.r_i, c.gap), moment_arm(c.r_j, c.gap));
        let v_t = Vec3::select(in_range, c.sliding_velocity(arm_i, arm_j), Vec3::zero());

        let stretched = stretched_spring(spring, c.n, v_t, dt);
        let cap = rescaled_maximum(c.gap, self.delta_f, self.f_mt);
        let kept = kept_fraction(self.k_t, stretched.norm(), cap);
        let spring = Vec3::select(in_range, stretched * kept, Vec3::zero());

        let f_t = tangential_part(spring * self.k_t, self.c_t, v_t);
        self.outcome(c, [arm_i, arm_j], f_t, v_t, [stretched, spring], dt)
    }

    /// The outcome of a contact: Eq. 2 with the tangential force on i, which acts at the end of the arms, and the energy that is lost
    /// where the spring slips and in the dashpots.
    #[inline(always)]
    pub(super) fn outcome(
        &self,
        c: &Contact<R>,
        [arm_i, arm_j]: [R; 2],
        f_t: Vec3<R>,
        v_t: Vec3<R>,
        [stretched, slipped]: [Vec3<R>; 2],
        dt: R,
    ) -> Outcome<R, Vec3<R>, Losses<R>> {
        let v_n = R::select(c.gap.le(self.delta_f), c.normal_velocity(), R::zero());
        let f_n = normal_force(self.k_n, self.delta_e, self.delta_f, c.gap);
        Outcome {
            wrench: Wrench {
                force: normal_part(f_n, self.c_n, v_n, c.n) + f_t,
                torque_i: contact_torque(arm_i, f_t, c.n),
                torque_j: contact_torque(arm_j, f_t, c.n),
            },
            memory: slipped,
            losses: Losses {
                normal_damping: self.c_n * v_n.squared() * dt,
                tangential_damping: self.c_t * v_t.dot(v_t) * dt,
                slip: spring_energy(self.k_t, stretched) - spring_energy(self.k_t, slipped),
            },
        }
    }
}

/// **Section 2**: the contact law as a whole, from two particles and a material to their forces.
///
/// ```math
/// (\mathbf{x}, \mathbf{v}, \boldsymbol{\omega}, r, m)_{i,j}, \; \text{material}, \; \boldsymbol{\xi}, \; \Delta t \mapsto
/// \mathbf{F}, \mathbf{T}_i, \mathbf{T}_j, \boldsymbol{\xi}
/// ```
///
/// # Reading
///
/// Eqs. 7 to 18 give the force parameters, Eqs. 2 to 5 the force. In this order: the spring follows the contact plane and is
/// incremented by the sliding velocity; it slips where its force exceeds the cap of Eq. 5; the updated springs and the dashpots
/// give the force. The dashpots act over the whole range, as in Eq. 2, so they start discontinuously at the fracture separation and
/// may pull while the particles separate; they never deliver power.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `x_i` | $\mathbf{x}_i$ | m (3) | any | position of i |
/// | `x_j` | $\mathbf{x}_j$ | m (3) | any | position of j, distinct from `x_i` |
/// | `v_i` | $\mathbf{v}_i$ | m/s (3) | any | velocity of i |
/// | `v_j` | $\mathbf{v}_j$ | m/s (3) | any | velocity of j |
/// | `omega_i` | $\boldsymbol{\omega}_i$ | rad/s (3) | any | angular velocity of i |
/// | `omega_j` | $\boldsymbol{\omega}_j$ | rad/s (3) | any | angular velocity of j |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `m_i` | $m_i$ | kg | > 0 | mass of i |
/// | `m_j` | $m_j$ | kg | > 0 | mass of j |
/// | `e` | $E$ | Pa | > 0 | Young's modulus |
/// | `nu` | $\nu$ | 1 | (-1, 1/4] | Poisson's ratio |
/// | `sigma_mn` | $\sigma_{m,N}$ | Pa | > 0 | tensile strength |
/// | `sigma_mt` | $\sigma_{m,T}$ | Pa | >= 0 | shear strength |
/// | `gamma` | $\gamma$ | J/m^2 | > 0 | surface energy |
/// | `eta` | $\eta$ | 1 | [0, 1] | restitution coefficient |
/// | `s` | $s$ | 1 | >= 0 | scaling parameter |
/// | `xi` | $\boldsymbol{\xi}$ | m (3) | any | tangential spring before |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `force` | $\mathbf{F}$ | N (3) | | force on i; the force on j is its negative |
/// | → `torque_i` | $\mathbf{T}_i$ | N m (3) | | torque on i about its centre |
/// | → `torque_j` | $\mathbf{T}_j$ | N m (3) | | torque on j about its centre |
/// | → `xi_next` | $\boldsymbol{\xi}$ | m (3) | | tangential spring now |
///
/// Rounding: at most 2 ULP.
///
/// # Laws
///
/// * `swapping_i_and_j_reverses_the_force`
/// * `angular_momentum_is_kept_which_arms_of_one_radius_do_not`
/// * `a_rigid_motion_of_the_pair_changes_no_force`
/// * `turning_the_world_turns_the_forces`
/// * `beyond_its_range_a_pair_feels_and_remembers_nothing`
/// * `dashpots_never_deliver_power`
/// * `the_spring_force_never_exceeds_the_cap`
/// * `a_spin_about_the_normal_leaves_the_spring`
/// * `a_dashpot_sets_in_with_a_jump_and_may_pull`
/// * `spheres_that_overlap_have_the_springs_and_dashpots_of_their_material`
/// * `at_its_range_a_pair_still_slides_and_is_damped`
#[inline(always)]
pub fn contact<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
    m_i: R,
    m_j: R,
    e: R,
    nu: R,
    sigma_mn: R,
    sigma_mt: R,
    gamma: R,
    eta: R,
    s: R,
    xi: Vec3<R>,
    dt: R,
) -> (Vec3<R>, Vec3<R>, Vec3<R>, Vec3<R>) {
    let (k_n, k_t, delta_e, delta_f, f_mt, c_n, c_t) =
        force_parameters(e, nu, sigma_mn, sigma_mt, gamma, eta, s, r_i, r_j, m_i, m_j);
    let parameters = Parameters { k_n, k_t, delta_e, delta_f, f_mt, c_n, c_t };
    let Outcome { wrench, memory, .. } =
        parameters.act(&Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j), xi, dt);
    (wrench.force, wrench.torque_i, wrench.torque_j, memory)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/def_contact.rs", "wear-contact", [], contact)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use proptest::prelude::*;

    const DT: f64 = 0.05;
    const PAIR: Parameters<f64> =
        Parameters { k_n: 2.0, k_t: 0.7, delta_e: 0.2, delta_f: 0.5, f_mt: 0.3, c_n: 0.1, c_t: 0.07 };

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }

    fn unit() -> impl Strategy<Value = Vec3<f64>> {
        vector().prop_filter("long enough", |v| v.norm() > 0.1).prop_map(|v| v * (1.0 / v.norm()))
    }

    fn rotated(v: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Vec3<f64> {
        v * angle.cos() + axis.cross(v) * angle.sin() + axis * (axis.dot(v) * (1.0 - angle.cos()))
    }

    fn at(n: Vec3<f64>, gap: f64, v: Vec3<f64>, omega_i: Vec3<f64>, omega_j: Vec3<f64>) -> Contact<f64> {
        Contact::new(n * (1.75 + gap), v, omega_i, omega_j, 1.0, 0.75)
    }

    proptest! {
        #[test]
        fn swapping_i_and_j_reverses_the_force(
            x in unit(), gap in -0.3..0.5, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
        ) {
            let x = x * (1.75 + gap);
            let here = PAIR.act(&Contact::new(x, v, omega_i, omega_j, 1.0, 0.75), xi, DT);
            let there = PAIR.act(&Contact::new(-x, -v, omega_j, omega_i, 0.75, 1.0), -xi, DT);
            prop_assert!((here.wrench.force + there.wrench.force).norm() < 1e-14);
            prop_assert!((here.wrench.torque_i - there.wrench.torque_j).norm() < 1e-14);
            prop_assert!((here.memory + there.memory).norm() < 1e-14);
        }

        #[test]
        fn angular_momentum_is_kept_which_arms_of_one_radius_do_not(
            n in unit(), gap in 0.05..0.4, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
        ) {
            let c = at(n, gap, v, omega_i, omega_j);
            let Wrench { force, torque_i, torque_j } = PAIR.act(&c, xi, DT).wrench;
            let couple = (c.n * c.distance).cross(force);
            prop_assert!((torque_i + torque_j + couple).norm() < 1e-14);
            let in_plane = force.perpendicular_to(c.n);
            prop_assume!(in_plane.norm() > 1e-3);
            let of_the_surfaces = contact_torque(c.r_i, in_plane, c.n) + contact_torque(c.r_j, in_plane, c.n);
            prop_assert!((of_the_surfaces + couple).norm() > 0.9 * gap * in_plane.norm());
        }

        #[test]
        fn a_rigid_motion_of_the_pair_changes_no_force(n in unit(), gap in -0.3..0.5, omega in vector(), xi in vector()) {
            let still = PAIR.act(&at(n, gap, Vec3::zero(), Vec3::zero(), Vec3::zero()), xi, DT);
            let turning = PAIR.act(&at(n, gap, omega.cross(n * (1.75 + gap)), omega, omega), xi, DT);
            prop_assert!((still.wrench.force - turning.wrench.force).norm() < 1e-14);
            prop_assert!((still.memory - turning.memory).norm() < 1e-14);
            prop_assert!(turning.losses.normal_damping + turning.losses.tangential_damping < 1e-28);
        }

        #[test]
        fn turning_the_world_turns_the_forces(
            n in unit(), gap in -0.3..0.5, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
            axis in unit(), angle in -3.0..3.0,
        ) {
            let turn = |v| rotated(v, axis, angle);
            let before = PAIR.act(&at(n, gap, v, omega_i, omega_j), xi, DT);
            let after = PAIR.act(&at(turn(n), gap, turn(v), turn(omega_i), turn(omega_j)), turn(xi), DT);
            prop_assert!((turn(before.wrench.force) - after.wrench.force).norm() < 1e-13);
            prop_assert!((turn(before.wrench.torque_j) - after.wrench.torque_j).norm() < 1e-13);
            prop_assert!((turn(before.memory) - after.memory).norm() < 1e-13);
        }

        #[test]
        fn beyond_its_range_a_pair_feels_and_remembers_nothing(n in unit(), beyond in 1e-9..1e6, v in vector(), omega in vector(), xi in vector()) {
            let Outcome { wrench, memory, losses } = PAIR.act(&at(n, 0.5 + beyond, v, omega, omega), xi, DT);
            for zero in [wrench.force, wrench.torque_i, wrench.torque_j, memory] {
                prop_assert_eq!(zero.norm(), 0.0);
            }
            prop_assert_eq!((losses.normal_damping, losses.tangential_damping), (0.0, 0.0));
        }

        #[test]
        fn dashpots_never_deliver_power(n in unit(), gap in -0.3..0.7, v in vector(), omega_i in vector(), omega_j in vector()) {
            let dashpots = Parameters { k_n: 0.0, k_t: 0.0, ..PAIR };
            let c = at(n, gap, v, omega_i, omega_j);
            let Outcome { wrench, losses, .. } = dashpots.act(&c, Vec3::zero(), DT);
            let power = wrench.power(&c);
            prop_assert!(power <= 1e-15);
            prop_assert!((losses.normal_damping + losses.tangential_damping + power * DT).abs() < 1e-15);
        }

        #[test]
        fn the_spring_force_never_exceeds_the_cap(n in unit(), gap in -0.3..0.7, v in vector(), xi in vector()) {
            let outcome = PAIR.act(&at(n, gap, v, Vec3::zero(), Vec3::zero()), xi, DT);
            prop_assert!(PAIR.k_t * outcome.memory.norm() <= rescaled_maximum(gap, PAIR.delta_f, PAIR.f_mt) * (1.0 + 1e-14) + 1e-15);
            prop_assert!(outcome.losses.slip >= -1e-16);
        }

        #[test]
        fn a_spin_about_the_normal_leaves_the_spring(n in unit(), gap in -0.3..0.0, spin in -3.0..3.0, xi in vector()) {
            let (still, spinning) = (Vec3::zero(), n * spin);
            let before = PAIR.act(&at(n, gap, still, still, still), xi, DT);
            let after = PAIR.act(&at(n, gap, still, spinning, spinning), xi, DT);
            prop_assert!((before.memory - after.memory).norm() < 1e-14);
        }

        #[test]
        fn spheres_that_overlap_have_the_springs_and_dashpots_of_their_material(
            at in vector(), n in unit(), gap in -0.3..-0.01, speed in -1.0..1.0, slid in vector(), drift in vector(),
        ) {
            let (r_i, r_j, m_i, m_j) = (1.0, 0.75, 4.0, 2.0);
            let (e, nu, sigma_mn, sigma_mt, gamma, eta, s) = (1.0, 0.2, 0.2, 0.15, 1.5, 0.8, 0.5);
            let (k_n, k_t, .., c_n, c_t) = force_parameters(e, nu, sigma_mn, sigma_mt, gamma, eta, s, r_i, r_j, m_i, m_j);
            let (xi, zero) = (slid.perpendicular_to(n) * 1e-3, Vec3::zero());
            let act = |v: Vec3<f64>, xi, dt| contact(
                at + n * (r_i + r_j + gap), at, v + drift, drift, zero, zero, r_i, r_j, m_i, m_j, e, nu, sigma_mn, sigma_mt, gamma, eta, s, xi, dt,
            );
            let (force, torque_i, torque_j, next) = act(n * speed, xi, DT);
            prop_assert!((force + n * (k_n * gap + c_n * speed) + xi * k_t).norm() < 1e-13);
            prop_assert!((next - xi).norm() < 1e-15);
            // the tangential force acts halfway between the surfaces
            for (torque, arm) in [(torque_i, r_i + 0.5 * gap), (torque_j, r_j + 0.5 * gap)] {
                prop_assert!((torque + n.cross(force) * arm).norm() < 1e-14);
            }
            // sliding stretches the spring and is damped
            let (force, .., next) = act(xi, zero, DT);
            prop_assert!((next - xi * DT).norm() < 1e-15);
            prop_assert!((force + n * (k_n * gap) + xi * (k_t * DT + c_t)).norm() < 1e-13);
        }

        #[test]
        fn a_dashpot_sets_in_with_a_jump_and_may_pull(n in unit(), speed in 0.1..1.0) {
            let force = |gap| PAIR.act(&at(n, gap, n * speed, Vec3::zero(), Vec3::zero()), Vec3::zero(), DT).wrench.force.dot(n);
            let (edge, touching) = (PAIR.delta_f, 0.0);
            prop_assert!((force(edge - 1e-9) + PAIR.c_n * speed).abs() < 1e-8);
            prop_assert_eq!(force(edge + 1e-9), 0.0);
            prop_assert!(force(touching) < 0.0);
        }
    }

    #[test]
    fn at_its_range_a_pair_still_slides_and_is_damped() {
        let (n, v, none) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.5, 0.25, 0.0), Vec3::zero());
        let Outcome { wrench, memory, losses } = PAIR.act(&at(n, PAIR.delta_f, v, none, none), none, DT);
        assert!((wrench.force + Vec3::new(PAIR.c_n * 0.5, PAIR.c_t * 0.25, 0.0)).norm() < 1e-15);
        assert_eq!((memory, losses.tangential_damping), (none, PAIR.c_t * 0.0625 * DT));
    }
}
