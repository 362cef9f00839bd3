//! Do two and three spheres move in the engine as the elementary validations of the soot paper (Section 3) ask: contact, neck and attraction,
//! each with its golden trajectory, under both ways to step?

mod common;

use common::soot::{dry, settings};
use serde_json::Value;
use std::path::Path;
use veridem::run::advance_until;
use veridem::simulation::{Integrator, Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::mechanics::four_springs::{Friction, Springs};
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::soot::Soot;
use veridem::system::{Domain, Particles, System};

fn runs(name: &str) -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/trajectories").join(name);
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    file["runs"].as_array().unwrap().clone()
}
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a decimal"))
}
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().flat_map(|v| if v.is_array() { numbers(v) } else { vec![number(v)] }).collect()
}
fn vector(numbers: &[f64], k: usize) -> Vec3<f64> {
    Vec3([numbers[k], numbers[k + 1], numbers[k + 2]])
}
/// What a run does not have is nought.
fn get(run: &Value, key: &str) -> f64 {
    run.get(key).map_or(0.0, number)
}

/// Springs and friction of a run for necks and contacts alike, and no attraction but that of its Hamaker constant.
fn law(run: &Value) -> Soot {
    let of = |key: &str| get(run, key);
    let springs = Springs {
        k_n: of("k_n"),
        k_t: of("k_t"),
        k_r: of("k_r"),
        k_o: of("k_o"),
        eta_n: of("eta_n"),
        eta_t: of("eta_t"),
        eta_r: of("eta_r"),
        eta_o: of("eta_o"),
    };
    let mut law = Soot { neck: springs, contact: springs, ..dry() };
    law.friction = Friction::from_ratio([of("mu_t"), of("mu_r"), of("mu_o")], 1.0);
    law.attraction.a = of("a");
    law
}

/// Spheres of one radius and mass in free space.
fn spheres(places: &[Vec3<f64>], radius: f64, mass: f64) -> System {
    let mut particles = Particles::default();
    places.iter().for_each(|&x| particles.push(x, radius, mass, 0));
    System::new(particles, Domain { sides: [20.0 * radius; 3], periodic: [false; 3] })
}

/// Two of unit mass and radius.
fn unit_pair(gap: f64) -> System {
    spheres(&[Vec3::zero(), Vec3([2.0 + gap, 0.0, 0.0])], 1.0, 1.0)
}

struct Motion {
    simulation: Simulation<Soot>,
    dt: f64,
}

impl Motion {
    fn new(law: Soot, system: System, integrator: Integrator, dt: f64) -> Self {
        let skin = 0.1 * system.particles.radius[0];
        let settings = Settings { integrator, skin, max_overlap: f64::INFINITY, ..settings(dt) };
        Self { simulation: Simulation::new(law, system, settings).expect("a stable step"), dt }
    }

    /// Goes on to a time; what is left to it is less than a step.
    fn until(&mut self, time: f64) -> f64 {
        let steps = (time / self.dt + 1e-9).floor() as u64;
        advance_until(&mut self.simulation, |now| now.system().step >= steps).expect("a stable step");
        time - steps as f64 * self.dt
    }

    /// Position, velocity and spin of a sphere, `late` after the last step.
    fn state(&self, id: u32, late: f64) -> [Vec3<f64>; 3] {
        let system = self.simulation.system();
        let (p, of) = (system.place(id), &system.particles);
        [of.x[p] + of.v[p] * late, of.v[p], of.w[p]]
    }

    fn assert_near(&self, late: f64, expected: &[(u32, [Option<Vec3<f64>>; 3])], tolerance: f64, what: &str) {
        for (id, values) in expected {
            for (k, (is, expected)) in self.state(*id, late).into_iter().zip(values).enumerate() {
                if let Some(expected) = expected {
                    let error = (is - *expected).norm();
                    assert!(error < tolerance, "{what}: number {k} of sphere {id}: {is:?}, expected {expected:?}");
                }
            }
        }
    }
}

const BOTH: [Integrator; 2] = [Integrator::HalfStep, Integrator::VelocityVerlet];

#[test]
fn a_kicked_neck_follows_its_golden_trajectory() {
    for (run, integrator) in runs("soot_necks.json").iter().flat_map(|run| BOTH.map(|i| (run, i))) {
        let mut system = unit_pair(0.0);
        system.necks = vec![(0, 1)];
        system.particles.v[1].0[1] = number(&run["kick"]);
        let mut motion = Motion::new(law(run), system, integrator, 1e-4);
        for sample in run["samples"].as_array().unwrap().iter().map(numbers) {
            let late = motion.until(sample[0]);
            let plane = |k: usize| Some(Vec3([sample[k], sample[k + 1], 0.0]));
            let spin = |k: usize| Some(Vec3([0.0, 0.0, sample[k]]));
            // First order where a dashpot sees the velocity of half a step before, and in the springs of the first step.
            let expected = [(0, [plane(1), None, spin(5)]), (1, [plane(3), None, spin(6)])];
            motion.assert_near(late, &expected, 2e-5, &format!("{} {integrator:?} at {}", run["name"], sample[0]));
        }
    }
}

#[test]
fn oblique_collisions_with_spin_follow_their_golden_trajectories() {
    for (run, integrator) in runs("soot_oblique.json").iter().flat_map(|run| BOTH.map(|i| (run, i))) {
        let samples: Vec<_> = run["samples"].as_array().unwrap().iter().map(numbers).collect();
        let mut system = unit_pair(0.0);
        let of = &mut system.particles;
        (of.v[0], of.w[0], of.v[1], of.w[1]) =
            (vector(&samples[0], 4), vector(&samples[0], 7), vector(&samples[0], 13), vector(&samples[0], 16));
        let mut motion = Motion::new(law(run), system, integrator, 1e-4);
        for sample in &samples {
            let late = motion.until(sample[0]);
            let at = |k: usize| Some(vector(sample, k));
            let expected = [(0, [at(1), at(4), at(7)]), (1, [at(10), at(13), at(16)])];
            // Velocities belong to half a step before, or friction is of first order.
            motion.assert_near(late, &expected, 1e-4, &format!("{} {integrator:?} at {}", run["name"], sample[0]));
        }
        motion.until(number(&run["contact_time"]) + 1.0);
        let end = numbers(&run["final"]);
        let at = |k: usize| Some(vector(&end, k));
        let expected = [(0, [None, at(3), at(6)]), (1, [None, at(12), at(15)])];
        motion.assert_near(0.0, &expected, 2e-5, &format!("{} {integrator:?} parted", run["name"]));
    }
}

#[test]
fn planar_collisions_with_dashpots_end_as_their_golden_trajectories() {
    for (run, integrator) in runs("soot_planar.json").iter().flat_map(|run| BOTH.map(|i| (run, i))) {
        let plane = |key: &str| {
            let v = numbers(&run[key]);
            Vec3([v[0], v[1], 0.0])
        };
        // An overlap below every other scale: the dashpots act from first touch on.
        let mut system = unit_pair(-1e-12);
        let of = &mut system.particles;
        (of.v[0], of.v[1]) = (plane("v_i"), plane("v_j"));
        (of.w[0].0[2], of.w[1].0[2]) = (number(&run["omega_i"]), number(&run["omega_j"]));
        let mut motion = Motion::new(law(run), system, integrator, 2e-5);
        motion.until(number(&run["contact_time"]) + 1.0);
        let end = numbers(&run["final"]);
        let of = |k: usize| [None, Some(Vec3([end[k], end[k + 1], 0.0])), Some(Vec3([0.0, 0.0, end[k + 2]]))];
        motion.assert_near(0.0, &[(0, of(0)), (1, of(3))], 2e-5, &format!("{} {integrator:?}", run["name"]));
    }
}

#[test]
fn three_spheres_in_a_triangle_fall_collide_and_vibrate_as_their_golden_trajectories() {
    // From SI to the units of the engine.
    const NANO: f64 = 1e9;
    let (radius, mass) = (14.0, sphere_mass(1.7e-3, 14.0));
    for (run, integrator) in runs("soot_triangles.json").iter().flat_map(|run| BOTH.map(|i| (run, i))) {
        let what = format!("{} {integrator:?}", run["name"]);
        let samples: Vec<_> = run["samples"].as_array().unwrap().iter().map(numbers).collect();
        let last = samples.last().expect("samples")[0] * NANO;
        let dt = last / 20_000.0;
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU / 3.0 * k as f64;
            Vec3([angle.cos(), angle.sin(), 0.0])
        };
        let from_centre = (2.0 * radius + NANO * get(run, "delta_start")) / 3f64.sqrt();
        let mut system = spheres(&[0, 1, 2].map(|k| corner(k) * from_centre), radius, mass);
        // The dashpots act from first touch on.
        system.particles.x.iter_mut().for_each(|x| *x = *x * (1.0 - 1e-14));
        for (k, v) in system.particles.v.iter_mut().enumerate() {
            *v = corner(k) * (-get(run, "speed") / 3f64.sqrt());
        }
        if what.contains("neck") {
            system.necks = vec![(0, 1), (0, 2), (1, 2)];
        }
        let mut law = law(run);
        for springs in [&mut law.neck, &mut law.contact] {
            (springs.k_n, springs.eta_n) = (springs.k_n * 1e3, springs.eta_n * 1e12);
        }
        law.attraction.a *= 1e21;
        let mut motion = Motion::new(law, system, integrator, dt);
        let sides = |motion: &Motion, late: f64| {
            let [a, b, c] = [0, 1, 2].map(|id| motion.state(id, late));
            let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| {
                let side = a[0] - b[0];
                (side.norm() - 2.0 * radius, (a[1] - b[1]).dot(side) / side.norm())
            });
            assert!(sides.iter().all(|side| (side.0 - sides[0].0).abs() < 1e-12 * radius), "{what}: {sides:?}");
            sides[0]
        };
        let most = |k: usize, unit: f64| samples.iter().map(|sample| unit * sample[k].abs()).fold(0.0, f64::max);
        let (way, speed) = (most(1, NANO), most(2, 1.0));
        for sample in &samples {
            let late = motion.until(NANO * sample[0]);
            let (gap, rate) = sides(&motion, late);
            assert!((gap - NANO * sample[1]).abs() < 5e-4 * way, "{what}: gap {gap} instead of {sample:?}");
            // Velocities half a step behind are wrong by as much as half a step of acceleration.
            assert!((rate - sample[2]).abs() < 2e-3 * speed, "{what}: rate {rate} instead of {sample:?}");
        }
        let of = &motion.simulation.system().particles;
        assert!(of.w.iter().all(|w| w.norm() < 1e-12), "{what} turns: {:?}", of.w);
    }
}
