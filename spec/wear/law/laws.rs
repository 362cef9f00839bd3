//! What the composed law must obey, in every phase and as a motion.

use super::*;
use crate::numbers::Lanes;
use crate::wear::def_restitution::{damping_ratio_of, restitution};
use crate::wear::def_sphere::moment_of_inertia;
use crate::wear::eq01_symplectic_euler::symplectic_euler;
use crate::{Flat, Losses};
use proptest::prelude::*;

/// The material of the patch tests with a critical diameter of 150.
fn patch(interaction: Interaction) -> Wear {
    let material = Material {
        young_modulus: 1.0,
        poisson_ratio: 0.15,
        tensile_strength: 0.2,
        shear_strength: 0.1,
        surface_energy: 1.5,
        restitution: 0.95,
        scaling: 0.5,
    };
    Wear { material, interaction }
}

const ALL: [Interaction; 3] = [Interaction::Repulsive, Interaction::Normal, Interaction::Full];

fn vector() -> impl Strategy<Value = Vec3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
}

/// Two equal spheres and their spring.
#[derive(Clone)]
struct Pair {
    law: Wear,
    r: f64,
    m: f64,
    x: [Vec3<f64>; 2],
    v: [Vec3<f64>; 2],
    omega: [Vec3<f64>; 2],
    spring: Vec3<f64>,
    lost: f64,
}

impl Pair {
    /// At rest along the first axis.
    fn new(law: Wear, r: f64, m: f64, gap: f64) -> Self {
        let x = Vec3::new(r + 0.5 * gap, 0.0, 0.0);
        Self { law, r, m, x: [x, -x], v: [Vec3::zero(); 2], omega: [Vec3::zero(); 2], spring: Vec3::zero(), lost: 0.0 }
    }
    fn contact(&self) -> Contact<f64> {
        let ([x_i, x_j], [v_i, v_j]) = (self.x, self.v);
        Contact::new(x_i - x_j, v_i - v_j, self.omega[0], self.omega[1], self.r, self.r)
    }
    fn coefficients(&self) -> Parameters<f64> {
        self.law.coefficients(self.r, self.r, self.m, self.m)
    }
    fn step(&mut self, dt: f64) {
        let outcome = self.law.pair(&self.contact(), &self.coefficients(), self.spring, dt);
        let (force, inertia) = (outcome.wrench.force, moment_of_inertia(self.m, self.r));
        let torques = [outcome.wrench.torque_i, outcome.wrench.torque_j];
        for (i, force) in [force, -force].into_iter().enumerate() {
            (self.v[i], self.x[i], self.omega[i]) =
                symplectic_euler(self.x[i], self.v[i], self.omega[i], force, torques[i], self.m, inertia, dt);
        }
        self.spring = outcome.memory;
        let Losses { normal, tangential, slip } = outcome.losses;
        self.lost += normal + tangential + slip;
    }
    fn energy(&self) -> f64 {
        let stored = self.law.stored(&self.contact(), &self.coefficients(), &self.spring);
        let inertia = moment_of_inertia(self.m, self.r);
        let kinetic: f64 = (0..2)
            .map(|i| 0.5 * self.m * self.v[i].dot(self.v[i]) + 0.5 * inertia * self.omega[i].dot(self.omega[i]))
            .sum();
        kinetic + stored.normal + stored.tangential
    }
    fn angular_momentum(&self) -> Vec3<f64> {
        let inertia = moment_of_inertia(self.m, self.r);
        let of = |i: usize| self.x[i].cross(self.v[i]) * self.m + self.omega[i] * inertia;
        of(0) + of(1)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn no_pair_of_any_phase_gives_anything_but_numbers(
        nu in -0.5..=0.25, s in 0.0..1.0, r_i in 10.0..2000.0, r_j in 10.0..2000.0,
        gap in prop_oneof![-5.0..50.0f64, Just(0.0), Just(1e6)], v in vector(), omega in vector(), dt in 0.0..1.0,
    ) {
        for interaction in ALL {
            let mut law = patch(interaction);
            (law.material.poisson_ratio, law.material.scaling) = (nu, s);
            let k = law.coefficients(r_i, r_j, 1.0, 2.0);
            for gap in [gap, k.delta_e, k.delta_f] {
                for spring in [Vec3::zero(), v] {
                    let c = Contact::new(Vec3::new(r_i + r_j + gap, 0.0, 0.0), v, omega, -omega, r_i, r_j);
                    let outcome = law.pair(&c, &k, spring, dt);
                    let stored = law.stored(&c, &k, &outcome.memory);
                    let vectors = [outcome.wrench.force, outcome.wrench.torque_i, outcome.wrench.torque_j, outcome.memory];
                    let numbers = [outcome.losses.normal, outcome.losses.tangential, outcome.losses.slip, stored.normal, stored.tangential];
                    prop_assert!(vectors.iter().flat_map(|v| v.0).chain(numbers).all(f64::is_finite));
                }
            }
            prop_assert!(law.critical_time_step(r_i, 1.0) > 0.0);
        }
    }

    #[test]
    fn eight_lanes_have_the_bits_of_eight_numbers(
        gaps in prop::array::uniform8(-5.0..50.0), v in vector(), omega in vector(), spring in vector(),
    ) {
        for interaction in ALL {
            let law = patch(interaction);
            let of = |gap: f64| (Vec3::new(0.6 * (80.0 + gap), 0.0, 0.8 * (80.0 + gap)), v * gap, omega * (1.0 + gap));
            let k = law.coefficients(45.0, 35.0, 1.0, 0.5);
            let lift = |f: &dyn Fn(usize) -> f64| Lanes(std::array::from_fn::<f64, 8, _>(f));
            let vector = |pick: &dyn Fn(f64) -> Vec3<f64>| Vec3(std::array::from_fn(|a| lift(&|lane| pick(gaps[lane]).0[a])));
            let c = Contact::new(
                vector(&|gap| of(gap).0), vector(&|gap| of(gap).1), vector(&|gap| of(gap).2), vector(&|_| omega), Lanes([45.0; 8]), Lanes([35.0; 8]),
            );
            let lanes = law.pair(&c, &Parameters::from_fn(|n| Lanes([k.get(n); 8])), vector(&|_| spring), Lanes([0.1; 8]));
            for (lane, &gap) in gaps.iter().enumerate() {
                let (x, v, omega_i) = of(gap);
                let one = law.pair(&Contact::new(x, v, omega_i, omega, 45.0, 35.0), &k, spring, 0.1);
                for a in 0..3 {
                    for (number, eight) in [
                        (one.wrench.force, lanes.wrench.force), (one.wrench.torque_i, lanes.wrench.torque_i),
                        (one.wrench.torque_j, lanes.wrench.torque_j), (one.memory, lanes.memory),
                    ] {
                        prop_assert_eq!(number.0[a].to_bits(), eight.0[a].0[lane].to_bits());
                    }
                }
                prop_assert_eq!(one.losses.slip.to_bits(), lanes.losses.slip.0[lane].to_bits());
            }
        }
    }

    #[test]
    fn only_the_full_law_acts_in_the_contact_plane(v in vector(), gap in -5.0..20.0) {
        let acts = |interaction| {
            let mut pair = Pair::new(patch(interaction), 45.0, 1.0, gap);
            pair.v[0] = Vec3::new(0.0, 1.0 + v.0[0], 0.5);
            let wrench = pair.law.pair(&pair.contact(), &pair.coefficients(), Vec3::zero(), 0.1).wrench;
            (wrench.force.0[0], wrench.force.0[1], wrench.torque_i.norm())
        };
        let [repulsive, normal, full] = ALL.map(acts);
        prop_assert!(repulsive.0 >= 0.0 && repulsive.1 == 0.0 && repulsive.2 == 0.0);
        prop_assert!(normal.0 * gap <= 0.0 && normal.1 == 0.0 && normal.2 == 0.0);
        prop_assert!(full.0 == normal.0 && full.1 < 0.0 && full.2 > 0.0);
    }

    #[test]
    fn a_collision_without_cohesion_returns_what_the_dashpot_leaves(eta in 0.3..0.99) {
        let mut law = patch(Interaction::Repulsive);
        law.material.restitution = eta;
        let mut pair = Pair::new(law, 45.0, 1.0, 0.0);
        let k = pair.coefficients();
        let (zeta, speed) = (damping_ratio_of(k.c_n, k.k_n, effective_mass(1.0, 1.0)), 0.02);
        pair.v = [Vec3::new(-0.5 * speed, 0.0, 0.0), Vec3::new(0.5 * speed, 0.0, 0.0)];
        let dt = 1e-4 * critical_time_step(1.0, k.k_n);
        pair.step(dt);
        while pair.contact().gap < 0.0 {
            pair.step(dt);
        }
        prop_assert!((pair.contact().normal_velocity() / speed - restitution(zeta)).abs() < 5e-4);
    }

    #[test]
    fn an_oblique_encounter_keeps_angular_momentum_and_accounts_for_its_energy(
        speed in 0.01..0.05f64, aim in -0.8..0.8, spin in vector(), r in prop_oneof![Just(45.0), Just(450.0)],
    ) {
        let mut pair = Pair::new(patch(Interaction::Full), r, 1.0, 0.0);
        let range = pair.coefficients().delta_f;
        pair.x = [Vec3::new(r + 0.5 * range, 0.0, 0.0), Vec3::new(-r - 0.5 * range, 0.0, 0.0)];
        let velocity = Vec3::new(-speed * r, aim * speed * r, 0.0);
        (pair.v, pair.omega) = ([velocity, -velocity], [spin * speed, spin * (-0.5 * speed)]);
        let (angular_momentum, energy) = (pair.angular_momentum(), pair.energy());
        let dt = 2e-4 * pair.law.critical_time_step(r, 1.0);
        for _ in 0..40_000 {
            pair.step(dt);
        }
        let drift = (pair.angular_momentum() - angular_momentum).norm();
        prop_assert!(drift < 1e-12 * angular_momentum.norm().max(speed * r * r));
        prop_assert!(pair.lost > 0.0);
        prop_assert!((pair.energy() + pair.lost - energy).abs() < 2e-3 * (energy.abs() + pair.lost));
    }

    #[test]
    fn a_slow_pair_is_captured_and_a_fast_one_escapes(r in 20.0..70.0) {
        let end = |speed: f64| {
            let mut law = patch(Interaction::Normal);
            law.material.restitution = 0.5;
            let mut pair = Pair::new(law, r, 1.0, 0.0);
            let k = pair.coefficients();
            pair.x = [Vec3::new(r + 0.4999 * k.delta_f, 0.0, 0.0), Vec3::new(-r - 0.4999 * k.delta_f, 0.0, 0.0)];
            // In units of what the work of separation would give to a pair at rest.
            let velocity = Vec3::new(-0.5 * speed * (2.0 * k.k_n * k.delta_e * k.delta_f).sqrt(), 0.0, 0.0);
            pair.v = [velocity, -velocity];
            let dt = 2e-3 * critical_time_step(1.0, k.k_n);
            for _ in 0..20_000 {
                pair.step(dt);
            }
            pair.contact().gap - k.delta_f
        };
        prop_assert!(end(0.1) < 0.0);
        prop_assert!(end(10.0) > 0.0);
    }
}

/// Sliding velocity that a pair of small amplitude reaches, in units of what it starts with.
fn amplification(nu: f64, fraction_of_eq_6: f64) -> f64 {
    let mut law = patch(Interaction::Full);
    (law.material.poisson_ratio, law.material.restitution) = (nu, 1.0);
    let mut pair = Pair::new(law, 45.0, 1.0, -0.01);
    let start = 1e-9;
    pair.v = [Vec3::new(0.0, start, 0.0), Vec3::new(0.0, -start, 0.0)];
    let dt = fraction_of_eq_6 * critical_time_step(1.0, pair.coefficients().k_n);
    let sliding = |pair: &Pair| pair.contact().sliding_velocity(45.0, 45.0).norm();
    // The normal is at rest in its own equilibrium: an overlap would push the pair apart.
    pair.x = [Vec3::new(45.0, 0.0, 0.0), Vec3::new(-45.0, 0.0, 0.0)];
    (0..300)
        .map(|_| {
            pair.step(dt);
            sliding(&pair)
        })
        .fold(0.0, f64::max)
        / (2.0 * start)
}

#[test]
fn sliding_and_turning_is_unstable_below_the_limit_of_eq_6() {
    for nu in [0.0, 0.05, 0.1, 0.15] {
        let limit = crate::wear::def_stable_step::sliding_limit(nu).0;
        assert!(limit < 1.0);
        assert!(amplification(nu, 0.99 * limit) < 20.0);
        assert!(amplification(nu, 1.01 * limit) > 1e3);
    }
}

#[test]
fn the_limit_of_the_time_step_is_the_tightest_of_three() {
    for (nu, eta) in [(0.0, 1.0), (0.2, 1.0), (0.2, 0.5), (0.25, 0.95)] {
        let mut law = patch(Interaction::Full);
        (law.material.poisson_ratio, law.material.restitution) = (nu, eta);
        let k = law.coefficients(45.0, 45.0, 1.0, 1.0);
        let limit = law.critical_time_step(45.0, 1.0);
        let of_eq_6 = critical_time_step(1.0, k.k_n);
        assert!(limit <= of_eq_6 && limit > 0.2 * of_eq_6);
        assert_eq!(limit < of_eq_6, nu < 1.0 / 6.0 || eta < 1.0);
    }
}
