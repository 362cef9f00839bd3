//! The authors' published program: where it reads the contact law otherwise than we do.

use super::def_contact::{Losses, Parameters};
use super::def_parameters::force_parameters;
use super::eq04_tangential_force::kept_fraction;
use super::eq05_rescaled_maximum::rescaled_maximum;
use super::law::{Stored, Wear};
use crate::equation::Equation;
use crate::mechanics::projected_spring::stretched_spring;
use crate::{Contact, Outcome, PairModel, Real, Vec3, equation};

/// The contact law of a material as the authors' published program reads it. The material says whether springs are forgotten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Published(pub Wear);

impl From<Wear> for Published {
    fn from(law: Wear) -> Self {
        Self(law)
    }
}

impl PairModel for Published {
    type Coefficients<R: Real> = Parameters<R>;
    type Memory<R: Real> = Vec3<R>;
    type Losses<R: Real> = Losses<R>;
    type Stored<R: Real> = Stored<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Parameters<R> {
        self.0.coefficients(r_i, r_j, m_i, m_j)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.0.range(r_i, r_j)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Parameters<R>,
        spring: Vec3<R>,
        dt: R,
    ) -> Outcome<R, Vec3<R>, Losses<R>> {
        k.act_as_published(c, spring, dt)
    }

    fn relisted<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: Vec3<R>) -> (Vec3<R>, Losses<R>) {
        self.0.relisted(c, k, spring)
    }

    #[inline(always)]
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Parameters<R>, spring: &Vec3<R>) -> Stored<R> {
        self.0.stored(c, k, spring)
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        self.0.critical_time_step(r, m)
    }
}

impl<R: Real> Parameters<R> {
    /// The contact as [`published_contact`] reads it, its spring advanced by `dt`, and the energy lost.
    #[inline(always)]
    pub fn act_as_published(&self, c: &Contact<R>, spring: Vec3<R>, dt: R) -> Outcome<R, Vec3<R>, Losses<R>> {
        let in_range = c.gap.le(self.delta_f);
        let arms = [c.r_i, c.r_j];
        let v_t = Vec3::select(in_range, c.sliding_velocity(c.r_i, c.r_j), Vec3::zero());

        // The dashpot under the cap counts as an elongation of the spring.
        let stretched = stretched_spring(spring, c.n, v_t, dt);
        let lag = R::select(self.k_t.gt(R::zero()), self.c_t / self.k_t, R::zero());
        let elongation = stretched + v_t * lag;
        let kept = kept_fraction(self.k_t, elongation.norm(), rescaled_maximum(c.gap, self.delta_f, self.f_mt));
        let slipped = Vec3::select(in_range, stretched * kept - v_t * (lag * (R::one() - kept)), Vec3::zero());

        let f_t = Vec3::select(in_range, elongation * -(self.k_t * kept), Vec3::zero());
        self.outcome(c, arms, f_t, v_t, [stretched, slipped], dt)
    }
}

/// **Section 2** as the authors' published program computes it: the contact law as a whole.
///
/// ```math
/// \mathbf{F}_T = -\min\left(1, \frac{F'_{m,T}}{|k_T \boldsymbol{\xi} + c_T \mathbf{v}_T|}\right) (k_T \boldsymbol{\xi} + c_T \mathbf{v}_T), \quad
/// a = r
/// ```
///
/// # Reading
///
/// The program is a pair style of LAMMPS. It differs from [`contact`](super::def_contact::contact) twice. The cap of Eq. 5 limits the
/// force of spring and dashpot together, where Eq. 2 adds the dashpot to the limited force of the spring; a pair that slips keeps the
/// spring with which both have the limited force. And the arms, of the torques as of the sliding velocity, are the radii, so that a
/// tangential force creates angular momentum. At every rebuild of its neighbour list it also forgets the springs of pairs that do not
/// touch.
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
/// Rounding: at most 4 ULP.
///
/// # Laws
///
/// * `without_dashpots_a_touching_pair_that_does_not_spin_feels_the_same_force`
/// * `the_whole_tangential_force_never_exceeds_the_cap_which_ours_does`
/// * `a_pair_that_sticks_has_the_spring_of_the_paper`
/// * `a_tangential_force_creates_angular_momentum_at_the_rate_of_the_gap`
/// * `what_spring_and_dashpot_lose_is_the_work_of_the_force`
/// * `spheres_that_stick_without_spin_act_as_in_the_paper_but_for_the_arms`
/// * `at_its_range_a_pair_is_damped_and_without_a_stiffness_nothing_lags`
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
    let contact = Contact::new(x_i - x_j, v_i - v_j, omega_i, omega_j, r_i, r_j);
    let Outcome { wrench, memory, .. } = parameters.act_as_published(&contact, xi, dt);
    (wrench.force, wrench.torque_i, wrench.torque_j, memory)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("wear/def_published.rs", "wear-published-contact", [], published_contact)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Wrench;
    use crate::mechanics::projected_spring::spring_energy;
    use crate::wear::def_contact::contact;
    use crate::wear::def_kinematics::moment_arm;
    use proptest::prelude::*;

    const DT: f64 = 0.05;
    const PAIR: Parameters<f64> =
        Parameters { k_n: 2.0, k_t: 0.7, delta_e: 0.2, delta_f: 0.5, f_mt: 0.3, c_n: 0.1, c_t: 0.4 };

    fn vector() -> impl Strategy<Value = Vec3<f64>> {
        prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
    }

    fn unit() -> impl Strategy<Value = Vec3<f64>> {
        vector().prop_filter("long enough", |v| v.norm() > 0.1).prop_map(|v| v * (1.0 / v.norm()))
    }

    fn at(n: Vec3<f64>, gap: f64, v: Vec3<f64>, omega_i: Vec3<f64>, omega_j: Vec3<f64>) -> Contact<f64> {
        Contact::new(n * (1.75 + gap), v, omega_i, omega_j, 1.0, 0.75)
    }

    proptest! {
        #[test]
        fn without_dashpots_a_touching_pair_that_does_not_spin_feels_the_same_force(
            n in unit(), gap in -0.3..0.7, v in vector(), xi in vector(),
        ) {
            let undamped = Parameters { c_n: 0.0, c_t: 0.0, ..PAIR };
            let c = at(n, gap, v, Vec3::zero(), Vec3::zero());
            let (own, published) = (undamped.act(&c, xi, DT), undamped.act_as_published(&c, xi, DT));
            prop_assert!((own.wrench.force - published.wrench.force).norm() < 1e-14);
            prop_assert!((own.memory - published.memory).norm() < 1e-14);
        }

        #[test]
        fn the_whole_tangential_force_never_exceeds_the_cap_which_ours_does(
            n in unit(), gap in -0.3..0.4, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
        ) {
            let c = at(n, gap, v, omega_i, omega_j);
            let cap = rescaled_maximum(gap, PAIR.delta_f, PAIR.f_mt);
            let in_plane = |outcome: Outcome<f64, _, _>| outcome.wrench.force.perpendicular_to(n).norm();
            prop_assert!(in_plane(PAIR.act_as_published(&c, xi, DT)) <= cap * (1.0 + 1e-13) + 1e-14);
            let v_t = c.sliding_velocity(moment_arm(c.r_i, c.gap), moment_arm(c.r_j, c.gap));
            prop_assume!(v_t.norm() > 0.1);
            prop_assert!(in_plane(PAIR.act(&c, v_t * (10.0 / v_t.norm()), DT)) > cap + 0.9 * PAIR.c_t * v_t.norm());
        }

        #[test]
        fn a_pair_that_sticks_has_the_spring_of_the_paper(n in unit(), gap in -0.3..0.0, v in vector(), xi in vector()) {
            let strong = Parameters { f_mt: 10.0, ..PAIR };
            let c = at(n, gap, v, Vec3::zero(), Vec3::zero());
            let (own, published) = (strong.act(&c, xi, DT), strong.act_as_published(&c, xi, DT));
            prop_assert_eq!(own.memory, published.memory);
            prop_assert!((own.wrench.force - published.wrench.force).norm() < 1e-15);
        }

        #[test]
        fn a_tangential_force_creates_angular_momentum_at_the_rate_of_the_gap(
            n in unit(), gap in -0.3..0.4, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
        ) {
            let c = at(n, gap, v, omega_i, omega_j);
            let Wrench { force, torque_i, torque_j } = PAIR.act_as_published(&c, xi, DT).wrench;
            let created = torque_i + torque_j + (c.n * c.distance).cross(force);
            prop_assert!((created - c.n.cross(force) * gap).norm() < 1e-14);
        }

        #[test]
        fn spheres_that_stick_without_spin_act_as_in_the_paper_but_for_the_arms(
            at in vector(), drift in vector(), n in unit(), gap in -0.3..-0.01, v in vector(), slid in vector(),
        ) {
            let (r_i, r_j, zero) = (1.0, 0.75, Vec3::zero());
            macro_rules! act {
                ($law:ident) => {
                    $law(
                        at + n * (r_i + r_j + gap), at, v + drift, drift, zero, zero, r_i, r_j, 4.0, 2.0, 1.0, 0.2, 0.2, 10.0, 1.5, 0.8, 0.5, slid * 1e-3, DT,
                    )
                };
            }
            let (own, published) = (act!(contact), act!(published_contact));
            prop_assert!((own.0 - published.0).norm() < 1e-13 && (own.3 - published.3).norm() < 1e-15);
            prop_assert!((published.1 + n.cross(own.0) * r_i).norm() < 1e-13);
            prop_assert!((published.2 + n.cross(own.0) * r_j).norm() < 1e-13);
        }

        #[test]
        fn what_spring_and_dashpot_lose_is_the_work_of_the_force(
            n in unit(), gap in -0.3..0.4, v in vector(), omega_i in vector(), omega_j in vector(), xi in vector(),
        ) {
            // The spring is advanced before it acts: the stored energy differs from the work of its force by half a step's elongation.
            let c = at(n, gap, v, omega_i, omega_j);
            let xi = xi.perpendicular_to(n) * 0.3;
            let force_along = Parameters { k_n: 0.0, c_n: 0.0, ..PAIR };
            let outcome = force_along.act_as_published(&c, xi, DT);
            let work = outcome.wrench.power(&c) * DT;
            let stored = spring_energy(PAIR.k_t, outcome.memory) - spring_energy(PAIR.k_t, xi);
            let lost = outcome.losses.tangential_damping + outcome.losses.slip;
            let slid = c.sliding_velocity(c.r_i, c.r_j) * DT;
            let coarse = PAIR.k_t * (slid.dot(slid) + (xi + slid - outcome.memory).norm() * slid.norm());
            prop_assert!((work + stored + lost).abs() <= coarse + 1e-14);
        }
    }

    #[test]
    fn at_its_range_a_pair_is_damped_and_without_a_stiffness_nothing_lags() {
        let (n, v, none) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.5, 0.25, 0.0), Vec3::zero());
        let edge = at(n, PAIR.delta_f, v, none, none);
        let Outcome { wrench, memory, losses } = PAIR.act_as_published(&edge, none, DT);
        assert!((wrench.force + n * (PAIR.c_n * 0.5)).norm() < 1e-15 && losses.tangential_damping > 0.0);
        // the spring takes back what the dashpot was allowed to exceed the cap by
        assert!((memory + Vec3::new(0.0, 0.25, 0.0) * (PAIR.c_t / PAIR.k_t)).norm() < 1e-15);
        let beyond = PAIR.act_as_published(&at(n, 0.75, v, none, none), v, DT);
        assert_eq!((beyond.wrench.force, beyond.memory, beyond.losses.tangential_damping), (none, none, 0.0));
        let loose = Parameters { k_t: 0.0, ..PAIR };
        let (xi, c) = (Vec3::new(0.0, 0.0, 0.1), at(n, -0.1, v, none, none));
        let outcome = loose.act_as_published(&c, xi, DT);
        assert!((outcome.memory - xi - Vec3::new(0.0, 0.25 * DT, 0.0)).norm() < 1e-15);
        assert_eq!(outcome.wrench.force.perpendicular_to(n), none);
        // beyond its range such a pair remembers nothing either
        let beyond = at(n, 0.75, v, none, none);
        assert_eq!(
            [loose.act_as_published(&beyond, xi, DT), loose.act(&beyond, xi, DT)].map(|outcome| outcome.memory),
            [none; 2]
        );
    }
}
