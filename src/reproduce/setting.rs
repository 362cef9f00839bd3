//! How a chapter is computed, and the runs that it keeps.

use super::Extent;
use crate::error::{AtPath, Error};
use crate::interrupt::Interrupt;
use crate::output::{Manifest, RunFolder};
use crate::run::Reader;
use crate::run::sweep::{Point, carry_out};
use indicatif::HumanDuration;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Instant;

/// How a chapter is computed.
pub struct Setting<'a> {
    /// How much of it.
    pub extent: Extent,
    /// Where runs are kept that take long: what has finished is not run again, and what was stopped is gone on with.
    pub runs: PathBuf,
    /// Reads the cases of those runs.
    pub read: Reader<'a>,
    /// Stops it.
    pub interrupt: &'a Interrupt,
    /// Hears how it is going.
    pub tell: &'a (dyn Fn(String) + Sync),
}

/// What has become of runs.
pub struct Kept {
    /// The folders of those that have finished, in order.
    pub folders: Vec<Option<RunFolder>>,
    /// Whether a signal has stopped the others.
    pub stopped: bool,
}

impl Setting<'_> {
    /// Runs, or goes on with, whatever has not finished, one run on each core.
    pub fn keep(&self, points: &[Point]) -> Result<Kept, Error> {
        std::fs::create_dir_all(&self.runs).at(&self.runs)?;
        let (begin, state) = (Instant::now(), Mutex::new((0, 0, None)));
        carry_out(points, &self.runs, self.interrupt, self.read, &|_, outcome| {
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
                "warning: another build of this program has made {n} of these runs, or a part of them"
            )),
        }
        Ok(Kept { folders, stopped: self.interrupt.is_due() })
    }
}
