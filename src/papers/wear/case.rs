//! The sections of a case of the wear paper.

use crate::case::InSteps;
use crate::case::quantity::{
    CriticalDamping, CriticalDiameter, CriticalStep, Density, Drag, JunctionDiameter, Length, ModeDiameter, Pressure,
    Quantity, Scaled, SurfaceEnergy, Time, Velocity, YoungModulus,
};
use crate::case::section::{choice, defaults, section};
use std::path::PathBuf;

/// A length, or a multiple of the most frequent particle diameter.
pub type InDiameters = Scaled<Length, ModeDiameter>;
/// A stress, or a multiple of Young's modulus.
pub type InModuli = Scaled<Pressure, YoungModulus>;
/// A time step, or a multiple of the critical one.
pub type InCriticalSteps = Scaled<Time, CriticalStep>;
/// A drag on every particle, or a multiple of the critical damping.
pub type InCriticalDampings = Scaled<Drag, CriticalDamping>;

/// A case of the wear paper.
pub type Case = crate::case::Case<Model, Sample, Experiment>;

choice! {
    /// The contact model.
    pub enum Model {
        /// Pham-Ba & Molinari 2022: a cohesive solid.
        Wear = "wear": Material,
    }
}

section! {
    /// A material of the wear model: the macroscopic properties that the particles together are to have.
    pub struct Material {
        /// Young's modulus E.
        young_modulus: Quantity<Pressure>,
        /// Poisson's ratio, at most 1/4.
        poisson_ratio: f64,
        /// Tensile strength.
        tensile_strength: Quantity<Pressure>,
        /// Shear strength.
        shear_strength: Quantity<Pressure>,
        /// Surface energy.
        surface_energy: Quantity<SurfaceEnergy>,
        /// Restitution coefficient of a collision.
        restitution: f64,
        /// Density of the whole solid, voids included.
        density: Quantity<Density>,
        /// Exponent s by which strength falls with diameters beyond d_c: 0 keeps the strength, 1/2 the surface energy.
        scaling: f64,
        /// Drops the tangential springs of pairs that do not touch whenever neighbours are listed, as the authors' published
        /// program does; for comparison only.
        forget_stretched_springs: bool = false,
    }
}

choice! {
    /// How the particles are arranged.
    pub enum Sample {
        /// A hexagonal close-packed lattice of equal particles.
        Hcp = "hcp": Hcp,
        /// A relaxed random packing of many sizes.
        Amorphous = "amorphous": Amorphous,
    }
}

section! {
    /// A hexagonal close-packed lattice, Section 3.1.
    pub struct Hcp {
        /// Diameter d_0 of the particles.
        diameter: Scaled<Length, CriticalDiameter>,
        /// Sides of the box; the load acts along the second.
        size: [InDiameters; 3] = [Scaled::times(25.0), Scaled::times(25.0), Scaled::times(3.0)],
    }
}

section! {
    /// An amorphous sample, Section 3.2.
    pub struct Amorphous {
        /// Most frequent diameter d_0.
        diameter: Scaled<Length, CriticalDiameter>,
        /// Smallest diameter d_s.
        smallest: InDiameters = Scaled::times(0.75),
        /// Largest diameter d_l.
        largest: InDiameters = Scaled::times(1.25),
        /// Sides of the box before the relaxation.
        size: [InDiameters; 3] = [Scaled::times(100.0), Scaled::times(100.0), Scaled::times(3.0)],
        /// Volume of all particles over volume of the box, before the relaxation.
        volume_fraction: f64 = 0.75,
        /// How the random particles come to rest.
        relaxation: Relaxation = defaults(),
        /// File to keep the equilibrated sample in.
        save: Option<PathBuf> = None,
        /// File with an equilibrated sample to start from; it must have been made with the same keys above and model.
        load: Option<PathBuf> = None,
    }
}

section! {
    /// The two phases of relaxation, Section 3.2.
    pub struct Relaxation {
        /// Time step of both phases.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Steps of the first phase: repulsion only, fixed box.
        repulsion_steps: u64 = 3000,
        /// Damping of the first phase.
        repulsion_damping: InCriticalDampings = Scaled::times(1.0),
        /// Damping of the second phase: cohesion too, moving box.
        cohesion_damping: InCriticalDampings = Scaled::times(0.02),
        /// The second phase ends when all stresses are below this.
        residual_stress: InModuli = Scaled::times(1e-14),
        /// The second phase has failed after this many steps.
        max_steps: u64 = 200_000,
    }
}

choice! {
    /// What is done to a sample.
    pub enum Experiment {
        /// Mechanical tests between two walls, Section 3.
        Patch = "patch": Patch,
        /// A junction between two bodies is sheared, Section 4.
        Junction = "junction": Junction,
    }
}

section! {
    /// Mechanical tests, each starting from the same sample.
    pub struct Patch {
        /// Thickness of the two rigid walls.
        walls: InDiameters = Scaled::times(1.5),
        /// Elasticity under a small load.
        compression: Option<Compression> = None,
        /// Pulling the walls apart.
        tension: Option<Deformation> = None,
        /// Moving the upper wall sideways.
        shear: Option<Deformation> = None,
    }
}

section! {
    /// A constant pressure on the upper wall.
    pub struct Compression {
        /// The pressure.
        stress: InModuli = Scaled::times(0.01),
        /// How long the sample has to come to rest.
        duration: InSteps = Scaled::times(20_000.0),
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag on every particle.
        damping: InCriticalDampings = Scaled::times(0.2),
    }
}

section! {
    /// A deformation at constant rate up to failure.
    pub struct Deformation {
        /// Strain of one time step.
        strain_per_step: f64 = 1e-5,
        /// Strain at which the test ends.
        strain: f64 = 0.5,
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag on every particle.
        damping: InCriticalDampings = Scaled::times(0.01),
    }
}

section! {
    /// A cylindrical junction between two bodies, carved from the sample and sheared, Section 4.
    pub struct Junction {
        /// Diameter D of the cylinder.
        diameter: Quantity<Length>,
        /// Height of the cylinder.
        height: Scaled<Length, JunctionDiameter> = Scaled::times(0.5),
        /// Thickness of the two rigid walls.
        walls: InDiameters = Scaled::times(1.5),
        /// Velocity of the upper wall.
        shear_velocity: Quantity<Velocity>,
        /// Pressure on the upper wall.
        normal_stress: InModuli,
        /// How long it is sheared.
        duration: InSteps,
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag on every particle.
        damping: InCriticalDampings = Scaled::times(0.0),
    }
}

/// The file with an equilibrated sample that a case reads.
pub fn reads(case: &Case) -> Vec<PathBuf> {
    if let Sample::Amorphous(Amorphous { load: Some(file), .. }) = &case.sample {
        vec![file.clone()]
    } else {
        Vec::new()
    }
}

/// The file that a case keeps its equilibrated sample in, with the section that asks for it.
pub fn saves(case: &Case) -> Vec<(String, PathBuf)> {
    match &case.sample {
        Sample::Amorphous(Amorphous { save: Some(file), .. }) => vec![("sample.amorphous".into(), file.clone())],
        _ => Vec::new(),
    }
}
