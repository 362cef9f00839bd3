//! Laube et al. 2018: water-covered oxide nanoparticles in contact, in agglomerates, and in films under the tip of an atomic force microscope.

pub mod case;
pub mod chain;
mod check;
#[cfg(feature = "cli")]
pub mod claims;
mod columns;
pub mod film;
mod imported;
mod lammps;
mod law;
pub mod pair;
mod pull;
#[cfg(feature = "cli")]
mod shown;
mod stage;
mod study;
#[cfg(feature = "verify")]
mod trajectories;
mod watch;

pub use film::Spectrum;
pub use law::Law;
pub use pull::Pull;
pub use study::Plan;
pub use watch::rolling_resistance;

use super::{Paper, path};
use crate::case::check::Found;
use crate::case::springs::Transport;
use crate::figures::Graph;
#[cfg(feature = "verify")]
use crate::golden::Trajectory;
use crate::output::Column;
use crate::output::columns::TIME;
#[cfg(feature = "cli")]
use crate::reproduce::{Chapter, Listed};
use crate::run::Runnable;
#[cfg(feature = "cli")]
use crate::spec::languages::{Exported, law as exported_law};
use crate::spec::titania::{self, Tabulated};
use crate::spec::{Carried, Necked};
use case::{Case, Experiment, Model, Sample, TitaniaTest};
use columns::{CONTACTS, DISTANCE, FRICTION, MEAN_PULL, MOVED, PULLED, ROLLING_RESISTANCE};
use film::columns::{FORCE, MOVED as TIP_MOVED};
use std::path::PathBuf;

/// The paper.
pub struct Titania;

/// Contact events marked on the pulling force.
const MARKS: &[&str] = &["sliding", "rolling", "detachment", "breaks"];

impl Paper for Titania {
    const NAME: &'static str = "titania";
    const REFERENCE: &'static str = "Laube et al. 2018";
    const TITLE: &'static str = "A contact model for water-covered nanoparticles: claims and results";
    const GRAPHS: &'static [Graph] = &[
        Graph { name: "approach", stages: &["approach"], x: TIME, y: DISTANCE, marks: &[] },
        Graph { name: "sliding friction", stages: &["sliding"], x: MOVED, y: FRICTION, marks: &[] },
        Graph { name: "rolling resistance", stages: &["rolling"], x: MOVED, y: ROLLING_RESISTANCE, marks: &[] },
        Graph { name: "pulling force", stages: &["pulling"], x: PULLED, y: MEAN_PULL, marks: MARKS },
        Graph { name: "contacts", stages: &["pulling"], x: PULLED, y: CONTACTS, marks: &[] },
        Graph { name: "spectroscopy", stages: &["approach", "retraction"], x: TIP_MOVED, y: FORCE, marks: MARKS },
    ];
    const QUANTITIES: &'static [(&'static str, &'static [Column])] = &[
        ("Columns of a pair", columns::PAIR),
        ("Columns of a particle that is dragged", columns::DRAGGED),
        ("Columns of an agglomerate that is stretched", columns::STRETCHED),
        ("Columns of pairs and agglomerates", columns::COUNTS),
        ("Windows of 50 ps of a stretched agglomerate, with the column `pulled`", columns::IN_WINDOW),
        ("Results of pairs and agglomerates", columns::results::ALL),
        ("Columns of a path", path::COLUMNS),
        ("Column of a path that pulls", path::PULLED),
        ("Results of each leg of a path", path::results::ALL),
        ("Columns of a film under a tip", film::columns::TIPPED),
        ("Columns of a film", film::columns::COUNTS),
        ("Columns of a film of rigid aggregates, and of a film with necks", film::columns::BY_BONDING),
        ("Windows of the averaging time, with the column `tip moved`", film::columns::IN_WINDOW),
        ("Results of a film", film::columns::results::ALL),
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
        case::read_as_published(case);
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
    #[cfg(feature = "cli")]
    fn exported_laws() -> Vec<Exported> {
        let title = "With the parameters of Laube et al. 2018, at half humidity and 300 K, in SI; radii are those of the contact spheres.";
        exported_law(&titania::Titania::paper(1e-9, 1e-9, 1e-9), "titania-law", title).into()
    }
    #[cfg(feature = "cli")]
    fn shown_laws() -> Vec<super::shown::Law> {
        shown::laws()
    }
    fn study(case: Case) -> Box<dyn Runnable> {
        let Model::Titania(titania) = &case.model;
        match titania.springs {
            Transport::Projected => planned::<titania::Titania, Tabulated, Necked<Tabulated>>(&case),
            Transport::Carried => {
                planned::<Carried<titania::Titania>, Carried<Tabulated>, Carried<Necked<Tabulated>>>(&case)
            }
        }
    }
}

/// The plan of a case, under one law for a few spheres, one for many, and one for many with necks.
fn planned<Few: Law + 'static, Many: Law + 'static, Joined: Law + 'static>(case: &Case) -> Box<dyn Runnable> {
    match case::checked(case) {
        (titania, TitaniaTest::Spectroscopy(..)) if titania.neck_springs.is_some() => {
            Box::new(film::Plan::<Joined>::of(case))
        }
        (_, TitaniaTest::Spectroscopy(..)) => Box::new(film::Plan::<Many>::of(case)),
        (titania, TitaniaTest::Path(pair, path)) => {
            Box::new(pair::path::<Few>(titania, pair, path, case.limits.overlap))
        }
        (_, TitaniaTest::Chain(..)) => Box::new(Plan::<Many>::of(case)),
        (_, TitaniaTest::Contact(..)) => Box::new(Plan::<Few>::of(case)),
    }
}
