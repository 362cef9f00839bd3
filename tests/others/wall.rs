//! A ball on a wall under gravity, which the engine does not have.

use super::{NO_SPRINGS, UP, dashpot, near, rough};
use veridem::spec::mechanics::drag::global_damping;
use veridem::spec::mechanics::four_springs::{Memory, Order, Springs};
use veridem::spec::mechanics::primary_particle::solid_inertia;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::mechanics::verlet::{verlet_begin, verlet_end};
use veridem::spec::soot::{SUBSTRATE, Wall};
use veridem::spec::{Touch, Vec3, Wrench};

/// A ball of 5 mm and 2700 kg/m³ on a wall, moved as LAMMPS moves it: velocity Verlet, springs not stretched before the first step.
struct Ball {
    wall: Wall,
    x: Vec3<f64>,
    v: Vec3<f64>,
    omega: Vec3<f64>,
    gravity: f64,
    memory: Memory<f64>,
    wrench: Wrench<f64>,
}

impl Ball {
    const R: f64 = 0.0025;

    fn new(contact: Springs<f64>, mu: [f64; 3], z: f64, v: [f64; 3], spin: f64, gravity: f64) -> Self {
        let wall = rough(contact, mu).walls[SUBSTRATE];
        let (x, omega) = (UP * z, Vec3([0.0, spin, 0.0]));
        let none = Wrench { force: Vec3::zero(), torque_i: Vec3::zero(), torque_j: Vec3::zero() };
        let mut ball = Self { wall, x, v: Vec3(v), omega, gravity, memory: Memory::zero(), wrench: none };
        ball.evaluate(0.0);
        ball
    }

    fn mass() -> f64 {
        sphere_mass(2700.0, Self::R)
    }

    fn evaluate(&mut self, dt: f64) {
        let touch = Touch { n: UP, gap: self.x.0[2] - Self::R, v: self.v, omega: self.omega, r: Self::R };
        let outcome = self.wall.evaluate(Order::StretchFirst, &touch, self.memory, dt);
        (self.memory, self.wrench) = (outcome.memory, outcome.wrench);
        self.wrench.force = self.wrench.force - UP * (Self::mass() * self.gravity);
    }

    fn run(&mut self, steps: usize, dt: f64) {
        let (m, i) = (Self::mass(), solid_inertia(Self::mass(), Self::R));
        for _ in 0..steps {
            let Wrench { force, torque_i, .. } = self.wrench;
            (self.v, self.x, self.omega) = verlet_begin(self.x, self.v, self.omega, force, torque_i, m, i, dt);
            self.evaluate(dt);
            (self.v, self.omega) = verlet_end(self.v, self.omega, self.wrench.force, self.wrench.torque_i, m, i, dt);
        }
    }
}

/// LAMMPS, `dem04-hookehistory-oblique-3d-si.yaml`. There the dashpot pulls at the end of the impact, and the arm of the friction is the radius, not
/// the distance from the contact: at the deepest, 0.4 % more.
///
/// Equations: `soot-wall`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn an_oblique_impact_ends_as_in_lammps() {
    let springs = Springs { k_n: 2e7, k_t: 5.7e6, eta_n: dashpot(Ball::mass(), 2e7, 0.98), ..NO_SPRINGS };
    let mut ball = Ball::new(springs, [0.092, 0.0, 0.0], 0.00255, [2.5069, 0.0, -2.9876], 0.0, 0.0);
    ball.run(1724 + 1133, 1e-8);
    near(ball.v.0[0], 1.9626463236052916, 1e-5);
    near(ball.v.0[2], 2.9278279037320356, 1e-4);
    near(ball.omega.0[1], 544.2536763947109, 4e-3);
}

/// LAMMPS, `dem05-hookehistory-slip-3d-si.yaml`. While the ball slides its velocity knows nothing of the arm; when it rolls the spring swings about 5/7 of the speed.
///
/// Equations: `soot-wall`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn a_ball_slips_until_it_rolls_as_in_lammps() {
    let springs = Springs { k_n: 1e4, k_t: 2.8e3, ..NO_SPRINGS };
    let mut ball = Ball::new(springs, [0.4, 0.0, 0.0], 0.002499982, [1.0, 0.0, 0.0], 0.0, 1.0);
    for (steps, v, spin, digits) in [
        (25_000, 0.9000013722713527, 99.99862772864624, 1e-12),
        (25_000, 0.8000030206974034, 199.99697930258714, 1e-12),
        (25_000, 0.7142403332603812, 285.7596667396157, 1e-4),
    ] {
        ball.run(steps, 1e-5);
        near(ball.v.0[0], v, digits);
        // The arm is shorter than the radius by 7e-6 of it.
        near(ball.omega.0[1], spin, digits.max(1e-5));
    }
}

/// LAMMPS, `dem07-rolling-mu02-3d-si.yaml`. There the ball lies on a soft Hertzian contact, whose load is the printed torque over `mu R`: 0.1 % more than the
/// weight, and less with time.
///
/// Equations: `soot-wall`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn rolling_resistance_brakes_a_ball_as_in_lammps() {
    let (springs, mu) = (Springs { k_n: 1e4, k_r: 1e4, ..NO_SPRINGS }, 0.2);
    let load = 8.845036537909259e-8 / (mu * Ball::R);
    let z = Ball::R - load / springs.k_n;
    let mut ball = Ball::new(springs, [0.0, mu, 0.0], z, [0.0; 3], 1.0, load / Ball::mass());
    for (steps, spin) in [(1000, 0.7999464224280581), (1500, 0.4996392223770553), (1500, 0.19936081024606936)] {
        ball.run(steps, 1e-6);
        assert!((ball.omega.0[1] - spin).abs() < 1e-4 * (1.0 - spin), "{:?} {spin}", ball.omega);
    }
}

/// LAMMPS, `dem05-sliptime-3d-si.yaml`: faster, so that the ball still slides at the end.
///
/// Equations: `soot-wall`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn a_fast_ball_still_slips_as_in_lammps() {
    let springs = Springs { k_n: 1e4, k_t: 2.8e3, ..NO_SPRINGS };
    let mut ball = Ball::new(springs, [0.4, 0.0, 0.0], 0.002499982, [1.4, 0.0, 0.0], 0.0, 1.0);
    for (steps, v, spin) in [
        (40_000, 1.2400019628833119, 159.998037116675),
        (30_000, 1.1200010578590238, 279.99894214094314),
        (30_000, 1.0000022220127893, 399.9977779871734),
    ] {
        ball.run(steps, 1e-5);
        near(ball.v.0[0], v, 1e-12);
        near(ball.omega.0[1], spin, 1e-5);
    }
}

/// LAMMPS, `dem07-hooke-rolling-3d-si.yaml`: on a contact of Hooke, on which the ball bounces by one part in seventy of its depth.
///
/// Equations: `soot-wall`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn rolling_resistance_on_a_linear_spring_brakes_a_ball_as_in_lammps() {
    let springs = Springs { k_n: 1e4, k_r: 1e4, ..NO_SPRINGS };
    let mut ball = Ball::new(springs, [0.0, 0.05, 0.0], 0.002499982, [0.0; 3], 1.0, 1.0);
    for (steps, z, torque, spin) in [
        (3000, 2.4999826039845e-3, 2.1745019375082365e-8, 0.8500928218789187),
        (4000, 2.4999825690977923e-3, 2.1788627759672385e-8, 0.6499413004479903),
        (3000, 2.4999820048911287e-3, 2.2493886089164878e-8, 0.5000467081209597),
    ] {
        ball.run(steps, 1e-6);
        near(ball.x.0[2], z, 1e-14);
        // The arm is shorter than the radius by 7e-6 of it.
        near(ball.wrench.torque_i.0[1], -torque, 1e-5);
        assert!((ball.omega.0[1] - spin).abs() < 1e-5 * (1.0 - spin), "{:?} {spin}", ball.omega);
    }
}

/// LAMMPS, `dem04-legacy-hookehistory-oblique-3d-si.yaml` and `dem04-legacy-hookehistory-grazing-3d-si.yaml`, with a dashpot beside the tangential spring. The arm is the radius there, as in the oblique impact.
///
/// Equations: `soot-wall`, `soot-12`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn damped_friction_turns_a_ball_as_in_lammps() {
    let eta_n = 4300.0 * Ball::mass();
    for (k_t, mu, v, steps, after, spin) in [
        (5.7e6, 0.092, [2.5069, 0.0, -2.9876], 2857, [1.9626080446272482, 2.928193430873338], 544.2919553727485),
        (
            2e7 * 2.0 / 7.0,
            0.5,
            [3.7839, 0.0, -0.94345],
            6400,
            [2.8497777743815123, 0.9246902718500019],
            934.1222256184888,
        ),
    ] {
        let springs = Springs { k_n: 2e7, k_t, eta_n, eta_t: 0.5 * eta_n, ..NO_SPRINGS };
        let mut ball = Ball::new(springs, [mu, 0.0, 0.0], 0.00255, v, 0.0, 0.0);
        ball.run(steps, 1e-8);
        near(ball.v.0[0], after[0], 1e-5);
        near(ball.v.0[2], after[1], 1e-4);
        near(ball.omega.0[1], spin, 4e-3);
    }
}

/// LAMMPS, `dem09-viscous-linear-3d-si.yaml`: a sphere falls in a drag, which takes the velocity in the middle of the step.
///
/// Equations: `wear-global-damping`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn a_sphere_sinks_as_in_lammps() {
    let (r, dt, gravity) = (5e-5, 1e-4, 9.81);
    let (m, none) = (sphere_mass(2000.0, r), Vec3::zero());
    let pulled = |v: Vec3<f64>| global_damping(1e-7, v) - UP * (m * gravity);
    let (mut x, mut v) = (UP * 0.008, none);
    for (steps, z, sinks) in
        [(500, 3.925313960138311e-3, 0.10188257919450797), (300, 8.517476626774392e-4, 0.102682435639419)]
    {
        // A run begins with the force at the full velocity.
        let mut force = pulled(v);
        for _ in 0..steps {
            let (half, next, _) = verlet_begin(x, v, none, force, none, m, solid_inertia(m, r), dt);
            force = pulled(half);
            (x, v) = (next, verlet_end(half, none, force, none, m, solid_inertia(m, r), dt).0);
        }
        near(x.0[2], z, 1e-12);
        near(v.0[2], -sinks, 1e-12);
    }
}
