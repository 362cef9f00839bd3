//! A force curve, from the folder of a run.

use super::Stage;
use crate::error::Error;
use crate::output::{Finding, RunFolder, read};
use crate::run::Series;
use serde::Deserialize;

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

/// The columns of the curve.
pub const MOVED: &str = "tip moved [nm]";
pub const FORCE: &str = "force on the tip [pN]";
/// The findings that a spectrum holds.
pub const LARGEST: &str = "largest pull on the tip";
pub const LAST: &str = "last peak of the pull";
pub const WAY: &str = "way of the tip from the setpoint to the rupture";

/// A line of the events.
#[derive(Deserialize)]
struct Event {
    stage: String,
    time_ns: f64,
    event: String,
}

impl Spectrum {
    /// How far the tip had moved at the last peak of the pull, nm.
    pub fn peak(&self) -> f64 {
        self.retraction.iter().rev().find(|point| self.last == Some(-point.1)).map_or(0.0, |point| point.0)
    }

    /// What a run has left that has finished; its series must be as fine as the force is averaged.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let (series, findings) = (Series::read(folder)?, Finding::of_run(folder)?);
        let up = Stage::Retraction.name();
        let moved = series.curve(up, "time [ns]", MOVED);
        let path = folder.events();
        let lines = read(&path)?;
        let lines = lines.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
        let events =
            lines.map(|line| serde_json::from_slice(line).map_err(|error| Error::input(&path, error.to_string())));
        let events: Vec<Event> = events.collect::<Result<_, Error>>()?;
        let going_up = events.into_iter().filter(|event| event.stage == up);
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

/// A curve at a place, between its points.
pub fn between(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let ((a, f), (b, g)) = curve.iter().zip(&curve[1..]).find(|(p, q)| p.0 <= x && x <= q.0 && p.0 < q.0)?;
    Some(f + (g - f) * (x - a) / (b - a))
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn events_lie_on_the_curve() {
        let curve = [(0.0, 1.0), (2.0, 5.0), (3.0, 4.0)];
        assert_eq!([0.0, 1.0, 2.25, 3.0].map(|x| between(&curve, x)), [1.0, 3.0, 4.75, 4.0].map(Some));
        assert_eq!(between(&curve, 3.5), None);
    }
}
