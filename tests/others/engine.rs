//! The cases of LAMMPS without gravity through the engine: forces, neighbours, contacts and integration as in a run.

use super::{NO_SPRINGS, dashpot, near, rough};
use std::f64::consts::PI;
use veridem::run::advance;
use veridem::simulation::{Integrator, Settings, Simulation};
use veridem::spec::mechanics::four_springs::Springs;
use veridem::spec::mechanics::reduced_mass::effective_mass;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::soot::SUBSTRATE;
use veridem::spec::wear::{Interaction, Material, Wear};
use veridem::spec::{PairModel, Vec3};
use veridem::system::{Domain, Particles, PrescribedMotion, Shape, Surface, System};

/// A sphere: place, velocity, spin, radius, mass.
type Sphere = ([f64; 3], [f64; 3], [f64; 3], f64, f64);

fn system(spheres: &[Sphere], side: f64) -> System {
    let mut particles = Particles::default();
    for &(x, v, w, r, m) in spheres {
        particles.push(Vec3(x), r, m, 0);
        let last = particles.len() - 1;
        (particles.v[last], particles.w[last]) = (Vec3(v), Vec3(w));
    }
    System::new(particles, Domain { sides: [side; 3], periodic: [false; 3] })
}

/// The particles after some steps of the velocity Verlet method.
fn after<M: PairModel>(law: M, system: System, steps: u64, dt: f64) -> Particles {
    let settings = Settings::new(dt).integrator(Integrator::VelocityVerlet).synchronous_start();
    let mut simulation = Simulation::new(law, system, settings).expect("a stable step");
    advance(&mut simulation, steps).expect("a stable step");
    simulation.system().particles.clone()
}

/// LAMMPS, `unittest/granular/tests`: `dem01-hooke-twosphere` with restitutions of 0.8 and 0.5, `dem01-hooke-veldamp`, `dem01-hooke-massvel` and `dem01-legacy-hooke-twosphere` by the engine, with the repulsion of a material that has
/// this stiffness and this dashpot.
///
/// Equations: `wear-contact`, `wear-7`, `wear-12`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn the_engine_lets_two_spheres_rebound_as_in_lammps() {
    let (r, k_n) = (0.0025, 1e6);
    let m = sphere_mass(2700.0, r);
    let m_eff = effective_mass(m, m);
    for (c_n, x, v) in [
        (dashpot(m_eff, k_n, 0.8), 2.5118996608531133e-3, 1.5997548989987018),
        (dashpot(m_eff, k_n, 0.5), 2.506804594433399e-3, 0.9993293792676254),
        (4.05, 2.5068052837844447e-3, 0.9994057600771722),
        (45_000.0 * m_eff, 2.5069240303402292e-3, 1.012915942061946),
        (46_000.0 * m_eff, 2.5067840755741795e-3, 0.997056415615803),
    ] {
        let law = |young_modulus: f64| {
            let material = Material {
                young_modulus,
                poisson_ratio: 0.25,
                tensile_strength: 1.0,
                shear_strength: 1.0,
                surface_energy: 1.0,
                restitution: 1.0 - 0.5 * PI * c_n / (k_n * m_eff).sqrt(),
                scaling: 0.0,
                forget_stretched_springs: false,
            };
            Wear { material, interaction: Interaction::Repulsive }
        };
        let law = law(k_n / law(1.0).coefficients(r, r, m, m).k_n);
        let spheres = [-1.0, 1.0].map(|side| ([side * 0.00255, 0.0, 0.0], [side * -2.0, 0.0, 0.0], [0.0; 3], r, m));
        let found = after(law, system(&spheres, 0.1), 2068, 3e-8);
        for p in 0..2 {
            let side = found.x[p].0[0].signum();
            near(found.x[p].0[0], side * x, 1e-13);
            near(found.v[p].0[0], side * v, 1e-13);
        }
    }
}

/// LAMMPS, `dem04-hookehistory-oblique-3d-si.yaml`, on a substrate of the engine. The dashpot and the arm differ as for the law alone.
///
/// Equations: `soot-wall`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn the_engine_lets_a_ball_rebound_from_a_wall_as_in_lammps() {
    let (r, k_n) = (0.0025, 2e7);
    let m = sphere_mass(2700.0, r);
    let law = rough(Springs { k_n, k_t: 5.7e6, eta_n: dashpot(m, k_n, 0.98), ..NO_SPRINGS }, [0.092, 0.0, 0.0]);
    let plane = Shape::Plane { point: Vec3::zero(), normal: Vec3([0.0, 0.0, 1.0]) };
    let surfaces = vec![Surface::new("substrate", SUBSTRATE, plane, PrescribedMotion::Still)];
    let ball = ([0.0, 0.0, 0.00255], [2.5069, 0.0, -2.9876], [0.0; 3], r, m);
    let found = after(law, System { surfaces, ..system(&[ball], 0.1) }, 1724 + 1133, 1e-8);
    near(found.v[0].0[0], 1.9626463236052916, 1e-5);
    near(found.v[0].0[2], 2.9278279037320356, 1e-4);
    near(found.w[0].0[1], 544.2536763947109, 4e-3);
}

/// LAMMPS, `dem06-hookehistory-spin-3d-si.yaml`: a ball that spins falls on a large one; after 600 steps, when the dashpot begins to pull there, they still press on each other. The arms of the friction are the radii
/// there, not the distances from the contact: at the deepest, 3e-4 more.
///
/// Equations: `soot-contact`, `soot-12`, `soot-17`, `soot-verlet-begin`, `soot-verlet-end`.
#[test]
fn the_engine_lets_a_spinning_ball_bounce_as_in_lammps() {
    let (k_n, [small, large]) = (1.2e8, [(0.1, 2700.0), (0.5, 2.7e6)]);
    let [m_i, m_j] = [small, large].map(|(r, density)| sphere_mass(density, r));
    let eta_n = dashpot(effective_mass(m_i, m_j), k_n, 0.5);
    let law = rough(Springs { k_n, k_t: 3.4e7, eta_n, ..NO_SPRINGS }, [0.4, 0.0, 0.0]);
    let ball = ([0.0, 0.0, 0.60001], [0.0, 0.0, -0.2], [0.0, 22.86, 0.0], small.0, m_i);
    let found = after(law, system(&[ball, ([0.0; 3], [0.0; 3], [0.0; 3], large.0, m_j)], 4.0), 600, 1e-6);
    let p = if found.radius[0] == small.0 { 0 } else { 1 };
    near(found.x[p].0[2], 0.5999579975299932, 1e-7);
    near(found.v[p].0[2], 5.371117240419684e-2, 1e-6);
    near(found.v[p].0[0], 0.10053843852848338, 1e-3);
    near(found.w[p].0[1], 20.34706728448627, 1e-3);
    near(found.w[1 - p].0[1], -4.021254101418352e-6, 2e-3);
}
