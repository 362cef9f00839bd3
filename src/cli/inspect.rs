//! `veridem inspect`: summarises a run folder, or compares two.

use super::run::table;
use super::{OutputMode, print};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder, Series, read};
use crate::papers::Papers;
use serde_json::json;
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The run folder
    #[arg(required_unless_present = "diff")]
    run: Option<PathBuf>,
    /// Compare two run folders; the exit status is 4 if they differ
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with = "run")]
    diff: Option<Vec<PathBuf>>,
}

/// Summarises or compares.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    match (&arguments.run, &arguments.diff) {
        (_, Some(pair)) => compare(&pair[0], &pair[1], manner),
        (Some(run), None) => summarise(run, papers, manner),
        (None, None) => unreachable!("the command line demands one of the two"),
    }
}

fn summarise(root: &Path, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let folder = RunFolder::open(root)?;
    let title = papers.read(&folder.case())?.title;
    let manifest = Manifest::read(&folder)?;
    let (series, findings) = (Series::read(&folder)?, Finding::of_run(&folder)?);
    let last = series.rows.last().map(Vec::as_slice).unwrap_or_default();
    let state: Vec<(&String, &String)> = series.columns.iter().zip(last).filter(|(_, cell)| !cell.is_empty()).collect();
    if manner.json {
        let state: serde_json::Map<String, serde_json::Value> =
            state.into_iter().map(|(column, cell)| (column.clone(), json!(cell))).collect();
        let summary = json!({ "title": title, "manifest": manifest, "state": state, "results": findings });
        return print(&format!("{summary:#}\n"));
    }
    let mut text = format!(
        "{title}\n{}, {} rows, commit {}\n\n",
        manifest.status_word(&folder),
        series.rows.len(),
        manifest.commit
    );
    for (column, cell) in state {
        text.push_str(&format!("{column:36}  {cell}\n"));
    }
    print(&format!("{text}\n{}", table(&findings)))
}

/// The largest difference of a column, and the first row that differs.
struct Difference {
    column: String,
    row: usize,
    largest: f64,
    scale: f64,
}

fn compare(a: &Path, b: &Path, manner: OutputMode) -> Result<(), Error> {
    let (folder_a, folder_b) = (RunFolder::open(a)?, RunFolder::open(b)?);
    let (series_a, series_b) = (Series::read(&folder_a)?, Series::read(&folder_b)?);
    let differences = differences(&series_a, &series_b);
    let rows = (series_a.rows.len(), series_b.rows.len());
    let (findings_a, findings_b) = (Finding::of_run(&folder_a)?, Finding::of_run(&folder_b)?);
    let changed: Vec<(&Finding, Option<&Finding>)> = findings_a
        .iter()
        .map(|one| (one, findings_b.iter().find(|other| other.name == one.name)))
        .filter(|(one, other)| *other != Some(one))
        .collect();
    let frames = last_frame(&folder_a)? == last_frame(&folder_b)?;
    let same_columns = series_a.columns == series_b.columns;
    let identical = same_columns && differences.is_empty() && rows.0 == rows.1 && findings_a == findings_b && frames;
    if manner.json {
        let list: Vec<_> = differences
            .iter()
            .map(|d| json!({ "column": d.column, "first_row": d.row, "largest": d.largest, "scale": d.scale }))
            .collect();
        let results: Vec<_> = changed.iter().map(|(one, other)| json!({ "a": one, "b": other })).collect();
        let report = json!({ "identical": identical, "rows": [rows.0, rows.1], "series": list, "results": results, "last_frame_identical": frames });
        print(&format!("{report:#}\n"))?;
    } else {
        let mut text = String::new();
        if rows.0 != rows.1 {
            text.push_str(&format!("series: {} rows and {} rows\n", rows.0, rows.1));
        }
        if !same_columns {
            text.push_str("series: the columns differ\n");
        }
        for d in &differences {
            let Difference { column, row, largest, scale } = d;
            text.push_str(&format!("{column}: differs from row {row} on, by up to {largest:e} of {scale:e}\n"));
        }
        for (one, other) in &changed {
            let other = other.map_or("nothing", |other| &other.value);
            text.push_str(&format!("{}: {} and {other}\n", one.name, one.value));
        }
        if !frames {
            text.push_str("last frame: differs\n");
        }
        if identical {
            text.push_str("identical\n");
        }
        print(&text)?;
    }
    if identical { Ok(()) } else { Err(Error::Verification(format!("{} and {} differ", a.display(), b.display()))) }
}

/// Compares column by column, over the rows that both have.
fn differences(a: &Series, b: &Series) -> Vec<Difference> {
    let mut found = Vec::new();
    for (place, column) in a.columns.iter().enumerate() {
        let Some(other) = b.columns.iter().position(|name| name == column) else { continue };
        let pairs = || a.rows.iter().zip(&b.rows).map(|(x, y)| (&x[place], &y[other]));
        let Some(row) = pairs().position(|(x, y)| x != y) else { continue };
        let number = |cell: &str| cell.parse::<f64>().unwrap_or(f64::NAN);
        let sizes = |f: &dyn Fn(f64, f64) -> f64| pairs().map(|(x, y)| f(number(x), number(y))).fold(0.0, f64::max);
        let largest = sizes(&|x, y| (x - y).abs());
        found.push(Difference {
            column: column.clone(),
            row: row + 1,
            largest,
            scale: sizes(&|x, y| x.abs().max(y.abs())),
        });
    }
    found
}

fn last_frame(folder: &RunFolder) -> Result<Option<Vec<u8>>, Error> {
    let mut frames = folder.outputs()?.into_iter().filter(|path| path.starts_with(folder.frames()));
    frames.next_back().map(|path| read(&path)).transpose()
}
