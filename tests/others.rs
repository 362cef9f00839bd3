//! Values that other projects publish with their tests, computed with these laws. Each is compared to the digits in which it is printed, or to a
//! bound with its reason. The documentation of a test names the source, and in its last line the equations; the book shows it with them.

use std::f64::consts::PI;
use veridem::geometry::Sphere;
use veridem::geometry::capacity::capacity;
use veridem::interrupt::Interrupt;
use veridem::random::Stream;
use veridem::spec::mechanics::four_springs::{Friction, Memory, Order, Springs};
use veridem::spec::mechanics::friction::spring_with_friction;
use veridem::spec::mechanics::kick_and_drift::{drift, kick};
use veridem::spec::mechanics::primary_particle::solid_inertia;
use veridem::spec::mechanics::rotated_spring::rotated_spring;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::mechanics::verlet::{verlet_begin, verlet_end};
use veridem::spec::soot::eq18_hamaker::{hamaker_energy, hamaker_force};
use veridem::spec::soot::eq21_hamaker_plane::{plane_energy, plane_force};
use veridem::spec::soot::{Along, Attraction, Coefficients, SUBSTRATE, Soot, Wall};
use veridem::spec::wear::def_contact::Parameters;
use veridem::spec::{Contact, PairModel, Touch, Vec3, Wrench};

const NO_SPRINGS: Springs<f64> =
    Springs { k_n: 0.0, k_t: 0.0, k_r: 0.0, k_o: 0.0, eta_n: 0.0, eta_t: 0.0, eta_r: 0.0, eta_o: 0.0 };
const UP: Vec3<f64> = Vec3([0.0, 0.0, 1.0]);

/// Friction of spheres and walls, with `mu` of sliding, rolling and torsion, and no attraction.
fn rough(contact: Springs<f64>, mu: [f64; 3]) -> Soot {
    let friction = Friction::from_ratio(mu, 1.0);
    let wall = Wall { contact, friction, hamaker: 0.0, delta_0: 1.0, cutoff: 10.0 };
    let attraction = Attraction { a: 0.0, delta_0: 1.0, psi: 0.0, kappa: 1.0, d_cutoff: 10.0, cutoff: 10.0 };
    Soot { neck: contact, contact, friction, attraction, reading: Along, walls: [wall; 2] }
}

#[track_caller]
fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "found {found}, expected {expected}");
}

/// The dashpot of a spring that reverses a mass with a restitution `e`.
fn dashpot(m: f64, k: f64, e: f64) -> f64 {
    -2.0 * e.ln() * (m * k / (PI * PI + e.ln() * e.ln())).sqrt()
}

/// MercuryDPM, `Drivers/SelfTests/Interactions/TorsionFrictionSelfTest`: a sphere twists between two fixed ones.
///
/// Equations: `soot-contact`, `soot-10`, `soot-12`, `soot-17`.
#[test]
fn torsion_slips_swings_and_decays_as_in_mercury_dpm() {
    let (k, eta, dt) = (12496.0268, 17.83375, 4e-4);
    let law = rough(Springs { k_n: k, k_o: 0.4 * k, eta_o: 0.4 * eta, ..NO_SPRINGS }, [0.0, 0.0, 0.1]);
    let (mut omega, mut memory, mut torques) = (UP, Memory::zero(), vec![]);
    for step in 0..=480 {
        let contact = Contact::new(UP * 0.995, Vec3::zero(), Vec3::zero(), omega, 0.5, 0.5);
        let outcome = law.pair(&contact, &Coefficients { bonded: 0.0 }, memory, dt);
        memory = outcome.memory;
        torques.push(outcome.wrench.torque_i.0[2]);
        // From both neighbours; the spin is one at the start, so the first kick lasts half a step.
        let kicked = if step == 0 { 0.5 * dt } else { dt };
        omega = kick(omega, outcome.wrench.torque_j * 2.0, solid_inertia(1.0, 0.5), kicked);
    }
    for (step, printed) in [(1, 2.7622), (40, 3.05719), (80, -1.99477), (480, -0.11824)] {
        near(torques[step], printed, 5e-6);
    }
}

/// 4C, unit tests of `particle_interaction_dem_contact_tangential`.
///
/// Equations: `soot-rotated`, `soot-12`, `soot-13`, `soot-17`.
#[test]
fn a_tangential_spring_turns_sticks_and_slips_as_in_4c() {
    let n = Vec3([1.0, 2.0, 4.0]) * (1.0 / 21f64.sqrt());
    let (rate, k, eta) = (Vec3([-0.03, 0.1, 0.12]), 3.0, 0.4480966430480714);
    let turned = rotated_spring(Vec3([0.1, 0.05, -0.25]), n);
    let (.., sticking, _) = spring_with_friction(turned, rate, k, eta, 0.2, 0.2, 1e3);
    let (slips, .., slipping, left) = spring_with_friction(turned, rate, k, eta, 0.2, 0.2, 1.5);
    assert_eq!(slips, 1.0);
    for (found, printed) in [
        (turned, [0.17923102017884, 0.16378007016342, -0.12669779012642]),
        (sticking, [0.52425016124507, 0.53614987479507, -0.32632177321349]),
        (slipping, [0.19231710945136, 0.19668242716113, -0.11970861396859]),
        (left, [0.068586669580933, 0.050624254285441, -0.057826737044788]),
    ] {
        assert!((found - Vec3(printed)).norm() < 1e-14, "{found:?} {printed:?}");
    }
}

/// azplugins, `test_pair.py` and `test_wall.py`: the attraction of its colloids, whose weak repulsion, of other physics, changes the fifth digit for two spheres and the fourth for the plane (its force: the third).
///
/// Equations: `soot-18`, `soot-hamaker-force`, `soot-21`, `soot-22`.
#[test]
fn spheres_and_planes_attract_as_in_azplugins() {
    near(-hamaker_energy(1.5, 0.75, 0.75, 100.0), 1.26583, 1e-4);
    near(hamaker_force(1.5, 0.75, 0.75, 100.0), 4.1279, 1e-4);
    near(-plane_energy(0.75, 2.25, 100.0), 0.374977848076, 5e-4);
    near(plane_force(0.75, 2.25, 100.0), 0.394551653468, 2e-3);
}

/// LAMMPS, `unittest/granular/tests/dem01-hooke-twosphere-e08-3d-si.yaml`: the dashpot may pull.
///
/// Equations: `wear-contact`, `wear-2`, `wear-3`, `mechanics-kick`, `mechanics-drift`.
#[test]
fn two_spheres_rebound_as_in_lammps() {
    let (r, k, dt) = (0.0025, 1e6, 3e-8);
    let m = sphere_mass(2700.0, r);
    let law =
        Parameters { k_n: k, c_n: dashpot(0.5 * m, k, 0.8), k_t: 0.0, delta_e: 0.0, delta_f: 0.0, f_mt: 0.0, c_t: 0.0 };
    let (mut x, mut v) = (UP * 0.00255, UP * -2.0);
    for _ in 0..2068 {
        // By symmetry: the other sphere is the mirror image.
        let contact = Contact::new(x * 2.0, v * 2.0, Vec3::zero(), Vec3::zero(), r, r);
        v = kick(v, law.act(&contact, Vec3::zero(), dt).wrench.force, m, dt);
        x = drift(x, v, dt);
    }
    near(v.0[2], 1.5997548989987018, 1e-14);
    near(x.0[2], 2.5118996608531133e-3, 1e-14);
}

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

/// ZENO, validation of version 5: the capacity of touching spheres of radii 1 and 1/4 in radii of the larger.
///
/// Equations: `titania-capacity`, `titania-return`, `titania-return-cosine`.
#[test]
fn a_small_sphere_on_a_large_one_adds_to_its_capacity_as_in_zeno() {
    let at = |x: f64, radius: f64| Sphere { centre: Vec3([x, 0.0, 0.0]), radius };
    let spheres = [at(0.0, 1.0), at(1.25, 0.25)];
    let [found, deviation] = capacity(&spheres, 200_000, &mut Stream::new(7, "others"), &Interrupt::default()).unwrap();
    assert!((found - 1.01992).abs() < 4.0 * deviation && deviation < 2e-3, "{found} +- {deviation}");
}

/// The pair tests of ON-DEM, the European network on the discrete element method (working group 4, testingInteractions): two fixed spheres of radius 1
/// overlap by 0.05 and turn so that their surfaces slide at a given velocity. Returns the friction on the first after each of 200 steps, and the torques.
fn sheared(
    whole: Vec3<f64>,
    branch: impl Fn(f64) -> Vec3<f64>,
    slide: impl Fn(f64) -> Vec3<f64>,
) -> Vec<(Vec3<f64>, Wrench<f64>)> {
    let law = rough(Springs { k_n: 1e7, k_t: 5e6, ..NO_SPRINGS }, [0.5, 0.0, 0.0]);
    let mut memory = Memory::zero();
    let one = |step: usize| {
        let t = step as f64 * DT;
        let n = branch(t);
        // Both spheres turn alike: their surfaces meet at twice the arm.
        let spin = whole + n.cross(slide(t)) * (1.0 / 1.95);
        let x = n * 1.95;
        let contact = Contact::new(x, whole.cross(x), spin, spin, 1.0, 1.0);
        let outcome = law.pair(&contact, &Coefficients { bonded: 0.0 }, memory, DT);
        memory = outcome.memory;
        (outcome.wrench.force.perpendicular_to(n), outcome.wrench)
    };
    (1..=200).map(one).collect()
}

const DT: f64 = 6.0 * PI / 200.0;
const X: Vec3<f64> = Vec3([1.0, 0.0, 0.0]);
/// Where the friction of half the normal force of 5e5 N ends.
const SLIP: f64 = 2.5e5;

fn largest(forces: &[(Vec3<f64>, Wrench<f64>)]) -> f64 {
    forces.iter().map(|(force, _)| force.norm()).fold(0.0, f64::max)
}

/// ON-DEM, `testingInteractions`, tests 1 and 2. The reference counts the sliding of one surface; here both together slide at that velocity.
///
/// Equations: `soot-contact`, `soot-8`, `soot-12`, `soot-17`.
#[test]
fn a_sheared_contact_is_elastic_and_then_slips_as_in_on_dem() {
    let swing = |amplitude: f64| sheared(Vec3::zero(), |_| UP, move |t: f64| X * (amplitude * t.sin()));
    let elastic = swing(0.02);
    near(elastic[0].0.norm(), 886.949957289513, 1e-12);
    near(elastic[0].1.torque_i.norm(), 864.7762083572752, 1e-12);
    near(elastic[1].0.norm(), 2652.9772412570437, 1e-12);
    near(largest(&elastic), 199950.64629463377, 1e-12);
    assert_eq!(elastic[0].1.torque_i, elastic[0].1.torque_j);
    near(largest(&swing(0.08)), SLIP, 1e-12);
}

/// ON-DEM, `testingInteractions`, test 3: the pair turns about the direction of shear, and the friction stays along it.
///
/// Equations: `soot-contact`, `soot-8`, `soot-rotated`, `soot-12`, `soot-17`.
#[test]
fn friction_across_the_plane_in_which_a_pair_turns_grows_as_in_on_dem() {
    let turning = sheared(X, |t| Vec3([0.0, -t.sin(), t.cos()]), |_| X * 0.02);
    for (step, (force, _)) in turning.iter().enumerate() {
        let expected = (5e6 * 0.02 * DT * (step + 1) as f64).min(SLIP);
        near(force.0[0].abs(), expected, 1e-12);
        near(force.norm(), expected, 1e-12);
    }
}

/// ON-DEM, `testingInteractions`, test 4: the pair spins about its normal. The springs of the papers stay fixed in space and are relaxed after each turn; an objective law, as that of the
/// network, slips from t = 2.5 on.
///
/// Equations: `soot-contact`, `soot-8`, `soot-rotated`, `soot-12`.
#[test]
fn springs_do_not_follow_a_pair_that_spins_about_its_normal_unlike_in_on_dem() {
    let spinning = sheared(UP, |_| UP, |t| Vec3([t.cos(), t.sin(), 0.0]) * 0.02);
    for (step, (force, _)) in spinning.iter().enumerate() {
        // The sum of the steps of 2e5 |sin(t / 2)|.
        let t = DT * (step + 1) as f64;
        let expected = 1e5 * DT * (0.5 * t).sin().abs() / (0.5 * DT).sin();
        assert!((force.norm() - expected).abs() < 1e-12 * SLIP, "{step}: {force:?} {expected}");
    }
    assert!(largest(&spinning) < 0.81 * SLIP);
}
