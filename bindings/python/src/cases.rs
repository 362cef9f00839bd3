//! Cases: checked, run, resumed.

use crate::errors::{caught, exception};
use crate::work::{interruptible, limit, pool};
use pyo3::exceptions::{PyFileExistsError, PyValueError};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;
use std::time::Instant;
use veridem::error::Error;
use veridem::interrupt::Interrupt;
use veridem::output::{Place, RunFolder};
use veridem::papers::PAPERS;
use veridem::run::sweep::{Point, Sweep};
use veridem::run::{Job, Message};

/// The YAML text of a case that is given as JSON.
#[pyfunction]
pub(crate) fn yaml_of(json: &str) -> PyResult<String> {
    caught(|| {
        let value: serde_json::Value =
            serde_json::from_str(json).map_err(|error| PyValueError::new_err(error.to_string()))?;
        serde_yaml::to_string(&value).map_err(|error| PyValueError::new_err(error.to_string()))
    })
}

/// A case: its file, and its text if it is not to be read from there.
pub(crate) fn read(file: &Path, text: Option<&str>, excess: bool) -> Result<Job, Error> {
    let job = match text {
        Some(text) => PAPERS.parse(file, text)?,
        None => PAPERS.read(file)?,
    };
    Ok(Job { excess, ..job })
}

/// Checks a case; returns it with its defaults, derived values and plan as JSON.
#[pyfunction]
pub(crate) fn check(
    py: Python<'_>,
    file: PathBuf,
    text: Option<String>,
    excess: bool,
    threads: Option<usize>,
) -> PyResult<String> {
    caught(|| {
        let work = |interrupt: &_, _: &Sender<()>| {
            let checked = read(&file, text.as_deref(), excess)?.checked(interrupt)?;
            Ok(serde_json::to_string(&checked).expect("a mapping with keys that are words"))
        };
        interruptible(py, &pool(threads)?, &limit(None)?, work, |()| Ok(()))
    })
}

/// What a run tells: the share that is done, and that or a remark in words.
type Told = (Option<f64>, String);

/// Puts the messages of a run in words, and sends them.
fn teller(sender: &Sender<Told>) -> impl FnMut(Message<'_>) + use<'_> {
    let mut begun: Option<(String, Instant, u64)> = None;
    move |message| {
        let told = match message {
            Message::Note(text) => (None, text),
            Message::Progress(state) => {
                if begun.as_ref().is_none_or(|begun| begun.0 != state.stage) {
                    begun = Some((state.stage.into(), Instant::now(), state.step));
                }
                let pace = begun.as_ref().and_then(|(_, since, first)| {
                    let taken = state.step.checked_sub(*first).filter(|&taken| taken > 0)?;
                    Some(since.elapsed().as_secs_f64() / taken as f64)
                });
                let share = state.before.saturating_add(state.step) as f64 / state.all.max(1) as f64;
                (Some(share.min(1.0)), format!("{}: {}", state.stage, state.summary(pace)))
            }
        };
        // Nobody listens any more after an exception.
        sender.send(told).ok();
    }
}

/// Runs a case in a new folder.
#[pyfunction]
pub(crate) fn run(
    py: Python<'_>,
    file: PathBuf,
    text: Option<String>,
    out: PathBuf,
    force: bool,
    excess: bool,
    threads: Option<usize>,
    max_time: Option<f64>,
    tell: &Bound<'_, PyAny>,
) -> PyResult<()> {
    caught(|| {
        // The words of the command line would not help here.
        if !force && !matches!(Place::of(&RunFolder::at(&out)).map_err(exception)?, Place::Free) {
            let what = format!("{}: exists already; `force=True` replaces a run", out.display());
            return Err(PyFileExistsError::new_err(what));
        }
        let work = |interrupt: &_, sender: &Sender<Told>| {
            let job = read(&file, text.as_deref(), excess)?;
            job.launch(&out, force, interrupt, &mut teller(sender)).map(drop)
        };
        interruptible(py, &pool(threads)?, &limit(max_time)?, work, |told| tell.call1(told).map(drop))
    })
}

/// Resumes a run.
#[pyfunction]
pub(crate) fn resume(
    py: Python<'_>,
    run: PathBuf,
    threads: Option<usize>,
    max_time: Option<f64>,
    tell: &Bound<'_, PyAny>,
) -> PyResult<()> {
    caught(|| {
        let work = |interrupt: &_, sender: &Sender<Told>| {
            let folder = RunFolder::open(&run)?;
            let job = PAPERS.read(&folder.case())?;
            job.resume(&folder, interrupt, &mut teller(sender)).map(drop)
        };
        interruptible(py, &pool(threads)?, &limit(max_time)?, work, |told| tell.call1(told).map(drop))
    })
}

/// Runs a case for several values of its keys; returns the runs as JSON.
#[pyfunction]
pub(crate) fn sweep(
    py: Python<'_>,
    file: PathBuf,
    text: Option<String>,
    keys: Vec<String>,
    out: PathBuf,
    force: bool,
    excess: bool,
    threads: Option<usize>,
    max_time: Option<f64>,
    tell: &Bound<'_, PyAny>,
) -> PyResult<String> {
    caught(|| {
        let work = |interrupt: &Interrupt, sender: &Sender<Told>| {
            let reader = |file: &Path, text: &str| read(file, Some(text), excess);
            let sweep = Sweep::begin(&read(&file, text.as_deref(), excess)?, &keys, &out, &reader)?;
            let (count, ended) = (sweep.points().len(), AtomicUsize::new(0));
            let say = |share: Option<f64>, point: &Point, text: &str| {
                sender.send((share, format!("{}: {text}", point.name))).ok();
            };
            let note = |point: &Point, text: String| say(None, point, &text);
            let failures = sweep.carry_out(interrupt, &reader, &|_| force, &note, &|point, outcome| {
                let share = (ended.fetch_add(1, Ordering::Relaxed) + 1) as f64 / count as f64;
                let outcome = outcome.as_ref().map_or_else(Error::to_string, |_| "finished".into());
                say(Some(share), point, &outcome);
            })?;
            let runs = sweep.json(&failures)?;
            // What failed stands in the table; what was interrupted has no table.
            match sweep.verdict(failures, interrupt) {
                Err(Error::Stopped(run)) => Err(Error::Stopped(run)),
                _ => Ok(runs),
            }
        };
        interruptible(py, &pool(threads)?, &limit(max_time)?, work, |told| tell.call1(told).map(drop))
    })
}
