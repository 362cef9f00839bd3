//! The golden vectors and trajectories of `golden/`: what the equations and the contact law are compared with.

use serde_json::Value;
use std::path::{Path, PathBuf};
use veridem::golden::{check, documented, file_of, read};
use veridem_spec::mechanics::symplectic_euler::symplectic_euler;
use veridem_spec::mechanics::virial::pair_stress;
use veridem_spec::numbers::Reference;
use veridem_spec::wear::a04_time_step::kick_and_drift;
use veridem_spec::wear::a35_impact::{impact_separation, impact_velocity};
use veridem_spec::wear::def_contact::Parameters;
use veridem_spec::wear::eq03_normal_force::normal_force;
use veridem_spec::wear::eq07_normal_stiffness::normal_stiffness;
use veridem_spec::wear::eq08_tangential_stiffness::tangential_stiffness;
use veridem_spec::wear::eq15_normal_cross_section::normal_cross_section;
use veridem_spec::wear::eq16_tangential_cross_section::tangential_cross_section;
use veridem_spec::{Contact, Real, Vec3};

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

#[test]
fn the_vectors_of_every_equation_hold() {
    let wrong: Vec<String> =
        documented().unwrap().iter().flat_map(|(e, document)| check(&golden(), e, document)).collect();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn no_file_of_vectors_is_without_an_equation() {
    let documented = documented().unwrap();
    let known: Vec<PathBuf> = documented.iter().map(|(equation, _)| file_of(&golden(), equation)).collect();
    for paper in veridem_spec::papers() {
        for entry in std::fs::read_dir(golden().join(paper.name)).unwrap() {
            let path = entry.unwrap().path();
            assert!(known.contains(&path), "{}", path.display());
        }
    }
}

#[test]
fn a_wrong_digit_in_a_vector_is_noticed() {
    let (equation, document) = documented().unwrap().into_iter().find(|(equation, _)| equation.id == "wear-7").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = file_of(folder.path(), &equation);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    let text = std::fs::read_to_string(file_of(&golden(), &equation)).unwrap();
    std::fs::write(&path, &text).unwrap();
    assert_eq!(check(folder.path(), &equation, &document), Vec::<String>::new());
    let digits = read(folder.path(), &equation).unwrap().vectors[0].out["k_n"].as_str().unwrap().to_string();
    let other = if digits.ends_with('1') { "2" } else { "1" };
    let end = digits.find('e').unwrap_or(digits.len());
    let changed = format!("{}{other}{}", &digits[..end - 1], &digits[end..]);
    std::fs::write(&path, text.replacen(&digits, &changed, 1)).unwrap();
    assert_eq!(check(folder.path(), &equation, &document).len(), 1);
}

/// The runs of a file of trajectories.
fn runs(name: &str) -> Vec<Value> {
    let text = std::fs::read_to_string(golden().join("trajectories").join(name)).unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(file["schema"], "veridem golden trajectories 1");
    file["runs"].as_array().unwrap().clone()
}

/// A number, or a decimal or fraction as text.
fn exact(value: &Value) -> Reference {
    let part = |text: &str| Reference::parse(text).expect("a decimal");
    match (value.as_f64(), value.as_str().and_then(|text| text.split_once('/'))) {
        (Some(number), _) => Reference::exact(number),
        (None, Some((numerator, denominator))) => part(numerator) / part(denominator),
        (None, None) => part(value.as_str().expect("a decimal")),
    }
}
fn number(value: &Value) -> f64 {
    exact(value).to_f64()
}
fn samples(run: &Value) -> Vec<Vec<f64>> {
    let row = |row: &Value| row.as_array().unwrap().iter().map(number).collect();
    run["samples"].as_array().unwrap().iter().map(row).collect()
}
fn assert_near(value: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((value - expected).abs() <= tolerance, "{what}: {value}, expected {expected} to {tolerance:e}");
}

#[test]
fn the_integrator_follows_the_exact_map_below_at_and_above_its_limit() {
    for run in runs("euler.json") {
        let h = exact(&run["h"]);
        let one = Reference::exact(1.0);
        // the start is one step before the first sample, undone exactly: x_0 = x_1 - h v_1, v_0 = v_1 + h x_0
        let first = run["samples"][0].as_array().unwrap();
        let (x_1, v_1) = (exact(&first[1]), exact(&first[2]));
        let mut x = x_1 - h * v_1;
        let mut v = v_1 + h * x;
        let (mut position, mut velocity) = (Vec3::new(x.to_f64(), 0.0, 0.0), Vec3::new(v.to_f64(), 0.0, 0.0));
        let mut n = 0;
        for sample in run["samples"].as_array().unwrap() {
            while n < sample[0].as_u64().unwrap() {
                (v, x) = kick_and_drift(one, one, h, x, v);
                let (none, dt) = (Vec3::zero(), h.to_f64());
                (velocity, position, _) = symplectic_euler(position, velocity, none, -position, none, 1.0, 1.0, dt);
                n += 1;
            }
            let size = (x.squared() + v.squared()).sqrt();
            for (value, double, column) in [(x, position.0[0], 1), (v, velocity.0[0], 2)] {
                let expected = exact(&sample[column]);
                // the file has 25 digits
                assert!((value - expected).abs().le(size * Reference::exact(1e-23)), "{} step {n}", run["name"]);
                // a step makes a few roundings, and the norm may grow 199-fold between its least and its largest
                let tolerance = 4.0 * 199.0 * n as f64 * f64::EPSILON * size.to_f64();
                assert_near(double, expected.to_f64(), tolerance, &format!("{} step {n}", run["name"]));
            }
        }
    }
}

/// Two spheres on a line, moved by the contact law and Eq. 1.
struct Pair {
    law: Parameters<f64>,
    masses: [f64; 2],
    x: [Vec3<f64>; 2],
    v: [Vec3<f64>; 2],
    lost: f64,
}

const RADIUS: f64 = 10.0;

impl Pair {
    /// Surfaces `gap` apart, `i` moving with `v_i` and `j` with `v_j` along the normal, which is the x axis.
    fn new(law: Parameters<f64>, masses: [f64; 2], gap: f64, v_i: f64, v_j: f64) -> Self {
        let along = |x| Vec3::new(x, 0.0, 0.0);
        Self { law, masses, x: [along(2.0 * RADIUS + gap), along(0.0)], v: [along(v_i), along(v_j)], lost: 0.0 }
    }
    fn gap(&self) -> f64 {
        (self.x[0] - self.x[1]).0[0] - 2.0 * RADIUS
    }
    fn speed(&self) -> f64 {
        (self.v[0] - self.v[1]).0[0]
    }
    fn step(&mut self, dt: f64) {
        let none = Vec3::zero();
        let contact = Contact::new(self.x[0] - self.x[1], self.v[0] - self.v[1], none, none, RADIUS, RADIUS);
        let outcome = self.law.act(&contact, none, dt);
        self.lost += outcome.losses.normal_damping;
        for (k, force) in [outcome.wrench.force, -outcome.wrench.force].into_iter().enumerate() {
            (self.v[k], self.x[k], _) =
                symplectic_euler(self.x[k], self.v[k], none, force, none, self.masses[k], 1.0, dt);
        }
    }
    /// Steps to each time of the samples in turn and compares separation and relative velocity. The scheme is of first order:
    /// it is at most a step of the fastest motion ahead or behind.
    fn follow(&mut self, samples: &[Vec<f64>], what: &str) {
        let m_eff = self.masses[0] * self.masses[1] / (self.masses[0] + self.masses[1]);
        let fastest = samples.iter().map(|sample| sample[2].abs()).fold(0.0, f64::max);
        let steps = 4000;
        for window in samples.windows(2) {
            let dt = (window[1][0] - window[0][0]) / f64::from(steps);
            (0..steps).for_each(|_| self.step(dt));
            let per_time = (self.law.k_n / m_eff).sqrt() + self.law.c_n / m_eff;
            assert_near(self.gap(), window[1][1], dt * fastest, what);
            assert_near(self.speed(), window[1][2], dt * fastest * per_time.max(per_time * per_time), what);
        }
    }
}

const NO_LAW: Parameters<f64> =
    Parameters { k_n: 0.0, k_t: 0.0, delta_e: 0.0, delta_f: 0.0, f_mt: 0.0, c_n: 0.0, c_t: 0.0 };

#[test]
fn collisions_follow_the_closed_form() {
    for run in runs("collisions.json") {
        let what = run["name"].as_str().unwrap();
        let get = |key: &str| number(&run[key]);
        let (masses, v_0, m_eff) =
            ([get("m_i"), get("m_j")], get("v0"), get("m_i") * get("m_j") / (get("m_i") + get("m_j")));
        let law = Parameters { k_n: get("k_n"), c_n: get("c_n"), ..NO_LAW };
        let samples = samples(&run);
        for sample in &samples {
            let (t, scale) = (sample[0], 8.0 * f64::EPSILON);
            let x = impact_separation(law.k_n, m_eff, law.c_n, -v_0, t);
            let v = impact_velocity(law.k_n, m_eff, law.c_n, -v_0, t);
            assert_near(x, sample[1], scale * get("max_overlap"), what);
            assert_near(v, sample[2], scale * v_0, what);
            let force = Contact::new(
                Vec3::new(2.0 * RADIUS + x, 0.0, 0.0),
                Vec3::new(v, 0.0, 0.0),
                Vec3::zero(),
                Vec3::zero(),
                RADIUS,
                RADIUS,
            );
            // the separation is the difference of the distance and the radii
            let lost = 4.0 * RADIUS * f64::EPSILON * law.k_n;
            let acts = law.act(&force, Vec3::zero(), 0.0).wrench.force.0[0];
            assert_near(acts, sample[5], lost + 8.0 * f64::EPSILON, what);
        }
        let mut pair = Pair::new(law, masses, 0.0, samples[0][3], samples[0][4]);
        pair.follow(&samples, what);
        // a first-order scheme of 32 000 steps
        assert_near(pair.speed() / v_0, get("restitution"), 1e-3, what);
        assert_near(pair.lost, get("energy_lost"), 1e-3 * (0.5 * m_eff * v_0 * v_0), what);
    }
}

#[test]
fn passages_follow_the_closed_form() {
    for run in runs("passages.json") {
        let what = run["name"].as_str().unwrap();
        let get = |key: &str| number(&run[key]);
        let (v_0, mass) = (get("v0"), 2.0 * get("m_eff"));
        let law =
            Parameters { k_n: get("k_n"), c_n: get("c_n"), delta_e: get("delta_e"), delta_f: get("delta_f"), ..NO_LAW };
        let mut pair = Pair::new(law, [mass, mass], law.delta_f, -0.5 * v_0, 0.5 * v_0);
        let samples = samples(&run);
        pair.follow(&samples, what);
        while pair.gap() <= law.delta_f {
            pair.step(1e-5);
        }
        assert_near(pair.speed(), get("exit_v"), 1e-3, what);
    }
}

#[test]
fn a_slow_pull_follows_the_curve_and_a_closed_loop_does_no_work() {
    let run = &runs("quasistatic_loop.json")[0];
    let get = |key: &str| number(&run[key]);
    let (k_n, delta_e, delta_f) = (get("k_n"), get("delta_e"), get("delta_f"));
    let force = |hundredths: f64| normal_force(k_n, delta_e, delta_f, hundredths / 100.0);
    let samples = samples(run);
    for sample in &samples {
        assert_near(force(sample[0]), sample[1], 2.0 * f64::EPSILON, "force");
    }
    // trapezoids are exact between corners
    let work = |path: &mut dyn Iterator<Item = f64>| {
        let forces: Vec<f64> = path.map(force).collect();
        forces.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]) * 0.01).sum::<f64>()
    };
    let out = work(&mut samples.iter().map(|sample| sample[0]));
    let back = work(&mut samples.iter().rev().map(|sample| sample[0]));
    assert_near(out, get("work_outward"), 100.0 * f64::EPSILON, "work outward");
    assert_near(out - back, 0.0, 100.0 * f64::EPSILON, "loop");
}

#[test]
fn sliding_and_parting_in_turn_follows_the_exact_path() {
    let run = &runs("tangential_path.json")[0];
    let get = |key: &str| number(&run[key]);
    let delta_f = get("delta_f");
    let law = Parameters { k_t: get("k_t"), f_mt: get("f_mt"), delta_e: delta_f, delta_f, ..NO_LAW };
    let (mut s, mut spring) = (0.0, Vec3::zero());
    for sample in samples(run) {
        // one step of unit time in which j slides by the change of s
        let slide = Vec3::new(0.0, sample[0] - s, 0.0);
        let apart = Vec3::new(2.0 * RADIUS + sample[1], 0.0, 0.0);
        let outcome = law.act(&Contact::new(apart, slide, Vec3::zero(), Vec3::zero(), RADIUS, RADIUS), spring, 1.0);
        (s, spring) = (sample[0], outcome.memory);
        // the separation is the difference of the distance and the radii, divided by delta_f in the cap
        let tolerance = 64.0 * RADIUS * f64::EPSILON;
        assert_near(spring.0[1], sample[2], tolerance, &format!("spring at {sample:?}"));
        assert_near(-outcome.wrench.force.0[1], sample[4], tolerance, &format!("force at {sample:?}"));
    }
}

/// Directions to the twelve neighbours of the two particles of a cell, and whether the neighbour is the other one.
fn neighbours(lattice: &str) -> [Vec<(Vec3<f64>, bool)>; 2] {
    let polar = |degrees: f64, radius: f64, z: f64| {
        let angle = degrees.to_radians();
        Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
    };
    if lattice == "hcp" {
        let of = |first: f64| {
            let layer = (0..6).map(|k| (polar(60.0 * f64::from(k), 1.0, 0.0), false));
            let beyond = [1.0, -1.0].into_iter().flat_map(|side| (0..3).map(move |k| (120.0 * f64::from(k), side)));
            let hollow =
                beyond.map(|(turn, side)| (polar(first + turn, (1f64 / 3.0).sqrt(), side * (2f64 / 3.0).sqrt()), true));
            layer.chain(hollow).collect()
        };
        [of(90.0), of(270.0)]
    } else {
        let corners =
            [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|pair| pair.map(|x: f64| x / 2f64.sqrt()));
        let faces =
            corners.iter().flat_map(|[a, b]| [Vec3::new(*a, *b, 0.0), Vec3::new(*a, 0.0, *b), Vec3::new(0.0, *a, *b)]);
        let all: Vec<_> = faces.map(|n| (n, false)).collect();
        [all.clone(), all]
    }
}

#[test]
fn close_packed_lattices_have_the_stiffness_of_linear_algebra() {
    for run in runs("lattice.json") {
        let lattice = neighbours(run["lattice"].as_str().unwrap());
        let relaxed = run["relaxed"].as_bool().unwrap();
        for sample in samples(&run) {
            let (nu, e, r) = (sample[0], 1.0, 1.0);
            let law = Parameters {
                k_n: normal_stiffness(normal_cross_section(r, nu), e, r, r),
                k_t: tangential_stiffness(tangential_cross_section(r, nu), e, r, r),
                delta_e: 1.0,
                delta_f: 1.0,
                f_mt: 1e3,
                ..NO_LAW
            };
            // stress of a small strain, the second particle of each cell moved by `shift` along y; and the force on the first along y
            let respond = |strain: [f64; 3], shift: f64| {
                let (mut stress, mut pull) = ([0.0; 3], 0.0);
                for (particle, around) in lattice.iter().enumerate() {
                    for (to, other) in around {
                        let moved = Vec3(std::array::from_fn(|k| 2.0 * strain[k] * to.0[k]));
                        let side = if particle == 0 { shift } else { -shift };
                        let moved = moved + Vec3::new(0.0, if *other { side } else { 0.0 }, 0.0);
                        // the force on i of a neighbour j towards `to`; the response is linear, so directions stay those at rest
                        let (n, none) = (-*to, Vec3::zero());
                        let at = Contact { gap: moved.dot(*to), ..Contact::new(n * 2.0, none, none, none, r, r) };
                        let force = law.act(&at, (-moved).perpendicular_to(n), 0.0).wrench.force;
                        // every pair is seen from both its particles; the cell of two has twice the volume 4 sqrt(2) r^3
                        let share = pair_stress(2.0 * (8.0 * 2f64.sqrt()), *to * 2.0, force);
                        (0..3).for_each(|k| stress[k] += share[k].0[k]);
                        pull += if particle == 0 { force.0[1] } else { 0.0 };
                    }
                }
                (stress, pull)
            };
            let relax = |strain: [f64; 3]| {
                let stiffness = respond([0.0; 3], 1.0).1;
                let shift = if relaxed { -respond(strain, 0.0).1 / stiffness } else { 0.0 };
                respond(strain, shift).0
            };
            let (along_y, along_z) = (relax([0.0, 1e-3, 0.0]), relax([0.0, 0.0, 1e-3]));
            let stiffness = [along_y[1], along_y[0], along_y[2], along_z[2]].map(|stress| stress / 1e-3);
            for (value, expected) in stiffness.into_iter().zip(&sample[1..]) {
                assert_near(value, *expected, 1e-12, &format!("{} nu = {nu}", run["name"]));
            }
        }
    }
}
