//! A sweep as a whole: all combinations of the values of its keys, their runs, and the summary in its folder.

use super::axis::{Axis, axes};
use super::summary::{Summary, row};
use super::{Point, carry_out, distinct};
use crate::case::unmarked;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output::{Finding, Lock, create_folder};
use crate::run::{Job, Reader};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

/// Shortest interval between two versions of the summary.
const PAUSE: Duration = Duration::from_secs(1);

/// A sweep whose folder this process writes.
pub struct Sweep {
    #[cfg(feature = "cli")]
    title: String,
    axes: Vec<Axis>,
    points: Vec<Point>,
    out: PathBuf,
    /// The summary, and when it was written last.
    summary: Mutex<(Summary, Instant)>,
    _lock: Lock,
}

impl Sweep {
    /// Checks all combinations of the values of keys such as `seed=1,2,5` in a case, and writes their summary into a folder, before the first is
    /// run.
    ///
    /// # Errors
    ///
    /// If a key or value is wrong, two runs coincide, or the folder cannot be written.
    pub fn begin(case: &Job, keys: &[String], out: &Path, read: Reader) -> Result<Self, Error> {
        let axes = axes(keys)?;
        let points = points(&case.file, &case.text, &axes, read)?;
        create_folder(out)?;
        let lock = Lock::take(out)?;
        let mut summary = Summary::open(out)?;
        for point in &points {
            let before = summary.row(&point.name).cloned();
            let (mut row, _) = row(&axes, point, out, String::new())?;
            row.reason =
                before.filter(|before| before.status == row.status).map_or(String::new(), |before| before.reason);
            summary.put(row);
        }
        summary.write()?;
        Ok(Self {
            #[cfg(feature = "cli")]
            title: case.title.clone(),
            axes,
            points,
            out: out.into(),
            summary: Mutex::new((summary, Instant::now())),
            _lock: lock,
        })
    }

    /// The combinations, the last key varying fastest.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Its folder.
    pub fn out(&self) -> &Path {
        &self.out
    }

    /// Starts or resumes all runs that have not finished; those of `anew` replace what is in their folders. `note` receives remarks about runs,
    /// `ended` whether there was anything left to do. Returns the runs that failed, in their order.
    ///
    /// # Errors
    ///
    /// If the summary or the report cannot be written.
    pub fn carry_out(
        &self,
        interrupt: &Interrupt,
        read: Reader,
        anew: &(dyn Fn(&Point) -> bool + Sync),
        note: &(dyn Fn(&Point, String) + Sync),
        ended: &(dyn Fn(&Point, &Result<bool, Error>) + Sync),
    ) -> Result<Vec<(String, Error)>, Error> {
        let failures = Mutex::new(Vec::new());
        carry_out(&self.points, &self.out, interrupt, read, anew, note, &|point, outcome| {
            ended(point, &outcome);
            let reason = outcome.as_ref().err().map_or(String::new(), |error| error.to_string().replace('\n', "; "));
            failures.lock().expect("no worker panics").extend(outcome.err().map(|error| (point.name.clone(), error)));
            let (summary, written) = &mut *self.held();
            if let Ok((row, _)) = row(&self.axes, point, &self.out, reason) {
                summary.put(row);
            }
            // What cannot be written now is tried again at the end.
            if written.elapsed() >= PAUSE && summary.write().is_ok() {
                *written = Instant::now();
            }
        });
        self.held().0.write()?;
        #[cfg(feature = "cli")]
        super::report::report(&self.title, &self.axes, &self.points, &self.out, &self.held().0)?;
        let mut failures = failures.into_inner().expect("no worker panics");
        failures.sort_by_key(|(name, _)| self.points.iter().position(|point| point.name == *name));
        Ok(failures)
    }

    /// The summary as a table.
    pub fn table(&self) -> String {
        self.held().0.table()
    }

    /// The outcome: an interruption, or the first of the failures.
    ///
    /// # Errors
    ///
    /// What the outcome is, unless all runs have finished.
    pub fn verdict(&self, failures: Vec<(String, Error)>, interrupt: &Interrupt) -> Result<(), Error> {
        if interrupt.is_due() || failures.iter().any(|(_, error)| matches!(error, Error::Stopped(_))) {
            return Err(Error::Stopped(None));
        }
        let count = failures.len();
        match failures.into_iter().next() {
            None => Ok(()),
            Some((name, first)) => {
                let what = format!("{count} of {} runs did not finish", self.points.len());
                Err(Error::Runs(what, name, first.into()))
            }
        }
    }

    /// The runs for programs, each with its results, or with the error that ended it.
    ///
    /// # Errors
    ///
    /// If the results of a run cannot be read.
    pub fn json(&self, failures: &[(String, Error)]) -> Result<String, Error> {
        let object = |point: &Point| {
            let reason = self.held().0.row(&point.name).map_or(String::new(), |row| row.reason.clone());
            let (row, findings) = row(&self.axes, point, &self.out, reason)?;
            let keys: serde_json::Map<String, serde_json::Value> = self
                .axes
                .iter()
                .zip(&point.values)
                .map(|(axis, value)| (axis.key.clone(), value.clone().into()))
                .collect();
            let error = failures.iter().find(|(name, _)| *name == point.name).map(|(_, error)| error.to_json());
            Ok(serde_json::json!({
                "run": self.out.join(&point.name), "keys": keys, "status": row.status, "reason": row.reason, "error": error, "results": Finding::results(&findings)
            }))
        };
        let runs: Vec<serde_json::Value> = self.points.iter().map(object).collect::<Result<_, Error>>()?;
        Ok(format!("{:#}\n", serde_json::Value::Array(runs)))
    }

    fn held(&self) -> MutexGuard<'_, (Summary, Instant)> {
        self.summary.lock().expect("no worker panics")
    }
}

/// All combinations, each with its case; errors in any of them are found before the first is run.
fn points(file: &Path, text: &str, axes: &[Axis], read: Reader) -> Result<Vec<Point>, Error> {
    let base = serde_yaml::from_str(unmarked(text)).expect("the case has been read before");
    let count = axes.iter().map(|axis| axis.values.len()).product();
    let points: Vec<Point> = (0..count)
        .map(|mut number| {
            let mut values: Vec<(&str, &str)> = Vec::new();
            for Axis { key, values: choices } in axes.iter().rev() {
                values.push((key, &choices[number % choices.len()]));
                number /= choices.len();
            }
            values.reverse();
            Point::new(file, &base, &values, read)
        })
        .collect::<Result<_, Error>>()?;
    distinct(&points)?;
    Ok(points)
}
