//! The paper's experiments, one function each.

use crate::build::amorphous::FILL;
use crate::build::protocol::{Progress, Setup, Stage};
use crate::build::{Sizes, random_packing, stages};
use crate::case::section::defaults;
use crate::case::{Limits, Patch};
use crate::observe::fate::Witness;
use crate::observe::packing::volume_fraction;
use crate::observe::patch::{Elasticity, Gauge};
use crate::observe::{Link, links};
use crate::simulation::Simulation;
use crate::spec::wear::{Material, Wear};
use crate::system::{Halt, System};

/// A relaxed amorphous sample.
#[derive(Clone, Debug)]
pub struct Relaxed {
    /// At rest, with the masses of the material's density.
    pub system: System,
    /// Volume of the spheres over volume of the box.
    pub volume_fraction: f64,
    /// Steps of the second phase.
    pub steps: u64,
    /// Largest residual stress over Young's modulus.
    pub residual: f64,
}

/// Section 3.2: random spheres come to rest.
pub fn relax(sizes: Sizes, sides: [f64; 3], material: &Material, density: f64, seed: u64) -> Result<Relaxed, Halt> {
    let mut system = random_packing(sizes, sides, FILL, density, seed);
    let (mut steps, mut residual) = (0, f64::NAN);
    for stage in stages::relaxation(&defaults(), material.young_modulus, density) {
        (system, _) = stage.run(system, material, f64::INFINITY, |simulation| {
            steps = simulation.system().step;
            residual = simulation.largest_stress() / material.young_modulus;
            Progress::Going
        })?;
    }
    Ok(Relaxed { volume_fraction: volume_fraction(&system), system, steps, residual })
}

/// The overlap that is allowed in a test.
fn overlap() -> f64 {
    defaults::<Limits>().overlap
}

/// How thick the walls about a sample are, nm.
fn wall(d_0: f64) -> f64 {
    defaults::<Patch>().walls.value(d_0)
}

/// Elastic constants by a confined compression of 0.01 E, or none when the sample gives way: it is compressed by more than
/// ten times what its target stiffness allows.
pub fn elasticity(sample: &System, d_0: f64, material: &Material, steps: u64) -> Result<Option<Elasticity>, Halt> {
    let mut case: crate::case::Compression = defaults();
    case.duration = crate::case::InSteps::times(steps as f64);
    let stage = stages::compression(&case, wall(d_0), material.young_modulus);
    let mut gauge = None;
    let mut measured = None;
    let mut given_way = false;
    stage.run(sample.clone(), material, overlap(), |simulation| {
        let (system, step) = (simulation.system(), simulation.system().step);
        let gauge = gauge.get_or_insert_with(|| Gauge::new(system, &links(simulation), wall(d_0)));
        if step % 100 != 0 {
            return Progress::Going;
        }
        let links = links(simulation);
        given_way |= gauge.read(system, &links).strain.0[1] < -0.1;
        measured = gauge.elasticity(system, &links);
        if given_way { Progress::Done } else { Progress::Going }
    })?;
    Ok(measured.filter(|_| !given_way))
}

/// The direction of a strength test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pull {
    /// The walls are pulled apart.
    Tension,
    /// The upper wall is moved sideways.
    Shear,
}

/// Stress against strain, up to failure.
#[derive(Clone, Debug)]
pub struct Strength {
    /// Strain and stress, MPa.
    pub curve: Vec<(f64, f64)>,
    /// The largest stress.
    pub peak: f64,
}

/// Strain between two looks.
const LOOK: f64 = 1e-3;

/// The peak stress of a sample deformed at constant rate. The test ends when the stress has fallen to half of its peak, or at `most` strain.
pub fn strength(sample: &System, d_0: f64, material: &Material, pull: Pull, most: f64) -> Result<Strength, Halt> {
    let case = crate::case::Deformation { strain: most, ..defaults() };
    let every = (LOOK / case.strain_per_step).round() as u64;
    let (stage, axis) = match pull {
        Pull::Tension => (stages::tension(&case, wall(d_0)), 1),
        Pull::Shear => (stages::shear(&case, wall(d_0)), 0),
    };
    let mut gauge = None;
    let mut strength = Strength { curve: Vec::new(), peak: 0.0 };
    stage.run(sample.clone(), material, overlap(), |simulation| {
        let system = simulation.system();
        let gauge = gauge.get_or_insert_with(|| Gauge::new(system, &links(simulation), wall(d_0)));
        if system.step % every != 0 {
            return Progress::Going;
        }
        let reading = gauge.read(system, &links(simulation));
        let (strain, stress) = (reading.strain.0[axis], reading.stress[1].0[axis]);
        strength.curve.push((strain, stress));
        strength.peak = strength.peak.max(stress);
        if stress < 0.5 * strength.peak && strain > 0.02 { Progress::Done } else { Progress::Going }
    })?;
    Ok(strength)
}

/// Shears a junction carved from a full relaxed box, and watches it every `window` nm of sliding.
pub fn shear_junction(
    full: &System,
    stage: &Stage,
    material: &Material,
    window: f64,
    mut see: impl FnMut(&Simulation<Wear>, &[Link], &Witness),
) -> Result<Witness, Halt> {
    let Setup::Junction(junction) = stage.setup else { panic!("the stage shears a junction") };
    let mut witness = None;
    let mut every = 1;
    stage.run(full.clone(), material, overlap(), |simulation| {
        let system = simulation.system();
        let witness = witness.get_or_insert_with(|| {
            every = (window / (junction.velocity * simulation.settings().dt)).round().max(1.0) as u64;
            Witness::new(system, junction.height)
        });
        if system.step > 0 && system.step % every == 0 {
            let links = links(simulation);
            witness.look(system, &links);
            see(simulation, &links, witness);
        }
        Progress::Going
    })?;
    Ok(witness.expect("a stage is seen at its beginning"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::hcp;
    use crate::reproduce::wear::patch_material;

    #[test]
    fn a_lattice_without_poisson_effect_has_the_modulus_of_its_target() {
        let measured =
            elasticity(&hcp(180.0, [4, 7, 2], 1.0), 180.0, &patch_material(0.0, 0.5), 20_000).unwrap().unwrap();
        // Beyond linear order the load of 0.01 E turns the bonds: a deviation of its square.
        assert!((measured.young_modulus - 1.0).abs() < 1e-3, "{measured:?}");
        assert!(measured.poisson_ratio.abs() < 2e-3, "{measured:?}");
        assert!((measured.strain + 0.01).abs() < 1e-4, "{measured:?}");
    }

    #[test]
    fn a_random_sample_comes_to_rest_without_stress_at_the_density_of_the_material() {
        let relaxed = relax(Sizes::around(180.0), [900.0; 3], &patch_material(0.15, 0.0), 2.0, 1).unwrap();
        assert!(relaxed.residual < 1e-14, "{relaxed:?}");
        assert!(relaxed.volume_fraction > FILL && relaxed.volume_fraction < 0.85, "{}", relaxed.volume_fraction);
        let total: f64 = relaxed.system.particles.mass.iter().sum();
        assert!((total / relaxed.system.domain.volume() / 2.0 - 1.0).abs() < 1e-12);
        assert!(relaxed.system.particles.v.iter().all(|v| v.norm() == 0.0));
    }

    #[test]
    fn a_stretched_lattice_breaks_near_its_target_strength() {
        let measured =
            strength(&hcp(180.0, [6, 4, 2], 1.0), 180.0, &patch_material(0.0, 0.0), Pull::Tension, 0.5).unwrap();
        assert!((measured.peak / 0.2 - 1.0).abs() < 0.15, "{}", measured.peak);
        assert!(measured.curve[measured.curve.len() - 1].1 < 0.5 * measured.peak);
    }
}
