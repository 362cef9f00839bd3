//! The papers' additions to the engine: one module and one entry of a list per paper.

mod necks;
mod path;
mod quantities;
#[cfg(feature = "cli")]
pub mod shown;
pub mod soot;
pub mod titania;
pub mod wear;

use crate::case::check::Found;
use crate::case::section::{Field, Key, Part};
use crate::case::{self, Case, Outline, Words};
use crate::error::Error;
use crate::figures::Graph;
use crate::geometry::Sphere;
#[cfg(feature = "verify")]
use crate::golden::Trajectory;
use crate::initial::aggregate::necks::{Neck, NeckLength};
use crate::interrupt::Interrupt;
use crate::output::Column;
#[cfg(feature = "cli")]
use crate::reproduce::{Chapter, Listed};
use crate::run::{Job, Paths, Runnable};
#[cfg(feature = "cli")]
use crate::spec::languages::Exported;
use serde_yaml::{Mapping, Value};
use std::path::{Path, PathBuf};

/// The papers of this program.
pub const PAPERS: Papers = Papers(&[&wear::Wear, &soot::Soot, &titania::Titania]);

/// A case of a paper.
pub type CaseOf<P> = Case<<P as Paper>::Model, <P as Paper>::Sample, <P as Paper>::Experiment>;

/// Reads and checks the text of a case of a paper.
///
/// # Errors
///
/// All problems of the case, by line and key.
pub fn parse<P: Paper>(file: &Path, text: &str) -> Result<CaseOf<P>, Error> {
    case::parse(file, text, P::complete, P::check)
}

/// A paper's additions to the engine.
pub trait Paper: Sync {
    /// Its name: the key below `model` in case files, and a word of the command line.
    const NAME: &'static str;
    /// Authors and year.
    const REFERENCE: &'static str;
    /// The title of its claims.
    const TITLE: &'static str;
    /// The graphs in its reports.
    const GRAPHS: &'static [Graph] = &[];
    /// The columns of its tables and its results, by heading.
    const QUANTITIES: &'static [(&'static str, &'static [Column])] = &[];
    /// The chapters of its claims.
    #[cfg(feature = "cli")]
    const CHAPTERS: &'static [Chapter] = &[];
    /// Its tables of parameters.
    #[cfg(feature = "cli")]
    const TABLES: &'static [shown::Table] = &[];
    /// The list of its claims.
    #[cfg(feature = "cli")]
    const LISTED: &'static [Listed] = &[];
    /// The golden trajectories that belong to it.
    #[cfg(feature = "verify")]
    const TRAJECTORIES: &'static [Trajectory] = &[];

    /// The section below `model`: a choice of one key, which is the name.
    type Model: Part;
    /// The sections below `sample`.
    type Sample: Part;
    /// The sections below `experiment`.
    type Experiment: Part;

    /// Completes values of a case that have no default.
    fn complete(_case: &mut CaseOf<Self>) {}
    /// Finds the problems of a case beyond its grammar.
    fn check(_case: &CaseOf<Self>, _found: &mut Found) {}
    /// Finds values of a checked case that are accepted but may not mean what their author thinks.
    fn doubts(_case: &CaseOf<Self>, _found: &mut Found) {}
    /// The keys that a case has but does not use, such as `sample.aggregate.spheres`.
    fn unused(_case: &CaseOf<Self>) -> &'static [&'static str] {
        &[]
    }
    /// The derived values of a checked case, with units.
    fn derived(_case: &CaseOf<Self>) -> Vec<(String, String)> {
        Vec::new()
    }
    /// The paths of the files that a case reads.
    fn reads(_case: &mut CaseOf<Self>) -> Vec<&mut PathBuf> {
        Vec::new()
    }
    /// The paths of the files that a case writes beside its run folder, with the sections that ask for them.
    fn saves(_case: &mut CaseOf<Self>) -> Vec<(String, &mut PathBuf)> {
        Vec::new()
    }
    /// The contact laws that other languages have beside the equations, which may hold the whole law already.
    #[cfg(feature = "cli")]
    fn exported_laws() -> Vec<Exported> {
        Vec::new()
    }
    /// The contact laws whose forces are drawn.
    #[cfg(feature = "cli")]
    fn shown_laws() -> Vec<shown::Law> {
        Vec::new()
    }
    /// The start of a run of an imported aggregate with default values, for a paper that has aggregates.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    fn imported(
        _spheres: &[Sphere],
        _necks: &[Neck],
        _length: NeckLength,
        _interrupt: &Interrupt,
    ) -> Result<Option<AtStart>, Error> {
        Ok(None)
    }
    /// The study of a checked case.
    fn study(case: CaseOf<Self>) -> Box<dyn Runnable>;
}

/// The start of a run of an imported aggregate with default values.
#[derive(Clone, Debug, serde::Serialize)]
pub struct AtStart {
    /// The paper.
    pub paper: &'static str,
    /// Number of its necks.
    pub necks: usize,
    /// Energy that the springs of necks and contacts hold, zJ.
    pub springs: f64,
    /// Why it is refused, if it is.
    pub refusal: Option<String>,
}

/// Any paper.
pub trait AnyPaper: Sync {
    /// [`Paper::NAME`].
    fn name(&self) -> &'static str;
    /// [`Paper::REFERENCE`].
    fn reference(&self) -> &'static str;
    /// [`Paper::TITLE`].
    fn title(&self) -> &'static str;
    /// [`Paper::QUANTITIES`].
    fn quantities(&self) -> &'static [(&'static str, &'static [Column])];
    /// [`Paper::CHAPTERS`].
    #[cfg(feature = "cli")]
    fn chapters(&self) -> &'static [Chapter];
    /// [`Paper::TABLES`].
    #[cfg(feature = "cli")]
    fn tables(&self) -> &'static [shown::Table];
    /// [`Paper::shown_laws`].
    #[cfg(feature = "cli")]
    fn shown_laws(&self) -> Vec<shown::Law>;
    /// [`Paper::LISTED`].
    #[cfg(feature = "cli")]
    fn listed(&self) -> &'static [Listed];
    /// [`Paper::TRAJECTORIES`].
    #[cfg(feature = "verify")]
    fn trajectories(&self) -> &'static [Trajectory];
    /// [`Paper::exported_laws`].
    #[cfg(feature = "cli")]
    fn exported_laws(&self) -> Vec<Exported>;
    /// The words below `model`, `sample` and `experiment`.
    fn words(&self) -> Words;
    /// The keys below `model`, `sample` and `experiment`.
    fn sections(&self) -> [Vec<Key>; 3];
    /// [`Paper::imported`].
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`].
    fn imported(
        &self,
        spheres: &[Sphere],
        necks: &[Neck],
        length: NeckLength,
        interrupt: &Interrupt,
    ) -> Result<Option<AtStart>, Error>;
    /// Reads and checks a case of the paper.
    ///
    /// # Errors
    ///
    /// All problems of the case, by line and key.
    fn read(&self, file: &Path, text: &str) -> Result<Job, Error>;
}

impl<P: Paper> AnyPaper for P {
    fn name(&self) -> &'static str {
        P::NAME
    }
    fn reference(&self) -> &'static str {
        P::REFERENCE
    }
    fn title(&self) -> &'static str {
        P::TITLE
    }
    fn quantities(&self) -> &'static [(&'static str, &'static [Column])] {
        P::QUANTITIES
    }
    #[cfg(feature = "cli")]
    fn chapters(&self) -> &'static [Chapter] {
        P::CHAPTERS
    }
    #[cfg(feature = "cli")]
    fn tables(&self) -> &'static [shown::Table] {
        P::TABLES
    }
    #[cfg(feature = "cli")]
    fn shown_laws(&self) -> Vec<shown::Law> {
        P::shown_laws()
    }
    #[cfg(feature = "cli")]
    fn listed(&self) -> &'static [Listed] {
        P::LISTED
    }
    #[cfg(feature = "verify")]
    fn trajectories(&self) -> &'static [Trajectory] {
        P::TRAJECTORIES
    }
    #[cfg(feature = "cli")]
    fn exported_laws(&self) -> Vec<Exported> {
        P::exported_laws()
    }
    fn words(&self) -> Words {
        Words { model: P::Model::names(), sample: P::Sample::names(), experiment: P::Experiment::names() }
    }
    fn sections(&self) -> [Vec<Key>; 3] {
        [P::Model::keys(), P::Sample::keys(), P::Experiment::keys()]
    }
    fn imported(
        &self,
        spheres: &[Sphere],
        necks: &[Neck],
        length: NeckLength,
        interrupt: &Interrupt,
    ) -> Result<Option<AtStart>, Error> {
        P::imported(spheres, necks, length, interrupt)
    }
    fn read(&self, file: &Path, text: &str) -> Result<Job, Error> {
        let mut case = parse::<P>(file, text)?;
        let written = serde_yaml::to_value(&case).expect("a case is plain data");
        let paths = Paths::of(file);
        let mut doubts = Found::new();
        P::doubts(&case, &mut doubts);
        let reads = P::reads(&mut case).into_iter().map(|path| paths.lead(path)).collect();
        let saves = P::saves(&mut case).into_iter().map(|(section, path)| (section, paths.lead(path))).collect();
        Ok(Job {
            file: file.into(),
            text: text.into(),
            title: case.title.clone(),
            seed: case.seed,
            output: case.output.clone(),
            resolved: resolved(written, P::unused(&case), P::derived(&case)),
            reads,
            saves,
            graphs: P::GRAPHS,
            instructions: None,
            excess: false,
            doubts: case::problems(doubts, file, text),
            study: P::study(case),
        })
    }
}

/// A case with every default that it uses, and its derived values below `derived`.
fn resolved(mut case: Value, unused: &[&str], derived: Vec<(String, String)>) -> String {
    for key in unused {
        let (section, word) = key.rsplit_once('.').unwrap_or(("", key));
        let section = section.split('.').try_fold(&mut case, |place, word| place.get_mut(word));
        if let Some(section) = section.and_then(Value::as_mapping_mut) {
            section.retain(|key, _| key != word);
        }
    }
    let mapping = case.as_mapping_mut().expect("a case is a mapping");
    let text = |(key, value): (String, String)| (Value::String(key), Value::String(value));
    mapping.insert("derived".into(), Value::Mapping(derived.into_iter().map(text).collect::<Mapping>()));
    serde_yaml::to_string(&case).expect("a mapping can be written")
}

/// A list of papers.
#[derive(Clone, Copy)]
pub struct Papers(pub &'static [&'static dyn AnyPaper]);

impl Papers {
    /// The paper with this name.
    pub fn find(&self, name: &str) -> Option<&'static dyn AnyPaper> {
        self.0.iter().copied().find(|paper| paper.name() == name)
    }

    /// The golden trajectories of all papers.
    #[cfg(feature = "verify")]
    pub fn trajectories(&self) -> Vec<&'static Trajectory> {
        self.0.iter().flat_map(|paper| paper.trajectories()).collect()
    }

    /// Reads and checks a case file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read; all problems of the case, by line and key.
    pub fn read(&self, file: &Path) -> Result<Job, Error> {
        self.parse(file, &case::read_text(file)?)
    }

    /// Reads and checks the text of a case file.
    ///
    /// # Errors
    ///
    /// All problems of the case, by line and key.
    pub fn parse(&self, file: &Path, text: &str) -> Result<Job, Error> {
        let all = || self.0.iter().map(|paper| paper.words());
        let all = Words {
            model: each_once(all().flat_map(|words| words.model)),
            sample: each_once(all().flat_map(|words| words.sample)),
            experiment: each_once(all().flat_map(|words| words.experiment)),
        };
        let outline = Outline::read(file, text, &all)?;
        let paper = self.find(outline.model).expect("the outline holds one of the names");
        outline.suits(&paper.words(), file, text)?;
        paper.read(file, text)
    }

    /// Every key of a case file.
    pub fn keys(&self) -> Vec<Key> {
        let mut keys = case::keys();
        for (place, name) in ["model", "sample", "experiment"].into_iter().enumerate() {
            let key = keys.iter_mut().find(|key| key.key == name).expect("every case has these sections");
            key.keys = self.0.iter().flat_map(|paper| std::mem::take(&mut paper.sections()[place])).collect();
            let names = each_once(key.keys.iter().map(|key| key.key));
            key.expects = case::section::one_of_these(&names);
            key.schema = case::json_schema::choice(&key.keys);
        }
        keys
    }
}

/// Words without repetition: papers may have samples and experiments of the same name.
fn each_once(words: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    words.fold(Vec::new(), |mut all, word| {
        if !all.contains(&word) {
            all.push(word);
        }
        all
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_only_key_of_a_model_is_the_name_of_its_paper() {
        for paper in PAPERS.0 {
            assert_eq!(paper.words().model, [paper.name()]);
        }
    }
}
