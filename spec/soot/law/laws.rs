//! Laws of the composed contact law, with every element alone and together, in motion.

mod encounters;
mod reach;
mod spheres;

use super::*;
use crate::mechanics::pair_frequency::neck_frequencies;
use crate::mechanics::samples::{unit, vector};
use crate::numbers::{Dual, Lanes};
use proptest::prelude::*;
use spheres::Spheres;

const UNDAMPED: Springs<f64> =
    Springs { k_n: 100.0, k_t: 70.0, k_r: 30.0, k_o: 40.0, eta_n: 0.0, eta_t: 0.0, eta_r: 0.0, eta_o: 0.0 };
const DAMPED: Springs<f64> = Springs { eta_n: 0.5, eta_t: 0.4, eta_r: 0.1, eta_o: 0.1, ..UNDAMPED };
const ROUGH: Friction<f64> =
    Friction { static_t: 0.5, static_r: 0.1, static_o: 0.1, dynamic_t: 0.4, dynamic_r: 0.1, dynamic_o: 0.1 };
/// Nothing acts at a distance.
const NONE: Attraction<f64> = Attraction { a: 0.0, delta_0: 0.1, psi: 0.0, kappa: 3.0, d_cutoff: 3.0, cutoff: 6.0 };
const ATTRACTION: Attraction<f64> = Attraction { a: 0.5, psi: 0.2, ..NONE };

fn law(springs: Springs<f64>, attraction: Attraction<f64>) -> Soot {
    let wall = Wall { contact: springs, friction: ROUGH, hamaker: 2.0, delta_0: 0.1, cutoff: 4.0 };
    Soot { neck: springs, contact: springs, friction: ROUGH, attraction, reading: Along, walls: [wall; 2] }
}
/// The same with springs read otherwise.
fn read<S>(Soot { neck, contact, friction, attraction, walls, .. }: Soot, reading: S) -> Soot<S> {
    Soot { neck, contact, friction, attraction, reading, walls }
}
fn memory() -> impl Strategy<Value = Memory<f64>> {
    (vector(), vector(), -1.0..1.0, -0.2..0.2).prop_map(|(tangential, rolling, torsion, rest)| Memory {
        tangential,
        rolling,
        torsion,
        rest,
    })
}
fn along(x: f64) -> Vec3<f64> {
    Vec3::new(x, 0.0, 0.0)
}
fn dimer<S: Reading>(law: Soot<S>, bonded: f64, gap: f64) -> Spheres<2, S> {
    Spheres::new(law, bonded, [along(0.0), along(2.0 + gap)])
}

fn only_numbers<S: Reading>(law: Soot<S>, c: &Contact<f64>, memory: Memory<f64, S::Torsion<f64>>, dt: f64) {
    for bonded in [0.0, 1.0] {
        let k = Coefficients { bonded };
        let SpringsOutcome { wrench, memory, losses } = law.pair(c, &k, memory, dt);
        let stored = law.stored(c, &k, &memory);
        let vectors = [wrench.force, wrench.torque_i, wrench.torque_j].into_iter().flat_map(|v| v.0);
        let remembered = (0..<Soot<S> as PairModel>::Memory::<f64>::LEN).map(|k| *memory.at(k));
        let energies = (0..5).map(|k| *losses.at(k)).chain((0..7).map(|k| *stored.at(k)));
        assert!(vectors.chain(remembered).chain(energies).all(f64::is_finite));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn no_pair_gives_anything_but_numbers(
        gap in prop_oneof![-0.5..5.0f64, Just(0.0), Just(1e6)], v in vector(), omega in vector(), memory in memory(), dt in 0.0..1.0,
    ) {
        let nothing = Springs::from_fn(|_| 0.0);
        let c = Contact::new(along(2.0 + gap), v, omega, -omega, 1.0, 1.0);
        for law in [UNDAMPED, DAMPED, nothing].map(|springs| law(springs, ATTRACTION)) {
            for memory in [memory, Memory::zero()] {
                only_numbers(law, &c, memory, dt);
                let Memory { tangential, rolling, torsion, rest } = memory;
                let turned = Memory { tangential, rolling, torsion: c.n * torsion + rolling, rest };
                only_numbers(read(law, Printed), &c, turned, dt);
                only_numbers(read(law, Programmed), &c, turned, dt);
            }
        }
    }

    #[test]
    fn eight_lanes_have_the_bits_of_eight_numbers(
        gaps in prop::array::uniform8(-0.3..5.0), v in vector(), omega in vector(), memory in memory(),
    ) {
        let law = law(DAMPED, ATTRACTION);
        let bonded = |lane: usize| (lane % 2) as f64;
        let lift = |f: &dyn Fn(usize) -> f64| Lanes(std::array::from_fn::<f64, 8, _>(f));
        let constant = |v: Vec3<f64>| Vec3(v.0.map(|x| Lanes([x; 8])));
        let x = Vec3(std::array::from_fn(|a| lift(&|lane| [0.6, 0.0, 0.8][a] * (2.0 + gaps[lane]))));
        let c = Contact::new(x, constant(v), constant(omega), constant(-omega), Lanes([1.0; 8]), Lanes([1.0; 8]));
        let remembered = Memory::from_fn(|k| Lanes([*memory.at(k); 8]));
        let lanes = law.pair(&c, &Coefficients { bonded: lift(&bonded) }, remembered, Lanes([0.1; 8]));
        for (lane, gap) in gaps.iter().enumerate() {
            let x = Vec3::new(0.6 * (2.0 + gap), 0.0, 0.8 * (2.0 + gap));
            let one = law.pair(&Contact::new(x, v, omega, -omega, 1.0, 1.0), &Coefficients { bonded: bonded(lane) }, memory, 0.1);
            for a in 0..3 {
                prop_assert_eq!(one.wrench.force.0[a].to_bits(), lanes.wrench.force.0[a].0[lane].to_bits());
                prop_assert_eq!(one.wrench.torque_i.0[a].to_bits(), lanes.wrench.torque_i.0[a].0[lane].to_bits());
            }
            for k in 0..8 {
                prop_assert_eq!(one.memory.at(k).to_bits(), lanes.memory.at(k).0[lane].to_bits());
            }
        }
    }

    #[test]
    fn without_a_neck_nothing_acts_beyond_the_range(n in unit(), beyond in 1e-9..1e3, v in vector(), memory in memory()) {
        for attraction in [ATTRACTION, NONE] {
            let law = law(DAMPED, attraction);
            let c = Contact::new(n * (law.range(1.0, 1.0) + beyond), v, v, v, 1.0, 1.0);
            let evaluate = law.pair(&c, &Coefficients { bonded: 0.0 }, memory, 0.1);
            prop_assert_eq!((evaluate.wrench.force.norm(), evaluate.memory), (0.0, Memory::zero()));
            let neck = law.pair(&c, &Coefficients { bonded: 1.0 }, memory, 0.1);
            prop_assert!(neck.wrench.force.norm() > 0.0);
        }
    }

    #[test]
    fn a_neck_a_contact_and_attraction_alone_and_together_keep_energy_momentum_and_angular_momentum(
        element in 0..4usize, v in prop::array::uniform3(vector()), omega in prop::array::uniform3(vector()),
    ) {
        // Three spheres in a bent chain: necks, contacts without friction limits and dashpots, attraction, all of it.
        let (bonded, springs, attraction) = [(1.0, UNDAMPED, NONE), (0.0, UNDAMPED, NONE), (0.0, Springs::from_fn(|_| 0.0), ATTRACTION), (1.0, UNDAMPED, ATTRACTION)][element];
        let friction = Friction::from_ratio([1e9; 3], 1.0);
        // Without springs the spheres must not fall through each other.
        let gap = if element == 2 { 1.5 } else { 0.0 };
        let places = [along(0.0), along(2.0 + gap), Vec3::new(2.0 + gap, 2.0 + gap, 0.0)];
        let mut spheres = Spheres::new(Soot { friction, ..law(springs, attraction) }, bonded, places);
        (spheres.v, spheres.omega) = (v.map(|v| v * 0.03), omega.map(|omega| omega * 0.03));
        let dt = 5e-4;
        spheres.start(dt);
        let (energy, momentum, angular_momentum) = (spheres.energy(), spheres.momentum(), spheres.angular_momentum());
        let mut scale: f64 = 0.0;
        for _ in 0..4000 {
            spheres.step(dt);
            scale = scale.max(spheres.energy().abs());
        }
        prop_assert!((spheres.momentum() - momentum).norm() < 1e-12);
        prop_assert!((spheres.angular_momentum() - angular_momentum).norm() < 1e-10);
        // Kinetic energy is taken half a step behind: an error of first order in the step, times the largest frequency.
        prop_assert!((spheres.energy() + spheres.lost - energy).abs() < 0.03 * scale + 1e-6);
    }

    #[test]
    fn a_neck_is_stressed_by_what_it_does_to_its_spheres(n in unit(), gap in -0.3..0.3, rest in -0.2..0.2, spring in vector(), rolling in vector(), torsion in -1.0..1.0) {
        let (law, still) = (law(UNDAMPED, NONE), Vec3::zero());
        let c = Contact::new(n * (2.0 + gap), still, still, still, 1.0, 1.0);
        let (tangential, rolling) = (spring.perpendicular_to(n), rolling.perpendicular_to(n));
        fn differ<S: Reading>(law: Soot<S>, c: &Contact<f64>, memory: Memory<f64, S::Torsion<f64>>) -> f64 {
            let wrench = law.pair(c, &Coefficients { bonded: 1.0 }, memory, 1e-3).wrench;
            // Opposite rotations of equal spheres bend and twist the neck; equal rotations balance the transverse force.
            let moment = (wrench.torque_i - wrench.torque_j) * 0.5;
            let (pull, across) = (-wrench.force.dot(c.n), wrench.force.perpendicular_to(c.n));
            let (expected, found) = (neck_stress(pull, across, moment, c.n, 0.3), law.neck_stress(c, &memory, 0.3));
            (expected.0 - found.0).abs().max((expected.1 - found.1).abs())
        }
        let (along, in_plane) =
            (Memory { tangential, rolling, torsion, rest }, Memory { tangential, rolling, torsion: rolling * torsion, rest });
        prop_assert!(differ(law, &c, along) < 1e-9);
        prop_assert!(differ(read(law, Printed), &c, in_plane) < 1e-9);
    }

    #[test]
    fn an_oblique_encounter_accounts_for_its_energy(speed in 0.1..0.5f64, aim in -1.0..1.0, spin in vector()) {
        let mut pair = dimer(law(DAMPED, NONE), 0.0, 0.0);
        let velocity = Vec3::new(speed, aim * speed, 0.0);
        (pair.v, pair.omega) = ([velocity, -velocity], [spin * speed, spin * (-0.5 * speed)]);
        let dt = 2e-5;
        pair.start(dt);
        let (energy, angular_momentum) = (pair.energy(), pair.angular_momentum());
        pair.step(dt);
        while pair.gap() < 0.0 {
            pair.step(dt);
        }
        pair.step(dt);
        prop_assert!((pair.angular_momentum() - angular_momentum).norm() < 1e-11);
        prop_assert!(pair.lost > 0.0);
        prop_assert!((pair.energy() + pair.lost - energy).abs() < 2e-3 * energy);
    }

    #[test]
    fn attraction_draws_two_spheres_together_as_their_potential_says(gap in 0.3..1.5, a in 0.1..2.0, psi in 0.0..1.0) {
        let attraction = Attraction { a, psi, ..ATTRACTION };
        let mut pair = dimer(law(UNDAMPED, attraction), 0.0, gap);
        let dt = 1e-4;
        pair.start(dt);
        let energy = pair.energy();
        while pair.gap() > 0.05 {
            pair.step(dt);
        }
        let fallen = pair.v[1] - pair.v[0];
        prop_assert!(fallen.0[0] < 0.0);
        prop_assert!((pair.energy() - energy).abs() < 5e-3 * fallen.dot(fallen));
    }

    #[test]
    fn a_wall_attracts_with_the_slope_of_what_it_stores(gap in -0.2..2.0f64) {
        let wall = law(UNDAMPED, NONE).walls[SUBSTRATE];
        let (n, none) = (Vec3::new(0.0, 0.0, 1.0), Vec3::zero());
        let touch = Touch { n, gap, v: none, omega: none, r: 1.0 };
        let force = wall.evaluate(Order::StretchFirst, &touch, Memory::<f64>::zero(), 0.1).wrench.force.0[2] - wall.pull(gap, 1.0);
        let (gap, r) = (Dual::variable(gap), Dual::constant(1.0));
        let slope = wall.stored(gap, &Memory::<_>::zero())[0].slope + wall.energy(gap, r).slope;
        prop_assert!((force + slope).abs() < 1e-10 * (1.0 + force.abs()));
        prop_assert_eq!(wall.energy(3.0, 1.0), 0.0);
    }
}

/// Angular frequency of the coordinate `of` in a motion, from the times at which it changes sign.
fn frequency(mut pair: Spheres<2>, of: impl Fn(&Spheres<2>) -> f64) -> f64 {
    let (dt, mut crossings, mut before) = (1e-4, vec![], 0.0);
    pair.start(dt);
    for n in 0..200_000 {
        pair.step(dt);
        let now = of(&pair);
        if before * now < 0.0 {
            crossings.push((f64::from(n) + before / (before - now)) * dt);
        }
        before = now;
    }
    std::f64::consts::PI * (crossings.len() - 1) as f64 / (crossings.last().unwrap() - crossings[0])
}

#[test]
fn a_kicked_neck_oscillates_with_the_frequency_of_its_spring() {
    let (n, t, r, o) =
        neck_frequencies(UNDAMPED.k_n, UNDAMPED.k_t, UNDAMPED.k_r, UNDAMPED.k_o, 1.0, spheres::INERTIA, 1.0);
    let kick = 1e-6;
    let start = |v: Vec3<f64>, omega_i: Vec3<f64>, omega_j: Vec3<f64>| {
        let mut pair = dimer(law(UNDAMPED, NONE), 1.0, 0.0);
        (pair.v, pair.omega) = ([-v, v], [omega_i, omega_j]);
        pair
    };
    let (none, side) = (Vec3::zero(), Vec3::new(0.0, 0.0, kick));
    let near =
        |measured: f64, expected: f64| assert!((measured / expected - 1.0).abs() < 1e-3, "{measured} {expected}");
    near(frequency(start(along(kick), none, none), |pair| pair.gap()), n);
    // Equal spins alone: the pair as a whole does not turn in the mean, for its angular momentum is undone by the velocities.
    let balanced = Vec3::new(0.0, -0.4 * kick, 0.0);
    near(
        frequency(start(balanced, side, side), |pair| {
            pair.springs[2].tangential.norm() * pair.springs[2].tangential.0[1].signum()
        }),
        t,
    );
    near(frequency(start(none, side, -side), |pair| pair.springs[2].rolling.0[1]), r);
    near(frequency(start(none, along(kick), along(-kick)), |pair| pair.springs[2].torsion), o);
}

/// Relative spin after a twist, along the normal and across: the pair lies along `n` and turns about `turning`.
fn after_a_twist<S: Reading>(law: Soot<S>, n: Vec3<f64>, turning: Vec3<f64>) -> (f64, f64) {
    let mut pair: Spheres<2, S> = Spheres::new(law, 1.0, [-n, n]);
    (pair.v, pair.omega) = ([turning.cross(-n), turning.cross(n)], [n * 1e-3 + turning, n * -1e-3 + turning]);
    for _ in 0..10_000 {
        pair.step(1e-4);
    }
    let n = pair.contact(1, 0).n;
    let spin = pair.omega[0] - pair.omega[1];
    (spin.dot(n), spin.perpendicular_to(n).norm())
}

#[test]
fn a_twist_meets_no_lasting_resistance_as_published_and_bends_a_pair_that_turns() {
    let law = law(UNDAMPED, NONE);
    let (still, slow, quick) = (Vec3::zero(), Vec3::new(0.0, 1e-4, 0.0), Vec3::new(0.0, 1e-3, 0.0));
    assert!((after_a_twist(law, along(1.0), still).0 - 2e-3).abs() > 1e-6);
    assert!((after_a_twist(read(law, Programmed), along(1.0), still).0 - 2e-3).abs() < 1e-12);
    // The rate at which the pair rotates determines where it is bent, not how much.
    let [bent, more] = [slow, quick].map(|turning| after_a_twist(read(law, Programmed), along(1.0), turning).1);
    assert!((more / bent - 1.0).abs() < 0.01);
    assert!(after_a_twist(law, along(1.0), quick).1 < 0.02 * bent);
}

#[test]
fn a_neck_that_acts_before_it_is_stretched_gains_what_a_negative_dashpot_gives() {
    let (dt, omega_r) = (1e-3, (2.0 * UNDAMPED.k_r / spheres::INERTIA).sqrt());
    fn largest<S: Reading>(reading: S, dt: f64, period: f64) -> (f64, f64) {
        let mut pair = dimer(read(law(UNDAMPED, NONE), reading), 1.0, 0.0);
        pair.omega = [Vec3::new(0.0, 1e-6, 0.0), Vec3::new(0.0, -1e-6, 0.0)];
        let energy = pair.energy();
        for _ in 0..2000 {
            pair.step(dt);
        }
        // Over the last period.
        let mut spin: f64 = 0.0;
        for _ in 0..(period / dt) as usize {
            pair.step(dt);
            spin = spin.max(pair.omega[0].norm() * 1e6);
        }
        (spin, (pair.energy() + pair.lost) / energy)
    }
    let period = std::f64::consts::TAU / omega_r;
    let time = 2.0 + period;
    let (spin, energy) = largest(Programmed, dt, period);
    assert!((spin.ln() / (0.5 * omega_r * omega_r * dt * time) - 1.0).abs() < 0.1, "{spin}");
    assert!((energy - 1.0).abs() < 0.05, "{energy}");
    assert!((largest(Along, dt, period).0 - 1.0).abs() < 0.02);
}

#[test]
fn a_neck_that_acts_before_it_is_stretched_rolls_ever_faster_above_its_limit() {
    let law = read(law(Springs { eta_o: 0.4, ..DAMPED }, NONE), Programmed);
    let limit = law.critical_time_step(1.0, 1.0);
    let spin = |fraction: f64| {
        let mut pair = dimer(law, 1.0, 0.0);
        pair.omega = [Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, -1.0, 0.0)].map(|omega| omega * 1e-6);
        (0..8000).for_each(|_| pair.step(fraction * limit));
        let last = (0..200).map(|_| {
            pair.step(fraction * limit);
            pair.omega[0].norm() * 1e6
        });
        last.fold(0.0, f64::max)
    };
    assert!(spin(0.5) < 0.5 && spin(1.5) > 10.0);
}

#[test]
fn a_neck_is_stable_below_the_critical_time_step_and_not_above() {
    for (springs, other) in [
        (UNDAMPED, 1.0),
        (DAMPED, 1.0),
        (Springs { eta_t: 20.0, ..UNDAMPED }, 1.0),
        (Springs { k_r: 70.0, ..UNDAMPED }, 3.0),
        (Springs { k_r: 70.0, eta_t: 0.2, eta_r: 0.5, ..UNDAMPED }, 3.0),
    ] {
        let law = law(springs, NONE);
        let limit = law.critical_time_step_among(1.0, 1.0, other);
        let grows = |dt: f64| {
            let mut pair = dimer(law, 1.0, other - 1.0);
            pair.radii[1] = other;
            (pair.v, pair.omega) = (
                [Vec3::new(-1e-9, 1e-9, 0.0), Vec3::new(1e-9, -1e-9, 0.0)],
                [Vec3::new(2e-9, 3e-9, 1e-9), Vec3::zero()],
            );
            (0..400).for_each(|_| pair.step(dt));
            pair.energy().is_nan() || pair.energy() > 1e-14
        };
        assert!(!grows(0.98 * limit), "{springs:?} {other}");
        assert!(grows(1.02 * limit), "{springs:?} {other}");
    }
}

#[test]
fn a_neck_twice_as_strong_bears_twice_the_stresses_and_four_times_the_energy() {
    let strength = Strength { energy: Some(5.0), stress: Some([7.0, 11.0, 3.0]) };
    assert_eq!(strength.times(2.0), Strength { energy: Some(20.0), stress: Some([14.0, 22.0, 3.0]) });
    assert_eq!(Strength::default().times(2.0), Strength::default());
}
