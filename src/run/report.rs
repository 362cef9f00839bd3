//! The pictures of a run and the page that shows them.

use crate::case::Case;
use crate::error::{AtPath, Error};
use crate::figures::{Axis, Curve, Mark, Plot, Report, snapshot};
use crate::output::{Finding, RunFolder, write_atomically};
use crate::system::System;
use std::collections::BTreeMap;

/// Draws the particles as they are now, with one of the axes pointing upwards.
pub fn picture(folder: &RunFolder, name: &str, system: &System, upwards: usize) -> Result<(), Error> {
    let mut turned;
    let system = if upwards == 1 {
        system
    } else {
        turned = system.clone();
        turned.domain.sides.swap(1, upwards);
        turned.domain.periodic.swap(1, upwards);
        turned.particles.x.iter_mut().for_each(|x| x.0.swap(1, upwards));
        &turned
    };
    let height = system.domain.sides[1];
    let path = folder.figures().join(name).with_extension("svg");
    write_atomically(&path, snapshot(system, [-0.1 * height, 1.2 * height]).as_bytes())
}

/// The curves that a reader asks for first: name, stages or none for all, axes.
const CURVES: [(&str, &[&str], &str, &str); 21] = [
    ("friction", &["shearing"], "slid [nm]", "friction [pN]"),
    ("separation", &["shearing"], "slid [nm]", "separation [nm]"),
    ("turns", &["shearing"], "slid [nm]", "third body turns"),
    ("compression", &["compression"], "normal strain", "normal stress [MPa]"),
    ("tension", &["tension"], "normal strain", "normal stress [MPa]"),
    ("shear", &["shear"], "shear strain", "shear stress [MPa]"),
    ("relaxation", &["cohesion"], "step", "volume fraction"),
    ("coordination", &["restructuring"], "time [ns]", "coordination number"),
    ("convexity", &["restructuring"], "time [ns]", "convexity"),
    ("gyration", &["restructuring"], "time [ns]", "gyration radius [nm]"),
    ("height", &["deposition"], "time [ns]", "height [nm]"),
    ("deposition energy", &["deposition"], "time [ns]", "kinetic energy [zJ]"),
    ("force curve", &["indentation"], "tip displacement [nm]", "cantilever reading [pN]"),
    ("force on the tip", &["indentation"], "tip displacement [nm]", "pull on the tip [pN]"),
    ("approach", &["approach"], "time [ns]", "distance [nm]"),
    ("sliding friction", &["sliding"], "moved [nm]", "friction [pN]"),
    ("rolling resistance", &["rolling"], "moved [nm]", "rolling resistance [pN]"),
    ("pulling force", &["pulling"], "pulled [nm]", "pulling force [pN]"),
    ("contacts", &["pulling"], "pulled [nm]", "contacts"),
    ("spectroscopy", &["approach", "retraction"], "tip moved [nm]", "force on the tip [pN]"),
    ("ledger", &[], "time [ns]", "relative residual"),
];

/// Makes figures and report of a finished run from what it has recorded.
pub fn report(case: &Case, folder: &RunFolder, findings: &[Finding]) -> Result<(), Error> {
    let mut page = Report::new(&case.title);
    let rows: Vec<[String; 4]> =
        findings.iter().map(|f| [f.name.clone(), f.value.clone(), f.unit.clone(), f.target.clone()]).collect();
    page.table(&["quantity", "value", "unit", "target"], &rows);
    let series = Series::read(folder)?;
    for (name, stages, x, y) in CURVES {
        let labels = if stages.len() > 1 { stages } else { &[""] };
        let points = |k: usize| series.curve(stages.get(k).copied().unwrap_or_default(), x, y);
        let curves = labels.iter().enumerate().map(|(k, label)| Curve::new(*label, Mark::Line, points(k)));
        let curves: Vec<Curve> = curves.filter(|curve| curve.points.len() > 1).collect();
        if curves.is_empty() {
            continue;
        }
        let plot = Plot { title: name.into(), x: Axis::linear(x), y: Axis::linear(y), curves };
        let svg = plot.svg();
        write_atomically(&folder.figures().join(name).with_extension("svg"), svg.as_bytes())?;
        page.figure(&svg, &format!("{y} against {x}"));
    }
    for (name, svg) in pictures(folder)? {
        page.figure(&svg, &name);
    }
    write_atomically(&folder.report(), page.finish().as_bytes())
}

/// Snapshots made during the run, in the order of their names.
fn pictures(folder: &RunFolder) -> Result<BTreeMap<String, String>, Error> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder.figures()).at(&folder.figures())? {
        let path = entry.at(&folder.figures())?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().to_string();
        if !CURVES.iter().any(|curve| curve.0 == name) {
            found.insert(name, std::fs::read_to_string(&path).at(&path)?);
        }
    }
    Ok(found)
}

/// The time series of a run, read back.
pub struct Series {
    /// The columns' names.
    pub columns: Vec<String>,
    /// The rows' cells.
    pub rows: Vec<Vec<String>>,
}

impl Series {
    /// Reads that of a run folder.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let path = folder.series();
        let broken = |error: csv::Error| Error::input(&path, error.to_string());
        let mut reader = csv::Reader::from_path(&path).map_err(broken)?;
        let line = |record: &csv::StringRecord| record.iter().map(str::to_string).collect::<Vec<_>>();
        let columns = line(reader.headers().map_err(broken)?);
        let rows = reader.records().map(|record| record.map(|r| line(&r)).map_err(broken)).collect::<Result<_, _>>()?;
        Ok(Self { columns, rows })
    }

    /// The points of one column against another in one stage, or in all for an empty name.
    pub fn curve(&self, stage: &str, x: &str, y: &str) -> Vec<(f64, f64)> {
        let place = |name: &str| self.columns.iter().position(|column| column == name);
        let (Some(x), Some(y)) = (place(x), place(y)) else { return Vec::new() };
        let of_stage = self.rows.iter().filter(|row| stage.is_empty() || row[0] == stage);
        of_stage.filter_map(|row| Some((row[x].parse().ok()?, row[y].parse().ok()?))).collect()
    }
}
