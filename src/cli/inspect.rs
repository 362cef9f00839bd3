//! `veridem inspect`: summarises a run folder, or compares two.

use super::run::{Limits, table};
use super::{OutputMode, print};
use crate::error::Error;
use crate::initial::aggregate::import::{self, Options};
use crate::observe::aggregate::AggregateShape;
use crate::output::{Apart, Finding, Manifest, ReadFrame, ReadTable, RunFolder, Series, read};
use crate::papers::Papers;
use serde_json::json;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The run folder, or one of its frames (`.xyz`), of which the shape of the aggregate is measured
    #[arg(required_unless_present = "diff")]
    run: Option<PathBuf>,
    /// Compare two run folders, or two frames (`.xyz`) number by number; the exit status is 4 if they differ
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with = "run")]
    diff: Option<Vec<PathBuf>>,
    /// Of two frames: differences up to this fraction of the largest number of a column are none
    #[arg(long, value_name = "FRACTION", default_value_t = 0.0, requires = "diff")]
    within: f64,
}

/// Summarises or compares.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    match (&arguments.run, &arguments.diff) {
        (_, Some(pair)) if pair.iter().all(|path| path.is_file()) => measure_apart(pair, arguments.within, manner),
        (_, Some(pair)) => compare(&pair[0], &pair[1], manner),
        (Some(frame), None) if frame.is_file() => measure(frame, manner),
        (Some(run), None) => summarise(run, papers, manner),
        (None, None) => unreachable!("the command line demands one of the two"),
    }
}

/// The shape of the spheres of a frame.
fn measure(frame: &Path, manner: OutputMode) -> Result<(), Error> {
    let options = Options { unit: Some(1.0), disconnected: true, ..Options::default() };
    let interrupt = Limits::default().interrupt()?;
    let imported = import::read(frame, &options, &interrupt)?;
    let shape = AggregateShape::of(&imported.spheres, &interrupt)?.findings();
    if manner.json {
        return print(&format!(
            "{:#}\n",
            json!({ "spheres": imported.spheres.len(), "shape": Finding::results(&shape) })
        ));
    }
    print(&format!("{} spheres\n\n{}", imported.spheres.len(), table(&shape)))
}

fn summarise(root: &Path, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let folder = RunFolder::open(root)?;
    let title = papers.read(&folder.case())?.title;
    let manifest = Manifest::read(&folder)?;
    let (series, findings) = (Series::read(&folder)?, Finding::of_run(&folder)?);
    let state = series.last();
    if manner.json {
        let state: serde_json::Map<String, serde_json::Value> =
            state.into_iter().map(|(column, cell)| (column.into(), json!(cell))).collect();
        let summary =
            json!({ "title": title, "manifest": manifest, "state": state, "results": Finding::results(&findings) });
        return print(&format!("{summary:#}\n"));
    }
    let mut text = format!(
        "{title}\n{}, {} rows, commit {}\n\n",
        manifest.status_word(&folder),
        series.tables[0].rows.len(),
        manifest.commit
    );
    for (column, cell) in state {
        text.push_str(&format!("{column:36}  {cell}\n"));
    }
    print(&format!("{text}\n{}", table(&findings)))
}

/// How far two frames are apart.
fn measure_apart(pair: &[PathBuf], within: f64, manner: OutputMode) -> Result<(), Error> {
    let [one, two] = [ReadFrame::read(&pair[0])?, ReadFrame::read(&pair[1])?];
    let found = one.apart(&two).map_err(|what| Error::input(&pair[1], what))?;
    let differ = found.iter().any(|apart| apart.is_beyond(within));
    if manner.json {
        print(&format!("{:#}\n", json!({ "identical": !differ, "columns": found })))?;
    } else {
        let row = |Apart { column, difference, largest, sphere }: &Apart| {
            format!("{column:20} {difference:.1e} of {largest:.3e}, sphere {sphere}\n")
        };
        print(&format!(
            "largest difference of each column, of its largest number\n\n{}",
            found.iter().map(row).collect::<String>()
        ))?;
    }
    let [a, b] = [&pair[0], &pair[1]].map(|path| path.display());
    if differ { Err(Error::Verification(format!("{a} and {b} differ"))) } else { Ok(()) }
}

/// A difference between two runs.
#[derive(serde::Serialize)]
struct Difference {
    /// The file, relative to the run folder.
    file: String,
    /// The first row of the series, or the first line, that differs, counted from 1; 0 if the whole file does.
    row: usize,
    /// The column of the series; otherwise empty.
    column: String,
    /// What stands there in the first run.
    a: String,
    /// What stands there in the second.
    b: String,
}

fn compare(a: &Path, b: &Path, manner: OutputMode) -> Result<(), Error> {
    let folders = [RunFolder::open(a)?, RunFolder::open(b)?];
    let found = differences(&folders)?;
    if manner.json {
        print(&format!("{:#}\n", json!({ "identical": found.is_empty(), "differences": found })))?;
    } else if found.is_empty() {
        print("identical\n")?;
    } else {
        let line = |Difference { file, row, column, a, b }: &Difference| match (row, &**column) {
            (0, _) => format!("{file}: {a} and {b}\n"),
            (row, "") => format!("{file}: line {row}: {a} and {b}\n"),
            (row, column) => format!("{file}: row {row}, {column}: {a} and {b}\n"),
        };
        print(&found.iter().map(line).collect::<String>())?;
    }
    match found.is_empty() {
        true => Ok(()),
        false => Err(Error::Verification(format!("{} and {} differ", a.display(), b.display()))),
    }
}

/// The first difference of every column of the series, and of every other file that holds results.
fn differences(folders: &[RunFolder; 2]) -> Result<Vec<Difference>, Error> {
    let [a, b] = folders;
    let mut found = Vec::new();
    let [ours, theirs] = [Series::read(a)?, Series::read(b)?];
    for (a, b) in ours.tables.iter().filter_map(|a| Some((a, theirs.tables.iter().find(|b| b.file == a.file)?))) {
        found.extend(of_tables(a, b));
    }
    let compared = |path: &PathBuf| {
        [&ours, &theirs]
            .iter()
            .all(|series| series.tables.iter().any(|table| path.file_name().is_some_and(|name| name == &*table.file)))
    };
    let name = |folder: &RunFolder, path: &Path| path.strip_prefix(folder.root()).unwrap_or(path).to_path_buf();
    let mut names = BTreeSet::new();
    for folder in folders {
        let given = [folder.case(), folder.resolved()];
        let others = folder.outputs()?;
        let others = others.iter().filter(|path| !given.contains(path) && !compared(path));
        names.extend(others.map(|path| name(folder, path)));
    }
    for name in names {
        let paths = folders.each_ref().map(|folder| folder.root().join(&name));
        let file = name.display().to_string();
        if let Some(missing) = paths.iter().position(|path| !path.exists()) {
            let word = |k: usize| if k == missing { "missing" } else { "present" };
            found.push(Difference { file, row: 0, column: String::new(), a: word(0).into(), b: word(1).into() });
            continue;
        }
        let [a, b] = [read(&paths[0])?, read(&paths[1])?];
        if a != b {
            let lines = |bytes: &[u8]| -> Vec<String> {
                bytes.split(|&byte| byte == b'\n').map(|line| String::from_utf8_lossy(line).into()).collect()
            };
            let (a, b) = (lines(&a), lines(&b));
            let place = a.iter().zip(&b).position(|(a, b)| a != b).unwrap_or(a.len().min(b.len()));
            let at =
                |lines: &[String]| lines.get(place).map_or("the end of the file".into(), |line| format!("`{line}`"));
            found.push(Difference { file, row: place + 1, column: String::new(), a: at(&a), b: at(&b) });
        }
    }
    Ok(found)
}

/// The first row of every column that differs, over the rows that both have, and the number of rows.
fn of_tables(a: &ReadTable, b: &ReadTable) -> Vec<Difference> {
    let difference = |row, column: &str, one: &str, b: &str| Difference {
        file: a.file.clone(),
        row,
        column: column.into(),
        a: one.into(),
        b: b.into(),
    };
    if a.columns != b.columns {
        let [a, b] = [a, b].map(|table| table.columns.join(","));
        return vec![difference(0, "", &a, &b)];
    }
    let rows = || a.rows.iter().zip(&b.rows);
    let of_column = |(place, column): (usize, &String)| {
        let row = rows().position(|(a, b)| a[place] != b[place])?;
        Some(difference(row + 1, column, &a.rows[row][place], &b.rows[row][place]))
    };
    let mut found: Vec<Difference> = a.columns.iter().enumerate().filter_map(of_column).collect();
    if a.rows.len() != b.rows.len() {
        let [a, b] = [a, b].map(|table| format!("{} rows", table.rows.len()));
        found.push(difference(0, "", &a, &b));
    }
    found
}
