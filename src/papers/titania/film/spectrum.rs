//! A force curve, from the folder of a run.

use super::Stage;
use crate::error::Error;
use crate::output::columns::TIME;
use crate::output::{Column, Event, Finding, RunFolder, Series, between};

/// What comes out of a film under a tip.
#[derive(Clone, Debug, Default)]
pub struct Spectrum {
    /// How far the tip had moved, nm, and the mean force on it, pN: coming down.
    pub approach: Vec<(f64, f64)>,
    /// The same going up.
    pub retraction: Vec<(f64, f64)>,
    /// What happened while it went up, and how far it had moved then.
    pub events: Vec<(f64, String)>,
    /// Largest pull, last peak of the pull, pN, and the way from the setpoint to the rupture, nm; what there was.
    pub largest: f64,
    /// The last peak before nothing pulls any more.
    pub last: Option<f64>,
    /// The way.
    pub rupture: Option<f64>,
}

/// How far the tip has moved.
pub const MOVED: Column = Column::new("tip moved", "nm");
/// Mean force on it.
pub const FORCE: Column = Column::new("force on the tip", "pN");
/// A finding that a spectrum holds.
pub const LARGEST: &str = "largest pull on the tip";
/// Another.
pub const LAST: &str = "last peak of the pull";
/// Another.
pub const WAY: &str = "way of the tip from the setpoint to the rupture";

impl Spectrum {
    /// How far the tip had moved at the last peak of the pull, nm.
    pub fn peak(&self) -> f64 {
        self.retraction.iter().rev().find(|point| self.last == Some(-point.1)).map_or(0.0, |point| point.0)
    }

    /// What a run has left that has finished; its series must be as fine as the force is averaged.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let (series, findings) = (Series::read(folder)?, Finding::of_run(folder)?);
        let up = Stage::Retraction.name();
        let moved = series.curve(up, TIME, MOVED);
        let going_up = Event::all(folder)?.into_iter().filter(|event| event.stage == up);
        let found =
            |name| findings.iter().find(|finding| finding.name == name).and_then(|found| found.value.parse().ok());
        Ok(Self {
            approach: series.curve(Stage::Approach.name(), MOVED, FORCE),
            retraction: series.curve(up, MOVED, FORCE),
            events: going_up
                .filter_map(|Event { time_ns, event, .. }| Some((between(&moved, time_ns)?, event)))
                .collect(),
            largest: found(LARGEST).unwrap_or(0.0),
            last: found(LAST),
            rupture: found(WAY),
        })
    }
}
