//! The sections of a case of the soot paper. Defaults are the authors' published inputs, but for the distance that necks bridge.

mod sample;
mod stages;

pub use sample::*;
pub use stages::*;

use super::quantity::{Density, Drag, Energy, Force, Length, Pressure, Quantity, Sharpness, Stiffness};
use super::section::{defaults, section, words};
use super::units::{in_unit, rounded};
use super::{Case, Experiment, Model, Sample};
use crate::spec::PairModel;
use crate::spec::soot::def_sphere::solid_inertia;
use crate::spec::soot::eq24_fractal::gyration_radius;
use crate::spec::soot::{self, Along, Printed, Programmed};
use crate::spec::wear::def_sphere::sphere_mass;
use serde_yaml::{Mapping, Value};
use std::path::PathBuf;

/// A quantity that is written in this file, not by a user.
pub(crate) fn quantity<K: super::quantity::Kind>(text: &str) -> Quantity<K> {
    Quantity::parse(text).expect("a quantity of the right kind")
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
    /// Four springs with their dashpots.
    pub struct FourSprings {
        /// Normal stiffness.
        normal_stiffness: Quantity<Stiffness>,
        /// Tangential stiffness.
        tangential_stiffness: Quantity<Stiffness>,
        /// Rolling stiffness.
        rolling_stiffness: Quantity<Stiffness>,
        /// Torsional stiffness.
        torsional_stiffness: Quantity<Stiffness>,
        /// Normal damping coefficient.
        normal_damping: Quantity<Drag>,
        /// Tangential damping coefficient.
        tangential_damping: Quantity<Drag>,
        /// Rolling damping coefficient.
        rolling_damping: Quantity<Drag>,
        /// Torsional damping coefficient.
        torsional_damping: Quantity<Drag>,
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

fn springs(stiffness: [&str; 4], damping: [&str; 4]) -> FourSprings {
    let ([k_n, k_t, k_r, k_o], [c_n, c_t, c_r, c_o]) = (stiffness, damping);
    FourSprings {
        normal_stiffness: quantity(k_n),
        tangential_stiffness: quantity(k_t),
        rolling_stiffness: quantity(k_r),
        torsional_stiffness: quantity(k_o),
        normal_damping: quantity(c_n),
        tangential_damping: quantity(c_t),
        rolling_damping: quantity(c_r),
        torsional_damping: quantity(c_o),
    }
}

fn published_contact() -> FourSprings {
    springs(["1e4 N/m"; 4], ["5e-9 kg/s", "1e-9 kg/s", "2.5e-10 kg/s", "2.5e-10 kg/s"])
}

impl NeckSet {
    /// The springs of the set.
    pub fn springs(self) -> FourSprings {
        match self {
            Self::S => springs(["1e5 N/m"; 4], ["1.25e-7 kg/s", "2.5e-8 kg/s", "6.25e-9 kg/s", "6.25e-9 kg/s"]),
            Self::P => springs(
                ["1e6 N/m", "1e7 N/m", "1e7 N/m", "1e7 N/m"],
                ["1.25e-6 kg/s", "2.5e-7 kg/s", "6.25e-8 kg/s", "6.25e-8 kg/s"],
            ),
        }
    }
}

impl FourSprings {
    /// The springs in engine units.
    pub fn spec(&self) -> soot::Springs<f64> {
        soot::Springs {
            k_n: self.normal_stiffness.value,
            k_t: self.tangential_stiffness.value,
            k_r: self.rolling_stiffness.value,
            k_o: self.torsional_stiffness.value,
            eta_n: self.normal_damping.value,
            eta_t: self.tangential_damping.value,
            eta_r: self.rolling_damping.value,
            eta_o: self.torsional_damping.value,
        }
    }
}

impl Soot {
    /// The contact law in engine units, its springs read as the caller does.
    pub fn law<S>(&self, reading: S) -> soot::Soot<S> {
        let ([static_t, static_r, static_o], [dynamic_t, dynamic_r, dynamic_o]) =
            (self.friction.at_rest, self.friction.in_motion);
        let friction = soot::Friction { static_t, static_r, static_o, dynamic_t, dynamic_r, dynamic_o };
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

impl Case {
    /// The sections of a case of the soot paper, if it is one.
    pub fn soot(&self) -> Option<(&Soot, &Aggregate, Vec<SootStage>)> {
        let stages = match &self.experiment {
            Experiment::Deposition(test) => vec![SootStage::Deposition(test.clone())],
            Experiment::Restructuring(test) => vec![SootStage::Restructuring(test.clone())],
            Experiment::Sequence(stages) => stages.clone(),
            _ => return None,
        };
        match (&self.model, &self.sample) {
            (Model::Soot(soot), Sample::Aggregate(sample)) => Some((soot, sample, stages)),
            _ => None,
        }
    }

    /// Chooses the springs of necks that a case of the soot paper leaves open.
    pub(super) fn choose_necks(&mut self) {
        let Some((.., stages)) = self.soot() else { return };
        let restructured = stages.iter().all(|stage| matches!(stage, SootStage::Restructuring(_)));
        if let Model::Soot(Soot { necks, neck_springs: None, .. }) = &mut self.model {
            necks.get_or_insert(if restructured { NeckSet::P } else { NeckSet::S });
        }
    }

    /// The key of a stage of a case of the soot paper.
    pub fn soot_key(&self, number: usize, stage: &SootStage) -> String {
        match &self.experiment {
            Experiment::Sequence(_) => format!("experiment.sequence[{number}].{}", stage.name()),
            _ => format!("experiment.{}", stage.name()),
        }
    }

    /// The files that a case of the soot paper needs.
    pub fn soot_files(&self) -> Vec<PathBuf> {
        let Some((_, Aggregate { import, deposited, .. }, stages)) = self.soot() else { return Vec::new() };
        let surfaces = stages.iter().filter_map(|stage| stage.solid().map(|solid| solid.stl.clone()));
        let imported = import.iter().flat_map(|import| [Some(import.file.clone()), import.necks.clone()]).flatten();
        imported.chain(deposited.clone()).chain(surfaces).collect()
    }

    /// What follows from a case of the soot paper, with units: of spheres from a file, little is known before it is read.
    pub(super) fn derived_of_soot(&self) -> Mapping {
        let (soot, sample, stages) = self.soot().expect(OF_SOOT);
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
                (format!("{}.dt", self.soot_key(number, stage)), text)
            }));
            let at_the_cutoff = |stage| {
                soot.law_of(Along, stage).attraction.force(soot.cutoff.value, soot.cutoff.value - 2.0 * r, r, r)
            };
            let left = stages.iter().map(at_the_cutoff).fold(0.0, f64::max);
            rows.push(("attraction at the cutoff, where it ends".into(), in_unit(left, "N")));
        }
        rows.into_iter().map(|(key, value)| (Value::String(key), Value::String(value))).collect()
    }
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
const OF_SOOT: &str = "asked only of cases of the soot paper";
