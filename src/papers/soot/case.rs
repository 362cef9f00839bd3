//! The sections of a case of the soot paper. Defaults are the authors' published inputs, except the largest gap of a neck.

mod derived;
mod necks;
mod pair;
mod sample;
mod stages;

pub use derived::{derived, unused};
pub use necks::*;
pub use pair::*;
pub use sample::*;
pub use stages::*;

use crate::case::quantity::{Density, Energy, Force, Length, Quantity, Sharpness, quantity};
use crate::case::section::{choice, defaults, section, words};
use crate::case::springs::{FourSprings, Transport, four_springs};
use crate::initial::aggregate::import::Import;
use crate::spec::PairModel;
use crate::spec::mechanics::four_springs::Friction;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::{self, Along, Lagging, Printed, Programmed};
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
    /// The initial arrangement of the particles.
    pub enum Sample {
        /// A fractal aggregate.
        Aggregate = "aggregate": Aggregate,
        /// Two spheres.
        Pair = "pair": TwoSpheres,
    }
}

choice! {
    /// The experiment.
    pub enum Experiment {
        /// Deposition of an aggregate on a substrate.
        Deposition = "deposition": Deposition,
        /// Restructuring of a coated aggregate.
        Restructuring = "restructuring": Restructuring,
        /// A path of two spheres: sliding, rolling, twisting, and pulling.
        Path = "path": Path,
        /// A sequence of depositions, indentations and restructurings.
        Sequence = "sequence": Vec<SootStage>,
    }
}

section! {
    /// The interactions of soot spheres.
    pub struct Soot {
        /// Density of the spheres.
        density: Quantity<Density> = quantity("1700 kg/m^3"),
        /// Springs of a neck; the default is P if all stages are restructurings, otherwise S.
        necks: Option<NeckSet> = None,
        /// Springs of a neck, if they are neither of the published sets.
        neck_springs: Option<FourSprings> = None,
        /// Energy stored in the four springs of a neck at which it breaks.
        break_energy: Option<Quantity<Energy>> = None,
        /// Strength of a neck; without this key and `break_energy` necks never break.
        break_stress: Option<NeckStrength> = None,
        /// Strengths of single necks relative to `break_energy` and `break_stress`: stresses are multiplied by a number for each neck, the energy by its square; without this key all are alike.
        neck_strengths: Option<NeckStrengths> = None,
        /// Springs of a frictional contact.
        contact: FourSprings = published_contact(),
        /// Friction coefficients of a contact.
        friction: FrictionCoefficients = defaults(),
        /// Hamaker constant of two spheres.
        hamaker_constant: Quantity<Energy> = quantity("1e-19 J"),
        /// Hamaker constant of a sphere and the substrate.
        substrate_hamaker_constant: Quantity<Energy> = quantity("1e-19 J"),
        /// Hamaker constant of a sphere and the tip.
        tip_hamaker_constant: Quantity<Energy> = quantity("1e-18 J"),
        /// Gap below which the van der Waals force is constant.
        saturation: Quantity<Length> = quantity("1 nm"),
        /// Largest capillary force between two coated spheres, during restructuring; `0 nN` for dry soot.
        capillary_force: Quantity<Force> = quantity("1 nN"),
        /// Centre distance at which the capillary force has fallen to one half.
        capillary_reach: Quantity<Length> = quantity("56 nm"),
        /// Sharpness of this decrease.
        capillary_sharpness: Quantity<Sharpness> = quantity("0.178571429 1/nm"),
        /// Cutoff of the attraction: distance between centres, or between a centre and a surface.
        cutoff: Quantity<Length> = quantity("70 nm"),
        /// Resistance of contacts and necks to torsion.
        torsion: Torsion = Torsion::Spring,
        /// Whether the springs of contacts and necks act before or after they are stretched by a step.
        springs_act: SpringsAct = SpringsAct::AfterStretching,
        /// Whether tangential and rolling springs follow a pair that spins about its normal; `carried` is a reading that no paper takes.
        springs: Transport = Transport::Projected,
    }
}

words! {
    /// Resistance to torsion.
    pub enum Torsion {
        /// A spring and a dashpot.
        Spring = "spring",
        /// A dashpot only; the spring is rotated into the contact plane, as the paper says, and bends the pair.
        AsPrinted = "as-printed",
        /// The springs of the authors' program: `as-printed`, and all springs act before they are stretched, whatever `springs_act` says. The program differs from it at its start, where it stretches all springs three times; where
        /// spheres part so fast that their dashpot pulls, in which case its friction pushes along the motion; in the arm of the rolling torque, for which it takes the radius; and at surfaces, of which every facet acts.
        AsPublished = "as-published",
    }
}

words! {
    /// Order of stretching and acting within a step.
    pub enum SpringsAct {
        /// They act with the elongation at the end of the step.
        AfterStretching = "after-stretching",
        /// They act with the elongation at its beginning: they lag by one step, which reduces each damping coefficient by the stiffness times the time step.
        BeforeStretching = "before-stretching",
    }
}

section! {
    /// Coefficients of sliding, rolling and torsional friction.
    pub struct FrictionCoefficients {
        /// Static coefficients.
        at_rest: [f64; 3] = [1.0, 0.1, 0.1],
        /// Dynamic coefficients, at most the static ones.
        in_motion: [f64; 3] = [1.0, 0.1, 0.1],
    }
}

/// The published springs of a frictional contact.
pub(super) fn published_contact() -> FourSprings {
    four_springs(["1e4 N/m"; 4], ["5e-9 kg/s", "1e-9 kg/s", "2.5e-10 kg/s", "2.5e-10 kg/s"])
}

impl Soot {
    /// The contact law in engine units, with the given reading of the springs.
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

/// The model, the sample and the stages of a case about an aggregate.
pub fn parts(case: &Case) -> Option<(&Soot, &Aggregate, Vec<SootStage>)> {
    let (Model::Soot(soot), Sample::Aggregate(sample)) = (&case.model, &case.sample) else { return None };
    let stages = match &case.experiment {
        Experiment::Deposition(test) => vec![SootStage::Deposition(test.clone())],
        Experiment::Restructuring(test) => vec![SootStage::Restructuring(test.clone())],
        Experiment::Sequence(stages) => stages.clone(),
        Experiment::Path(_) => return None,
    };
    Some((soot, sample, stages))
}

/// The model, the spheres and the path of a case about two spheres.
pub fn path(case: &Case) -> Option<(&Soot, &TwoSpheres, &Path)> {
    match (&case.model, &case.sample, &case.experiment) {
        (Model::Soot(soot), Sample::Pair(pair), Experiment::Path(path)) => Some((soot, pair, path)),
        _ => None,
    }
}

/// Chooses the springs of necks if the case does not.
pub fn choose_necks(case: &mut Case) {
    let restructured =
        parts(case).is_some_and(|(.., stages)| stages.iter().all(|stage| matches!(stage, SootStage::Restructuring(_))));
    let Model::Soot(soot) = &mut case.model;
    if soot.neck_springs.is_none() {
        soot.necks.get_or_insert(if restructured { NeckSet::P } else { NeckSet::S });
    }
}

/// The key of a stage in the case.
pub fn key(case: &Case, number: usize, stage: &SootStage) -> String {
    stage.key(matches!(case.experiment, Experiment::Sequence(_)).then_some(number))
}

/// The files that a case reads.
pub fn reads(case: &mut Case) -> Vec<&mut PathBuf> {
    let Model::Soot(soot) = &mut case.model;
    let strengths = if let Some(NeckStrengths::File(file)) = &mut soot.neck_strengths { Some(file) } else { None };
    let Sample::Aggregate(Aggregate { import, deposited, .. }) = &mut case.sample else { return Vec::new() };
    let imported = import.iter_mut().flat_map(Import::files_mut);
    let surfaces: Vec<&mut Solid> = match &mut case.experiment {
        Experiment::Deposition(test) => test.substrate.iter_mut().collect(),
        Experiment::Restructuring(_) | Experiment::Path(_) => Vec::new(),
        Experiment::Sequence(stages) => stages.iter_mut().filter_map(SootStage::solid_mut).collect(),
    };
    imported.chain(strengths).chain(deposited).chain(surfaces.into_iter().map(|solid| &mut solid.stl)).collect()
}

/// The files that a case writes beside its run folder, with the sections that ask for them.
pub fn saves(case: &mut Case) -> Vec<(String, &mut PathBuf)> {
    let Some((.., stages)) = parts(case) else { return Vec::new() };
    let keys: Vec<String> = stages.iter().enumerate().map(|(number, stage)| key(case, number, stage)).collect();
    let saves: Vec<Option<&mut PathBuf>> = match &mut case.experiment {
        Experiment::Deposition(test) => vec![test.save.as_mut()],
        Experiment::Restructuring(_) | Experiment::Path(_) => Vec::new(),
        Experiment::Sequence(stages) => stages.iter_mut().map(SootStage::save_mut).collect(),
    };
    keys.into_iter().zip(saves).filter_map(|(key, save)| Some((key, save?))).collect()
}

impl Soot {
    /// The largest stable time step of an isolated pair of spheres with radii in this range, ns. More necks per sphere reduce it: to 0.69 of this value for a sphere with three
    /// necks, to 0.56 in a row of five spheres.
    pub fn step_limit(&self, [least, largest]: [f64; 2]) -> f64 {
        let m = sphere_mass(self.density.value, least);
        match (self.torsion, self.lags()) {
            (Torsion::Spring, false) => self.law(Along).critical_time_step_among(least, m, largest),
            (Torsion::Spring, true) => self.law(Lagging).critical_time_step_among(least, m, largest),
            (_, false) => self.law(Printed).critical_time_step_among(least, m, largest),
            (_, true) => self.law(Programmed).critical_time_step_among(least, m, largest),
        }
    }

    /// Whether springs act before they are stretched.
    pub fn lags(&self) -> bool {
        self.torsion == Torsion::AsPublished || self.springs_act == SpringsAct::BeforeStretching
    }
}
