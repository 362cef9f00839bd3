//! Necks in any model: spheres joined by necks, with a contact law for all other pairs.
//!
//! **Reference.** Suggested by Laube et al. 2018, Sections 4.2 and 4.5: rigid aggregates should bend and break. The neck is that of
//! Demidov, Gor & Khalizov 2024, Section 2.1.1. Nothing here is an equation of its own.
//!
//! **Reading.** A pair that a neck joins is held by the four springs of the neck and by nothing else: the material between the two
//! particles leaves no room for a water layer. A pair without a neck, or whose neck has broken, obeys the contact law, with initially
//! relaxed springs. A neck joins the bare particles, which touch at equilibrium: their spheres are smaller than the spheres of the
//! contact law by the equilibrium overlap.

use super::carried::Turns;
use super::contact_kinematics::ContactKinematics;
use super::four_springs::{Friction, Memory, Springs};
use crate::{Contact, Flat, Outcome, PairModel, Real, Vec3, Wrench, flat_struct};

/// Number of steps between checks of the strength of necks: a small fraction of the period of their springs at any published time step.
pub const EXAMINED: u64 = 5;

flat_struct! {
    /// Energies of a neck, J, by spring: stored in the spring, or dissipated by its dashpot.
    pub struct OfNeck {
        /// Along the normal.
        pub neck_normal,
        /// Across it.
        pub neck_tangential,
        /// Of rolling.
        pub neck_rolling,
        /// Of torsion.
        pub neck_torsion,
    }
}

flat_struct! {
    /// One for a pair that a neck joins, zero for one that obeys the contact law.
    pub struct Joined {
        /// One or zero.
        pub joined,
    }
}

/// A contact law, and necks.
#[derive(Clone, Debug)]
pub struct Necked<M> {
    /// The law of spheres that no neck joins.
    pub law: M,
    /// The springs of a neck.
    pub neck: Springs<f64>,
    /// Thickness by which the sphere of the contact law exceeds the particle, m.
    pub layer: f64,
}

impl<M> Necked<M> {
    /// The contact kinematics of two particles inside the spheres of the contact law.
    #[inline(always)]
    fn under<R: Real>(&self, c: &Contact<R>) -> Contact<R> {
        let layer = R::lit(self.layer);
        Contact { r_i: c.r_i - layer, r_j: c.r_j - layer, gap: c.gap + (layer + layer), ..*c }
    }

    #[inline(always)]
    fn springs<R: Real>(&self) -> Springs<R> {
        Springs::from_fn(|k| R::lit(*self.neck.at(k)))
    }
}

/// `yes` where the mask is true, zero elsewhere.
#[inline(always)]
fn only<R: Real, A: Flat<R>>(mask: R::Mask, yes: &A) -> A {
    A::from_fn(|k| R::select(mask, *yes.at(k), R::zero()))
}

impl<M: PairModel> Necked<M> {
    /// Whether a neck that holds these energies breaks at this one, J.
    pub fn neck_breaks((_, held): &<Self as PairModel>::Stored<f64>, energy: f64) -> bool {
        (0..OfNeck::<f64>::LEN).map(|spring| *held.at(spring)).sum::<f64>() > energy
    }
}

impl<M: PairModel> PairModel for Necked<M> {
    type Coefficients<R: Real> = (M::Coefficients<R>, Joined<R>);
    type Memory<R: Real> = (M::Memory<R>, Memory<R>);
    type Losses<R: Real> = (M::Losses<R>, OfNeck<R>);
    type Stored<R: Real> = (M::Stored<R>, OfNeck<R>);

    /// A pair without a neck.
    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Self::Coefficients<R> {
        (self.law.coefficients(r_i, r_j, m_i, m_j), Joined { joined: R::zero() })
    }

    fn joined<R: Real>(&self, (constants, _): Self::Coefficients<R>) -> Self::Coefficients<R> {
        (constants, Joined { joined: R::one() })
    }

    const FRICTION_STOPS: bool = M::FRICTION_STOPS;

    fn turning<R: Real>(&self, (constants, joined): Self::Coefficients<R>, inertia: R) -> Self::Coefficients<R> {
        (self.law.turning(constants, inertia), joined)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.law.range(r_i, r_j)
    }

    /// Both are evaluated, and one of them acts.
    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        (constants, joined): &Self::Coefficients<R>,
        (memory, springs): Self::Memory<R>,
        dt: R,
    ) -> Outcome<R, Self::Memory<R>, Self::Losses<R>> {
        let joined = joined.joined.gt(R::lit(0.5));
        let free = self.law.pair(c, constants, memory, dt);
        let smooth = Friction::from_fn(|_| R::zero());
        let neck =
            self.springs().evaluate(&smooth, joined, &ContactKinematics::of_spheres(&self.under(c)), springs, dt);
        let either = |neck: Vec3<R>, free: Vec3<R>| Vec3::select(joined, neck, free);
        Outcome {
            wrench: Wrench {
                force: either(neck.wrench.force, free.wrench.force),
                torque_i: either(neck.wrench.torque_i, free.wrench.torque_i),
                torque_j: either(neck.wrench.torque_j, free.wrench.torque_j),
            },
            memory: (only(!joined, &free.memory), only(joined, &neck.memory)),
            losses: (only(!joined, &free.losses), only(joined, &OfNeck::from_fn(|k| *neck.losses.at(k)))),
        }
    }

    fn relisted<R: Real>(
        &self,
        c: &Contact<R>,
        (constants, _): &Self::Coefficients<R>,
        (memory, springs): Self::Memory<R>,
    ) -> (Self::Memory<R>, Self::Losses<R>) {
        let (kept, lost) = self.law.relisted(c, constants, memory);
        ((kept, springs), (lost, OfNeck::from_fn(|_| R::zero())))
    }

    fn stored<R: Real>(
        &self,
        c: &Contact<R>,
        (constants, joined): &Self::Coefficients<R>,
        (memory, springs): &Self::Memory<R>,
    ) -> Self::Stored<R> {
        let joined = joined.joined.gt(R::lit(0.5));
        let neck = self.springs().stored(joined, self.under(c).gap, springs);
        (only(!joined, &self.law.stored(c, constants, memory)), only(joined, &OfNeck::from_fn(|k| neck[k])))
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        self.critical_time_step_among(r, m, r)
    }

    fn critical_time_step_among(&self, r: f64, m: f64, largest: f64) -> f64 {
        self.law.critical_time_step_among(r, m, largest).min(self.neck.critical_time_step(r, m, largest))
    }
}

impl<M: Turns> Turns for Necked<M> {
    #[inline(always)]
    fn turned<R: Real>((memory, springs): Self::Memory<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Self::Memory<R> {
        (M::turned(memory, &turn), springs.turned(&turn))
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::mechanics::projected_spring::{spring_energy, stretched_spring};
    use crate::mechanics::reduced_mass::effective_mass;
    use crate::mechanics::stable_step::stable_time_step;
    use crate::numbers::{Dual, Lanes};
    use proptest::prelude::*;

    flat_struct! {
        /// Energies of the contact law.
        pub struct Energies {
            /// Along the normal.
            pub normal,
            /// Across it.
            pub tangential,
        }
    }

    /// A contact law: spheres that overlap repel, damped, and a spring holds them against sliding.
    #[derive(Clone, Copy)]
    struct Law {
        k_n: f64,
        k_t: f64,
        eta: f64,
    }

    impl PairModel for Law {
        /// The mass that oscillates.
        type Coefficients<R: Real> = R;
        type Memory<R: Real> = Vec3<R>;
        type Losses<R: Real> = Energies<R>;
        type Stored<R: Real> = Energies<R>;

        fn coefficients<R: Real>(&self, _: R, _: R, m_i: R, m_j: R) -> R {
            effective_mass(m_i, m_j)
        }

        fn range(&self, r_i: f64, r_j: f64) -> f64 {
            r_i + r_j
        }

        fn pair<R: Real>(&self, c: &Contact<R>, _: &R, xi: Vec3<R>, dt: R) -> Outcome<R, Vec3<R>, Energies<R>> {
            let touches = c.gap.lt(R::zero());
            let damping = -(R::lit(self.eta) * c.normal_velocity());
            let stretched = stretched_spring(xi, c.n, c.sliding_velocity(c.r_i, c.r_j), dt);
            let memory = Vec3::select(touches, stretched, Vec3::zero());
            let (normal, across) =
                (R::select(touches, damping - R::lit(self.k_n) * c.gap, R::zero()), -(memory * R::lit(self.k_t)));
            let heat = R::select(touches, -(damping * c.normal_velocity() * dt), R::zero());
            let couple = across.cross(c.n);
            Outcome {
                wrench: Wrench { force: c.n * normal + across, torque_i: couple * c.r_i, torque_j: couple * c.r_j },
                memory,
                losses: Energies { normal: heat, tangential: R::zero() },
            }
        }

        fn stored<R: Real>(&self, c: &Contact<R>, _: &R, xi: &Vec3<R>) -> Energies<R> {
            let overlap = (-c.gap).max(R::zero());
            let normal = R::lit(0.5 * self.k_n) * overlap.squared();
            Energies { normal, tangential: spring_energy(R::lit(self.k_t), *xi) }
        }

        fn critical_time_step(&self, _: f64, m: f64) -> f64 {
            stable_time_step(0.5 * m, self.k_n, self.eta)
        }
    }

    const LAYER: f64 = 0.075;

    fn model() -> Necked<Law> {
        let neck =
            Springs { k_n: 80.0, k_t: 31.0, k_r: 12.0, k_o: 5.0, eta_n: 0.1, eta_t: 0.2, eta_r: 0.3, eta_o: 0.4 };
        Necked { law: Law { k_n: 200.0, k_t: 90.0, eta: 0.5 }, neck, layer: LAYER }
    }

    fn radii() -> (f64, f64) {
        (4.0 + LAYER, 6.0 + LAYER)
    }

    /// Two particles of 8 and 12 nm, at a given distance beyond equilibrium.
    fn contact<R: Real>(beyond: R, v: [f64; 3], w: [f64; 3]) -> Contact<R> {
        let ((r_i, r_j), of) = (radii(), |numbers: [f64; 3]| Vec3(numbers.map(R::lit)));
        let x = Vec3::new(R::lit(10.0) + beyond, R::zero(), R::zero());
        Contact::new(x, of(v), of(w), -of(w) * R::lit(0.3), R::lit(r_i), R::lit(r_j))
    }

    fn constants<R: Real>(model: &Necked<Law>) -> (<Necked<Law> as PairModel>::Coefficients<R>, R) {
        let (r_i, r_j) = radii();
        (model.coefficients(R::lit(r_i), R::lit(r_j), R::lit(1.0), R::lit(2.0)), R::lit(1e-3))
    }

    proptest! {
        #[test]
        fn without_a_neck_the_contact_law_acts_alone(beyond in -0.3..1.5f64, v in prop::array::uniform3(-1.0..1.0), w in prop::array::uniform3(-1.0..1.0)) {
            let (model, c) = (model(), contact(beyond, v, w));
            let (k, dt) = constants::<f64>(&model);
            let spring = Vec3([0.0, 0.1, -0.2]);
            let (found, law) = (model.pair(&c, &k, (spring, Memory::zero()), dt), model.law.pair(&c, &k.0, spring, dt));
            prop_assert_eq!(found.wrench.force, law.wrench.force);
            prop_assert_eq!([found.wrench.torque_i, found.wrench.torque_j], [law.wrench.torque_i, law.wrench.torque_j]);
            prop_assert_eq!(found.memory, (law.memory, Memory::zero()));
            prop_assert_eq!(found.losses.0, law.losses);
            prop_assert_eq!(model.stored(&c, &k, &(spring, Memory::zero())).0, model.law.stored(&c, &k.0, &spring));
        }

        #[test]
        fn a_neck_pulls_as_hookes_spring_between_particles_that_touch_at_rest(beyond in -0.3..1.5f64) {
            let (model, c) = (model(), contact(beyond, [0.0; 3], [0.0; 3]));
            let (k, dt) = constants::<f64>(&model);
            let found = model.pair(&c, &model.joined(k), (Vec3::zero(), Memory::zero()), dt);
            prop_assert!((found.wrench.force - Vec3([-80.0 * beyond, 0.0, 0.0])).norm() < 1e-11);
            prop_assert_eq!(found.memory, (Vec3::zero(), Memory::zero()));
            let held = model.stored(&c, &model.joined(k), &found.memory);
            prop_assert_eq!((held.0.normal, held.0.tangential), (0.0, 0.0));
            prop_assert!((held.1.neck_normal - 40.0 * beyond * beyond).abs() < 1e-11);
        }

        #[test]
        fn what_a_neck_does_is_what_it_held_and_what_its_dashpots_take(beyond in -0.3..0.3f64, v in prop::array::uniform3(-1.0..1.0), w in prop::array::uniform3(-1.0..1.0)) {
            let model = model();
            let (k, _) = constants::<f64>(&model);
            let k = model.joined(k);
            // Over a short time energies are of first order in it, and differences of second order.
            let change = |dt: f64| {
                let c = contact(beyond, v, w);
                let acts = model.pair(&c, &k, (Vec3::zero(), Memory::zero()), dt);
                let later = contact(beyond + v[0] * dt, v, w);
                let sum = |of: (_, OfNeck<f64>)| (0..4).map(|spring| *of.1.at(spring)).sum::<f64>();
                let (before, after) = (model.stored(&c, &k, &(Vec3::zero(), Memory::zero())), model.stored(&later, &k, &acts.memory));
                (acts.wrench.power(&c) * dt + sum((before.0, after.1)) - sum((before.0, before.1)) + sum((before.0, OfNeck::from_fn(|spring| *acts.losses.1.at(spring))))).abs()
            };
            prop_assert!(change(1e-6) < 1e-3 * 1e-6 * 80.0, "{}", change(1e-6));
        }

        #[test]
        fn the_pull_is_minus_the_gradient_of_what_is_held(beyond in -0.3..1.5f64) {
            let model = model();
            let (k, dt) = constants::<Dual>(&model);
            let (c, k) = (contact(Dual::variable(beyond), [0.0; 3], [0.0; 3]), model.joined(k));
            let memory = (Vec3::zero(), Memory::zero());
            let force = model.pair(&c, &k, memory, dt).wrench.force.0[0].value;
            prop_assert!((force + model.stored(&c, &k, &memory).1.neck_normal.slope).abs() < 1e-10);
        }

        #[test]
        fn eight_pairs_some_with_necks_have_the_bits_of_one(places in prop::array::uniform8(-0.3..1.5f64), v in prop::array::uniform3(-1.0..1.0)) {
            let model = model();
            let ((k, dt), (single, step)) = (constants::<Lanes<8>>(&model), constants::<f64>(&model));
            let mixed = (k.0, Joined { joined: Lanes(std::array::from_fn(|lane| f64::from(lane as u8 % 2))) });
            let together = model.pair(&contact(Lanes(places), v, v), &mixed, Flat::from_fn(|_| Lanes::lit(0.0)), dt).wrench.force;
            for (lane, beyond) in places.into_iter().enumerate() {
                let k = if lane % 2 == 1 { model.joined(single) } else { single };
                let alone = model.pair(&contact(beyond, v, v), &k, Flat::from_fn(|_| 0.0), step).wrench.force;
                prop_assert_eq!(alone, Vec3(together.0.map(|component| component.0[lane])));
            }
        }
    }

    #[test]
    fn a_neck_acts_between_the_particles_inside_their_layers() {
        let (model, v, w) = (model(), [0.3, -0.5, 0.7], [0.2, 0.9, -0.4]);
        let (k, dt) = constants::<f64>(&model);
        let springs =
            Memory { tangential: Vec3([0.0, 0.2, 0.1]), rolling: Vec3([0.0, -0.3, 0.4]), torsion: 0.5, rest: 0.0 };
        let (c, smooth) = (contact(0.2, v, w), Friction::from_fn(|_| 0.0));
        let bare = Contact::new(c.n * c.distance, c.v, c.omega_i, c.omega_j, 4.0, 6.0);
        let alone = model.neck.evaluate(&smooth, true, &ContactKinematics::of_spheres(&bare), springs, dt);
        let found = model.pair(&c, &model.joined(k), (Vec3([0.1; 3]), springs), dt);
        for (found, alone) in [
            (found.wrench.force, alone.wrench.force),
            (found.wrench.torque_i, alone.wrench.torque_i),
            (found.wrench.torque_j, alone.wrench.torque_j),
            (found.memory.1.tangential, alone.memory.tangential),
            (found.memory.1.rolling, alone.memory.rolling),
        ] {
            assert!((found - alone).norm() < 1e-12 && alone.norm() > 0.1);
        }
        // of the contact law nothing is left
        assert_eq!((found.memory.0, found.losses.0), (Vec3::zero(), Energies::from_fn(|_| 0.0)));
    }

    #[test]
    fn a_neck_breaks_above_its_energy_and_a_new_list_changes_no_spring() {
        let (model, c) = (model(), contact(0.2, [0.0; 3], [0.0; 3]));
        let k = model.joined(constants::<f64>(&model).0);
        let springs =
            (Vec3([0.1, 0.0, 0.0]), Memory { tangential: Vec3([0.0, 0.2, 0.1]), torsion: 0.5, ..Memory::zero() });
        let held = model.stored(&c, &k, &springs);
        let energy = 0.5 * (80.0 * 0.04 + 31.0 * 0.05 + 5.0 * 0.25);
        assert!(
            !Necked::<Law>::neck_breaks(&held, energy + 1e-12) && Necked::<Law>::neck_breaks(&held, energy - 1e-12)
        );
        let exactly = (0..4).map(|spring| *held.1.at(spring)).sum();
        assert!(!Necked::<Law>::neck_breaks(&held, exactly));
        assert_eq!(model.relisted(&c, &k, springs), (springs, (Energies::from_fn(|_| 0.0), OfNeck::from_fn(|_| 0.0))));
        assert_eq!(model.turning(k, 7.0), k);
        assert_eq!([constants::<f64>(&model).0.1, k.1].map(|pair| pair.joined), [0.0, 1.0]);
    }

    #[test]
    fn the_step_must_suit_both() {
        let (r, stiff) = (radii().0, Necked { neck: Springs { k_n: 1e6, ..model().neck }, ..model() });
        assert_eq!(
            model().critical_time_step(r, 1.0),
            model().neck.critical_time_step(r, 1.0, r).min(model().law.critical_time_step(r, 1.0))
        );
        assert!(stiff.critical_time_step(r, 1.0) < 2.0 / (2.0 * 1e6f64).sqrt());
        let soft = Necked { neck: Springs::from_fn(|_| 1e-6), ..model() };
        assert_eq!(soft.critical_time_step(r, 1.0), soft.law.critical_time_step(r, 1.0));
    }
}
