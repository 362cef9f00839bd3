//! Any contact law with springs that follow a pair which spins about its normal.
//!
//! **Reading.** A reading that no paper takes, beside those of the papers, in which springs are projected and stay fixed in space while a pair spins about its normal. Before each step the springs in the
//! contact plane are turned by [`carried_spring`]; all else is the law's own. They keep their lengths, so nothing is stored or lost, and forces and torques obey the law as before.

use super::carried_spring::carried_spring;
use crate::{Contact, Outcome, PairModel, Real, Touch, Vec3};

/// A contact law whose springs can be turned.
pub trait Turns: PairModel {
    /// The contact history with every spring that lies in the contact plane turned.
    fn turned<R: Real>(memory: Self::Memory<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Self::Memory<R>;
}

/// A contact law whose springs are carried along by a pair that spins about its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried<M>(pub M);

impl<M: Turns> PairModel for Carried<M> {
    type Coefficients<R: Real> = M::Coefficients<R>;
    type Memory<R: Real> = M::Memory<R>;
    type Losses<R: Real> = M::Losses<R>;
    type Stored<R: Real> = M::Stored<R>;

    fn coefficients<R: Real>(&self, r_i: R, r_j: R, m_i: R, m_j: R) -> Self::Coefficients<R> {
        self.0.coefficients(r_i, r_j, m_i, m_j)
    }

    fn joined<R: Real>(&self, constants: Self::Coefficients<R>) -> Self::Coefficients<R> {
        self.0.joined(constants)
    }

    fn left_by_neck<R: Real>(memory: Self::Memory<R>) -> Self::Memory<R> {
        M::left_by_neck(memory)
    }

    const FRICTION_STOPS: bool = M::FRICTION_STOPS;

    fn turning<R: Real>(&self, constants: Self::Coefficients<R>, inertia: R) -> Self::Coefficients<R> {
        self.0.turning(constants, inertia)
    }

    fn range(&self, r_i: f64, r_j: f64) -> f64 {
        self.0.range(r_i, r_j)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Self::Coefficients<R>,
        memory: Self::Memory<R>,
        dt: R,
    ) -> Outcome<R, Self::Memory<R>, Self::Losses<R>> {
        self.0.pair(c, k, M::turned(memory, |xi| carried_spring(xi, c.n, c.omega_i, c.omega_j, dt)), dt)
    }

    fn relisted<R: Real>(
        &self,
        c: &Contact<R>,
        k: &Self::Coefficients<R>,
        memory: Self::Memory<R>,
    ) -> (Self::Memory<R>, Self::Losses<R>) {
        self.0.relisted(c, k, memory)
    }

    const MOSTLY_FAR: bool = M::MOSTLY_FAR;

    #[inline(always)]
    fn is_near<R: Real>(&self, c: &Contact<R>, k: &Self::Coefficients<R>) -> R::Mask {
        self.0.is_near(c, k)
    }

    #[inline(always)]
    fn far<R: Real>(&self, c: &Contact<R>) -> Vec3<R> {
        self.0.far(c)
    }

    #[inline(always)]
    fn stored<R: Real>(&self, c: &Contact<R>, k: &Self::Coefficients<R>, memory: &Self::Memory<R>) -> Self::Stored<R> {
        self.0.stored(c, k, memory)
    }

    fn critical_time_step(&self, r: f64, m: f64) -> f64 {
        self.0.critical_time_step(r, m)
    }

    fn critical_time_step_among(&self, r: f64, m: f64, largest: f64) -> f64 {
        self.0.critical_time_step_among(r, m, largest)
    }

    const SURFACES: usize = M::SURFACES;

    fn surface_range(&self, material: usize, r: f64) -> f64 {
        self.0.surface_range(material, r)
    }

    /// A surface does not spin: springs follow half the spin of the sphere.
    fn surface_contact(
        &self,
        material: usize,
        touch: &Touch<f64>,
        memory: Self::Memory<f64>,
        dt: f64,
    ) -> Outcome<f64, Self::Memory<f64>, Self::Losses<f64>> {
        let memory = M::turned(memory, |xi| carried_spring(xi, touch.n, touch.omega, Vec3::zero(), dt));
        self.0.surface_contact(material, touch, memory, dt)
    }

    fn surface_pull(&self, material: usize, touch: &Touch<f64>) -> f64 {
        self.0.surface_pull(material, touch)
    }

    fn surface_energy(&self, material: usize, touch: &Touch<f64>) -> f64 {
        self.0.surface_energy(material, touch)
    }

    fn surface_stored(
        &self,
        material: usize,
        touch: &Touch<f64>,
        memory: &Self::Memory<f64>,
        share: f64,
    ) -> Self::Stored<f64> {
        self.0.surface_stored(material, touch, memory, share)
    }

    fn surface_share(&self, sight: [Vec3<f64>; 2], change: [Vec3<f64>; 2]) -> (f64, Vec3<f64>) {
        self.0.surface_share(sight, change)
    }
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::Flat;
    use crate::mechanics::four_springs::{Friction, Springs};
    use crate::mechanics::rotated_spring::Twist;
    use crate::mechanics::samples::{rotated, unit, vector};
    use crate::numbers::Lanes;
    use crate::soot::{Along, Attraction, Following, Soot, Wall};
    use crate::wear::{Interaction, Material, Wear};
    use proptest::prelude::*;

    const STEPS: i32 = 2000;

    fn wear() -> Wear {
        let material = Material {
            young_modulus: 1.0,
            poisson_ratio: 0.2,
            tensile_strength: 0.2,
            shear_strength: 0.15,
            surface_energy: 1.5,
            restitution: 0.8,
            scaling: 0.5,
            forget_stretched_springs: false,
        };
        Wear { material, interaction: Interaction::Full }
    }

    fn soot<S>(reading: S) -> Soot<S> {
        let springs =
            Springs { k_n: 9.0, k_t: 7.0, k_r: 5.0, k_o: 3.0, eta_n: 0.4, eta_t: 0.3, eta_r: 0.2, eta_o: 0.1 };
        let friction = Friction::from_ratio([1.0, 0.5, 0.5], 0.8);
        let wall = Wall { contact: springs, friction, hamaker: 1.0, delta_0: 0.1, cutoff: 9.0 };
        let attraction = Attraction { a: 1.0, delta_0: 0.1, psi: 0.0, kappa: 1.0, d_cutoff: 9.0, cutoff: 9.0 };
        Soot { neck: springs, contact: springs, friction, attraction, reading, walls: [wall; 2] }
    }

    impl Turns for Soot<Along> {
        fn turned<R: Real>(memory: Self::Memory<R>, turn: impl Fn(Vec3<R>) -> Vec3<R>) -> Self::Memory<R> {
            memory.turned(turn)
        }
    }

    /// Radii 1 and 0.75 at this gap.
    fn at(n: Vec3<f64>, gap: f64, v: Vec3<f64>, omega_i: Vec3<f64>, omega_j: Vec3<f64>) -> Contact<f64> {
        Contact::new(n * (1.75 + gap), v, omega_i, omega_j, 1.0, 0.75)
    }

    /// The force between two spheres that turn as a body, before and after, and what was lost.
    fn turned<M: PairModel<Memory<f64> = Vec3<f64>>>(
        law: &M,
        n: Vec3<f64>,
        xi: Vec3<f64>,
        axis: Vec3<f64>,
        angle: f64,
    ) -> (Vec3<f64>, Vec3<f64>, f64) {
        let (k, dt) = (law.coefficients(1.0, 0.75, 2.0, 1.0), 1.0 / f64::from(STEPS));
        let (omega, still) = (axis * angle, Vec3::zero());
        let first = law.pair(&at(n, -0.1, still, still, still), &k, xi, dt);
        let (mut memory, mut force, mut lost) = (first.memory, first.wrench.force, 0.0);
        for step in 1..=STEPS {
            let n = rotated(n, axis, angle * f64::from(step) * dt);
            let next = law.pair(&at(n, -0.1, omega.cross(n * 1.65), omega, omega), &k, memory, dt);
            (memory, force) = (next.memory, next.wrench.force);
            lost += (0..M::Losses::<f64>::LEN).map(|k| next.losses.at(k).abs()).sum::<f64>();
        }
        (first.wrench.force, force, lost)
    }

    /// What a projected spring loses of its length, and what turning it in steps leaves.
    fn allowed(angle: f64) -> f64 {
        1e-12 + 0.1 * angle.abs().powi(2) / f64::from(STEPS)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn a_pair_that_turns_as_a_body_carries_its_springs(n in unit(), xi in vector(), axis in unit(), angle in -3.0..3.0f64) {
            let xi = xi.perpendicular_to(n) * 0.05;
            let (before, after, lost) = turned(&Carried(wear()), n, xi, axis, angle);
            prop_assert!((rotated(before, axis, angle) - after).norm() < allowed(angle));
            prop_assert!(lost < 1e-12);
        }

        #[test]
        fn projected_springs_stay_behind_a_pair_that_spins(n in unit(), xi in vector(), angle in 0.5..2.0f64) {
            let xi = xi.perpendicular_to(n) * 0.05;
            prop_assume!(xi.norm() > 0.01);
            let (before, after, _) = turned(&wear(), n, xi, n, angle);
            prop_assert!((before - after).norm() < 1e-12);
            let (_, carried, _) = turned(&Carried(wear()), n, xi, n, angle);
            prop_assert!((carried - after).norm() > 0.1 * before.perpendicular_to(n).norm());
        }

        #[test]
        fn the_stress_of_a_turned_sample_is_the_turned_stress(
            pairs in prop::collection::vec((unit(), vector()), 8), axis in unit(), angle in -3.0..3.0f64,
        ) {
            let mut difference = 0.0f64;
            let (mut before, mut after) = ([Vec3::zero(); 3], [Vec3::zero(); 3]);
            for (n, xi) in pairs {
                let (start, end, _) = turned(&Carried(wear()), n, xi.perpendicular_to(n) * 0.05, axis, angle);
                let add = |sum: &mut [Vec3<f64>; 3], more: [Vec3<f64>; 3]| for k in 0..3 { sum[k] = sum[k] + more[k]; };
                add(&mut before, n.outer(start));
                add(&mut after, rotated(n, axis, angle).outer(end));
            }
            // Both as linear maps, on the axes of space: sigma' R e = R (sigma^T e)^T.
            for k in 0..3 {
                let e = Vec3(std::array::from_fn(|axis| f64::from(u8::from(axis == k))));
                let apply = |of: &[Vec3<f64>; 3], v: Vec3<f64>| of[0] * v.0[0] + of[1] * v.0[1] + of[2] * v.0[2];
                let turned = rotated(apply(&before, e), axis, angle);
                difference = difference.max((apply(&after, rotated(e, axis, angle)) - turned).norm());
            }
            prop_assert!(difference < 8.0 * allowed(angle), "{difference}");
        }

        #[test]
        fn what_does_not_spin_obeys_the_law_itself_and_angular_momentum_is_kept(
            n in unit(), gap in -0.2..0.05, v in vector(), across in vector(), spin in -1.0..1.0, xi in vector(),
        ) {
            let (law, dt) = (wear(), 0.05);
            let k = law.coefficients(1.0, 0.75, 2.0, 1.0);
            let still = at(n, gap, v, across.perpendicular_to(n), -across.perpendicular_to(n));
            let (plain, carried) = (law.pair(&still, &k, xi, dt), Carried(law).pair(&still, &k, xi, dt));
            prop_assert!((plain.wrench.force - carried.wrench.force).norm() < 1e-15);
            let c = at(n, gap, v, n * spin, across);
            let wrench = Carried(law).pair(&c, &k, xi, dt).wrench;
            prop_assert!((wrench.torque_i + wrench.torque_j + (c.n * c.distance).cross(wrench.force)).norm() < 1e-14);
        }

        #[test]
        fn turning_a_spring_stores_and_loses_nothing(n in unit(), spin in -1.0..1.0, xi in vector(), dt in 0.0..1.0) {
            let law = Carried(wear());
            let (k, xi) = (law.coefficients(1.0, 0.75, 2.0, 1.0), xi.perpendicular_to(n) * 0.02);
            let c = at(n, -0.1, Vec3::zero(), n * spin, n * spin);
            let next = law.pair(&c, &k, xi, dt);
            let lost = (0..3).map(|cause| *next.losses.at(cause)).sum::<f64>();
            let held = |xi| law.stored(&c, &k, xi).tangential;
            prop_assert!((held(&next.memory) - held(&xi)).abs() < 1e-16 && lost.abs() < 1e-16);
        }

        #[test]
        fn the_reading_of_the_four_springs_does_the_same(
            n in unit(), gap in -0.2..0.05, v in vector(), omega_i in vector(), omega_j in vector(), springs in prop::array::uniform8(-0.05..0.05),
        ) {
            let (law, follows, dt) = (Carried(soot(Along)), soot(Following), 0.1);
            let memory = || Flat::from_fn(|k| if k < 7 { springs[k] } else { 0.0 });
            let c = at(n, gap, v, omega_i, omega_j);
            for joined in [false, true] {
                let k = follows.coefficients(1.0, 0.75, 1.0, 1.0);
                let k = if joined { follows.joined(k) } else { k };
                let (one, other) = (law.pair(&c, &k, memory(), dt), follows.pair(&c, &k, memory(), dt));
                prop_assert_eq!((one.wrench.force, one.memory), (other.wrench.force, other.memory));
            }
            let touch = Touch { n, gap, v, omega: omega_i, r: 1.0 };
            let (one, other) = (law.surface_contact(0, &touch, memory(), dt), follows.surface_contact(0, &touch, memory(), dt));
            prop_assert_eq!((one.wrench.force, one.memory), (other.wrench.force, other.memory));
            // A spring that sticks is turned.
            let held = (omega_j * 0.005).perpendicular_to(n);
            prop_assume!(held.norm() > 1e-3);
            let memory = || Flat::from_fn(|k| if k < 3 { held.0[k] } else { 0.0 });
            let touch = Touch { gap: -0.1, v: Vec3::zero(), omega: n, ..touch };
            let turned = law.surface_contact(0, &touch, memory(), dt).memory.tangential;
            let angle = 2.0 * (0.25 * dt).atan();
            prop_assert!((turned - rotated(held, n, angle)).norm() < 1e-12 * held.norm(), "{turned:?} {held:?}");
            prop_assert!((soot(Along).surface_contact(0, &touch, memory(), dt).memory.tangential - held).norm() < 1e-15);
        }

        #[test]
        fn torsion_lies_along_the_normal_and_is_not_turned(memory in prop::array::uniform8(-1.0..1.0f64), n in unit()) {
            let before: <Soot<Along> as PairModel>::Memory<f64> = Flat::from_fn(|k| memory[k]);
            let after = before.turned(|xi| xi.cross(n));
            prop_assert_eq!((after.torsion, after.rest), (before.torsion, before.rest));
            prop_assert_eq!((after.tangential, after.rolling), (before.tangential.cross(n), before.rolling.cross(n)));
            prop_assert_eq!(after.torsion.rotated(n), before.torsion);
        }

        #[test]
        fn eight_pairs_at_once_have_the_bits_of_one(gaps in prop::array::uniform8(-0.2..0.1f64), n in unit(), omega in vector(), xi in vector()) {
            let (law, wide) = (Carried(wear()), |x: f64| Lanes::<8>::lit(x));
            let vector = |v: Vec3<f64>| Vec3(v.0.map(wide));
            let still = Vec3::zero();
            let together = Contact::new(
                Vec3(n.0.map(|x| Lanes(gaps.map(|gap| x * (1.75 + gap))))), vector(still), vector(omega), vector(omega), wide(1.0), wide(0.75),
            );
            let k = law.coefficients(wide(1.0), wide(0.75), wide(2.0), wide(1.0));
            let together = law.pair(&together, &k, vector(xi), wide(0.1));
            let k = law.coefficients(1.0, 0.75, 2.0, 1.0);
            for (lane, gap) in gaps.into_iter().enumerate() {
                let alone = law.pair(&at(n, gap, still, omega, omega), &k, xi, 0.1);
                prop_assert_eq!(alone.memory, Vec3(together.memory.0.map(|x| x.0[lane])));
                prop_assert_eq!(alone.wrench.force, Vec3(together.wrench.force.0.map(|x| x.0[lane])));
            }
        }
    }

    #[test]
    fn all_else_is_the_law_itself() {
        let (law, carried) = (soot(Along), Carried(soot(Along)));
        assert_eq!(carried.range(1.0, 0.75), law.range(1.0, 0.75));
        assert_eq!(carried.critical_time_step(1.0, 2.0), law.critical_time_step(1.0, 2.0));
        assert_eq!(carried.critical_time_step_among(1.0, 2.0, 3.0), law.critical_time_step_among(1.0, 2.0, 3.0));
        assert_eq!(carried.surface_range(0, 1.0), law.surface_range(0, 1.0));
        let touch = Touch { n: Vec3([0.0, 0.0, 1.0]), gap: 0.2, v: Vec3::zero(), omega: Vec3::zero(), r: 1.0 };
        assert_eq!(carried.surface_pull(1, &touch), law.surface_pull(1, &touch));
        assert_eq!(carried.surface_energy(1, &touch), law.surface_energy(1, &touch));
        let held: <Soot<Along> as PairModel>::Memory<f64> = Flat::from_fn(|k| 0.1 * k as f64);
        assert_eq!(carried.surface_stored(1, &touch, &held, 0.5), law.surface_stored(1, &touch, &held, 0.5));
        let sight = [Vec3([1.0, 0.0, 0.2]), Vec3([0.5, 0.1, 0.0])];
        assert_eq!(carried.surface_share(sight, sight), law.surface_share(sight, sight));
        type Plain = Soot<Along>;
        assert_eq!(Carried::<Plain>::left_by_neck(held), Plain::left_by_neck(held));
        let constants = (<Carried<Plain> as PairModel>::MOSTLY_FAR, <Carried<Plain> as PairModel>::SURFACES);
        assert_eq!(constants, (<Plain as PairModel>::MOSTLY_FAR, <Plain as PairModel>::SURFACES));
    }
}
