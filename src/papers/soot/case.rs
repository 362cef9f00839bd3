//! The sections of a case of the soot paper. Defaults are the authors' published inputs, but for the distance that necks bridge.

mod sample;
mod stages;

pub use sample::*;
pub use stages::*;

use crate::case::quantity::{Density, Energy, Force, Length, Pressure, Quantity, Sharpness, quantity};
use crate::case::section::{choice, defaults, section, words};
use crate::case::springs::{FourSprings, four_springs};
use crate::case::units::{in_unit, rounded};
use crate::spec::PairModel;
use crate::spec::mechanics::four_springs::Friction;
use crate::spec::mechanics::primary_particle::solid_inertia;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::eq24_fractal::gyration_radius;
use crate::spec::soot::{self, Along, Printed, Programmed};
use std::path::PathBuf;

/// A case of the soot paper.
pub type Case = crate::case::Case<Model, Sample, Experiment>;

choice! {
    /// The contact model.
    pub enum Model {
        /// Demidov, Gor & Khalizov 2024: soot aggregates with necks.
        Soot = "soot": Soot,
    }
}

choice! {
    /// How the particles are arranged.
    pub enum Sample {
        /// A fractal aggregate.
        Aggregate = "aggregate": Aggregate,
    }
}

choice! {
    /// What is done to a sample.
    pub enum Experiment {
        /// An aggregate falls on a substrate.
        Deposition = "deposition": Deposition,
        /// A coated aggregate collapses.
        Restructuring = "restructuring": Restructuring,
        /// Depositions, indentations and restructurings, one after the other.
        Sequence = "sequence": Vec<SootStage>,
    }
}

section! {
    /// The interactions of soot spheres.
    pub struct Soot {
        /// Density of the spheres.
        density: Quantity<Density> = quantity("1700 kg/m^3"),
        /// The springs of a neck; if not given, P where all that is done is restructuring, else S.
        necks: Option<NeckSet> = None,
        /// Springs of a neck that are neither of the published sets.
        neck_springs: Option<FourSprings> = None,
        /// Energy of its four springs at which a neck breaks.
        break_energy: Option<Quantity<Energy>> = None,
        /// Stresses at which a neck breaks; without them, and without that energy, it never does.
        break_stress: Option<NeckStrength> = None,
        /// The springs of a frictional contact.
        contact: FourSprings = published_contact(),
        /// The friction of such a contact.
        friction: Rubbing = defaults(),
        /// Hamaker constant.
        hamaker_constant: Quantity<Energy> = quantity("1e-19 J"),
        /// Hamaker constant between a sphere and the substrate.
        substrate_hamaker_constant: Quantity<Energy> = quantity("1e-19 J"),
        /// Hamaker constant between a sphere and the tip.
        tip_hamaker_constant: Quantity<Energy> = quantity("1e-18 J"),
        /// Gap at which the van der Waals force stops growing.
        saturation: Quantity<Length> = quantity("1 nm"),
        /// Largest capillary force of two spheres while the coating acts, in a restructuring; `0 nN` for dry soot.
        capillary_force: Quantity<Force> = quantity("1 nN"),
        /// Distance of centres at which half of it is left.
        capillary_reach: Quantity<Length> = quantity("56 nm"),
        /// How sharply it drops there.
        capillary_sharpness: Quantity<Sharpness> = quantity("0.178571429 1/nm"),
        /// Distance of centres, and of a centre from a surface, beyond which no attraction acts.
        cutoff: Quantity<Length> = quantity("70 nm"),
        /// How a twist of a contact or neck is resisted.
        torsion: Torsion = Torsion::Spring,
    }
}

words! {
    /// A published set of the springs of a neck.
    pub enum NeckSet {
        /// 1e5 N/m throughout: deposition and indentation; stable at 50 fs.
        S = "S",
        /// 1e6 N/m along the normal, 1e7 N/m else: restructuring; needs 5 fs.
        P = "P",
    }
}

words! {
    /// How a twist is resisted.
    pub enum Torsion {
        /// By a spring and a dashpot.
        Spring = "spring",
        /// By a dashpot; the spring is turned into the contact plane, as the paper says, and bends the pair.
        AsPrinted = "as-printed",
        /// The same, and all springs act before they are stretched, as in the authors' program: their stiffness times the step is taken from their dashpots.
        AsPublished = "as-published",
    }
}

section! {
    /// The strength of a neck, an elastic beam with a circular section.
    pub struct NeckStrength {
        /// Largest tensile stress, of pulling and bending together.
        tension: Quantity<Pressure>,
        /// Largest shear stress, of shearing and twisting together.
        shear: Quantity<Pressure>,
        /// Radius of its section.
        neck_radius: Quantity<Length>,
    }
}

section! {
    /// Friction coefficients: of sliding, rolling, torsion.
    pub struct Rubbing {
        /// At rest.
        at_rest: [f64; 3] = [1.0, 0.1, 0.1],
        /// In motion, at most those at rest.
        in_motion: [f64; 3] = [1.0, 0.1, 0.1],
    }
}

fn published_contact() -> FourSprings {
    four_springs(["1e4 N/m"; 4], ["5e-9 kg/s", "1e-9 kg/s", "2.5e-10 kg/s", "2.5e-10 kg/s"])
}

impl NeckSet {
    /// The springs of the set.
    pub fn springs(self) -> FourSprings {
        match self {
            Self::S => four_springs(["1e5 N/m"; 4], ["1.25e-7 kg/s", "2.5e-8 kg/s", "6.25e-9 kg/s", "6.25e-9 kg/s"]),
            Self::P => four_springs(
                ["1e6 N/m", "1e7 N/m", "1e7 N/m", "1e7 N/m"],
                ["1.25e-6 kg/s", "2.5e-7 kg/s", "6.25e-8 kg/s", "6.25e-8 kg/s"],
            ),
        }
    }
}

impl Soot {
    /// The contact law in engine units, its springs read as the caller does.
    pub fn law<S>(&self, reading: S) -> soot::Soot<S> {
        let ([static_t, static_r, static_o], [dynamic_t, dynamic_r, dynamic_o]) =
            (self.friction.at_rest, self.friction.in_motion);
        let friction = Friction { static_t, static_r, static_o, dynamic_t, dynamic_r, dynamic_o };
        let (contact, delta_0, cutoff) = (self.contact.spec(), self.saturation.value, self.cutoff.value);
        let wall = |hamaker: f64| soot::Wall { contact, friction, hamaker, delta_0, cutoff };
        soot::Soot {
            neck: self.neck_springs.clone().unwrap_or_else(|| self.necks.unwrap_or(NeckSet::P).springs()).spec(),
            contact,
            friction,
            attraction: soot::Attraction {
                a: self.hamaker_constant.value,
                delta_0,
                psi: self.capillary_force.value,
                kappa: self.capillary_sharpness.value,
                d_cutoff: self.capillary_reach.value,
                cutoff,
            },
            reading,
            walls: [&self.substrate_hamaker_constant, &self.tip_hamaker_constant].map(|a| wall(a.value)),
        }
    }

    /// The contact law of a stage: the coating acts only in a restructuring.
    pub fn law_of<S>(&self, reading: S, stage: &SootStage) -> soot::Soot<S> {
        let mut law = self.law(reading);
        if !matches!(stage, SootStage::Restructuring(_)) {
            law.attraction.psi = 0.0;
        }
        law
    }
}

/// The model, the sample and the stages of a case.
pub fn parts(case: &Case) -> (&Soot, &Aggregate, Vec<SootStage>) {
    let (Model::Soot(soot), Sample::Aggregate(sample)) = (&case.model, &case.sample);
    let stages = match &case.experiment {
        Experiment::Deposition(test) => vec![SootStage::Deposition(test.clone())],
        Experiment::Restructuring(test) => vec![SootStage::Restructuring(test.clone())],
        Experiment::Sequence(stages) => stages.clone(),
    };
    (soot, sample, stages)
}

/// Chooses the springs of necks that a case leaves open.
pub fn choose_necks(case: &mut Case) {
    let (.., stages) = parts(case);
    let restructured = stages.iter().all(|stage| matches!(stage, SootStage::Restructuring(_)));
    let Model::Soot(soot) = &mut case.model;
    if soot.neck_springs.is_none() {
        soot.necks.get_or_insert(if restructured { NeckSet::P } else { NeckSet::S });
    }
}

/// The key of a stage in the case.
pub fn key(case: &Case, number: usize, stage: &SootStage) -> String {
    match &case.experiment {
        Experiment::Sequence(_) => format!("experiment.sequence[{number}].{}", stage.name()),
        _ => format!("experiment.{}", stage.name()),
    }
}

/// The files that a case reads.
pub fn reads(case: &Case) -> Vec<PathBuf> {
    let (_, Aggregate { import, deposited, .. }, stages) = parts(case);
    let surfaces = stages.iter().filter_map(|stage| stage.solid().map(|solid| solid.stl.clone()));
    let imported = import.iter().flat_map(|import| [Some(import.file.clone()), import.necks.clone()]).flatten();
    imported.chain(deposited.clone()).chain(surfaces).collect()
}

/// The files that a case writes beside its run folder, with the sections that ask for them.
pub fn saves(case: &Case) -> Vec<(String, PathBuf)> {
    let stages = parts(case).2;
    let save = |(number, stage): (usize, &SootStage)| match stage {
        SootStage::Deposition(Deposition { save: Some(file), .. }) => Some((key(case, number, stage), file.clone())),
        _ => None,
    };
    stages.iter().enumerate().filter_map(save).collect()
}

/// What follows from a case, with units: of spheres from a file, little is known before it is read.
pub fn derived(case: &Case) -> Vec<(String, String)> {
    let (soot, sample, stages) = parts(case);
    let mut rows = Vec::new();
    if let Some(radii) = sample.radii() {
        let (r, limit) = (sample.radius.value, soot.step_limit(radii));
        let mass = sphere_mass(soot.density.value, r);
        rows.extend([
            ("mass of a sphere".into(), in_unit(mass, "kg")),
            ("moment of inertia of a sphere".into(), in_unit(solid_inertia(mass, r), "kg m^2")),
            ("largest stable time step".into(), in_unit(limit, "fs")),
        ]);
        // Drawn radii have another mean than theirs, and fewer than three spheres no choice.
        if radii == [r, r] && sample.spheres >= 3 {
            let gyration = gyration_radius(sample.prefactor, sample.spheres as f64, r, sample.fractal_dimension);
            rows.push(("gyration radius R_g".into(), in_unit(gyration, "nm")));
        }
        if soot.torsion == Torsion::AsPublished {
            let lag = in_unit(soot.law(Programmed).contact.lag_limit(), "fs");
            rows.push(("that above which contacts gain energy until they slip".into(), lag));
        } else {
            rows.push(("that of a sphere with six necks, about".into(), in_unit(SIX_NECKS * limit, "fs")));
        }
        rows.extend(stages.iter().enumerate().map(|(number, stage)| {
            let dt = stage.dt().value;
            let text = format!("{} = {} of the largest stable step", in_unit(dt, "fs"), rounded(dt / limit));
            (format!("{}.dt", key(case, number, stage)), text)
        }));
        let at_the_cutoff =
            |stage| soot.law_of(Along, stage).attraction.force(soot.cutoff.value, soot.cutoff.value - 2.0 * r, r, r);
        let left = stages.iter().map(at_the_cutoff).fold(0.0, f64::max);
        rows.push(("attraction at the cutoff, where it ends".into(), in_unit(left, "N")));
    }
    rows
}

impl Soot {
    /// The largest stable time step of two spheres with radii between these that nothing else touches, ns. Where spheres have more necks it is smaller: 0.69 of it with three on
    /// one sphere, 0.56 in a row of five.
    pub fn step_limit(&self, [least, largest]: [f64; 2]) -> f64 {
        let m = sphere_mass(self.density.value, least);
        match self.torsion {
            Torsion::Spring => self.law(Along).critical_time_step_among(least, m, largest),
            Torsion::AsPrinted => self.law(Printed).critical_time_step_among(least, m, largest),
            Torsion::AsPublished => self.law(Programmed).critical_time_step_among(least, m, largest),
        }
    }
}

/// The largest stable time step of a sphere with six necks over that of one with one.
const SIX_NECKS: f64 = 0.52;
