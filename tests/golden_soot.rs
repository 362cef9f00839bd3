//! The golden trajectories of the soot paper: falls, necks, collisions, and what the cantilever reads.

use serde_json::Value;
use std::path::Path;
use veridem_spec::mechanics::contact_kinematics::ContactKinematics;
use veridem_spec::mechanics::four_springs::SpringsOutcome;
use veridem_spec::mechanics::four_springs::{Friction, Memory, Springs};
use veridem_spec::mechanics::primary_particle::solid_inertia;
use veridem_spec::mechanics::sphere::sphere_mass;
use veridem_spec::mechanics::verlet::{half_step, half_step_start};
use veridem_spec::soot::def_filter::filter_step;
use veridem_spec::soot::eq18_hamaker::{hamaker_energy, hamaker_force};
use veridem_spec::soot::eq21_hamaker_plane::{plane_energy, plane_force};
use veridem_spec::soot::eq25_tip::{tip_velocity, tip_way};
use veridem_spec::{Contact, Flat, Vec3};

fn runs(name: &str) -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/trajectories").join(name);
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(file["schema"], "veridem golden trajectories 1");
    file["runs"].as_array().unwrap().clone()
}
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a decimal"))
}
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().flat_map(|v| if v.is_array() { numbers(v) } else { vec![number(v)] }).collect()
}
fn samples(run: &Value) -> Vec<Vec<f64>> {
    run["samples"].as_array().unwrap().iter().map(numbers).collect()
}
fn assert_near(value: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((value - expected).abs() <= tolerance, "{what}: {value}, expected {expected} to {tolerance:e}");
}

#[test]
fn two_spheres_and_a_sphere_and_a_plane_fall_onto_each_other() {
    for run in runs("soot_falls.json") {
        let [r, a, rho, start] = ["r", "a", "rho", "delta_start"].map(|key| number(&run[key]));
        let what = run["name"].as_str().unwrap();
        let mass = sphere_mass(rho, r);
        // the gap closes with the acceleration of both spheres, or of one
        type Law = fn(f64, f64, f64) -> f64;
        let (energy, force, m): (Law, Law, f64) = match run["partner"].as_str() {
            Some("plane") => (plane_energy, plane_force, mass),
            _ => (|r, d, a| hamaker_energy(r, r, d, a), |r, d, a| hamaker_force(r, r, d, a), 0.5 * mass),
        };
        let at_start = energy(r, start, a);
        let (steps, total) = (200_000, number(&run["total_time"]));
        let dt = total / f64::from(steps);
        let (mut gap, mut speed, mut time) = (start, -0.5 * dt * force(r, start, a) / m, 0.0);
        for sample in samples(&run) {
            let by_energy = (2.0 * (at_start - energy(r, sample[0], a)) / m).sqrt();
            assert_near(by_energy, sample[2], 1e-13 * sample[2], what);
            while gap > sample[0] && time < total {
                speed += dt * force(r, gap, a) / m;
                gap -= dt * speed;
                time += dt;
            }
            // the last step may be too long by a step
            assert_near(time, sample[1], 1.5 * dt + 1e-8 * total, what);
        }
    }
}

/// Two solid spheres of unit mass and radius, moved by the four springs and the half-step scheme.
struct Pair {
    springs: Springs<f64>,
    friction: Friction<f64>,
    bonded: bool,
    x: [Vec3<f64>; 2],
    v: [Vec3<f64>; 2],
    omega: [Vec3<f64>; 2],
    memory: Memory<f64>,
}

impl Pair {
    fn new(run: &Value, bonded: bool, v: [Vec3<f64>; 2], omega: [Vec3<f64>; 2]) -> Self {
        // what a planar run does not have is nought
        let get = |key: &str| run.get(key).map_or(0.0, number);
        let springs = Springs {
            k_n: get("k_n"),
            k_t: get("k_t"),
            k_r: get("k_r"),
            k_o: get("k_o"),
            eta_n: get("eta_n"),
            eta_t: get("eta_t"),
            eta_r: get("eta_r"),
            eta_o: get("eta_o"),
        };
        let friction = Friction::from_ratio([get("mu_t"), get("mu_r"), get("mu_o")], 1.0);
        let x = [Vec3::zero(), Vec3::new(2.0, 0.0, 0.0)];
        Self { springs, friction, bonded, x, v, omega, memory: Memory::from_fn(|_| 0.0) }
    }
    fn act(&self, dt: f64) -> SpringsOutcome<f64> {
        let c = Contact::new(self.x[0] - self.x[1], self.v[0] - self.v[1], self.omega[0], self.omega[1], 1.0, 1.0);
        self.springs.evaluate(&self.friction, self.bonded, &ContactKinematics::of_spheres(&c), self.memory, dt)
    }
    fn start(&mut self, dt: f64) {
        let w = self.act(0.0).wrench;
        for (k, (force, torque)) in [(w.force, w.torque_i), (-w.force, w.torque_j)].into_iter().enumerate() {
            (self.v[k], self.omega[k]) =
                half_step_start(self.v[k], self.omega[k], force, torque, 1.0, solid_inertia(1.0, 1.0), dt);
        }
    }
    fn step(&mut self, dt: f64) {
        let SpringsOutcome { wrench: w, memory, .. } = self.act(dt);
        self.memory = memory;
        for (k, (force, torque)) in [(w.force, w.torque_i), (-w.force, w.torque_j)].into_iter().enumerate() {
            let (v, x, omega) =
                half_step(self.x[k], self.v[k], self.omega[k], force, torque, 1.0, solid_inertia(1.0, 1.0), dt);
            (self.v[k], self.x[k], self.omega[k]) = (v, x, omega);
        }
    }
    /// Steps of about `dt` from one sample to the next; before the comparison the velocities are brought to the time of the positions.
    fn follow(&mut self, samples: &[Vec<f64>], dt: f64, compare: impl Fn(&Self, &[f64])) {
        for window in samples.windows(2) {
            let time = window[1][0] - window[0][0];
            let steps = (time / dt).ceil();
            let dt = time / steps;
            self.start(dt);
            (0..steps as usize).for_each(|_| self.step(dt));
            self.start(-dt);
            compare(self, &window[1]);
        }
    }
    fn distance(&self) -> Vec3<f64> {
        self.x[1] - self.x[0]
    }
}

#[test]
fn a_kicked_neck_follows_the_planar_motion() {
    for run in runs("soot_necks.json") {
        let what = run["name"].as_str().unwrap();
        let (none, kick) = (Vec3::zero(), Vec3::new(0.0, number(&run["kick"]), 0.0));
        let mut pair = Pair::new(&run, true, [none, kick], [none, none]);
        pair.follow(&samples(&run), 2e-5, |pair, sample| {
            let n = pair.distance() * (1.0 / pair.distance().norm());
            let side = Vec3::new(-n.0[1], n.0[0], 0.0);
            let now = [
                pair.x[0].0[0],
                pair.x[0].0[1],
                pair.x[1].0[0],
                pair.x[1].0[1],
                pair.omega[0].0[2],
                pair.omega[1].0[2],
                pair.memory.tangential.dot(side),
                pair.memory.rolling.dot(side),
            ];
            // the first step stretches the springs by a step of the kick, which stays
            let tolerance = 5e-6;
            for (k, (now, expected)) in now.into_iter().zip(&sample[1..]).enumerate() {
                assert_near(now, *expected, tolerance, &format!("{what} column {} at {}", k + 1, sample[0]));
            }
        });
    }
}

#[test]
fn oblique_collisions_with_spin_follow_the_events_of_holding_and_slipping() {
    for run in runs("soot_oblique.json") {
        let what = run["name"].as_str().unwrap();
        let samples = samples(&run);
        let at = |sample: &[f64], k: usize| Vec3::new(sample[k], sample[k + 1], sample[k + 2]);
        let start = &samples[0];
        let mut pair = Pair::new(&run, false, [at(start, 4), at(start, 13)], [at(start, 7), at(start, 16)]);
        // the start is at first touch, where there is no force yet; friction is of first order in the step
        pair.follow(&samples, 1e-4, |pair, sample| {
            let state = [
                (pair.x[0], 1),
                (pair.v[0], 4),
                (pair.omega[0], 7),
                (pair.x[1], 10),
                (pair.v[1], 13),
                (pair.omega[1], 16),
                (pair.memory.tangential, 19),
                (pair.memory.rolling, 22),
            ];
            // at the end the springs are let go
            let compared = if sample[0] < 0.99 * number(&run["contact_time"]) { 8 } else { 6 };
            for (now, k) in state.into_iter().take(compared) {
                let error = (now - at(sample, k)).norm();
                assert!(error < 2e-5, "{what} column {k} at {}: {error:e}", sample[0]);
            }
            if compared == 8 {
                assert_near(pair.memory.torsion, sample[25], 2e-5, what);
            }
        });
        for _ in 0..30_000 {
            pair.step(1e-4);
        }
        let end = numbers(&run["final"]);
        for (now, k) in [(pair.v[0], 3), (pair.omega[0], 6), (pair.v[1], 12), (pair.omega[1], 15)] {
            let error = (now - at(&end, k)).norm();
            assert!(error < 2e-5, "{what} final {k}: {error:e}");
        }
    }
}

#[test]
fn planar_collisions_with_dashpots_slip_and_part_as_they_should() {
    for run in runs("soot_planar.json") {
        let what = run["name"].as_str().unwrap();
        let plane = |key: &str| {
            let v = numbers(&run[key]);
            Vec3::new(v[0], v[1], 0.0)
        };
        let spin = |key: &str| Vec3::new(0.0, 0.0, number(&run[key]));
        let mut pair = Pair::new(&run, false, [plane("v_i"), plane("v_j")], [spin("omega_i"), spin("omega_j")]);
        // an overlap below every other scale: the dashpots act from first touch on
        pair.x[1].0[0] -= 1e-12;
        pair.follow(&samples(&run), 2e-5, |pair, sample| {
            let n = pair.distance() * (1.0 / pair.distance().norm());
            let side = Vec3::new(-n.0[1], n.0[0], 0.0);
            let now = [
                pair.distance().norm(),
                (pair.v[1] - pair.v[0]).dot(n),
                pair.omega[0].0[2],
                pair.omega[1].0[2],
                pair.memory.tangential.dot(side),
                pair.memory.rolling.dot(side),
            ];
            for (k, (now, expected)) in now.into_iter().zip(&sample[1..]).enumerate() {
                assert_near(now, *expected, 5e-5, &format!("{what} column {} at {}", k + 1, sample[0]));
            }
        });
        (0..50_000).for_each(|_| pair.step(2e-5));
        let now =
            [pair.v[0].0[0], pair.v[0].0[1], pair.omega[0].0[2], pair.v[1].0[0], pair.v[1].0[1], pair.omega[1].0[2]];
        for (now, expected) in now.into_iter().zip(numbers(&run["final"])) {
            assert_near(now, expected, 2e-5, &format!("{what} final"));
        }
    }
}

#[test]
fn the_cantilever_reads_a_sawtooth_exactly() {
    let run = &runs("soot_filter.json")[0];
    let [omega_0, period, peak] = ["omega_0", "period", "peak"].map(|key| number(&run[key]));
    let (mut g, mut g_dot) = (0.0, 0.0);
    for window in samples(run).windows(2) {
        let dt = window[1][0] - window[0][0];
        // the force rises to the end of the interval, drop or not
        let rise = peak * dt / period;
        (g, g_dot) = filter_step(omega_0, dt, g, g_dot, window[0][1], window[0][1] + rise);
        assert_near(g, window[1][2], 1e-14 * peak, "reading");
    }
}

#[test]
fn the_tip_moves_as_the_equation_says() {
    for sample in samples(&runs("soot_tip.json")[0]) {
        let (rate, t_reversal) = (1e8, 1.08e-8);
        // the time of reversal is rounded, and so is its difference from the time
        assert_near(tip_velocity(sample[0], 1.5, rate, t_reversal), sample[1], 1e-15, "velocity");
        assert_near(tip_way(sample[0], 1.5, rate, t_reversal), sample[2], 1e-22, "way");
    }
}
