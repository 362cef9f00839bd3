//! Demidov, Gor & Khalizov 2024: soot aggregates with necks, deposited, indented, restructured.

pub mod case;
pub mod check;
#[cfg(feature = "cli")]
pub mod claims;
pub mod columns;
mod energy;
mod lammps;
mod place;
mod sample;
#[cfg(feature = "cli")]
mod shown;
mod stage;
mod strengths;
mod study;
pub mod tip;
#[cfg(feature = "verify")]
mod trajectories;
pub mod watch;

pub use study::Plan;

use super::{AtStart, Paper};
use crate::case::check::Found;
use crate::case::quantity::{Length, Quantity};
use crate::case::springs::Transport;
use crate::error::Error;
use crate::figures::Graph;
use crate::geometry::Sphere;
#[cfg(feature = "verify")]
use crate::golden::Trajectory;
use crate::initial::aggregate::necks::{Neck, NeckLength};
use crate::interrupt::Interrupt;
use crate::output::Column;
use crate::output::aggregate::{CONVEXITY, COORDINATION, GYRATION_RADIUS};
use crate::output::columns::{KINETIC, TIME};
use crate::papers::path::{self, Breaks, PathPlan};
#[cfg(feature = "cli")]
use crate::reproduce::{Chapter, Listed};
use crate::run::Runnable;
use crate::spec::mechanics::sphere::sphere_mass;
use crate::spec::soot::{self, Along, Following, Lagging, Printed, Programmed, Reading};
use case::{Case, Experiment, Model, Sample, Torsion};
use columns::{HEIGHT, PULL, READING, TIP_DISPLACEMENT};
use std::path::{Path, PathBuf};

/// The paper.
pub struct Soot;

/// Events marked on the force curve: breaking necks.
const MARKS: &[&str] = &["breaks"];

impl Paper for Soot {
    const NAME: &'static str = "soot";
    const REFERENCE: &'static str = "Demidov, Gor & Khalizov 2024";
    const TITLE: &'static str = "Discrete element method model of soot aggregates: claims and results";
    const GRAPHS: &'static [Graph] = &[
        Graph { name: "coordination", stages: &["restructuring"], x: TIME, y: COORDINATION, marks: &[] },
        Graph { name: "convexity", stages: &["restructuring"], x: TIME, y: CONVEXITY, marks: &[] },
        Graph { name: "gyration", stages: &["restructuring"], x: TIME, y: GYRATION_RADIUS, marks: &[] },
        Graph { name: "height", stages: &["deposition"], x: TIME, y: HEIGHT, marks: &[] },
        Graph { name: "deposition energy", stages: &["deposition"], x: TIME, y: KINETIC, marks: &[] },
        Graph { name: "force curve", stages: &["indentation"], x: TIP_DISPLACEMENT, y: READING, marks: &[] },
        Graph {
            name: "force on the neck",
            stages: &["leg"],
            x: path::ELONGATION,
            y: path::FORCE_X_SECOND,
            marks: MARKS,
        },
        Graph { name: "force on the tip", stages: &["indentation"], x: TIP_DISPLACEMENT, y: PULL, marks: MARKS },
    ];
    const QUANTITIES: &'static [(&'static str, &'static [Column])] = &[
        ("Columns of all stages, beside the first three of the shape", columns::AGGREGATE),
        ("Columns of stages with a substrate", columns::ON_SUBSTRATE),
        ("Columns of an indentation", columns::ON_TIP),
        ("Columns of a path", path::COLUMNS),
        ("Column of a path that pulls", path::PULLED),
        ("Results of each leg of a path", path::results::ALL),
        ("Results of a leg in which a neck may break", path::results::BREAKING),
        ("Results, beside the initial and the final shape", columns::results::ALL),
    ];
    #[cfg(feature = "cli")]
    const CHAPTERS: &'static [Chapter] = claims::CHAPTERS;
    #[cfg(feature = "cli")]
    const TABLES: &'static [super::shown::Table] = shown::TABLES;
    #[cfg(feature = "cli")]
    const LISTED: &'static [Listed] = claims::LISTED;
    #[cfg(feature = "verify")]
    const TRAJECTORIES: &'static [Trajectory] = trajectories::TRAJECTORIES;

    type Model = Model;
    type Sample = Sample;
    type Experiment = Experiment;

    fn complete(case: &mut Case) {
        case::choose_necks(case);
    }
    fn check(case: &Case, found: &mut Found) {
        check::problems(case, found);
    }
    fn unused(case: &Case) -> &'static [&'static str] {
        case::unused(case)
    }
    fn derived(case: &Case) -> Vec<(String, String)> {
        case::derived(case)
    }
    fn reads(case: &mut Case) -> Vec<&mut PathBuf> {
        case::reads(case)
    }
    fn saves(case: &mut Case) -> Vec<(String, &mut PathBuf)> {
        case::saves(case)
    }
    fn imported(
        spheres: &[Sphere],
        necks: &[Neck],
        length: NeckLength,
        interrupt: &Interrupt,
    ) -> Result<Option<AtStart>, Error> {
        let text = "title: a deposition\nmodel: {soot: {}}\nsample: {aggregate: {}}\nexperiment: {deposition: {}}\n";
        let mut plan = Plan::of(&super::parse::<Self>(Path::new(""), text).expect("a case of defaults"), Along);
        plan.sample.neck_length = length;
        let (kept, energy) = plan.kept(spheres, necks, interrupt)?;
        let refusal = energy.allowed(plan.sample.initial_energy).err().map(|error| error.to_string());
        Ok(Some(AtStart { paper: Self::NAME, necks: kept.len(), springs: energy.stored, refusal }))
    }
    #[cfg(feature = "cli")]
    fn shown_laws() -> Vec<super::shown::Law> {
        shown::laws()
    }
    fn study(case: Case) -> Box<dyn Runnable> {
        let Model::Soot(model) = &case.model;
        match (model.torsion, model.lags(), model.springs) {
            (.., Transport::Carried) => planned(&case, Following),
            (Torsion::Spring, false, _) => planned(&case, Along),
            (Torsion::Spring, true, _) => planned(&case, Lagging),
            (_, false, _) => planned(&case, Printed),
            (_, true, _) => planned(&case, Programmed),
        }
    }
}

/// When the neck of two spheres breaks, by its own strength if it has one.
fn breaks<S: Reading + 'static>(soot: &case::Soot, own: Option<f64>) -> Option<Breaks<soot::Soot<S>>> {
    let strength = soot.strength().times(own.unwrap_or(1.0));
    let breaks = move |law: &soot::Soot<S>, contact: &_, springs: &_, held: &_| {
        law.neck_breaks(contact, springs, held, &strength)
    };
    (strength != soot::Strength::default()).then(|| Box::new(breaks) as Breaks<soot::Soot<S>>)
}

/// The plan of a case whose springs are read like this.
fn planned<S: Reading + 'static>(case: &Case, reading: S) -> Box<dyn Runnable> {
    let Some((soot, pair, path)) = case::path(case) else { return Box::new(Plan::of(case, reading)) };
    let strength = soot.neck_strengths.as_ref().map(|given| strengths::drawn_for(given, case.seed, (0, 1)));
    let sphere = |radius: &Quantity<Length>| (radius.value, sphere_mass(soot.density.value, radius.value));
    Box::new(PathPlan {
        model: soot.law(reading),
        spheres: pair.radii.each_ref().map(sphere),
        distance: path.distance.value,
        neck: pair.neck,
        breaks: breaks(soot, strength),
        strength,
        legs: path.legs.clone(),
        dt: path.dt.value,
        overlap: case.limits.overlap,
    })
}
