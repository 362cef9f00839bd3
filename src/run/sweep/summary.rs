//! The summary of a sweep: one row per run, those of earlier sweeps into the same folder included.

use super::Point;
use super::axis::Axis;
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder, read, write_atomically};
use std::path::{Path, PathBuf};

/// The column between the keys and the results.
const STATUS: &str = "status";
/// The columns after the results.
const LAST: [&str; 2] = ["reason", "run"];

/// Cells by the headers of their columns.
type Cells = Vec<(String, String)>;

/// A run of the summary.
#[derive(Clone)]
pub(super) struct Row {
    /// The name of its folder.
    pub run: String,
    /// The keys that were varied.
    keys: Cells,
    /// Its status.
    pub status: String,
    /// Why it did not finish.
    pub reason: String,
    results: Cells,
}

/// The summary of all sweeps into a folder.
pub(super) struct Summary {
    file: PathBuf,
    rows: Vec<Row>,
}

impl Summary {
    /// The summary in a folder, empty if there is none yet.
    pub(super) fn open(out: &Path) -> Result<Self, Error> {
        let file = out.join("summary.csv");
        let rows = if file.exists() { rows(&file)? } else { Vec::new() };
        Ok(Self { file, rows })
    }

    /// The row of a run.
    pub(super) fn row(&self, run: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.run == run)
    }

    /// Adds a row, or replaces that of the same run.
    pub(super) fn put(&mut self, row: Row) {
        match self.rows.iter_mut().find(|old| old.run == row.run) {
            Some(old) => *old = row,
            None => self.rows.push(row),
        }
    }

    /// Writes the file.
    pub(super) fn write(&self) -> Result<(), Error> {
        write_atomically(&self.file, self.table().as_bytes())
    }

    /// The columns of all rows: keys, status, results, reason, name of the folder.
    pub(super) fn table(&self) -> String {
        let headers = |cells: fn(&Row) -> &Cells| {
            let mut headers: Vec<&str> = Vec::new();
            for (header, _) in self.rows.iter().flat_map(cells) {
                if !headers.contains(&&**header) {
                    headers.push(header);
                }
            }
            headers
        };
        let (keys, results) = (headers(|row| &row.keys), headers(|row| &row.results));
        let mut table = csv::Writer::from_writer(Vec::new());
        let head = keys.iter().chain(&[STATUS]).chain(&results).chain(&LAST);
        table.write_record(head).expect("memory can always grow");
        for Row { run, keys: cells, status, reason, results: findings } in &self.rows {
            let of = |cells: &Cells, header: &str| {
                cells.iter().find(|(other, _)| other == header).map_or(String::new(), |(_, cell)| cell.clone())
            };
            let cells = keys.iter().map(|key| of(cells, key)).chain([status.clone()]);
            let cells = cells.chain(results.iter().map(|result| of(findings, result)));
            let cells = cells.chain([reason.clone(), run.clone()]);
            table.write_record(cells).expect("memory can always grow");
        }
        let bytes = table.into_inner().expect("memory can always grow");
        String::from_utf8(bytes).expect("what was written is text")
    }
}

/// The rows of a file that a sweep wrote.
fn rows(file: &Path) -> Result<Vec<Row>, Error> {
    let strange = |what: String| {
        Error::input(file, format!("{what}; it is not replaced: move it away, or sweep into another folder with --out"))
    };
    let bytes = read(file)?;
    let mut reader = csv::Reader::from_reader(&*bytes);
    let headers = reader.headers().map_err(|error| strange(error.to_string()))?.clone();
    let headers: Vec<&str> = headers.iter().collect();
    let status = headers.iter().position(|header| *header == STATUS).filter(|_| headers.ends_with(&LAST));
    let status = status.ok_or_else(|| strange("is not the summary of a sweep".into()))?;
    let row = |record: csv::StringRecord| {
        let cell = |place: usize| record[place].to_string();
        let cells = |places: std::ops::Range<usize>| {
            let named = places.map(|place| (headers[place].to_string(), cell(place)));
            named.filter(|(_, cell)| !cell.is_empty()).collect()
        };
        let [reason, run] = [headers.len() - 2, headers.len() - 1];
        Row {
            run: cell(run),
            keys: cells(0..status),
            status: cell(status),
            reason: cell(reason),
            results: cells(status + 1..reason),
        }
    };
    reader.records().map(|record| record.map(row).map_err(|error| strange(error.to_string()))).collect()
}

/// The row of a run as its folder shows it, and its findings.
pub(super) fn row(axes: &[Axis], point: &Point, out: &Path, reason: String) -> Result<(Row, Vec<Finding>), Error> {
    let begun =
        RunFolder::open(&out.join(&point.name)).and_then(|run| Ok((Manifest::read(&run)?.status_word(&run), run)));
    let (status, findings) = match begun {
        Ok((status, run)) => (status.to_lowercase(), Finding::of_run(&run)?),
        Err(_) => ("not run".into(), Vec::new()),
    };
    let results = findings.iter().map(|finding| (finding.header(), finding.text())).collect();
    let keys = axes.iter().zip(&point.values).map(|(axis, value)| (axis.key.clone(), value.clone())).collect();
    Ok((Row { run: point.name.clone(), keys, status, reason, results }, findings))
}
