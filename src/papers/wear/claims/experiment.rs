//! The experiments of the paper, one function each.

use crate::case::section::defaults;
use crate::case::{InSteps, Limits};
use crate::error::Error;
use crate::initial::packing::FILL;
use crate::initial::{Sizes, random_packing};
use crate::interrupt::Interrupt;
use crate::observe::packing::volume_fraction;
use crate::observe::patch::{Elasticity, Gauge};
use crate::observe::{Link, links};
use crate::papers::wear::case::{Compression, Deformation, Patch};
use crate::papers::wear::fate::Witness;
use crate::papers::wear::protocol::{Protocol, Setup, Stage};
use crate::papers::wear::stages;
use crate::run::{Driver, RunState, RunningStage, Sink, Step};
use crate::simulation::Simulation;
use crate::spec::wear::{Material, Wear};
use crate::system::System;
use std::ops::ControlFlow;

/// A relaxed amorphous sample.
#[derive(Clone, Debug)]
pub struct Relaxed {
    /// At rest, with the masses of the material's density.
    pub system: System,
    /// Volume fraction of the spheres in the box.
    pub volume_fraction: f64,
    /// Number of steps of the second phase.
    pub steps: u64,
    /// Largest residual stress, relative to Young's modulus.
    pub residual: f64,
}

/// Section 3.2: relaxation of a random packing.
///
/// # Errors
///
/// If the sample does not relax, or the simulation halts.
pub fn relax(
    sizes: Sizes,
    sides: [f64; 3],
    material: &Material,
    density: f64,
    seed: u64,
    interrupt: &Interrupt,
) -> Result<Relaxed, Error> {
    let initial = random_packing(sizes, sides, FILL, density, seed, interrupt)?;
    let stages = stages::relaxation(&defaults(), material.young_modulus, density);
    let (mut steps, mut residual) = (0, f64::NAN);
    let system = observe(&stages, initial, material, f64::INFINITY, interrupt, |simulation| {
        steps = simulation.system().step;
        residual = simulation.largest_stress() / material.young_modulus;
        ControlFlow::Continue(())
    })?;
    Ok(Relaxed { volume_fraction: volume_fraction(&system), system, steps, residual })
}

/// Runs stages; `see` observes the initial state of each and every step, and may end a stage. Returns the final state.
fn observe(
    stages: &[Stage],
    initial: System,
    material: &Material,
    max_overlap: f64,
    interrupt: &Interrupt,
    see: impl FnMut(&Simulation<Wear>) -> ControlFlow<()>,
) -> Result<System, Error> {
    let protocol = Protocol { stages, initial, material, max_overlap };
    Ok(Driver::new(&protocol, interrupt).run(&mut Seeing(see))?.system)
}

/// Shows a closure the initial state of each stage, too.
struct Seeing<F>(F);

impl<'p, F: FnMut(&Simulation<Wear>) -> ControlFlow<()>> Sink<Protocol<'p>> for Seeing<F> {
    fn begin(&mut self, stage: &mut RunningStage<'_, Protocol<'p>>, _: &RunState) -> Result<(), Error> {
        let _ = (self.0)(&stage.simulation);
        Ok(())
    }
    fn step(
        &mut self,
        stage: &mut RunningStage<'_, Protocol<'p>>,
        _: &RunState,
        _: &Step,
    ) -> Result<ControlFlow<()>, Error> {
        Ok((self.0)(&stage.simulation))
    }
}

/// The largest overlap in a test.
fn overlap() -> f64 {
    defaults::<Limits>().overlap
}

/// Thickness of the walls of a sample, nm.
fn wall(d_0: f64) -> f64 {
    defaults::<Patch>().walls.value(d_0)
}

/// Elastic constants from a confined compression of 0.01 E, or none if the sample fails: if its strain exceeds ten times the strain
/// expected from the target stiffness.
///
/// # Errors
///
/// If the simulation halts.
pub fn elasticity(
    sample: &System,
    d_0: f64,
    material: &Material,
    steps: u64,
    interrupt: &Interrupt,
) -> Result<Option<Elasticity>, Error> {
    let case = Compression { duration: InSteps::times(steps as f64), ..defaults() };
    let stage = stages::compression(&case, wall(d_0), material.young_modulus);
    let mut gauge = None;
    let mut measured = None;
    let mut given_way = false;
    observe(&[stage], sample.clone(), material, overlap(), interrupt, |simulation| {
        let (system, step) = (simulation.system(), simulation.system().step);
        let gauge = gauge.get_or_insert_with(|| Gauge::new(system, &links(simulation), wall(d_0)));
        if step % 100 != 0 {
            return ControlFlow::Continue(());
        }
        let links = links(simulation);
        given_way |= gauge.read(system, &links).strain.0[1] < -0.1;
        measured = gauge.elasticity(system, &links);
        if given_way { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
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

/// Stress-strain curve up to failure.
#[derive(Clone, Debug)]
pub struct Strength {
    /// Strain and stress, MPa.
    pub curve: Vec<(f64, f64)>,
    /// The largest stress.
    pub peak: f64,
}

/// Strain between two measurements.
const LOOK: f64 = 1e-3;

/// The peak stress of a sample deformed at constant rate. The test ends when the stress has fallen to half its peak, or at the strain `most`.
///
/// # Errors
///
/// If the simulation halts.
pub fn strength(
    sample: &System,
    d_0: f64,
    material: &Material,
    pull: Pull,
    most: f64,
    interrupt: &Interrupt,
) -> Result<Strength, Error> {
    let case = Deformation { strain: most, ..defaults() };
    let every = (LOOK / case.strain_per_step).round() as u64;
    let (stage, axis) = match pull {
        Pull::Tension => (stages::tension(&case, wall(d_0)), 1),
        Pull::Shear => (stages::shear(&case, wall(d_0)), 0),
    };
    let mut gauge = None;
    let mut strength = Strength { curve: Vec::new(), peak: 0.0 };
    observe(&[stage], sample.clone(), material, overlap(), interrupt, |simulation| {
        let system = simulation.system();
        let gauge = gauge.get_or_insert_with(|| Gauge::new(system, &links(simulation), wall(d_0)));
        if system.step % every != 0 {
            return ControlFlow::Continue(());
        }
        let reading = gauge.read(system, &links(simulation));
        let (strain, stress) = (reading.strain.0[axis], reading.stress[1].0[axis]);
        strength.curve.push((strain, stress));
        strength.peak = strength.peak.max(stress);
        if stress < 0.5 * strength.peak && strain > 0.02 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    Ok(strength)
}

/// Shears a junction carved from a relaxed sample, and observes it every `window` nm of sliding.
///
/// # Errors
///
/// If the junction cannot be made, or the simulation halts.
pub fn shear_junction(
    full: &System,
    stage: &Stage,
    material: &Material,
    window: f64,
    interrupt: &Interrupt,
    mut see: impl FnMut(&Simulation<Wear>, &[Link], &Witness),
) -> Result<Witness, Error> {
    let Setup::Junction(junction) = stage.setup else { panic!("the stage shears a junction") };
    let mut witness = None;
    let mut every = 1;
    observe(std::slice::from_ref(stage), full.clone(), material, overlap(), interrupt, |simulation| {
        let system = simulation.system();
        let witness = witness.get_or_insert_with(|| {
            every = (window / (junction.slide.velocity * simulation.settings().dt)).round().max(1.0) as u64;
            Witness::new(system, junction.height)
        });
        if system.step > 0 {
            witness.follow(system);
        }
        if system.step > 0 && system.step % every == 0 {
            let links = links(simulation);
            witness.look(system, &links);
            see(simulation, &links, witness);
        }
        ControlFlow::Continue(())
    })?;
    Ok(witness.expect("a stage is seen at its beginning"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::hcp;
    use crate::papers::wear::claims::patch_material;

    #[test]
    fn a_lattice_without_poisson_effect_has_the_modulus_of_its_target() {
        let measured =
            elasticity(&hcp(180.0, [4, 7, 2], 1.0), 180.0, &patch_material(0.0, 0.5), 20_000, &Interrupt::default())
                .unwrap()
                .unwrap();
        // To second order the load of 0.01 E rotates the bonds: a deviation quadratic in the load.
        assert!((measured.young_modulus - 1.0).abs() < 1e-3, "{measured:?}");
        assert!(measured.poisson_ratio.abs() < 2e-3, "{measured:?}");
        assert!((measured.strain + 0.01).abs() < 1e-4, "{measured:?}");
    }

    #[test]
    fn a_random_sample_comes_to_rest_without_stress_at_the_density_of_the_material() {
        let relaxed =
            relax(Sizes::around(180.0), [900.0; 3], &patch_material(0.15, 0.0), 2.0, 1, &Interrupt::default()).unwrap();
        assert!(relaxed.residual < 1e-14, "{relaxed:?}");
        assert!(relaxed.volume_fraction > FILL && relaxed.volume_fraction < 0.85, "{}", relaxed.volume_fraction);
        let total: f64 = relaxed.system.particles.mass.iter().sum();
        assert!((total / relaxed.system.domain.volume() / 2.0 - 1.0).abs() < 1e-12);
        assert!(relaxed.system.particles.v.iter().all(|v| v.norm() == 0.0));
    }

    #[test]
    fn a_stretched_lattice_breaks_near_its_target_strength() {
        let measured = strength(
            &hcp(180.0, [6, 4, 2], 1.0),
            180.0,
            &patch_material(0.0, 0.0),
            Pull::Tension,
            0.5,
            &Interrupt::default(),
        )
        .unwrap();
        assert!((measured.peak / 0.2 - 1.0).abs() < 0.15, "{}", measured.peak);
        assert!(measured.curve[measured.curve.len() - 1].1 < 0.5 * measured.peak);
    }
}
