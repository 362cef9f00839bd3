//! A job: a checked case, ready to be run into its run folder.

use super::export;
use super::paths::{CasePath, Files};
use super::places::{free, is_there, outside, savable, unchanged};
use super::plan::{affordable, moderate, plan, stages, work};
use super::recorder::Recorder;
use super::saved::{Resumable, State};
use super::{Driver, Message, Outcome, Study};
use crate::case::{Output, located};
use crate::error::{AtPath, Error, Problem};
use crate::figures::Graph;
use crate::forces::Instructions;
use crate::interrupt::Interrupt;
use crate::output::{
    Claim, Finding, Lock, Manifest, Origin, Place, RunFolder, Status, sha256, sha256_file, state_hash, write_atomically,
};
use crate::system::System;
use serde_yaml::Mapping;
use std::path::{Path, PathBuf};

/// Reads and checks the text of a case file.
pub type Reader<'a> = &'a (dyn Fn(&Path, &str) -> Result<Job, Error> + Sync);

/// A case that has been read and checked, ready to be run.
pub struct Job {
    /// Its file.
    pub file: PathBuf,
    /// The text of the file.
    pub text: String,
    /// Its title.
    pub title: String,
    /// The seed of every random stream.
    pub seed: u64,
    /// Output intervals.
    pub output: Output,
    /// The case with every default and derived value.
    pub resolved: String,
    /// The files that it reads.
    pub reads: Vec<CasePath>,
    /// The files that it writes beside its run folder, with the sections that ask for them.
    pub saves: Vec<(String, CasePath)>,
    /// The graphs of its report.
    pub graphs: &'static [Graph],
    /// The vector instructions of its simulations, if not the widest: for checks, as results do not depend on them.
    pub instructions: Option<Instructions>,
    /// Whether it may ask for more steps, output or memory than is usual.
    pub excess: bool,
    /// Values that are accepted but may not mean what their author thinks.
    pub doubts: Vec<Problem>,
    /// Its stages.
    pub study: Box<dyn Runnable>,
}

/// A study of any kind.
pub trait Runnable {
    /// The plan of a job: its steps, its output and its cost, for people and programs. Makes its initial state and takes some steps.
    ///
    /// # Errors
    ///
    /// If the spheres cannot be placed, the simulation halts, or the job asks for more than is usual.
    fn plan(&self, job: &Job, interrupt: &Interrupt) -> Result<Mapping, Error>;
    /// About how much work a job is, as steps times spheres, to compare it with others. Finds out in a moment.
    fn work(&self, job: &Job, interrupt: &Interrupt) -> f64;
    /// Files for LAMMPS with the plugin of `bindings/lammps`, by name: of the latest checkpoint of a run, or of the start of a job.
    ///
    /// # Errors
    ///
    /// If there is no such state, or the plugin has no counterpart of something in it.
    fn for_lammps(
        &self,
        job: &Job,
        folder: Option<&RunFolder>,
        interrupt: &Interrupt,
    ) -> Result<Vec<(&'static str, String)>, Error>;
    /// Runs a job in a new folder at `root`, replacing it if requested; `tell` receives its messages.
    ///
    /// # Errors
    ///
    /// Wrong input, a halt, a failed stage, an interruption, or a file that cannot be written.
    fn start(
        &self,
        job: &Job,
        root: &Path,
        replace: bool,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<(RunFolder, Vec<Finding>), Error>;
    /// Resumes a job from its latest checkpoint, or from the beginning if it has none.
    ///
    /// # Errors
    ///
    /// As [`start`](Self::start), and if the files that the run reads have changed.
    fn resume(
        &self,
        job: &Job,
        folder: &RunFolder,
        manifest: Manifest,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<Vec<Finding>, Error>;
}

impl<S: Study> Runnable for S {
    fn plan(&self, job: &Job, interrupt: &Interrupt) -> Result<Mapping, Error> {
        plan(self, job, interrupt)
    }

    fn work(&self, job: &Job, interrupt: &Interrupt) -> f64 {
        work(self, job, interrupt)
    }

    fn for_lammps(
        &self,
        job: &Job,
        folder: Option<&RunFolder>,
        interrupt: &Interrupt,
    ) -> Result<Vec<(&'static str, String)>, Error> {
        export::for_lammps(self, job, folder, interrupt)
    }

    fn start(
        &self,
        job: &Job,
        root: &Path,
        replace: bool,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<(RunFolder, Vec<Finding>), Error> {
        affordable(self, job)?;
        let claim = Claim::new(root, replace)?;
        let files = job.files()?;
        // Errors in the input are found before anything is written.
        let initial = match self.initial(interrupt) {
            // A run that is to be replaced is worth more than one that has not begun.
            Err(Error::Interrupted) if claim.replaces() => return Err(Error::Interrupted),
            Err(Error::Interrupted) => {
                let (folder, _lock, mut manifest) = job.begin(claim, files, tell)?;
                manifest.end(&folder, Status::Stopped)?;
                return Err(Error::Stopped(Some(folder.root().into())));
            }
            initial => initial.map_err(|error| located(error, &job.file, &job.text))?,
        };
        moderate(&stages(&Driver::new(self, interrupt), self, &initial, &job.output), job)?;
        let (folder, _lock, manifest) = job.begin(claim, files, tell)?;
        let findings = from_the_beginning(self, job, &folder, manifest, initial, interrupt, tell)?;
        Ok((folder, findings))
    }

    fn resume(
        &self,
        job: &Job,
        folder: &RunFolder,
        mut manifest: Manifest,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<Vec<Finding>, Error> {
        folder.complete()?;
        if !folder.resolved().exists() {
            // It was killed before it had written all that precedes the first step.
            write_atomically(&folder.resolved(), job.resolved.as_bytes())?;
        }
        if folder.checkpoints().is_empty()? {
            unchanged(job.reads.iter(), &manifest)?;
            let initial = match self.initial(interrupt) {
                Err(Error::Interrupted) => return Err(Error::Stopped(Some(folder.root().into()))),
                initial => initial.map_err(|error| located(error, &job.file, &job.text))?,
            };
            manifest.resume();
            manifest.write(folder)?;
            return from_the_beginning(self, job, folder, manifest, initial, interrupt, tell);
        }
        let mut driver = Driver::new(self, interrupt).using(job.instructions);
        let origin = Origin::of(&manifest);
        let accepted = |path: &Path, state: State<S::Watch>| state.accepted(path, folder, &driver);
        let (from, passed_over) = folder.checkpoints().latest(&origin, accepted)?;
        let Resumable { stage, run, recorded, missing } = from;
        let later = self.reads_after(stage.number);
        unchanged(job.reads.iter().filter(|file| later.contains(&file.place)), &manifest)?;
        for problem in passed_over {
            tell(Message::Note(format!("warning: {problem}; an older checkpoint is used")));
        }
        if let Some(first) = missing.first() {
            let what = format!("{} missing frame files, the first is {}", missing.len(), first.display());
            tell(Message::Note(format!("warning: {what}; frames before the checkpoint are not written again")));
        }
        let mut sink = Recorder::resume(self, folder, origin, &job.output, recorded, tell)?;
        manifest.resume();
        manifest.write(folder)?;
        job.conclude(folder, manifest, || driver.resume(stage, run, &mut sink))
    }
}

/// Runs all stages in a folder, and concludes the run.
fn from_the_beginning<S: Study>(
    study: &S,
    job: &Job,
    folder: &RunFolder,
    manifest: Manifest,
    initial: System,
    interrupt: &Interrupt,
    tell: &mut dyn FnMut(Message),
) -> Result<Vec<Finding>, Error> {
    let origin = Origin::of(&manifest);
    job.conclude(folder, manifest, || {
        let mut sink = Recorder::begin(study, folder, origin, &job.output, tell)?;
        Driver::new(study, interrupt).using(job.instructions).run_from(initial, &mut sink)
    })
}

impl Job {
    /// Creates a run folder and runs the job from beginning to end; `tell` receives its messages.
    ///
    /// # Errors
    ///
    /// As [`Runnable::start`].
    pub fn launch(
        &self,
        root: &Path,
        replace: bool,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<(RunFolder, Vec<Finding>), Error> {
        self.needs(root)?;
        if !replace {
            free(&self.saves).map_err(|error| located(error, &self.file, &self.text))?;
        } else if root.is_dir() {
            outside(root, self.read_files())?;
        }
        self.study.start(self, root, replace, interrupt, tell)
    }

    /// Resumes a run from its latest checkpoint. Its case must not have changed since it was started.
    ///
    /// # Errors
    ///
    /// As [`Runnable::resume`], and if another process writes the folder, or the run has finished.
    pub fn resume(
        &self,
        folder: &RunFolder,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<Vec<Finding>, Error> {
        // A folder without a manifest is not a run's, and nothing is written into it.
        Manifest::read(folder)?;
        let _lock = Lock::take(folder.root())?;
        let manifest = Manifest::read(folder)?;
        if manifest.status == Status::Finished {
            let what = format!("{}: has finished; there is nothing to resume", folder.root().display());
            return Err(Error::Usage(what));
        }
        if !manifest.knows(&sha256_file(&folder.case())?) {
            return Err(Error::input(&folder.case(), "has changed since the run was started"));
        }
        if !manifest.is_ours() {
            let what = "the run was started by another build of this program; it may not continue with the same bits";
            tell(Message::Note(format!("warning: {what}")));
        }
        self.study.resume(self, folder, manifest, interrupt, tell)
    }

    /// Starts or resumes a run in a folder unless it has finished; returns whether there was anything left to do. What has been begun is read anew, with the files that it has kept.
    ///
    /// # Errors
    ///
    /// As [`launch`](Self::launch) and [`resume`](Self::resume), and if the folder holds something else.
    pub fn complete(
        &self,
        root: &Path,
        interrupt: &Interrupt,
        read: Reader,
        tell: &mut dyn FnMut(Message),
    ) -> Result<bool, Error> {
        let folder = RunFolder::at(root);
        let replace = match Place::of(&folder)? {
            Place::Free => false,
            Place::Other => {
                let what = "is not a resumable run; remove this folder to start again";
                return Err(Error::Usage(format!("{}: {what}", root.display())));
            }
            Place::Run(manifest) => {
                let case = folder.case();
                if case.exists() && std::fs::read_to_string(&case).at(&case)? != self.text {
                    return Err(Error::Usage("its run folder holds another case".into()));
                }
                if manifest.status == Status::Finished {
                    return Ok(false);
                }
                if !folder.checkpoints().is_empty()? {
                    let kept = read(&folder.case(), &self.text)?;
                    let job = Self { instructions: self.instructions, excess: self.excess, ..kept };
                    return job.resume(&folder, interrupt, tell).map(|_| true);
                }
                true
            }
        };
        // A run that was killed before its first checkpoint starts again.
        self.launch(root, replace, interrupt, tell).map(|_| true)
    }

    /// The plan of the job: its steps, its output and its cost.
    ///
    /// # Errors
    ///
    /// If a file is missing or wrong, and as [`Runnable::plan`].
    pub fn plan(&self, interrupt: &Interrupt) -> Result<Mapping, Error> {
        self.needs(&Path::new("run").join(self.file.file_stem().unwrap_or_default()))?;
        self.study.plan(self, interrupt).map_err(|error| located(error, &self.file, &self.text))
    }

    /// The case with every default and derived value, the plan of its run, and the warnings.
    ///
    /// # Errors
    ///
    /// As [`plan`](Self::plan).
    pub fn checked(&self, interrupt: &Interrupt) -> Result<Mapping, Error> {
        let plan = self.plan(interrupt)?;
        let mut checked: Mapping = serde_yaml::from_str(&self.resolved).expect("a resolved case is a mapping");
        checked.insert("plan".into(), plan.into());
        if !self.doubts.is_empty() {
            let doubts = self.doubts.iter().map(|doubt| doubt.to_string().into());
            checked.insert("warnings".into(), serde_yaml::Value::Sequence(doubts.collect()));
        }
        Ok(checked)
    }

    /// Checks that the input files exist, and that the files to be saved can be.
    fn needs(&self, root: &Path) -> Result<(), Error> {
        self.reads.iter().try_for_each(is_there)?;
        let reads: Vec<&Path> = self.read_files().collect();
        savable(&self.saves, &reads, root).map_err(|error| located(error, &self.file, &self.text))
    }

    /// All files that it reads, the case among them.
    fn read_files(&self) -> impl Iterator<Item = &Path> {
        self.reads.iter().map(|file| &file.place).chain([&self.file]).map(PathBuf::as_path)
    }

    /// The files that its run knows.
    fn files(&self) -> Result<Files, Error> {
        Files::of(&self.reads, self.saves.iter().map(|(_, file)| file))
    }

    /// Begins a run: its folder, its lock and its manifest.
    fn begin(
        &self,
        claim: Claim,
        files: Files,
        tell: &mut dyn FnMut(Message),
    ) -> Result<(RunFolder, Lock, Manifest), Error> {
        // The hash is taken from the text, because a case from a pipe can be read only once.
        let Files { places, mut hashes, copies } = files;
        hashes.insert(self.file.display().to_string(), sha256(self.text.as_bytes()));
        let graphs = crate::figures::graph_names(self.graphs);
        let manifest = Manifest::begin(self.seed, hashes, places, graphs.map(|name| format!("{name}.svg")).collect());
        let (folder, lock, left) = claim.begin(&manifest, &self.text, &self.resolved, &copies)?;
        for path in left {
            tell(Message::Note(format!("warning: {}: was not made by a run and is left where it is", path.display())));
        }
        Ok((folder, lock, manifest))
    }

    /// Writes results and report of a run, and its final status to the manifest.
    fn conclude(
        &self,
        folder: &RunFolder,
        mut manifest: Manifest,
        run: impl FnOnce() -> Result<Outcome, Error>,
    ) -> Result<Vec<Finding>, Error> {
        let run = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).unwrap_or_else(|broken| {
            manifest.end(folder, Status::Failed).ok();
            std::panic::resume_unwind(broken)
        });
        let result = run.and_then(|Outcome { findings, system }| {
            let results = serde_yaml::to_string(&Finding::results(&findings)).expect("findings are plain data");
            write_atomically(&folder.results(), results.as_bytes())?;
            #[cfg(feature = "cli")]
            crate::figures::report(&self.title, self.graphs, folder)?;
            folder.checkpoints().prune()?;
            manifest.final_state = Some(state_hash(&system));
            Ok(findings)
        });
        // An interruption before the first step of a stage leaves the checkpoints before it, or none.
        let result = match result {
            Err(Error::Interrupted) => Err(Error::Stopped(Some(folder.root().into()))),
            result => result,
        };
        let status = match &result {
            Ok(_) => Status::Finished,
            Err(Error::Halted(..)) => Status::Halted,
            Err(Error::Stopped(_)) => Status::Stopped,
            Err(Error::Io(..) | Error::NoInput(..)) => Status::Interrupted,
            Err(_) => Status::Failed,
        };
        let written = manifest.end(folder, status);
        result.and_then(|findings| written.map(|()| findings))
    }
}
