//! The force curve of a run, read from its folder.

use super::FilmStage;
use super::columns::{FORCE, MOVED, results};
use crate::error::Error;
use crate::output::columns::TIME;
use crate::output::{Column, Event, Finding, RunFolder, Series, between};

/// The result of the force spectroscopy of a film.
#[derive(Clone, Debug, Default)]
pub struct Spectrum {
    /// Displacement of the tip, nm, and mean force on it, pN, during the approach.
    pub approach: Vec<(f64, f64)>,
    /// The same during the retraction.
    pub retraction: Vec<(f64, f64)>,
    /// Events during the retraction, with the displacement of the tip at which they occurred.
    pub events: Vec<(f64, String)>,
    /// The largest pulling force, pN.
    pub largest: f64,
    /// The last peak of the pulling force before the tip is free, pN, if any.
    pub last: Option<f64>,
    /// Displacement of the tip from the setpoint to the rupture, nm, if the film ruptured.
    pub rupture: Option<f64>,
}

impl Spectrum {
    /// Displacement of the tip at the last peak of the pulling force, nm.
    pub fn peak(&self) -> f64 {
        let from = |point: &(f64, f64), last: f64| (point.1 + last).abs();
        let nearest = |last| self.retraction.iter().min_by(|a, b| from(a, last).total_cmp(&from(b, last)));
        self.last.and_then(nearest).map_or(0.0, |point| point.0)
    }

    /// Reads a finished run.
    ///
    /// # Errors
    ///
    /// If the series cannot be read.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let (series, findings) = (Series::read(folder)?, Finding::of_run(folder)?);
        let up = FilmStage::Retraction.name();
        let (moved, retraction) = (series.curve(up, TIME, MOVED), series.curve(up, MOVED, FORCE));
        let going_up = Event::all(folder)?.into_iter().filter(|event| event.stage == up);
        let found =
            |result: Column| findings.iter().find(|finding| finding.name == result.name).and_then(Finding::value);
        Ok(Self {
            approach: series.curve(FilmStage::Approach.name(), MOVED, FORCE),
            largest: retraction.iter().map(|point| -point.1).fold(0.0, f64::max),
            retraction,
            events: going_up
                .filter_map(|Event { time_ns, event, .. }| Some((between(&moved, time_ns)?, event)))
                .collect(),
            last: found(results::LAST).map(|peak| 1e3 * peak),
            rupture: found(results::RUPTURE),
        })
    }
}
