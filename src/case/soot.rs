//! The sections of a case of the soot paper. Defaults are the authors' published inputs.

mod stages;

pub use stages::*;

use super::quantity::{Density, Drag, Energy, Force, Length, Quantity, Sharpness, Stiffness};
use super::section::{defaults, section, words};
use super::units::{in_unit, rounded};
use super::{Case, Experiment, Model, Sample};
use crate::spec::soot::def_sphere::solid_inertia;
use crate::spec::soot::eq24_fractal::gyration_radius;
use crate::spec::wear::def_sphere::sphere_mass;
use crate::spec::{PairModel, soot};
use serde_yaml::{Mapping, Value};
use std::path::PathBuf;

/// A quantity that is written in this file, not by a user.
pub(super) fn quantity<K: super::quantity::Kind>(text: &str) -> Quantity<K> {
    Quantity::parse(text).expect("a quantity of the right kind")
}

section! {
    /// The interactions of soot spheres.
    pub struct Soot {
        /// Density of the spheres.
        density: Quantity<Density> = quantity("1700 kg/m^3"),
        /// The springs of a neck.
        necks: NeckSet = NeckSet::P,
        /// Springs of a neck that are neither of the published sets.
        neck_springs: Option<FourSprings> = None,
        /// Energy of its four springs at which a neck breaks; without it necks never do.
        break_energy: Option<Quantity<Energy>> = None,
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
        /// By the dashpot alone: what the published program comes to.
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
    /// Friction coefficients: of sliding, rolling, torsion.
    pub struct Rubbing {
        /// At rest.
        at_rest: [f64; 3] = [1.0, 0.1, 0.1],
        /// In motion, at most those at rest.
        in_motion: [f64; 3] = [1.0, 0.1, 0.1],
    }
}

section! {
    /// A fractal aggregate of touching spheres, by cluster-cluster aggregation: N = k_f (R_g / r)^D_f.
    pub struct Aggregate {
        /// Number of spheres N.
        spheres: u64 = 150,
        /// Their radius r.
        radius: Quantity<Length> = quantity("14 nm"),
        /// Fractal dimension D_f.
        fractal_dimension: f64 = 1.8,
        /// Fractal prefactor k_f.
        prefactor: f64 = 1.4,
        /// Geometric standard deviation of the radii, whose median is r; 1 for equal spheres.
        deviation: f64 = 1.0,
        /// In which order the spheres come together.
        growth: Growth = Growth::Clusters,
        /// Reads the spheres from a file instead of growing them: the keys above then only give what the file lacks.
        import: Option<Import> = None,
        /// File with a deposited aggregate to start from; it must have been made with the same keys beside this one and the same model. Another
        /// seed then breaks other necks and indents another sphere.
        deposited: Option<PathBuf> = None,
        /// Part of the contacts that are necks; which ones is drawn from the seed.
        neck_fraction: f64 = 0.5,
        /// Largest gap that a neck bridges: enough for rounding. A neck across a real gap, whose springs are relaxed at contact, would begin
        /// stretched.
        neck_distance: Quantity<Length> = quantity("0.01 nm"),
    }
}

words! {
    /// In which order the spheres of an aggregate come together.
    pub enum Growth {
        /// Clusters of like size are joined.
        Clusters = "clusters",
        /// One sphere after the other: the way to compact aggregates.
        Spheres = "spheres",
    }
}

section! {
    /// An aggregate from FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem (VTK), LAMMPS, or an XYZ file.
    pub struct Import {
        /// The file.
        file: PathBuf,
        /// Its unit of length, where it has none of its own.
        unit: Option<Quantity<Length>> = None,
        /// The radius of all spheres, where it has none.
        radius: Option<Quantity<Length>> = None,
        /// Accepts spheres that do not hang together.
        disconnected: bool = false,
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
    /// The contact law in engine units.
    pub fn law(&self) -> soot::Soot {
        let ([static_t, static_r, static_o], [dynamic_t, dynamic_r, dynamic_o]) =
            (self.friction.at_rest, self.friction.in_motion);
        let torsion = match self.torsion {
            Torsion::Spring => soot::Torsion::Spring,
            Torsion::AsPublished => soot::Torsion::AsPublished,
        };
        let friction = soot::Friction { static_t, static_r, static_o, dynamic_t, dynamic_r, dynamic_o };
        let (contact, delta_0, cutoff) = (self.contact.spec(), self.saturation.value, self.cutoff.value);
        let wall = |hamaker: f64| soot::Wall { contact, friction, hamaker, delta_0, cutoff, torsion };
        soot::Soot {
            neck: self.neck_springs.clone().unwrap_or_else(|| self.necks.springs()).spec(),
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
            torsion,
            walls: [&self.substrate_hamaker_constant, &self.tip_hamaker_constant].map(|a| wall(a.value)),
        }
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
        let import = import.as_ref().map(|import| import.file.clone());
        import.into_iter().chain(deposited.clone()).chain(surfaces).collect()
    }

    /// The largest stable time step of a case of the soot paper, ns.
    pub fn soot_step_limit(&self) -> f64 {
        let (soot, sample, _) = self.soot().expect(OF_SOOT);
        let r = sample.radius.value;
        soot.law().critical_time_step(r, sphere_mass(soot.density.value, r))
    }

    /// What follows from a case of the soot paper, with units.
    pub(super) fn derived_of_soot(&self) -> Mapping {
        let (soot, sample, stages) = self.soot().expect(OF_SOOT);
        let (r, limit) = (sample.radius.value, self.soot_step_limit());
        let mass = sphere_mass(soot.density.value, r);
        let gyration = gyration_radius(sample.prefactor, sample.spheres as f64, r, sample.fractal_dimension);
        let rows = [
            ("mass of a sphere", in_unit(mass, "kg")),
            ("moment of inertia of a sphere", in_unit(solid_inertia(mass, r), "kg m^2")),
            ("gyration radius R_g", in_unit(gyration, "nm")),
            ("largest stable time step", in_unit(limit, "fs")),
        ];
        let steps = stages.iter().enumerate().map(|(number, stage)| {
            let dt = stage.dt().value;
            let text = format!("{} = {} of the largest stable step", in_unit(dt, "fs"), rounded(dt / limit));
            (format!("{}.dt", self.soot_key(number, stage)), text)
        });
        let rows = rows.into_iter().map(|(key, value)| (String::from(key), value)).chain(steps);
        rows.map(|(key, value)| (Value::String(key), Value::String(value))).collect()
    }
}

const OF_SOOT: &str = "asked only of cases of the soot paper";
