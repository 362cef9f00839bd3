//! Small systems for the tests of the engine.

#![allow(dead_code, reason = "every test is a program that uses its own part")]

pub(crate) mod soot;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::io::Write;
use veridem::forces::Instructions;
use veridem::interrupt::Interrupt;
use veridem::output::{ReadTable, RunFolder};
use veridem::papers::PAPERS;
use veridem::run::advance;
use veridem::simulation::{Settings, Simulation};
use veridem::spec::Vec3;
use veridem::spec::mechanics::sphere::sphere_mass;
use veridem::spec::wear::{Interaction, Material, Wear};
use veridem::system::{Domain, Motion, Particles, System};

/// Silica: Table 5 of the wear paper, in MPa and pN/nm.
pub(crate) const SILICA: Material = Material {
    young_modulus: 73_000.0,
    poisson_ratio: 0.17,
    tensile_strength: 16_000.0,
    shear_strength: 9_000.0,
    surface_energy: 1_500.0,
    restitution: 0.9,
    scaling: 0.5,
    forget_stretched_springs: false,
};

/// The instruction sets to be compared, the plainest first. Says so, past what the test harness captures, if there is nothing to compare.
pub(crate) fn instruction_sets() -> Vec<Instructions> {
    let sets = Instructions::available();
    if sets.len() < 2 {
        let said = writeln!(std::io::stderr(), "this processor has {sets:?} alone: no instruction sets are compared");
        said.expect("standard error");
    }
    sets
}

/// Runs a case to its end, in a folder that lasts as long as the first result.
pub(crate) fn run_to_the_end(case: &str) -> (tempfile::TempDir, RunFolder) {
    let place = tempfile::tempdir().expect("a folder");
    let (file, run) = (place.path().join("case.yaml"), place.path().join("run"));
    std::fs::write(&file, case).expect("a case");
    let job = PAPERS.read(&file).expect("a good case");
    job.launch(&run, false, &Interrupt::default(), &mut |_| {}).map(drop).expect("a run to the end");
    (place, RunFolder::open(&run).expect("a run folder"))
}

/// The numbers of a column of a table.
pub(crate) fn column(table: &ReadTable, header: &str) -> Vec<f64> {
    let place = table.columns.iter().position(|column| column == header).unwrap_or_else(|| panic!("no {header}"));
    table.rows.iter().map(|row| row[place].parse().expect("a number")).collect()
}

/// Number drawn evenly from 0 to 1.
pub(crate) fn uniform(rng: &mut ChaCha8Rng) -> f64 {
    (rng.next_u64() >> 11) as f64 * 2f64.powi(-53)
}

/// A crowd of spheres of 1 to 3 nm, jittered about a cubic lattice of `side` points a side so that many touch and none coincide,
/// each with a random velocity and spin. Density that of silica.
pub(crate) fn crowd(seed: u64, side: usize) -> System {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut draw = |from: f64, to: f64| from + (to - from) * uniform(&mut rng);
    let spacing = 2.0;
    let mut particles = Particles::default();
    for k in 0..side * side * side {
        let place = [k % side, k / side % side, k / side / side];
        let radius = draw(0.5, 1.5);
        let mass = sphere_mass(2.2e-3, radius);
        particles.push(Vec3(place.map(|c| spacing * (c as f64 + 0.5 + draw(-0.1, 0.1)))), radius, mass, 0);
    }
    for p in 0..particles.len() {
        particles.v[p] = Vec3([draw(-50.0, 50.0), draw(-50.0, 50.0), draw(-50.0, 50.0)]);
        particles.w[p] = Vec3([draw(-50.0, 50.0), draw(-50.0, 50.0), draw(-50.0, 50.0)]);
    }
    System::new(particles, Domain::periodic([side as f64 * spacing; 3]))
}

/// The crowd between two rigid walls, the lower at rest, the upper pulled along x and pressed down along y.
pub(crate) fn sheared_crowd(seed: u64, side: usize) -> System {
    let mut system = crowd(seed, side);
    system.domain.periodic[1] = false;
    let height = system.domain.sides[1];
    let at_rest = [Motion::Velocity(0.0); 3];
    system.add_wall(at_rest, |particles, p| particles.x[p].0[1] < 2.0);
    let pulled = [Motion::Velocity(10.0), Motion::Load(-5_000.0), Motion::Velocity(0.0)];
    system.add_wall(pulled, |particles, p| particles.x[p].0[1] > height - 2.0);
    system
}

/// Silica with all its forces.
pub(crate) fn wear() -> Wear {
    Wear { material: SILICA, interaction: Interaction::Full }
}

/// Settings that the crowd is stable and quick with.
pub(crate) fn settings(dt: f64) -> Settings {
    Settings::new(dt).skin(0.3)
}

/// A simulation after some steps.
pub(crate) fn run(system: System, settings: Settings, steps: usize) -> Simulation<Wear> {
    let mut simulation = Simulation::new(wear(), system, settings).expect("a valid system");
    advance(&mut simulation, steps as u64).expect("a stable step");
    simulation
}
