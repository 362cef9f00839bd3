//! The two contacts of the paper: the neck and the frictional contact.

use crate::equation::Equation;
use crate::mechanics::contact_kinematics::ContactKinematics;
use crate::mechanics::four_springs::{Friction, Memory, Order, Springs, SpringsOutcome, never};
use crate::{Contact, Real, Vec3, equation};

/// Force on i, torques on i and j, and the three springs.
type Effect<R, O = R> = (Vec3<R>, Vec3<R>, Vec3<R>, Vec3<R>, Vec3<R>, O);

/// **Section 2.1.2**, Eqs. 3 to 12 together, unnumbered: a neck, from two particles and their springs to forces and springs.
///
/// ```math
/// (\mathbf{x}, \mathbf{v}, \boldsymbol{\omega}, r)_{i,j}, \; (k, \eta)_{\mathrm{n,t,r,o}}, \; \boldsymbol{\xi}_{\mathrm{t,r,o}}, \; \Delta t \mapsto
/// \mathbf{f}, \boldsymbol{\tau}_i, \boldsymbol{\tau}_j, \boldsymbol{\xi}_{\mathrm{t,r,o}}
/// ```
///
/// # Reading
///
/// In the order of Section 2.1.1: the springs rotate with the pair and are stretched by their rates, then they act. The neck is relaxed where the surfaces touch, and acts in tension and compression without
/// limit. Force on i and springs are in the convention of the paper, with the normal from i to j; seen from j the tangential spring is reversed, the other two are the same.
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
/// | `k_n` | $k_\mathrm{n}$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_\mathrm{t}$ | N/m | >= 0 | tangential stiffness |
/// | `k_r` | $k_\mathrm{r}$ | N/m | >= 0 | rolling stiffness |
/// | `k_o` | $k_\mathrm{o}$ | N/m | >= 0 | torsional stiffness |
/// | `eta_n` | $\eta_\mathrm{n}$ | kg/s | >= 0 | normal damping |
/// | `eta_t` | $\eta_\mathrm{t}$ | kg/s | >= 0 | tangential damping |
/// | `eta_r` | $\eta_\mathrm{r}$ | kg/s | >= 0 | rolling damping |
/// | `eta_o` | $\eta_\mathrm{o}$ | kg/s | >= 0 | torsional damping |
/// | `xi_t` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | any | tangential spring before |
/// | `xi_r` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | any | rolling spring before |
/// | `xi_o` | $\xi_\mathrm{o}$ | m | any | torsion spring before, along the normal |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `force` | $\mathbf{f}$ | N (3) | | force on i; the force on j is its negative |
/// | → `torque_i` | $\boldsymbol{\tau}_i$ | N m (3) | | torque on i about its centre |
/// | → `torque_j` | $\boldsymbol{\tau}_j$ | N m (3) | | torque on j about its centre |
/// | → `xi_t_next` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | | tangential spring now |
/// | → `xi_r_next` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | | rolling spring now |
/// | → `xi_o_next` | $\xi_\mathrm{o}$ | m | | torsion spring now |
///
/// Rounding: at most 40 ULP.
///
/// # Laws
///
/// * `a_neck_keeps_momentum_and_angular_momentum`
/// * `a_rigid_motion_of_a_necked_pair_changes_no_force`
/// * `turning_the_world_turns_the_forces`
/// * `seen_from_the_other_particle_the_pair_is_the_same`
/// * `dashpots_never_deliver_power`
/// * `a_neck_has_its_four_springs_and_dashpots`
#[inline(always)]
pub fn neck<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
    k_n: R,
    k_t: R,
    k_r: R,
    k_o: R,
    eta_n: R,
    eta_t: R,
    eta_r: R,
    eta_o: R,
    xi_t: Vec3<R>,
    xi_r: Vec3<R>,
    xi_o: R,
    dt: R,
) -> Effect<R> {
    let at = ContactKinematics::of_spheres(&Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j));
    let springs = Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o };
    let memory = Memory { tangential: xi_t, rolling: xi_r, torsion: xi_o, rest: R::zero() };
    effect(springs.evaluate(&Friction::from_ratio([R::zero(); 3], R::zero()), !never::<R>(), &at, memory, dt))
}

/// **Section 2.1.3**, Eqs. 3 to 17 together, unnumbered: a frictional contact, from two particles and their springs to forces and springs.
///
/// ```math
/// (\mathbf{x}, \mathbf{v}, \boldsymbol{\omega}, r)_{i,j}, \; (k, \eta)_{\mathrm{n,t,r,o}}, \; \mu, \; \boldsymbol{\xi}_{\mathrm{t,r,o}}, \; \Delta t \mapsto
/// \mathbf{f}, \boldsymbol{\tau}_i, \boldsymbol{\tau}_j, \boldsymbol{\xi}_{\mathrm{t,r,o}}
/// ```
///
/// # Reading
///
/// "Only enabled when the normal force is repulsive": along the normal the contact pushes with $\max(0, -k_\mathrm{n}\delta - \eta_\mathrm{n}\dot\delta)$ and never pulls. The same force caps the
/// friction of all three springs, each with its own coefficient, of which the paper names one. As soon as the spheres do not overlap, nothing acts and the springs are reset.
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
/// | `k_n` | $k_\mathrm{n}$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_\mathrm{t}$ | N/m | >= 0 | tangential stiffness |
/// | `k_r` | $k_\mathrm{r}$ | N/m | >= 0 | rolling stiffness |
/// | `k_o` | $k_\mathrm{o}$ | N/m | >= 0 | torsional stiffness |
/// | `eta_n` | $\eta_\mathrm{n}$ | kg/s | >= 0 | normal damping |
/// | `eta_t` | $\eta_\mathrm{t}$ | kg/s | >= 0 | tangential damping |
/// | `eta_r` | $\eta_\mathrm{r}$ | kg/s | >= 0 | rolling damping |
/// | `eta_o` | $\eta_\mathrm{o}$ | kg/s | >= 0 | torsional damping |
/// | `mu_t` | $\mu_\mathrm{s}$ | 1 | >= 0 | static friction coefficient of sliding |
/// | `mu_r` | $\mu_\mathrm{s,r}$ | 1 | >= 0 | static friction coefficient of rolling |
/// | `mu_o` | $\mu_\mathrm{s,o}$ | 1 | >= 0 | static friction coefficient of torsion |
/// | `phi` | $\mu_\mathrm{d} / \mu_\mathrm{s}$ | 1 | [0, 1] | ratio of the dynamic to the static coefficients |
/// | `xi_t` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | any | tangential spring before |
/// | `xi_r` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | any | rolling spring before |
/// | `xi_o` | $\xi_\mathrm{o}$ | m | any | torsion spring before, along the normal |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `force` | $\mathbf{f}$ | N (3) | | force on i; the force on j is its negative |
/// | → `torque_i` | $\boldsymbol{\tau}_i$ | N m (3) | | torque on i about its centre |
/// | → `torque_j` | $\boldsymbol{\tau}_j$ | N m (3) | | torque on j about its centre |
/// | → `xi_t_next` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | | tangential spring now |
/// | → `xi_r_next` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | | rolling spring now |
/// | → `xi_o_next` | $\xi_\mathrm{o}$ | m | | torsion spring now |
///
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `without_overlap_a_contact_feels_and_remembers_nothing`
/// * `a_contact_never_pulls_and_rubs_no_more_than_its_normal_force_allows`
/// * `with_friction_without_limit_a_contact_is_a_neck`
/// * `turning_the_world_turns_the_forces`
/// * `seen_from_the_other_particle_the_pair_is_the_same`
/// * `dashpots_never_deliver_power`
/// * `a_contact_that_sticks_has_its_four_springs_and_dashpots`
/// * `spheres_that_just_touch_feel_and_remember_nothing`
#[inline(always)]
pub fn frictional_contact<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
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
) -> Effect<R> {
    let at = ContactKinematics::of_spheres(&Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j));
    let springs = Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o };
    let memory = Memory { tangential: xi_t, rolling: xi_r, torsion: xi_o, rest: R::zero() };
    effect(springs.evaluate(&Friction::from_ratio([mu_t, mu_r, mu_o], phi), never::<R>(), &at, memory, dt))
}

/// **Section 2.1.3**, Eqs. 3 to 17 together, unnumbered: a frictional contact as the published program reads its springs.
///
/// ```math
/// (\mathbf{x}, \mathbf{v}, \boldsymbol{\omega}, r)_{i,j}, \; (k, \eta)_{\mathrm{n,t,r,o}}, \; \mu, \; \boldsymbol{\xi}_{\mathrm{t,r,o}}, \; \Delta t \mapsto
/// \mathbf{f}, \boldsymbol{\tau}_i, \boldsymbol{\tau}_j, \boldsymbol{\xi}_{\mathrm{t,r,o}}
/// ```
///
/// # Reading
///
/// As [`frictional_contact`], but for two steps, in which the program differs: springs act before they are stretched, so that they lag by one step; and the torsion spring is turned into the contact plane, as the text says of
/// all three, where it acts like a rolling spring. Each of [`Along`](super::law::Along), [`Printed`](super::law::Printed) and [`Lagging`](super::law::Lagging) keeps one or both steps; what else the program does otherwise is listed at
/// [`Programmed`](super::law::Programmed).
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
/// | `k_n` | $k_\mathrm{n}$ | N/m | >= 0 | normal stiffness |
/// | `k_t` | $k_\mathrm{t}$ | N/m | >= 0 | tangential stiffness |
/// | `k_r` | $k_\mathrm{r}$ | N/m | >= 0 | rolling stiffness |
/// | `k_o` | $k_\mathrm{o}$ | N/m | >= 0 | torsional stiffness |
/// | `eta_n` | $\eta_\mathrm{n}$ | kg/s | >= 0 | normal damping |
/// | `eta_t` | $\eta_\mathrm{t}$ | kg/s | >= 0 | tangential damping |
/// | `eta_r` | $\eta_\mathrm{r}$ | kg/s | >= 0 | rolling damping |
/// | `eta_o` | $\eta_\mathrm{o}$ | kg/s | >= 0 | torsional damping |
/// | `mu_t` | $\mu_\mathrm{s}$ | 1 | >= 0 | static friction coefficient of sliding |
/// | `mu_r` | $\mu_\mathrm{s,r}$ | 1 | >= 0 | static friction coefficient of rolling |
/// | `mu_o` | $\mu_\mathrm{s,o}$ | 1 | >= 0 | static friction coefficient of torsion |
/// | `phi` | $\mu_\mathrm{d} / \mu_\mathrm{s}$ | 1 | [0, 1] | ratio of the dynamic to the static coefficients |
/// | `xi_t` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | any | tangential spring before |
/// | `xi_r` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | any | rolling spring before |
/// | `xi_o` | $\boldsymbol{\xi}_\mathrm{o}$ | m (3) | any | torsion spring before |
/// | `dt` | $\Delta t$ | s | >= 0 | time step |
/// | → `force` | $\mathbf{f}$ | N (3) | | force on i; the force on j is its negative |
/// | → `torque_i` | $\boldsymbol{\tau}_i$ | N m (3) | | torque on i about its centre |
/// | → `torque_j` | $\boldsymbol{\tau}_j$ | N m (3) | | torque on j about its centre |
/// | → `xi_t_next` | $\boldsymbol{\xi}_\mathrm{t}$ | m (3) | | tangential spring now |
/// | → `xi_r_next` | $\boldsymbol{\xi}_\mathrm{r}$ | m (3) | | rolling spring now |
/// | → `xi_o_next` | $\boldsymbol{\xi}_\mathrm{o}$ | m (3) | | torsion spring now |
///
/// Rounding: at most 5 ULP.
///
/// # Laws
///
/// * `published_springs_act_before_they_are_stretched`
/// * `a_published_contact_has_the_springs_of_the_step_before`
/// * `a_published_contact_that_slips_goes_on_with_the_friction_that_it_feels`
#[inline(always)]
pub fn published_contact<R: Real>(
    x_i: Vec3<R>,
    x_j: Vec3<R>,
    v_i: Vec3<R>,
    v_j: Vec3<R>,
    omega_i: Vec3<R>,
    omega_j: Vec3<R>,
    r_i: R,
    r_j: R,
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
    xi_o: Vec3<R>,
    dt: R,
) -> Effect<R, Vec3<R>> {
    let at = ContactKinematics::of_spheres(&Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j));
    let springs = Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o };
    let memory = Memory { tangential: xi_t, rolling: xi_r, torsion: xi_o, rest: R::zero() };
    let friction = Friction::from_ratio([mu_t, mu_r, mu_o], phi);
    effect(springs.grip_in(Order::ActFirst, &friction, never::<R>(), &at, memory, dt))
}

fn effect<R: Real, O>(evaluate: SpringsOutcome<R, O>) -> Effect<R, O> {
    let SpringsOutcome { wrench, memory, .. } = evaluate;
    (wrench.force, wrench.torque_i, wrench.torque_j, memory.tangential, memory.rolling, memory.torsion)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![
        equation!("soot/def_contact.rs", "soot-neck", [], neck),
        equation!("soot/def_contact.rs", "soot-contact", [], frictional_contact),
        equation!("soot/def_contact.rs", "soot-published-contact", [], published_contact),
    ]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::samples::{rotated, unit, vector};
    use proptest::prelude::*;

    const DT: f64 = 0.05;
    const SPRINGS: Springs<f64> =
        Springs { k_n: 2.0, k_t: 0.7, k_r: 0.4, k_o: 0.3, eta_n: 0.1, eta_t: 0.07, eta_r: 0.05, eta_o: 0.03 };
    const FRICTION: Friction<f64> =
        Friction { static_t: 0.5, static_r: 0.2, static_o: 0.1, dynamic_t: 0.4, dynamic_r: 0.15, dynamic_o: 0.1 };
    const BOTH: [bool; 2] = [true, false];

    /// Two spheres at random: the direction from j to i, the overlap, velocities and spins.
    fn pair() -> impl Strategy<Value = Contact<f64>> {
        (unit(), -0.3..0.1, vector(), vector(), vector())
            .prop_map(|(n, gap, v, omega_i, omega_j)| Contact::new(n * (1.75 + gap), v, omega_i, omega_j, 1.0, 0.75))
    }
    fn memory() -> impl Strategy<Value = Memory<f64>> {
        (vector(), vector(), -1.0..1.0).prop_map(|(tangential, rolling, torsion)| Memory {
            tangential,
            rolling,
            torsion,
            ..Memory::zero()
        })
    }
    fn act(c: &Contact<f64>, bonded: bool, memory: Memory<f64>) -> SpringsOutcome<f64> {
        SPRINGS.evaluate(&FRICTION, bonded, &ContactKinematics::of_spheres(c), memory, DT)
    }
    fn distance(a: &SpringsOutcome<f64>, b: &SpringsOutcome<f64>) -> f64 {
        let (v, w) = (a.wrench, b.wrench);
        let wrenches = (v.force - w.force).norm() + (v.torque_i - w.torque_i).norm() + (v.torque_j - w.torque_j).norm();
        let (m, k) = (a.memory, b.memory);
        wrenches + (m.tangential - k.tangential).norm() + (m.rolling - k.rolling).norm() + (m.torsion - k.torsion).abs()
    }
    /// Away from the limits of friction, where rounding decides.
    fn clear(c: &Contact<f64>, memory: Memory<f64>) -> bool {
        let nudged = Contact { gap: c.gap + 1e-9, ..*c };
        distance(&act(c, false, memory), &act(&nudged, false, memory)) < 1e-6
    }

    proptest! {
        #[test]
        fn a_neck_keeps_momentum_and_angular_momentum(c in pair(), memory in memory()) {
            for bonded in BOTH {
                let wrench = act(&c, bonded, memory).wrench;
                let couple = (c.n * c.distance).cross(wrench.force);
                prop_assert!((wrench.torque_i + wrench.torque_j + couple).norm() < 1e-13);
            }
        }

        #[test]
        fn a_rigid_motion_of_a_necked_pair_changes_no_force(n in unit(), gap in -0.3..0.3, omega in vector(), memory in memory()) {
            let (x, zero) = (n * (1.75 + gap), Vec3::zero());
            let still = act(&Contact::new(x, zero, zero, zero, 1.0, 0.75), true, memory);
            let turning = act(&Contact::new(x, omega.cross(x), omega, omega, 1.0, 0.75), true, memory);
            prop_assert!(distance(&still, &turning) < 1e-13);
        }

        #[test]
        fn turning_the_world_turns_the_forces(c in pair(), memory in memory(), axis in unit(), angle in -3.0..3.0) {
            prop_assume!(clear(&c, memory));
            let turn = |v| rotated(v, axis, angle);
            let there = Contact { n: turn(c.n), v: turn(c.v), omega_i: turn(c.omega_i), omega_j: turn(c.omega_j), ..c };
            let turned = Memory { tangential: turn(memory.tangential), rolling: turn(memory.rolling), torsion: memory.torsion, ..memory };
            for bonded in BOTH {
                let (mut here, after) = (act(&c, bonded, memory), act(&there, bonded, turned));
                for v in [&mut here.wrench.force, &mut here.wrench.torque_i, &mut here.wrench.torque_j, &mut here.memory.tangential, &mut here.memory.rolling] {
                    *v = turn(*v);
                }
                prop_assert!(distance(&here, &after) < 1e-11);
            }
        }

        #[test]
        fn seen_from_the_other_particle_the_pair_is_the_same(c in pair(), memory in memory()) {
            prop_assume!(clear(&c, memory));
            let there = Contact { n: -c.n, v: -c.v, omega_i: c.omega_j, omega_j: c.omega_i, r_i: c.r_j, r_j: c.r_i, ..c };
            for bonded in BOTH {
                let here = act(&c, bonded, memory);
                let mut seen = act(&there, bonded, Memory { tangential: -memory.tangential, ..memory });
                std::mem::swap(&mut seen.wrench.torque_i, &mut seen.wrench.torque_j);
                seen.wrench.force = -seen.wrench.force;
                seen.memory.tangential = -seen.memory.tangential;
                prop_assert!(distance(&here, &seen) < 1e-12);
            }
        }

        #[test]
        fn dashpots_never_deliver_power(c in pair()) {
            let dashpots = Springs { k_n: 0.0, k_t: 0.0, k_r: 0.0, k_o: 0.0, ..SPRINGS };
            for bonded in BOTH {
                let evaluate = dashpots.evaluate(&FRICTION, bonded, &ContactKinematics::of_spheres(&c), Memory::zero(), DT);
                let (power, l) = (evaluate.wrench.power(&c), evaluate.losses);
                prop_assert!(power <= 1e-15);
                prop_assert!(!bonded || (l.normal + l.tangential + l.rolling + l.torsion + power * DT).abs() < 1e-14);
            }
        }

        #[test]
        fn without_overlap_a_contact_feels_and_remembers_nothing(n in unit(), beyond in 1e-12..1e6, v in vector(), omega in vector(), memory in memory()) {
            let SpringsOutcome { wrench, memory: after, losses } = act(&Contact::new(n * (1.75 + beyond), v, omega, -omega, 1.0, 0.75), false, memory);
            for none in [wrench.force, wrench.torque_i, wrench.torque_j] {
                prop_assert_eq!(none.norm(), 0.0);
            }
            prop_assert_eq!(after, Memory::zero());
            let held: f64 = SPRINGS.stored(false, beyond, &memory).iter().sum();
            prop_assert!((losses.slip - held).abs() < 1e-14);
        }

        #[test]
        fn a_published_contact_that_slips_goes_on_with_the_friction_that_it_feels(c in pair(), memory in memory()) {
            prop_assume!(c.gap < -1e-3);
            let at = ContactKinematics::of_spheres(&c);
            let [tangential, rolling] = [memory.tangential, memory.rolling].map(|xi| xi.perpendicular_to(c.n));
            prop_assume!(tangential.norm() > 0.5);
            let before = Memory { tangential, rolling, torsion: Vec3::zero(), rest: 0.0 };
            let acted = SPRINGS.grip_in(Order::ActFirst, &FRICTION, false, &at, before, DT);
            let (felt, f_n) = (acted.wrench.force.perpendicular_to(c.n), acted.wrench.force.dot(c.n));
            prop_assume!(f_n > 1e-6 && (felt.norm() - FRICTION.dynamic_t * f_n).abs() < 1e-12);
            let kept = acted.memory.tangential * SPRINGS.k_t + at.v_t * SPRINGS.eta_t;
            prop_assert!((kept - felt).norm() < 1e-12, "{kept:?} {felt:?}");
        }

        #[test]
        fn spheres_that_just_touch_feel_and_remember_nothing(v in vector(), omega in vector(), memory in memory()) {
            let touch = Contact::new(Vec3::new(1.75, 0.0, 0.0), Vec3([-v.0[0].abs(), v.0[1], v.0[2]]), omega, -omega, 1.0, 0.75);
            prop_assert_eq!(touch.gap, 0.0);
            // dashpots without springs remember nothing either
            let dashpots = Springs { k_n: 0.0, k_t: 0.0, k_r: 0.0, k_o: 0.0, ..SPRINGS };
            for springs in [SPRINGS, dashpots] {
                let SpringsOutcome { wrench, memory, .. } = springs.evaluate(&FRICTION, false, &ContactKinematics::of_spheres(&touch), memory, DT);
                prop_assert_eq!([wrench.force, wrench.torque_i, wrench.torque_j].map(Vec3::norm), [0.0; 3]);
                prop_assert_eq!(memory, Memory::zero());
            }
        }

        #[test]
        fn a_contact_never_pulls_and_rubs_no_more_than_its_normal_force_allows(c in pair(), memory in memory()) {
            let evaluate = act(&c, false, memory);
            let f_n = evaluate.wrench.force.dot(c.n);
            prop_assert!(f_n >= -1e-15);
            prop_assert!(evaluate.wrench.force.perpendicular_to(c.n).norm() <= FRICTION.static_t * f_n + 1e-14);
            prop_assert!(evaluate.losses.normal >= -1e-15);
        }

        #[test]
        fn a_neck_has_its_four_springs_and_dashpots((at, drift, c, memory) in (vector(), vector(), pair(), memory())) {
            let Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o } = SPRINGS;
            let evaluate = |v, omega_i, memory: Memory<f64>, dt| neck(
                at + c.n * c.distance, at, v + drift, drift, omega_i, Vec3::zero(), c.r_i, c.r_j, k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o,
                memory.tangential, memory.rolling, memory.torsion, dt,
            );
            let (at, n, zero) = (ContactKinematics::of_spheres(&c), -c.n, Vec3::zero());
            let in_plane = |xi: Vec3<f64>| xi.perpendicular_to(n) * (xi.norm() / xi.perpendicular_to(n).norm());
            prop_assume!([memory.tangential, memory.rolling].iter().all(|xi| xi.perpendicular_to(n).norm() > 0.1));
            let (xi_t, xi_r) = (in_plane(memory.tangential), in_plane(memory.rolling));
            // at rest, springs alone: the normal one pushes along minus n where the spheres overlap
            let (force, torque_i, torque_j, tangential, rolling, torsion) = evaluate(zero, zero, memory, DT);
            prop_assert!((force - n * (k_n * c.gap) - xi_t * k_t).norm() < 1e-13);
            let turning = n.cross(xi_r) * (at.a * k_r) + n * (at.r * k_o * memory.torsion);
            prop_assert!((torque_i - n.cross(xi_t) * (at.a_i * k_t) - turning).norm() < 1e-13);
            prop_assert!((torque_j - n.cross(xi_t) * (at.a_j * k_t) + turning).norm() < 1e-13);
            prop_assert!((tangential - xi_t).norm() + (rolling - xi_r).norm() + (torsion - memory.torsion).abs() < 1e-13);
            // without springs to begin with, in motion: each is stretched by its rate and adds its dashpot
            let (force, torque_i, torque_j, tangential, rolling, torsion) = evaluate(c.v, c.omega_i, Memory::zero(), DT);
            let at = ContactKinematics::of_spheres(&Contact { omega_j: zero, ..c });
            prop_assert!((tangential - at.v_t * DT).norm() + (rolling - at.v_r * DT).norm() + (torsion - at.v_o * DT).abs() < 1e-13);
            let f_t = at.v_t * (k_t * DT + eta_t);
            prop_assert!((force - n * (k_n * c.gap + eta_n * at.v_n) - f_t).norm() < 1e-13);
            let turning = n.cross(at.v_r) * (at.a * (k_r * DT + eta_r)) + n * (at.r * at.v_o * (k_o * DT + eta_o));
            prop_assert!((torque_i - n.cross(f_t) * at.a_i - turning).norm() < 1e-13);
            prop_assert!((torque_j - n.cross(f_t) * at.a_j + turning).norm() < 1e-13);
        }

        #[test]
        fn a_contact_that_sticks_has_its_four_springs_and_dashpots((at, drift, c, memory) in (vector(), vector(), pair(), memory())) {
            let Springs { k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o } = SPRINGS;
            let (x, v, Memory { tangential, rolling, torsion, .. }) = (at + c.n * c.distance, drift + c.v, memory);
            let neck = neck(x, at, v, drift, c.omega_i, c.omega_j, c.r_i, c.r_j, k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o, tangential, rolling, torsion, DT);
            let contact = |mu: f64| frictional_contact(
                x, at, v, drift, c.omega_i, c.omega_j, c.r_i, c.r_j, k_n, k_t, k_r, k_o, eta_n, eta_t, eta_r, eta_o, mu, mu, mu, 1.0, tangential, rolling, torsion, DT,
            );
            prop_assume!(c.gap < 0.0 && neck.0.dot(c.n) > 1e-6);
            let rough = contact(1e9);
            for (a, b) in [(rough.0, neck.0), (rough.1, neck.1), (rough.2, neck.2), (rough.3, neck.3), (rough.4, neck.4)] {
                prop_assert!((a - b).norm() < 1e-13);
            }
            prop_assert!((rough.5 - neck.5).abs() < 1e-13);
            // without friction only the normal force is left
            let smooth = contact(0.0);
            prop_assert!((smooth.0 - c.n * neck.0.dot(c.n)).norm() + smooth.1.norm() + smooth.2.norm() < 1e-13);
        }

        #[test]
        fn a_published_contact_has_the_springs_of_the_step_before((place, drift, c, memory) in (vector(), vector(), pair(), memory())) {
            let Springs { k_n, k_t, k_r, k_o, .. } = SPRINGS;
            let (x, zero, n) = (place + c.n * c.distance, Vec3::zero(), -c.n);
            let [xi_t, xi_r] = [memory.tangential, memory.rolling].map(|xi| xi.perpendicular_to(n));
            prop_assume!(c.gap < -1e-3);
            let at = ContactKinematics::of_spheres(&c);
            let (force, torque_i, torque_j, tangential, rolling, torsion) = published_contact(
                x, place, c.v + drift, drift, c.omega_i, c.omega_j, c.r_i, c.r_j, k_n, k_t, k_r, k_o, 0.0, 0.0, 0.0, 0.0, 1e9, 1e9, 1e9, 1.0, xi_t, xi_r, zero, DT,
            );
            prop_assert!((force - n * (k_n * c.gap) - xi_t * k_t).norm() < 1e-12);
            let turning = n.cross(xi_r) * (at.a * k_r);
            prop_assert!((torque_i - n.cross(xi_t) * (at.a_i * k_t) - turning).norm() < 1e-12);
            prop_assert!((torque_j - n.cross(xi_t) * (at.a_j * k_t) + turning).norm() < 1e-12);
            prop_assert!((tangential - xi_t - at.v_t * DT).norm() + (rolling - xi_r - at.v_r * DT).norm() < 1e-12);
            prop_assert!((torsion - n * (at.v_o * DT)).norm() < 1e-12);
        }

        #[test]
        fn published_springs_act_before_they_are_stretched(c in pair(), memory in memory()) {
            prop_assume!(c.gap < -1e-3);
            let at = ContactKinematics::of_spheres(&c);
            let rough = Friction::from_ratio([1e9; 3], 1.0);
            let undamped = Springs { eta_n: 0.0, eta_t: 0.0, eta_r: 0.0, eta_o: 0.0, ..SPRINGS };
            let Memory { tangential, rolling, .. } = memory;
            let [tangential, rolling] = [tangential, rolling].map(|xi| xi.perpendicular_to(c.n));
            let before = Memory { tangential, rolling, torsion: Vec3::zero(), rest: 0.0 };
            let acted = undamped.grip_in(Order::ActFirst, &rough, false, &at, before, DT);
            // The force is that of the springs before, without the elongation of this step.
            prop_assert!((acted.wrench.force.perpendicular_to(c.n) - tangential * undamped.k_t).norm() < 1e-12);
            prop_assert!((acted.memory.tangential - tangential - at.v_t * DT).norm() < 1e-12);
            // The torsion spring is a vector: a step of twisting is along the normal.
            prop_assert!((acted.memory.torsion - c.n * acted.memory.torsion.dot(c.n)).norm() < 1e-12);
            // One that is not along the normal is turned into the plane, with its length.
            let oblique = Vec3([0.3, 0.5, 0.7]);
            prop_assume!(oblique.perpendicular_to(c.n).norm() > 1e-2);
            let before = Memory { torsion: oblique, ..before };
            let turned = undamped.grip_in(Order::ActFirst, &rough, false, &at, before, 0.0).memory.torsion;
            prop_assert!(turned.dot(c.n).abs() < 1e-12 && (turned.norm() - oblique.norm()).abs() < 1e-12);
        }

        #[test]
        fn with_friction_without_limit_a_contact_is_a_neck(c in pair(), memory in memory()) {
            let at = ContactKinematics::of_spheres(&c);
            let f_n = -(SPRINGS.k_n * c.gap + SPRINGS.eta_n * at.v_n);
            prop_assume!(c.gap < 0.0 && f_n > 1e-6);
            let rough = SPRINGS.evaluate(&Friction::from_ratio([1e9; 3], 1.0), false, &at, memory, DT);
            prop_assert!(distance(&rough, &act(&c, true, memory)) < 1e-13);
        }
    }
}
