//! Pham-Ba & Molinari 2022: a solid of cohesive particles under patch tests, and the wear of a junction.

pub mod bodies;
pub mod case;
mod check;
#[cfg(feature = "cli")]
pub mod claims;
mod columns;
mod derived;
pub mod fate;
pub mod junction;
mod lammps;
pub mod protocol;
#[cfg(feature = "cli")]
mod shown;
pub mod stages;
mod study;
#[cfg(feature = "verify")]
mod trajectories;
mod watch;

pub use derived::{Critical, Scales, material};
pub use study::Plan;

use super::Paper;
use crate::case::check::Found;
use crate::case::springs::Transport;
use crate::figures::Graph;
#[cfg(feature = "verify")]
use crate::golden::Trajectory;
use crate::output::Column;
use crate::output::columns::STEP;
#[cfg(feature = "cli")]
use crate::reproduce::{Chapter, Listed};
use crate::run::Runnable;
use crate::spec::{Carried, wear as spec};
use case::{Case, Experiment, Model, Readings, Sample};
use columns::{
    LAYER_DISPLACEMENT, LAYER_HEIGHT, LAYER_VELOCITY, MEAN_FRICTION, NORMAL_STRAIN, NORMAL_STRESS, SEPARATION,
    SHEAR_STRAIN, SHEAR_STRESS, SHEARED_THICKNESS, SLID, THIRD_BODY_THICKNESS, TURNS, VOLUME_FRACTION,
};
use std::path::PathBuf;

/// The paper.
pub struct Wear;

impl Paper for Wear {
    const NAME: &'static str = "wear";
    const REFERENCE: &'static str = "Pham-Ba & Molinari 2022";
    const TITLE: &'static str = "Adhesive wear with a coarse-grained discrete element model: claims and results";
    const GRAPHS: &'static [Graph] = &[
        Graph { name: "friction", stages: &["shearing", "sliding"], x: SLID, y: MEAN_FRICTION, marks: &[] },
        Graph { name: "separation", stages: &["shearing"], x: SLID, y: SEPARATION, marks: &[] },
        Graph { name: "turns", stages: &["shearing"], x: SLID, y: TURNS, marks: &[] },
        Graph { name: "shear layer", stages: &["sliding"], x: SLID, y: SHEARED_THICKNESS, marks: &[] },
        Graph { name: "third body", stages: &["sliding"], x: SLID, y: THIRD_BODY_THICKNESS, marks: &[] },
        Graph { name: "velocity", stages: &["sliding"], x: LAYER_VELOCITY, y: LAYER_HEIGHT, marks: &[] },
        Graph { name: "displacement", stages: &["sliding"], x: LAYER_DISPLACEMENT, y: LAYER_HEIGHT, marks: &[] },
        Graph { name: "compression", stages: &["compression"], x: NORMAL_STRAIN, y: NORMAL_STRESS, marks: &[] },
        Graph { name: "tension", stages: &["tension"], x: NORMAL_STRAIN, y: NORMAL_STRESS, marks: &[] },
        Graph { name: "shear", stages: &["shear"], x: SHEAR_STRAIN, y: SHEAR_STRESS, marks: &[] },
        Graph { name: "relaxation", stages: &["cohesion"], x: STEP, y: VOLUME_FRACTION, marks: &[] },
    ];
    const QUANTITIES: &'static [(&'static str, &'static [Column])] = &[
        ("Columns of a relaxation", columns::RELAXATION),
        ("Columns of a patch test", columns::TEST),
        ("Columns of a sheared junction", columns::JUNCTION),
        ("Windows of 1 nm of sliding, with the columns `slid` and `separation`", columns::IN_WINDOW),
        ("Columns of two sliding bodies, with the columns `slid`, `friction` and `normal force`", columns::SLIDING),
        (
            "Windows of sliding bodies, with the columns `slid`, `rise`, `mean friction` and `mean normal force`",
            columns::IN_SLIDING_WINDOW,
        ),
        ("Profiles of sliding bodies, in `profiles.csv`", columns::PROFILE),
        ("Results", columns::results::ALL),
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
        derived::read_as_published(case);
    }
    fn check(case: &Case, found: &mut Found) {
        check::problems(case, found);
    }
    fn doubts(case: &Case, found: &mut Found) {
        check::doubts(case, found);
    }
    fn derived(case: &Case) -> Vec<(String, String)> {
        derived::derived(case)
    }
    fn reads(case: &mut Case) -> Vec<&mut PathBuf> {
        case::reads(case)
    }
    fn saves(case: &mut Case) -> Vec<(String, &mut PathBuf)> {
        case::saves(case)
    }
    #[cfg(feature = "cli")]
    fn shown_laws() -> Vec<super::shown::Law> {
        shown::laws()
    }
    fn study(case: Case) -> Box<dyn Runnable> {
        match (material(&case).readings, material(&case).springs) {
            (Readings::AsPublished, _) => Box::new(Plan::<spec::Published>::of(&case)),
            (Readings::Own, Transport::Projected) => Box::new(Plan::<spec::Wear>::of(&case)),
            (Readings::Own, Transport::Carried) => Box::new(Plan::<Carried<spec::Wear>>::of(&case)),
        }
    }
}
