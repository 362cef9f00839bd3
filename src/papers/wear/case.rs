//! The sections of a case of the wear paper.

use crate::case::InSteps;
use crate::case::quantity::{
    CriticalDamping, CriticalDiameter, CriticalStep, Density, Drag, JunctionDiameter, Length, ModeDiameter, Pressure,
    Quantity, Scaled, SurfaceEnergy, Time, Velocity, YoungModulus,
};
use crate::case::section::{choice, defaults, section, words};
use crate::case::springs::Transport;
use std::path::PathBuf;

/// A length, or a multiple of the most frequent particle diameter.
pub type InDiameters = Scaled<Length, ModeDiameter>;
/// A stress, or a multiple of Young's modulus.
pub type InModuli = Scaled<Pressure, YoungModulus>;
/// A time step, or a multiple of the critical time step.
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
    /// A material of the wear model: the macroscopic properties that the assembly of particles is to have.
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
        /// Bulk density of the solid, voids included.
        density: Quantity<Density>,
        /// Exponent s with which the strength falls for diameters above d_c: 0 preserves the strength, 1/2 the surface energy.
        scaling: f64,
        /// Whose reading of the paper is computed where there are several.
        readings: Readings = Readings::Own,
        /// Resets the tangential springs of pairs that do not touch whenever the neighbour list is rebuilt, as the authors' published
        /// program does; for comparison only.
        forget_stretched_springs: bool = false,
        /// Whether tangential springs follow a pair that spins about its normal; `carried` is a reading that no paper takes.
        springs: Transport = Transport::Projected,
    }
}

words! {
    /// Whose reading of the paper is computed.
    pub enum Readings {
        /// Ours.
        Own = "own",
        /// That of the authors' published program, a pair style of LAMMPS: the cap of Eq. 5 limits the force of spring and dashpot
        /// together, the moment arms are the radii, and `forget_stretched_springs` is true.
        AsPublished = "as-published",
    }
}

choice! {
    /// The initial arrangement of the particles.
    pub enum Sample {
        /// A hexagonal close-packed lattice of equal particles.
        Hcp = "hcp": Hcp,
        /// A relaxed, polydisperse random packing.
        Amorphous = "amorphous": Amorphous,
    }
}

section! {
    /// A hexagonal close-packed lattice, Section 3.1.
    pub struct Hcp {
        /// Diameter d_0 of the particles.
        diameter: Scaled<Length, CriticalDiameter>,
        /// Side lengths of the box; the load acts along the second axis.
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
        /// Side lengths of the box before the relaxation.
        size: [InDiameters; 3] = [Scaled::times(100.0), Scaled::times(100.0), Scaled::times(3.0)],
        /// Volume fraction of the particles in the box before the relaxation.
        volume_fraction: f64 = 0.75,
        /// Relaxation of the random packing.
        relaxation: Relaxation = defaults(),
        /// File in which the equilibrated sample is saved.
        save: Option<PathBuf> = None,
        /// File with an equilibrated sample to start from; it must have been made with the same model and the same values of the keys above.
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
        /// Damping of the second phase: with cohesion, deformable box.
        cohesion_damping: InCriticalDampings = Scaled::times(0.02),
        /// Stress below which all stresses must fall for the second phase to end.
        residual_stress: InModuli = Scaled::times(1e-14),
        /// Largest number of steps of the second phase; a sample that is not relaxed by then is an error.
        max_steps: u64 = 200_000,
    }
}

choice! {
    /// The experiment.
    pub enum Experiment {
        /// Mechanical tests between two walls, Section 3.
        Patch = "patch": Patch,
        /// Shearing of a junction between two bodies, Section 4.
        Junction = "junction": Junction,
        /// Long sliding of two bodies, between which a third-body layer forms.
        Sliding = "sliding": Sliding,
    }
}

section! {
    /// Mechanical tests, each starting from the same sample.
    pub struct Patch {
        /// Thickness of each rigid wall.
        walls: InDiameters = Scaled::times(1.5),
        /// Compression under a small load, for the elastic constants.
        compression: Option<Compression> = None,
        /// Tension: the walls are pulled apart.
        tension: Option<Deformation> = None,
        /// Simple shear: the upper wall moves sideways.
        shear: Option<Deformation> = None,
    }
}

section! {
    /// A constant pressure on the upper wall.
    pub struct Compression {
        /// The pressure.
        stress: InModuli = Scaled::times(0.01),
        /// Time that the sample is given to come to rest.
        duration: InSteps = Scaled::times(20_000.0),
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag coefficient of every particle.
        damping: InCriticalDampings = Scaled::times(0.2),
    }
}

section! {
    /// A deformation at constant rate up to failure.
    pub struct Deformation {
        /// Strain increment of one time step.
        strain_per_step: f64 = 1e-5,
        /// Strain at which the test ends.
        strain: f64 = 0.5,
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag coefficient of every particle.
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
        /// Thickness of each rigid wall.
        walls: InDiameters = Scaled::times(1.5),
        /// Velocity of the upper wall.
        shear_velocity: Quantity<Velocity>,
        /// Pressure on the upper wall.
        normal_stress: InModuli,
        /// Duration of the shearing.
        duration: InSteps,
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag coefficient of every particle.
        damping: InCriticalDampings = Scaled::times(0.0),
    }
}

section! {
    /// Long sliding of two bodies, cut out of the sample over its whole cross-section: the experiment of Pham-Ba & Molinari (2023) on the third-body layer.
    pub struct Sliding {
        /// Number of asperities of each body along the direction of sliding; at the beginning crests meet crests.
        asperities: u64 = 1,
        /// Height of the asperities from valley to crest; 0 for flat faces, which are welded together.
        asperity_height: InDiameters = Scaled::times(2.0),
        /// Thickness of each rigid wall.
        walls: InDiameters = Scaled::times(1.5),
        /// Velocity of the upper wall.
        shear_velocity: Quantity<Velocity>,
        /// Pressure on the upper wall.
        normal_stress: InModuli,
        /// Duration of the sliding.
        duration: InSteps,
        /// Sliding distance over which forces and velocities are averaged, and after which a profile is written.
        window: InDiameters = Scaled::times(5.0),
        /// Time step.
        dt: InCriticalSteps = Scaled::times(0.1),
        /// Drag coefficient of every particle.
        damping: InCriticalDampings = Scaled::times(0.0),
    }
}

/// The file with an equilibrated sample that a case reads.
pub fn reads(case: &mut Case) -> Vec<&mut PathBuf> {
    if let Sample::Amorphous(Amorphous { load: Some(file), .. }) = &mut case.sample { vec![file] } else { Vec::new() }
}

/// The file in which a case saves its equilibrated sample, with the section that asks for it.
pub fn saves(case: &mut Case) -> Vec<(String, &mut PathBuf)> {
    match &mut case.sample {
        Sample::Amorphous(Amorphous { save: Some(file), .. }) => vec![("sample.amorphous".into(), file)],
        _ => Vec::new(),
    }
}
