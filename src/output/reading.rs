//! Reading of a run folder: its time series and its events.

use super::columns::TIME;
use super::series::{PROFILES, SERIES, WINDOWS, stage_file};
use super::{Column, RunFolder, read};
use crate::error::Error;
use serde::Deserialize;
use std::path::Path;

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

/// A table of a run, as read.
pub struct ReadTable {
    /// Its file, relative to the run folder.
    pub file: String,
    /// The columns' names.
    pub columns: Vec<String>,
    /// The rows' cells.
    pub rows: Vec<Vec<String>>,
}

impl ReadTable {
    /// Reads a table.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, or is no table.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let bytes = read(path)?;
        let broken = |error: csv::Error| Error::input(path, error.to_string());
        let mut reader = csv::Reader::from_reader(&*bytes);
        let line = |record: &csv::StringRecord| record.iter().map(str::to_string).collect::<Vec<_>>();
        let columns = line(reader.headers().map_err(broken)?);
        let rows = reader.records().map(|record| record.map(|r| line(&r)).map_err(broken)).collect::<Result<_, _>>()?;
        let file = path.file_name().unwrap_or_default().to_string_lossy().into();
        Ok(Self { file, columns, rows })
    }

    fn place(&self, header: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == header)
    }
}

/// The series of a run, as read: its tables, that of all stages first.
pub struct Series {
    /// The tables.
    pub tables: Vec<ReadTable>,
}

impl Series {
    /// Reads the series of a run folder.
    ///
    /// # Errors
    ///
    /// If a table cannot be read.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let mut paths = folder.tables()?;
        if paths.first() != Some(&folder.series()) {
            paths.insert(0, folder.series());
        }
        Ok(Self { tables: paths.iter().map(|path| ReadTable::read(path)).collect::<Result<_, _>>()? })
    }

    /// The stages, in their order.
    pub fn stages(&self) -> Vec<&str> {
        let mut stages: Vec<&str> = self.tables[0].rows.iter().map(|row| &*row[0]).collect();
        stages.dedup();
        stages
    }

    /// The points of one column against another in one stage, or in all stages for an empty name.
    pub fn curve(&self, stage: &str, x: Column, y: Column) -> Vec<(f64, f64)> {
        self.curve_of(stage, &x.to_string(), &y.to_string())
    }

    /// The same, with columns given by their headers: from the first table of the stage that has both.
    pub fn curve_of(&self, stage: &str, x: &str, y: &str) -> Vec<(f64, f64)> {
        let own = stage_file(stage);
        for table in self.tables.iter().filter(|table| table.file == own || [SERIES, WINDOWS].contains(&&*table.file)) {
            if let (Some(x), Some(y)) = (table.place(x), table.place(y)) {
                let every = stage.is_empty() || table.file == own;
                let rows = table.rows.iter().filter(|row| every || row[0] == stage);
                return rows.filter_map(|row| Some((row[x].parse().ok()?, row[y].parse().ok()?))).collect();
            }
        }
        Vec::new()
    }

    /// The points of one column of the profiles against another in one stage: the time of every profile, ns, and its points.
    pub fn profiles(&self, stage: &str, x: Column, y: Column) -> Vec<(f64, Vec<(f64, f64)>)> {
        let Some(table) = self.tables.iter().find(|table| table.file == PROFILES) else { return Vec::new() };
        let [Some(time), Some(x), Some(y)] = [TIME, x, y].map(|column| table.place(&column.to_string())) else {
            return Vec::new();
        };
        let rows: Vec<&Vec<String>> = table.rows.iter().filter(|row| row[0] == stage).collect();
        let profile = |rows: &[&Vec<String>]| {
            let points = rows.iter().filter_map(|row| Some((row[x].parse().ok()?, row[y].parse().ok()?))).collect();
            Some((rows[0][time].parse().ok()?, points))
        };
        rows.chunk_by(|a, b| a[time] == b[time]).filter_map(profile).collect()
    }

    /// The last value of every column of the last stage that was written.
    pub fn last(&self) -> Vec<(&str, &str)> {
        let own = stage_file(self.stages().last().copied().unwrap_or_default());
        let mut state: Vec<(&str, &str)> = Vec::new();
        for table in self.tables.iter().filter(|table| table.file == own || table.file == SERIES) {
            let row = table.rows.last().map(Vec::as_slice).unwrap_or_default();
            let cells = table.columns.iter().map(String::as_str).zip(row.iter().map(String::as_str));
            let known: Vec<&str> = state.iter().map(|cell| cell.0).collect();
            state.extend(cells.filter(|cell| !known.contains(&cell.0)));
        }
        state
    }
}

/// The value of a curve by interpolation between its points.
pub fn between(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let mut ends = curve.windows(2).map(|ends| (ends[0], ends[1]));
    let ((a, f), (b, g)) = ends.find(|(p, q)| p.0 <= x && x <= q.0 && p.0 < q.0)?;
    Some(f + (g - f) * (x - a) / (b - a))
}
