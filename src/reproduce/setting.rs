//! The setting in which a chapter is computed, and its saved runs.

use super::Extent;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::{Lock, Manifest, RunFolder, create_folder};
use crate::run::Reader;
use crate::run::sweep::{Point, carry_out};
use indicatif::HumanDuration;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Instant;

/// The setting of a chapter.
pub struct Setting<'a> {
    /// Its extent.
    pub extent: Extent,
    /// Folder of long runs: finished ones are not repeated, stopped ones are resumed.
    pub runs: PathBuf,
    /// Reads the cases of these runs.
    pub read: Reader<'a>,
    /// Interrupts the computation.
    pub interrupt: &'a Interrupt,
    /// Receives messages about the progress.
    pub tell: &'a (dyn Fn(String) + Sync),
}

/// The outcome of a set of runs.
pub struct RunSet {
    /// The folders of the finished runs, in order.
    pub folders: Vec<Option<RunFolder>>,
    /// Whether the others were stopped by a signal.
    pub stopped: bool,
}

impl Setting<'_> {
    /// Starts or resumes all runs that have not finished, on all cores.
    ///
    /// # Errors
    ///
    /// The first run that fails, and a folder that cannot be written.
    pub fn run_all(&self, points: &[Point]) -> Result<RunSet, Error> {
        create_folder(&self.runs)?;
        let _lock = Lock::take(&self.runs)?;
        let (begin, state) = (Instant::now(), Mutex::new((0, 0, None)));
        let note = |point: &Point, text: String| (self.tell)(format!("{}: {text}", point.name));
        carry_out(points, &self.runs, self.interrupt, self.read, &|_| false, &note, &|_, outcome| {
            let (done, new, failure) = &mut *state.lock().expect("no worker panics");
            match outcome {
                Ok(was_left) => {
                    *done += 1;
                    *new += u32::from(was_left);
                    if *new > 0 {
                        let left = begin.elapsed() * (points.len() - *done) as u32 / *new;
                        (self.tell)(format!("{done} of {} runs, about {} left", points.len(), HumanDuration(left)));
                    }
                }
                Err(Error::Stopped(_)) => {}
                Err(error) => *failure = failure.take().or(Some(error)),
            }
        });
        if let Some(error) = state.into_inner().expect("no worker panics").2 {
            return Err(error);
        }
        let finished = |point: &Point| {
            RunFolder::open(&self.runs.join(&point.name)).ok().filter(|folder| folder.results().exists())
        };
        let folders: Vec<Option<RunFolder>> = points.iter().map(finished).collect();
        let others = folders.iter().flatten().filter(|folder| !Manifest::read(folder).is_ok_and(|run| run.is_ours()));
        match others.count() {
            0 => {}
            n => (self.tell)(format!(
                "warning: {n} of these runs were made, at least in part, by another build of this program"
            )),
        }
        Ok(RunSet { folders, stopped: self.interrupt.is_due() })
    }
}
