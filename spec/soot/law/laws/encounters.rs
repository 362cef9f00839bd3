//! Encounters with closed forms, of spheres of any size and mass with each other and with planes: what Chung & Ooi (2011, tests 3 and 6 to 8) and MFiX (DEM01 to 03) ask
//! of a contact, in the form that holds for linear springs.

use super::super::*;
use super::{NONE, law};
use crate::mechanics::primary_particle::solid_inertia;
use crate::mechanics::verlet::half_step;
use proptest::prelude::*;

/// A solid sphere.
struct Sphere {
    r: f64,
    m: f64,
    x: Vec3<f64>,
    v: Vec3<f64>,
    omega: Vec3<f64>,
}

/// Spheres between planes that face along z, under gravity.
struct Encounter {
    law: Soot,
    spheres: Vec<Sphere>,
    /// Height, and one for a floor, minus one for a ceiling.
    planes: Vec<(f64, f64)>,
    gravity: f64,
    memory: Vec<Memory<f64>>,
}

const UP: Vec3<f64> = Vec3([0.0, 0.0, 1.0]);
const K: f64 = 1e4;

/// Contacts of one stiffness and damping that resist sliding alone.
fn smooth(eta: f64, mu: f64) -> Soot {
    let springs = Springs { k_n: K, k_t: K, k_r: 0.0, k_o: 0.0, eta_n: eta, eta_t: eta, eta_r: 0.0, eta_o: 0.0 };
    let mut law = law(springs, NONE);
    law.friction = Friction::from_ratio([mu, 0.0, 0.0], 1.0);
    law.walls.iter_mut().for_each(|wall| wall.friction = law.friction);
    law
}

fn sphere(r: f64, m: f64, z: f64, v_z: f64) -> Sphere {
    Sphere { r, m, x: UP * z, v: UP * v_z, omega: Vec3::zero() }
}

impl Encounter {
    fn new(law: Soot, spheres: Vec<Sphere>, planes: Vec<(f64, f64)>) -> Self {
        let memory = vec![Memory::zero(); spheres.len() * (spheres.len() + planes.len())];
        Self { law, spheres, planes, gravity: 0.0, memory }
    }

    /// Steps of `dt`, up to a time.
    fn run(&mut self, time: f64, dt: f64) -> &mut Self {
        (0..(time / dt).round() as usize).for_each(|_| self.step(dt));
        self
    }

    fn step(&mut self, dt: f64) {
        let mut loads: Vec<_> = self.spheres.iter().map(|s| (UP * (-s.m * self.gravity), Vec3::zero())).collect();
        let mut add = |k: usize, force: Vec3<f64>, torque: Vec3<f64>| {
            loads[k] = (loads[k].0 + force, loads[k].1 + torque);
        };
        let mut memory = self.memory.iter_mut();
        for (i, a) in self.spheres.iter().enumerate() {
            for (j, b) in self.spheres[..i].iter().enumerate() {
                let contact = Contact::new(a.x - b.x, a.v - b.v, a.omega, b.omega, a.r, b.r);
                let memory = memory.next().unwrap();
                let evaluate = self.law.pair(&contact, &Coefficients { bonded: 0.0 }, *memory, dt);
                *memory = evaluate.memory;
                add(i, evaluate.wrench.force, evaluate.wrench.torque_i);
                add(j, -evaluate.wrench.force, evaluate.wrench.torque_j);
            }
            for &(height, facing) in &self.planes {
                let gap = facing * (a.x.0[2] - height) - a.r;
                let touch = Touch { n: UP * facing, gap, v: a.v, omega: a.omega, r: a.r };
                let memory = memory.next().unwrap();
                let evaluate = self.law.walls[SUBSTRATE].evaluate(Order::StretchFirst, &touch, *memory, dt);
                *memory = evaluate.memory;
                add(i, evaluate.wrench.force, evaluate.wrench.torque_i);
            }
        }
        for (s, (force, torque)) in self.spheres.iter_mut().zip(loads) {
            (s.v, s.x, s.omega) = half_step(s.x, s.v, s.omega, force, torque, s.m, solid_inertia(s.m, s.r), dt);
        }
    }
}

/// Decay rate and frequency of a contact of reduced mass `m`, how long it lasts until it would pull, and the restitution it then has.
fn impact(eta: f64, m: f64) -> (f64, f64, f64, f64) {
    let beta = 0.5 * eta / m;
    let omega = (K / m - beta * beta).sqrt();
    let time = (std::f64::consts::PI - (2.0 * beta * omega).atan2(omega * omega - beta * beta)) / omega;
    (beta, omega, time, (-beta * time).exp())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn a_damped_impact_on_a_plane_has_the_restitution_of_the_closed_form(eta in 0.0..120.0f64, m in 0.5..2.0f64, speed in 0.1..1.0f64) {
        // Test 3: from 1 down to a fifth.
        let (.., time, restitution) = impact(eta, m);
        let mut ball = Encounter::new(smooth(eta, 0.0), vec![sphere(1.0, m, 1.0, -speed)], vec![(0.0, 1.0)]);
        ball.run(2.0 * time, 1e-6);
        prop_assert!((ball.spheres[0].v.0[2] / speed - restitution).abs() < 1e-3);
    }

    #[test]
    fn a_dropped_sphere_falls_sinks_in_and_rises_as_the_closed_form_says(eta in 0.0..60.0f64, height in 0.2..1.0f64) {
        // DEM01: y'' + 2 beta y' + K y = -g within the contact; m = 1.
        let (g, dt) = (10.0, 1e-6);
        let mut ball = Encounter::new(smooth(eta, 0.0), vec![sphere(1.0, 1.0, 1.0 + height, 0.0)], vec![(0.0, 1.0)]);
        ball.gravity = g;
        let (fall, speed) = ((2.0 * height / g).sqrt(), (2.0 * g * height).sqrt());
        ball.run(0.5 * fall, dt);
        prop_assert!((ball.spheres[0].x.0[2] - 1.0 - 0.75 * height).abs() < 1e-5);
        let (beta, omega, time, _) = impact(eta, 1.0);
        ball.run(0.5 * fall, dt).run(0.5 * time, dt);
        let (rest, t) = (g / K, 0.5 * time);
        let swing = rest * (omega * t).cos() + (beta * rest - speed) / omega * (omega * t).sin();
        prop_assert!((ball.spheres[0].x.0[2] - 1.0 + rest - (-beta * t).exp() * swing).abs() < 2e-5);
    }

    #[test]
    fn bounces_rise_less_each_time_by_the_square_of_the_restitution(eta in 0.0..20.0) {
        // DEM02, with a weight that is small beside the force of the impact.
        let restitution = impact(eta, 1.0).3;
        let mut ball = Encounter::new(smooth(eta, 0.0), vec![sphere(1.0, 1.0, 1.5, 0.0)], vec![(0.0, 1.0)]);
        ball.gravity = 0.1;
        for bounce in 1..4 {
            while ball.spheres[0].x.0[2] >= 1.0 {
                ball.step(2e-5);
            }
            while ball.spheres[0].x.0[2] < 1.0 || ball.spheres[0].v.0[2] > 0.0 {
                ball.step(2e-5);
            }
            let expected = 0.5 * restitution.powi(2 * bounce);
            prop_assert!((ball.spheres[0].x.0[2] - 1.0 - expected).abs() < 0.03 * expected);
        }
    }

    #[test]
    fn two_spheres_clamped_between_planes_swing_in_their_two_modes(m in 0.5..2.0f64, g in 0.0..5.0) {
        // DEM03 with equal masses: both swing together with sqrt(K/m), and against each other with sqrt(3 K/m).
        let [low, high] = [0.9, 2.7];
        let mut pair = Encounter::new(smooth(0.0, 0.0), vec![sphere(1.0, m, low, 0.0), sphere(1.0, m, high, 0.0)], vec![(0.0, 1.0), (3.6, -1.0)]);
        pair.gravity = g;
        let (sag, omega) = (m * g / K, (K / m).sqrt());
        let t = 0.1;
        pair.run(t, 1e-6);
        let [a, b] = [0, 1].map(|k| pair.spheres[k].x.0[2]);
        // At rest the planes are a third of what is missing deep in the spheres: the spheres 28/15 apart, and lower by the sag.
        let (sum, difference) = (3.6 - 2.0 * sag * (1.0 - (omega * t).cos()), 28.0 / 15.0 + (1.8 - 28.0 / 15.0) * (3f64.sqrt() * omega * t).cos());
        prop_assert!((a + b - sum).abs() < 1e-4 && (b - a - difference).abs() < 1e-4, "{a} {b} {sum} {difference}");
    }

    #[test]
    fn opposite_spins_of_equal_spheres_leave_no_mark(eta in 0.0..60.0, speed in 0.1..0.5, spin in 0.1..3.0) {
        // Test 7: the surfaces meet at one velocity.
        let mut low = sphere(1.0, 1.0, 0.0, speed);
        let mut high = sphere(1.0, 1.0, 2.0, -speed);
        (low.omega, high.omega) = (Vec3([0.0, spin, 0.0]), Vec3([0.0, -spin, 0.0]));
        let mut pair = Encounter::new(smooth(eta, 0.4), vec![low, high], vec![]);
        let (.., time, restitution) = impact(eta, 0.5);
        pair.run(2.0 * time, 1e-6);
        for (sphere, spin, sign) in [(&pair.spheres[0], spin, -1.0), (&pair.spheres[1], -spin, 1.0)] {
            prop_assert_eq!((sphere.v.0[0], sphere.omega), (0.0, Vec3([0.0, spin, 0.0])));
            prop_assert!((sphere.v.0[2] - sign * restitution * speed).abs() < 1e-3 * speed);
        }
    }

    #[test]
    fn a_spinning_sphere_slides_on_a_plane_and_on_a_big_sphere_by_the_impulse_of_friction(
        eta in 0.0..60.0f64, mu in 0.05..0.2f64, speed in 0.1..0.3f64, on_sphere in any::<bool>(),
    ) {
        // Tests 6 and 8: the spin is fast enough that friction slides to the end, with mu times the normal impulse (1 + e) m v.
        let spin = 10.0 * speed;
        let mut ball = sphere(1.0, 1.0, 1.0, -speed);
        ball.omega = Vec3([0.0, spin, 0.0]);
        let big = sphere(5.0, 125_000.0, -5.0, 0.0);
        let (mut spheres, mut planes) = (vec![ball], vec![(0.0, 1.0)]);
        if on_sphere {
            (spheres, planes) = (vec![spheres.remove(0), big], vec![]);
        }
        let (.., time, restitution) = impact(eta, 1.0);
        let mut slide = Encounter::new(smooth(eta, mu), spheres, planes);
        slide.run(2.0 * time, 1e-6);
        let (ball, impulse) = (&slide.spheres[0], mu * (1.0 + restitution) * speed);
        prop_assert!((ball.v.0[2] - restitution * speed).abs() < 1e-3 * speed);
        prop_assert!((ball.v.0[0].abs() - impulse).abs() < 1e-2 * speed, "{:?} {impulse}", ball.v);
        prop_assert!((spin - ball.omega.0[1] - 2.5 * impulse).abs() < 5e-2 * speed);
    }
}
