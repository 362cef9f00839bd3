//! Laws of the composed contact law, in every phase and in motion.

mod pair;

use super::*;
use crate::Flat;
use crate::numbers::Lanes;
use crate::wear::Published;
use crate::wear::def_restitution::{damping_ratio_of, restitution};
use pair::Pair;
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
        forget_stretched_springs: false,
    };
    Wear { material, interaction }
}

const ALL: [Interaction; 3] = [Interaction::Repulsive, Interaction::Normal, Interaction::Full];

fn vector() -> impl Strategy<Value = Vec3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
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
            law.material = Material { poisson_ratio: nu, scaling: s, ..law.material };
            let k = law.coefficients(r_i, r_j, 1.0, 2.0);
            for gap in [gap, k.delta_e, k.delta_f] {
                for spring in [Vec3::zero(), v] {
                    let c = Contact::new(Vec3::new(r_i + r_j + gap, 0.0, 0.0), v, omega, -omega, r_i, r_j);
                    for outcome in [law.pair(&c, &k, spring, dt), Published(law).pair(&c, &k, spring, dt)] {
                        let stored = law.stored(&c, &k, &outcome.memory);
                        let vectors = [outcome.wrench.force, outcome.wrench.torque_i, outcome.wrench.torque_j, outcome.memory];
                        let numbers = [outcome.losses.normal_damping, outcome.losses.tangential_damping, outcome.losses.slip, stored.normal, stored.tangential];
                        prop_assert!(vectors.iter().flat_map(|v| v.0).chain(numbers).all(f64::is_finite));
                    }
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
            let lanes = law.pair(&c, &Parameters::from_fn(|n| Lanes([*k.at(n); 8])), vector(&|_| spring), Lanes([0.1; 8]));
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
    fn cohesion_is_reversible_a_passage_through_the_whole_range_gives_back_its_speed(
        speed in 0.5..5.0f64, r in prop_oneof![Just(20.0), Just(45.0), Just(450.0)],
    ) {
        // Small particles weaken before they separate, large ones break while their force is still increasing.
        let mut law = patch(Interaction::Normal);
        law.material.restitution = 1.0;
        let mut pair = Pair::new(law, r, 1.0, 0.0);
        let k = pair.coefficients();
        let apart = Vec3::new(r + 0.51 * k.delta_f, 0.0, 0.0);
        pair.x = [apart, -apart];
        let speed = speed * (k.k_n * k.delta_e * k.delta_f).sqrt();
        pair.v = [Vec3::new(-0.5 * speed, 0.0, 0.0), Vec3::new(0.5 * speed, 0.0, 0.0)];
        let dt = 2e-4 * critical_time_step(1.0, k.k_n);
        let mut overlapped = false;
        while pair.contact().gap <= 1.02 * k.delta_f {
            pair.step(dt);
            overlapped |= pair.contact().gap < 0.0;
        }
        prop_assert!(overlapped);
        prop_assert!((pair.contact().normal_velocity() / speed - 1.0).abs() < 2e-3);
    }

    #[test]
    fn no_closed_path_of_two_particles_delivers_work(corners in prop::collection::vec((-3.0..33.0, vector()), 3..8)) {
        // Driven slowly from corner to corner in separation and sliding, twice around the loop: the second round starts and
        // ends in the same state.
        let law = patch(Interaction::Full);
        let k = law.coefficients(45.0, 45.0, 1.0, 1.0);
        let slow = Parameters { c_n: 0.0, c_t: 0.0, ..k };
        let place = |(gap, slide): &(f64, Vec3<f64>)| Vec3::new(90.0 + gap, 8.0 * slide.0[1], 8.0 * slide.0[2]);
        let (mut spring, mut work) = (Vec3::zero(), 0.0);
        let (steps, mut energy) = (2000, 0.0);
        for round in 0..2 {
            if round == 1 {
                (work, energy) = (0.0, spring_energy(k.k_t, spring));
            }
            for n in 0..corners.len() {
                let (from, to) = (place(&corners[n]), place(&corners[(n + 1) % corners.len()]));
                let v = (to - from) * (1.0 / f64::from(steps));
                for step in 0..steps {
                    let x = from + v * (f64::from(step) + 0.5);
                    let outcome = slow.act(&Contact::new(x, v, Vec3::zero(), Vec3::zero(), 45.0, 45.0), spring, 1.0);
                    spring = outcome.memory;
                    work += outcome.wrench.force.dot(v);
                }
            }
        }
        let scale = k.k_n * k.delta_e * k.delta_f;
        prop_assert!(work + spring_energy(k.k_t, spring) - energy < 1e-3 * scale);
    }

    #[test]
    fn a_slow_pair_is_captured_and_a_fast_one_escapes(r in 20.0..70.0) {
        let end = |speed: f64| {
            let mut law = patch(Interaction::Normal);
            law.material.restitution = 0.5;
            let mut pair = Pair::new(law, r, 1.0, 0.0);
            let k = pair.coefficients();
            pair.x = [Vec3::new(r + 0.4999 * k.delta_f, 0.0, 0.0), Vec3::new(-r - 0.4999 * k.delta_f, 0.0, 0.0)];
            // In units of the velocity that the work of separation would give to a pair at rest.
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

/// Largest sliding velocity of a pair oscillating with small amplitude, relative to its initial value.
fn amplification(nu: f64, fraction_of_eq_6: f64) -> f64 {
    let mut law = patch(Interaction::Full);
    (law.material.poisson_ratio, law.material.restitution) = (nu, 1.0);
    let mut pair = Pair::new(law, 45.0, 1.0, -0.01);
    let start = 1e-9;
    pair.v = [Vec3::new(0.0, start, 0.0), Vec3::new(0.0, -start, 0.0)];
    let dt = fraction_of_eq_6 * critical_time_step(1.0, pair.coefficients().k_n);
    let sliding = |pair: &Pair| pair.contact().sliding_velocity(45.0, 45.0).norm();
    // The normal spring is at equilibrium: an overlap would push the pair apart.
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
        let [m_eff, sliding] = [1.0 / 2.0, 1.0 / 7.0];
        let three = [
            critical_time_step(1.0, k.k_n),
            stable_time_step(m_eff, k.k_n, k.c_n),
            stable_time_step(sliding, k.k_t, k.c_t),
        ];
        assert_eq!(limit, three.into_iter().fold(f64::INFINITY, f64::min));
        // undamped, the limits along the normal are one; a dashpot lowers its own, and sliding is the tightest below one sixth
        assert_eq!(three[0] == three[1], eta == 1.0);
        assert_eq!(limit == three[2], nu < 1.0 / 6.0, "{nu} {eta} {three:?}");
    }
}

#[test]
fn a_pair_acts_up_to_its_fracture_separation_and_a_stretched_spring_may_be_forgotten() {
    let (keeps, r_i, r_j) = (patch(Interaction::Full), 30.0, 50.0);
    let mut forgets = keeps;
    forgets.material.forget_stretched_springs = true;
    let k = keeps.coefficients(r_i, r_j, 2.0, 3.0);
    assert_eq!(keeps.range(r_i, r_j), r_i + r_j + k.delta_f);
    let (none, spring) = (Vec3::zero(), Vec3::new(0.0, 0.3, 0.4));
    let losses = |slip: f64| Losses { normal_damping: 0.0, tangential_damping: 0.0, slip };
    for (gap, forgotten) in [(0.5 * k.delta_f, true), (1e-3, true), (0.0, false), (-1.0, false)] {
        let c = Contact::new(Vec3::new(r_i + r_j + gap, 0.0, 0.0), none, none, none, r_i, r_j);
        assert_eq!(keeps.relisted(&c, &k, spring), (spring, losses(0.0)));
        let expected = if forgotten { (none, losses(spring_energy(k.k_t, spring))) } else { (spring, losses(0.0)) };
        assert_eq!(forgets.relisted(&c, &k, spring), expected);
    }
}
