//! The four springs of a neck or of a frictional contact of two spheres.
//!
//! Equations and sections are numbered as in Demidov, Gor & Khalizov 2024.

use super::contact_kinematics::ContactKinematics;
use super::friction::{dynamic_friction, rubbed, static_friction};
use super::neck_rest::{contact_rest, elongation};
use super::rotated_spring::{Span, Twist, rotated_spring, stretched};
use super::spring_force::{energy, force, turning_torque};
use crate::{Flat, Named, Outcome, Real, Vec3, Wrench, flat_struct};

flat_struct! {
    /// Stiffnesses and damping coefficients of the four springs of a contact.
    pub struct Springs {
        /// Normal stiffness, N/m.
        pub k_n,
        /// Tangential stiffness, N/m.
        pub k_t,
        /// Rolling stiffness, N/m.
        pub k_r,
        /// Torsional stiffness, N/m.
        pub k_o,
        /// Normal damping coefficient, kg/s.
        pub eta_n,
        /// Tangential damping coefficient, kg/s.
        pub eta_t,
        /// Rolling damping coefficient, kg/s.
        pub eta_r,
        /// Torsional damping coefficient, kg/s.
        pub eta_o,
    }
}

flat_struct! {
    /// Friction coefficients of a contact: static in sliding, rolling and torsion, then dynamic.
    pub struct Friction {
        /// Static, of sliding.
        pub static_t,
        /// Static, of rolling.
        pub static_r,
        /// Static, of torsion.
        pub static_o,
        /// Dynamic, of sliding.
        pub dynamic_t,
        /// Dynamic, of rolling.
        pub dynamic_r,
        /// Dynamic, of torsion.
        pub dynamic_o,
    }
}

impl<R: Real> Friction<R> {
    /// From the static coefficients of sliding, rolling and torsion, and the one ratio of the dynamic to the static ones.
    #[inline(always)]
    pub fn from_ratio(mu: [R; 3], phi: R) -> Self {
        let [static_t, static_r, static_o] = mu;
        let [dynamic_t, dynamic_r, dynamic_o] = mu.map(|mu| phi * mu);
        Self { static_t, static_r, static_o, dynamic_t, dynamic_r, dynamic_o }
    }
}

flat_struct! {
    /// Energy dissipated by a pair in one time step, J, by cause.
    pub struct Losses {
        /// Dashpot along the normal.
        pub normal,
        /// Tangential dashpot.
        pub tangential,
        /// Rolling dashpot.
        pub rolling,
        /// Torsion dashpot.
        pub torsion,
        /// Springs that slipped or were released. In a single step it may be negative: when Eq. 17 sets a spring against its dashpot.
        pub slip,
    }
}

/// Order of force and elongation of a spring within a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// It is stretched, then it acts: steps 3 and 4 of Section 2.1.1.
    StretchFirst,
    /// It acts, then it is stretched, as in the published program: it lags one step behind the positions, and acts like a dashpot of
    /// $\eta - k \Delta t$, which may be negative.
    ActFirst,
}

/// The springs of a contact that are stored as its history, m; `O` is the torsion spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory<R, O = R> {
    /// Tangential spring: reversed, seen from the other sphere.
    pub tangential: Vec3<R>,
    /// Rolling spring: the same, seen from the other sphere.
    pub rolling: Vec3<R>,
    /// Torsion spring: along the normal the same, seen from the other sphere.
    pub torsion: O,
    /// Gap at which the normal spring is at rest: zero unless a neck was made at another one.
    pub rest: R,
}

impl<R: Real, O: Twist<R>> Memory<R, O> {
    /// The springs of a contact that has just been made.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { tangential: Vec3::zero(), rolling: Vec3::zero(), torsion: O::none(), rest: R::zero() }
    }

    /// The same with the springs in the contact plane turned; torsion lies along the normal.
    #[inline(always)]
    pub fn turned(self, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Self {
        Self { tangential: turn(self.tangential), rolling: turn(self.rolling), ..self }
    }

    /// The gap at rest of the normal spring: of a neck where `bonded` is true, elsewhere of a contact.
    #[inline(always)]
    fn rest_of(&self, bonded: R::Mask, delta: R) -> R {
        R::select(bonded, self.rest, contact_rest(delta, self.rest))
    }

    /// The elongation of the normal spring at the gap `delta`.
    #[inline(always)]
    pub fn elongation(&self, bonded: R::Mask, delta: R) -> R {
        elongation(delta, self.rest_of(bonded, delta))
    }
}

impl<R: Copy + Send + Sync, O: Flat<R>> Flat<R> for Memory<R, O> {
    const LEN: usize = 7 + O::LEN;
    #[inline(always)]
    fn from_fn(mut f: impl FnMut(usize) -> R) -> Self {
        Self {
            tangential: Vec3([f(0), f(1), f(2)]),
            rolling: Vec3([f(3), f(4), f(5)]),
            torsion: O::from_fn(|k| f(6 + k)),
            rest: f(6 + O::LEN),
        }
    }
    #[inline(always)]
    fn at(&self, k: usize) -> &R {
        match k {
            0..3 => &self.tangential.0[k],
            3..6 => &self.rolling.0[k - 3],
            _ if k < 6 + O::LEN => self.torsion.at(k - 6),
            _ => &self.rest,
        }
    }
    #[inline(always)]
    fn at_mut(&mut self, k: usize) -> &mut R {
        match k {
            0..3 => &mut self.tangential.0[k],
            3..6 => &mut self.rolling.0[k - 3],
            _ if k < 6 + O::LEN => self.torsion.at_mut(k - 6),
            _ => &mut self.rest,
        }
    }
}

impl<R: Copy + Send + Sync, O: Named<R>> Named<R> for Memory<R, O> {
    fn names() -> Vec<String> {
        let vector = |spring: &'static str| {
            <Vec3<R> as Named<R>>::names().into_iter().map(move |axis| format!("{spring} {axis}"))
        };
        let torsion = O::names().into_iter().map(|axis| format!("torsion {axis}").trim_end().to_string());
        vector("tangential").chain(vector("rolling")).chain(torsion).chain(["rest".into()]).collect()
    }
}

/// A contact after one evaluation.
pub type SpringsOutcome<R, O = R> = Outcome<R, Memory<R, O>, Losses<R>>;

/// One spring after a step: its force, its next elongation, and the energies dissipated by dashpot and slip.
struct Pull<R, S> {
    force: S,
    xi: S,
    dashpot: R,
    slip: R,
}

impl<R: Real> Springs<R> {
    /// The springs of a contact, advanced by `dt`, and their forces. Where `bonded` is true they are the springs of a neck, which acts at any gap and in any direction; elsewhere they are those of
    /// a contact, which only acts while the spheres overlap, never pulls along the normal, and has the friction of Eqs. 13 to 17.
    #[inline(always)]
    pub fn evaluate(
        &self,
        friction: &Friction<R>,
        bonded: R::Mask,
        at: &ContactKinematics<R>,
        memory: Memory<R>,
        dt: R,
    ) -> SpringsOutcome<R> {
        self.grip_in(Order::StretchFirst, friction, bonded, at, memory, dt)
    }

    /// The same with any torsion springs, in any order.
    #[inline(always)]
    pub fn grip_in<O: Twist<R>>(
        &self,
        order: Order,
        friction: &Friction<R>,
        bonded: R::Mask,
        at: &ContactKinematics<R>,
        memory: Memory<R, O>,
        dt: R,
    ) -> SpringsOutcome<R, O> {
        let zero = R::zero();
        let rest = memory.rest_of(bonded, at.delta);
        let xi_n = elongation(at.delta, rest);
        let acts = bonded | xi_n.lt(zero);
        let rate = |v: Vec3<R>| Vec3::select(acts, v, Vec3::zero());
        let (xi_n, v_n, v_o) =
            (R::select(acts, xi_n, zero), R::select(acts, at.v_n, zero), R::select(acts, at.v_o, zero));

        let elastic = self.k_n * xi_n;
        let drawn = force(self.k_n, xi_n, self.eta_n, v_n);
        let attraction = R::select(bonded, drawn, drawn.min(zero));
        let f_n = (-attraction).max(zero);

        let t = Self::pull(
            self.k_t,
            self.eta_t,
            rotated_spring(memory.tangential, at.n),
            rate(at.v_t),
            dt,
            acts,
            bonded,
            order,
            friction.static_t,
            friction.dynamic_t,
            f_n,
        );
        let r = Self::pull(
            self.k_r,
            self.eta_r,
            rotated_spring(memory.rolling, at.n),
            rate(at.v_r),
            dt,
            acts,
            bonded,
            order,
            friction.static_r,
            friction.dynamic_r,
            f_n,
        );
        let o = Self::pull(
            self.k_o,
            self.eta_o,
            memory.torsion.rotated(at.n),
            O::of(v_o, at.n),
            dt,
            acts,
            bonded,
            order,
            friction.static_o,
            friction.dynamic_o,
            f_n,
        );

        let sliding = at.n.cross(t.force);
        let turning = turning_torque(at.n, at.a, r.force, at.r, o.force);
        Outcome {
            wrench: Wrench {
                force: at.n * attraction + t.force,
                torque_i: sliding * at.a_i + turning,
                torque_j: sliding * at.a_j - turning,
            },
            memory: Memory { tangential: t.xi, rolling: r.xi, torsion: o.xi, rest },
            losses: Losses {
                normal: (attraction - elastic) * v_n * dt,
                tangential: t.dashpot,
                rolling: r.dashpot,
                torsion: o.dashpot,
                slip: t.slip + r.slip + o.slip,
            },
        }
    }

    #[inline(always)]
    fn pull<S: Span<R>>(
        k: R,
        eta: R,
        before: S,
        xi_dot: S,
        dt: R,
        acts: R::Mask,
        bonded: R::Mask,
        order: Order,
        mu_s: R,
        mu_d: R,
        f_n: R,
    ) -> Pull<R, S> {
        let xi = stretched(before, xi_dot, dt);
        let lagged = order == Order::ActFirst;
        let acting = if lagged { before } else { xi };
        let holds = bonded | force(k, acting, eta, xi_dot).size().le(static_friction(mu_s, f_n));
        let (force, next) = rubbed(k, eta, acting, xi_dot, holds, dynamic_friction(mu_d, f_n));
        let next = if lagged { S::select(holds, xi, next) } else { next };
        let next = S::select(acts, next, S::none());
        // A lagging spring acts like one that does not lag, with a weaker dashpot.
        let eta = if lagged { eta - k * dt } else { eta };
        let dashpot = eta * xi_dot.square() * dt;
        // Work of friction minus dashpot dissipation and change of the spring's energy; the spring never held the energy of a whole step's stretch.
        let slip = force.inner(xi_dot) * dt - dashpot + energy(k, before) - energy(k, next);
        Pull { force, xi: next, dashpot, slip: R::select(holds & acts, R::zero(), slip) }
    }

    /// Energies stored in the four springs, J: normal, tangential, rolling, torsion.
    #[inline(always)]
    pub fn stored<O: Twist<R>>(&self, bonded: R::Mask, delta: R, memory: &Memory<R, O>) -> [R; 4] {
        let xi_n = memory.elongation(bonded, delta);
        let pressed = R::select(bonded, xi_n, xi_n.min(R::zero()));
        [
            energy(self.k_n, pressed),
            energy(self.k_t, memory.tangential),
            energy(self.k_r, memory.rolling),
            energy(self.k_o, memory.torsion),
        ]
    }
}

/// The mask that is true nowhere: no neck.
#[inline(always)]
pub(crate) fn never<R: Real>() -> R::Mask {
    R::one().lt(R::zero())
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::model::laws::lies_in_order;

    #[test]
    fn the_springs_of_a_contact_lie_end_to_end_in_the_order_of_their_names() {
        lies_in_order::<Memory<f64>>(8);
        lies_in_order::<Memory<f64, Vec3<f64>>>(10);
        let memory =
            Memory { tangential: Vec3([0.0, 1.0, 2.0]), rolling: Vec3([3.0, 4.0, 5.0]), torsion: 6.0, rest: 7.0 };
        assert_eq!(memory, Flat::from_fn(|k| k as f64));
        let names = Memory::<f64>::names();
        assert_eq!([&names[1], &names[5], &names[6], &names[7]], ["tangential y", "rolling z", "torsion", "rest"]);
        assert_eq!(Memory::<f64, Vec3<f64>>::names()[6..], ["torsion x", "torsion y", "torsion z", "rest"]);
        lies_in_order::<Springs<f64>>(8);
        lies_in_order::<Friction<f64>>(6);
        lies_in_order::<Losses<f64>>(5);
    }
}
