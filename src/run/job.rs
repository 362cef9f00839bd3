//! A job: a checked case, ready to be run into its run folder.

use super::recorder::{Recorder, State};
use super::{Driver, Message, Study};
use crate::case::{Output, located};
use crate::error::{AtPath, Error};
use crate::figures::Graph;
use crate::forces::Instructions;
use crate::interrupt::Interrupt;
use crate::output::{Finding, Manifest, RunFolder, Status, sha256_file, write_atomically};
use crate::simulation::{Settings, Simulation};
use crate::system::System;
use std::collections::BTreeMap;
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
    pub reads: Vec<PathBuf>,
    /// The files that it writes beside its run folder, with the sections that ask for them.
    pub saves: Vec<(String, PathBuf)>,
    /// The graphs of its report.
    pub graphs: &'static [Graph],
    /// The vector instructions of its simulations, if not the widest: for checks, as results do not depend on them.
    pub instructions: Option<Instructions>,
    /// Its stages.
    pub study: Box<dyn Runnable>,
}

/// A study of any kind.
pub trait Runnable {
    /// Checks the files that it needs, without computing anything.
    ///
    /// # Errors
    ///
    /// If a file it needs is missing or wrong.
    fn examine(&self) -> Result<(), Error>;
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
    fn examine(&self) -> Result<(), Error> {
        Study::examine(self)
    }

    fn start(
        &self,
        job: &Job,
        root: &Path,
        replace: bool,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<(RunFolder, Vec<Finding>), Error> {
        let inputs = job.inputs()?;
        // Errors in the input are found before anything is written.
        let initial = match self.initial(interrupt) {
            // A run that is to be replaced is worth more than one that has not begun.
            Err(Error::Stopped(_)) if replace && RunFolder::open(root).is_ok() => return Err(Error::Stopped(None)),
            Err(Error::Stopped(_)) => {
                let (folder, mut manifest) = job.make_folder(root, replace, inputs)?;
                manifest.end(&folder, Status::Stopped)?;
                return Err(Error::Stopped(Some(folder.root().into())));
            }
            initial => initial.map_err(|error| located(error, &job.file, &job.text))?,
        };
        let (folder, manifest) = job.make_folder(root, replace, inputs)?;
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
        if folder.checkpoints().is_empty()? {
            unchanged(&job.reads, &manifest)?;
            let initial = self.initial(interrupt).map_err(|error| located(error, &job.file, &job.text))?;
            manifest.resume();
            manifest.write(folder)?;
            return from_the_beginning(self, job, folder, manifest, initial, interrupt, tell);
        }
        let mut driver = Driver::new(self, interrupt).using(job.instructions);
        let mut missing = Vec::new();
        let fits = |state: &State<S::Watch>| {
            missing = state.recorded.check(folder)?;
            Ok(())
        };
        let (state, passed_over) = folder.checkpoints().latest(fits)?;
        let State { stage, dt, damping, skin, snapshot, watch, run, recorded } = state;
        unchanged(&self.reads_after(stage), &manifest)?;
        for problem in passed_over {
            tell(Message::Note(format!("warning: {problem}; an older checkpoint is used")));
        }
        if let Some(first) = missing.first() {
            let what = format!("{} missing frame files, the first is {}", missing.len(), first.display());
            tell(Message::Note(format!("warning: {what}; frames before the checkpoint are not written again")));
        }
        let mut sink = Recorder::resume(folder, &job.output, recorded, tell)?;
        manifest.resume();
        manifest.write(folder)?;
        job.conclude(folder, manifest, || {
            let settings = Settings { dt, damping, skin, ..driver.settings(stage, snapshot.system()) };
            let simulation = Simulation::resume(self.model(stage), settings, snapshot)?;
            let stage = driver.stage(stage, simulation, watch);
            Ok(driver.resume(stage, run, &mut sink)?.findings)
        })
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
    job.conclude(folder, manifest, || {
        let mut sink = Recorder::begin(study, folder, &job.output, tell)?;
        Ok(Driver::new(study, interrupt).using(job.instructions).run_from(initial, &mut sink)?.findings)
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
        self.study.start(self, root, replace, interrupt, tell)
    }

    /// Resumes a run from its latest checkpoint. Its case must not have changed since it was started.
    ///
    /// # Errors
    ///
    /// As [`Runnable::resume`].
    pub fn resume(
        &self,
        folder: &RunFolder,
        manifest: Manifest,
        interrupt: &Interrupt,
        tell: &mut dyn FnMut(Message),
    ) -> Result<Vec<Finding>, Error> {
        let begun_with = sha256_file(&folder.case())?;
        if !manifest.inputs.values().any(|input| *input == begun_with) {
            return Err(Error::input(&folder.case(), "has changed since the run was started"));
        }
        self.study.resume(self, folder, manifest, interrupt, tell)
    }

    /// Starts or resumes a run in a folder unless it has finished; returns whether there was anything left to do.
    ///
    /// # Errors
    ///
    /// As [`launch`](Self::launch) and [`resume`](Self::resume), and if the folder holds something else.
    pub fn complete(&self, root: &Path, interrupt: &Interrupt) -> Result<bool, Error> {
        // A run that was killed before its first checkpoint starts again.
        let replace = !RunFolder::clear(root)?;
        if replace {
            let what = "is not a resumable run; remove this folder to start again";
            let strange = |_| Error::Usage(format!("{}: {what}", root.display()));
            let folder = RunFolder::open(root).map_err(strange)?;
            let manifest = Manifest::read(&folder).map_err(strange)?;
            if std::fs::read_to_string(folder.case()).at(&folder.case())? != self.text {
                return Err(Error::Usage("its run folder holds another case".into()));
            }
            if manifest.status == Status::Finished {
                return Ok(false);
            }
            if !folder.checkpoints().is_empty()? {
                return self.resume(&folder, manifest, interrupt, &mut |_| {}).map(|_| true);
            }
        }
        self.launch(root, replace, interrupt, &mut |_| {}).map(|_| true)
    }

    /// Checks everything without running.
    ///
    /// # Errors
    ///
    /// If a file is missing or wrong, or the sample cannot be made.
    pub fn examine(&self) -> Result<(), Error> {
        self.needs(&Path::new("run").join(self.file.file_stem().unwrap_or_default()))?;
        self.study.examine().map_err(|error| located(error, &self.file, &self.text))
    }

    /// Checks that the input files exist, and that the output folders exist or are created by the run.
    fn needs(&self, root: &Path) -> Result<(), Error> {
        self.reads.iter().try_for_each(|file| is_there(file))?;
        for (section, file) in &self.saves {
            // The parent of a mere name is empty.
            let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
            if folder.is_some_and(|folder| !folder.is_dir() && !root.ancestors().any(|of_run| of_run == folder)) {
                let what = format!("found `{}`, expected a file in a folder that exists", file.display());
                return Err(located(Error::of_key(format!("{section}.save"), what), &self.file, &self.text));
            }
        }
        Ok(())
    }

    /// Hashes of the input files, by name.
    fn inputs(&self) -> Result<BTreeMap<String, String>, Error> {
        self.reads.iter().map(|file| Ok((file.display().to_string(), sha256_file(file)?))).collect()
    }

    /// The folder of a new run, and its manifest.
    fn make_folder(
        &self,
        root: &Path,
        replace: bool,
        mut inputs: BTreeMap<String, String>,
    ) -> Result<(RunFolder, Manifest), Error> {
        let folder = RunFolder::create(root, replace)?;
        write_atomically(&folder.case(), self.text.as_bytes())?;
        write_atomically(&folder.resolved(), self.resolved.as_bytes())?;
        // The hash is taken from the copy, because a case from a pipe can be read only once.
        inputs.insert(self.file.display().to_string(), sha256_file(&folder.case())?);
        let manifest = Manifest::begin(self.seed, inputs);
        manifest.write(&folder)?;
        Ok((folder, manifest))
    }

    /// Writes results and report of a run, and its final status to the manifest.
    fn conclude(
        &self,
        folder: &RunFolder,
        mut manifest: Manifest,
        run: impl FnOnce() -> Result<Vec<Finding>, Error>,
    ) -> Result<Vec<Finding>, Error> {
        let result = run().and_then(|findings| {
            let results = serde_yaml::to_string(&findings).expect("findings are plain data");
            write_atomically(&folder.results(), results.as_bytes())?;
            #[cfg(feature = "cli")]
            crate::figures::report(&self.title, self.graphs, folder, &findings)?;
            folder.checkpoints().prune()?;
            Ok(findings)
        });
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

fn is_there(file: &Path) -> Result<(), Error> {
    std::fs::metadata(file).map(drop).map_err(|cause| Error::NoInput(file.into(), cause))
}

/// Checks that files have not changed since a run was started.
fn unchanged(files: &[PathBuf], manifest: &Manifest) -> Result<(), Error> {
    for file in files {
        is_there(file)?;
        if manifest.inputs.get(&file.display().to_string()) != Some(&sha256_file(file)?) {
            return Err(Error::input(file, "has changed since the run was started"));
        }
    }
    Ok(())
}
