//! The stages requested by the sections of a case file.

use super::bodies::Bodies;
use super::case;
use super::junction::{Junction, Slide};
use super::protocol::{Drive, Setup, Stage, Stop};
use crate::case::InSteps;
use crate::spec::wear::Interaction;

/// The two phases of relaxation. At their end all stresses are below the residual stress and the box has the material's density.
pub fn relaxation(case: &case::Relaxation, young_modulus: f64, density: f64) -> [Stage; 2] {
    let repulsion = Stage {
        name: "repulsion",
        setup: Setup::None,
        interaction: Interaction::Repulsive,
        dt: case.dt.clone(),
        damping: case.repulsion_damping.clone(),
        relax_box: false,
        stop: Stop::After(InSteps::times(case.repulsion_steps as f64)),
        final_density: None,
    };
    let cohesion = Stage {
        name: "cohesion",
        interaction: Interaction::Normal,
        damping: case.cohesion_damping.clone(),
        relax_box: true,
        stop: Stop::Relaxed { stress: case.residual_stress.value(young_modulus), most: case.max_steps },
        final_density: Some(density),
        ..repulsion.clone()
    };
    [repulsion, cohesion]
}

/// A constant pressure on the upper wall.
pub fn compression(case: &case::Compression, thickness: f64, young_modulus: f64) -> Stage {
    let drive = Drive::Compress(case.stress.value(young_modulus));
    Stage {
        damping: case.damping.clone(),
        ..test("compression", thickness, drive, &case.dt, Stop::After(case.duration.clone()))
    }
}

/// Tension: the walls are pulled apart.
pub fn tension(case: &case::Deformation, thickness: f64) -> Stage {
    deformation("tension", case, thickness, Drive::Stretch)
}

/// Simple shear: the upper wall moves sideways.
pub fn shear(case: &case::Deformation, thickness: f64) -> Stage {
    deformation("shear", case, thickness, Drive::Shear)
}

fn deformation(name: &'static str, case: &case::Deformation, thickness: f64, drive: fn(f64) -> Drive) -> Stage {
    let stop = Stop::After(InSteps::times(case.strain / case.strain_per_step));
    Stage { damping: case.damping.clone(), ..test(name, thickness, drive(case.strain_per_step), &case.dt, stop) }
}

fn test(name: &'static str, thickness: f64, drive: Drive, dt: &case::InCriticalSteps, stop: Stop) -> Stage {
    Stage {
        name,
        setup: Setup::Walls { thickness, drive },
        interaction: Interaction::Full,
        dt: dt.clone(),
        damping: case::InCriticalDampings::times(0.0),
        relax_box: false,
        stop,
        final_density: None,
    }
}

/// Carving and shearing of the junction; `d_0` is the most frequent diameter, nm.
pub fn junction(case: &case::Junction, d_0: f64, young_modulus: f64) -> Stage {
    let diameter = case.diameter.value;
    let slide = Slide {
        wall: case.walls.value(d_0),
        velocity: case.shear_velocity.value,
        pressure: case.normal_stress.value(young_modulus),
    };
    let junction = Junction { diameter, height: case.height.value(diameter), slide };
    slid("shearing", Setup::Junction(junction), &case.dt, &case.damping, &case.duration)
}

/// Cutting and sliding of two bodies; `d_0` is the most frequent diameter, nm.
pub fn sliding(case: &case::Sliding, d_0: f64, young_modulus: f64) -> Stage {
    let slide = Slide {
        wall: case.walls.value(d_0),
        velocity: case.shear_velocity.value,
        pressure: case.normal_stress.value(young_modulus),
    };
    let bodies = Bodies { asperities: case.asperities, height: case.asperity_height.value(d_0), slide };
    slid("sliding", Setup::Bodies(bodies), &case.dt, &case.damping, &case.duration)
}

fn slid(
    name: &'static str,
    setup: Setup,
    dt: &case::InCriticalSteps,
    damping: &case::InCriticalDampings,
    duration: &InSteps,
) -> Stage {
    Stage {
        name,
        setup,
        interaction: Interaction::Full,
        dt: dt.clone(),
        damping: damping.clone(),
        relax_box: false,
        stop: Stop::After(duration.clone()),
        final_density: None,
    }
}
