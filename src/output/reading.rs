//! Reading of a run folder: its time series and its events.

use super::{Column, RunFolder, read};
use crate::error::Error;
use serde::Deserialize;

/// An event of a run.
#[derive(Deserialize)]
pub struct Event {
    /// The stage.
    pub stage: String,
    /// The time, ns.
    pub time_ns: f64,
    /// Its description.
    pub event: String,
}

impl Event {
    /// All events of a run.
    ///
    /// # Errors
    ///
    /// If the events cannot be read.
    pub fn all(folder: &RunFolder) -> Result<Vec<Self>, Error> {
        let path = folder.events();
        let lines = read(&path)?;
        let lines = lines.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
        lines.map(|line| serde_json::from_slice(line).map_err(|error| Error::input(&path, error.to_string()))).collect()
    }
}

/// The time series of a run, as read.
pub struct Series {
    /// The columns' names.
    pub columns: Vec<String>,
    /// The rows' cells.
    pub rows: Vec<Vec<String>>,
}

impl Series {
    /// Reads the series of a run folder.
    ///
    /// # Errors
    ///
    /// If the series cannot be read.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let path = folder.series();
        let bytes = read(&path)?;
        let broken = |error: csv::Error| Error::input(&path, error.to_string());
        let mut reader = csv::Reader::from_reader(&*bytes);
        let line = |record: &csv::StringRecord| record.iter().map(str::to_string).collect::<Vec<_>>();
        let columns = line(reader.headers().map_err(broken)?);
        let rows = reader.records().map(|record| record.map(|r| line(&r)).map_err(broken)).collect::<Result<_, _>>()?;
        Ok(Self { columns, rows })
    }

    /// The stages, in their order.
    pub fn stages(&self) -> Vec<&str> {
        let mut stages: Vec<&str> = self.rows.iter().map(|row| &*row[0]).collect();
        stages.dedup();
        stages
    }

    /// The points of one column against another in one stage, or in all stages for an empty name.
    pub fn curve(&self, stage: &str, x: Column, y: Column) -> Vec<(f64, f64)> {
        self.curve_of(stage, &x.to_string(), &y.to_string())
    }

    /// The same, with columns given by their headers.
    pub fn curve_of(&self, stage: &str, x: &str, y: &str) -> Vec<(f64, f64)> {
        let place = |header: &str| self.columns.iter().position(|column| column == header);
        let (Some(x), Some(y)) = (place(x), place(y)) else { return Vec::new() };
        let of_stage = self.rows.iter().filter(|row| stage.is_empty() || row[0] == stage);
        of_stage.filter_map(|row| Some((row[x].parse().ok()?, row[y].parse().ok()?))).collect()
    }
}

/// The value of a curve by interpolation between its points.
pub fn between(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let mut ends = curve.windows(2).map(|ends| (ends[0], ends[1]));
    let ((a, f), (b, g)) = ends.find(|(p, q)| p.0 <= x && x <= q.0 && p.0 < q.0)?;
    Some(f + (g - f) * (x - a) / (b - a))
}
