//! The pictures of a run and the page that shows them.

use super::soot::watch::AT_SURFACES;
use crate::case::Case;
use crate::error::{AtPath, Error};
use crate::figures::{Axis, Curve, Mark, Plot, Report, snapshot};
use crate::output::{Finding, RunFolder, read, write_atomically};
use crate::system::System;
use serde::Deserialize;
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

/// Events that are marked where they happened on curves of one of these quantities, by a word of theirs.
const MARKED: [&str; 4] = ["sliding", "rolling", "detachment", "breaks"];
const MARKED_ON: [&str; 3] = ["pulling force [pN]", "force on the tip [pN]", "pull on the tip [pN]"];
/// More events of a kind would hide the curve.
const MOST_MARKS: usize = 200;
/// What the energies of all causes are drawn together as.
const ENERGIES: &str = "energies";

/// Makes figures and report of a finished run from what it has recorded.
pub fn report(case: &Case, folder: &RunFolder, findings: &[Finding]) -> Result<(), Error> {
    let mut page = Report::new(&case.title);
    let rows: Vec<[String; 4]> =
        findings.iter().map(|f| [f.name.clone(), f.value.clone(), f.unit.clone(), f.target.clone()]).collect();
    page.table(&["quantity", "value", "unit", "target"], &rows);
    let (series, events) = (Series::read(folder)?, Event::all(folder)?);
    let done = series.stages();
    for (name, stages, x, y) in CURVES {
        let these: Vec<&str> =
            done.iter().copied().filter(|name| stages.iter().any(|stage| is_a(name, stage))).collect();
        let label = |stage| if these.len() > 1 { stage } else { "" };
        let of = if stages.is_empty() { &[""][..] } else { &these };
        let curves = of.iter().map(|stage| Curve::new(label(stage), Mark::Line, series.curve(stage, x, y)));
        let mut curves: Vec<Curve> = curves.filter(|curve| curve.points.len() > 1).collect();
        for stage in
            these.iter().filter(|stage| MARKED_ON.contains(&y) && stages.last().is_some_and(|last| is_a(stage, last)))
        {
            let marked = MARKED.map(|word| Curve::new(word, Mark::Points, series.marked(&events, stage, word, x, y)));
            curves.extend(marked.into_iter().filter(|curve| (1..=MOST_MARKS).contains(&curve.points.len())));
        }
        draw(folder, &mut page, name, Plot { title: name.into(), x: Axis::linear(x), y: Axis::linear(y), curves })?;
    }
    let (x, y) = (Axis::linear(TIME), Axis::linear("change of energy [aJ]"));
    draw(folder, &mut page, ENERGIES, Plot { title: ENERGIES.into(), x, y, curves: series.energies() })?;
    for (name, svg) in pictures(folder)? {
        page.figure(&svg, &name);
    }
    write_atomically(&folder.report(), page.finish().as_bytes())
}

fn draw(folder: &RunFolder, page: &mut Report, name: &str, plot: Plot) -> Result<(), Error> {
    if plot.curves.is_empty() {
        return Ok(());
    }
    let svg = plot.svg();
    write_atomically(&folder.figures().join(name).with_extension("svg"), svg.as_bytes())?;
    page.figure(&svg, &format!("{} against {}", plot.y.label, plot.x.label));
    Ok(())
}

/// Snapshots made during the run, in the order of their names.
fn pictures(folder: &RunFolder) -> Result<BTreeMap<String, String>, Error> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder.figures()).at(&folder.figures())? {
        let path = entry.at(&folder.figures())?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().to_string();
        if name != ENERGIES && !CURVES.iter().any(|curve| curve.0 == name) {
            found.insert(name, std::fs::read_to_string(&path).at(&path)?);
        }
    }
    Ok(found)
}

/// Something that happened in a run.
#[derive(Deserialize)]
pub struct Event {
    /// The stage.
    pub stage: String,
    /// When, ns.
    pub time_ns: f64,
    /// What.
    pub event: String,
}

impl Event {
    /// All that a run has written down.
    pub fn all(folder: &RunFolder) -> Result<Vec<Self>, Error> {
        let path = folder.events();
        let lines = read(&path)?;
        let lines = lines.split(|&byte| byte == b'\n').filter(|line| !line.is_empty());
        lines.map(|line| serde_json::from_slice(line).map_err(|error| Error::input(&path, error.to_string()))).collect()
    }
}

/// Whether the name of a stage is that of a kind of stages, or the same with a number.
fn is_a(name: &str, kind: &str) -> bool {
    name.strip_prefix(kind).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
}

const TIME: &str = "time [ns]";

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

    /// Where the events with a word were on the curve of a stage.
    fn marked(&self, events: &[Event], stage: &str, word: &str, x: &str, y: &str) -> Vec<(f64, f64)> {
        let [x, y] = [x, y].map(|column| self.curve(stage, TIME, column));
        let these = events.iter().filter(|event| event.stage == stage && event.event.contains(word));
        these.filter_map(|event| Some((between(&x, event.time_ns)?, between(&y, event.time_ns)?))).collect()
    }

    /// The stages, in their order.
    fn stages(&self) -> Vec<&str> {
        let mut stages: Vec<&str> = self.rows.iter().map(|row| &*row[0]).collect();
        stages.dedup();
        stages
    }

    /// How the energies of all causes, and all that was lost, have changed since the beginning, aJ against time; without what is too little to be seen.
    fn energies(&self) -> Vec<Curve> {
        let change = |column: &str| -> Vec<(f64, f64)> {
            let points = self.curve("", TIME, column);
            points.iter().map(|point| (point.0, 1e-3 * (point.1 - points[0].1))).collect()
        };
        let cause =
            |column| str::strip_suffix(column, " energy [zJ]").or((column == AT_SURFACES).then_some("at surfaces"));
        let held = |column| Some((cause(column)?, change(column)));
        let mut curves: Vec<(&str, Vec<(f64, f64)>)> = self.columns.iter().filter_map(|column| held(column)).collect();
        curves.push(("lost", self.lost()));
        let size = |points: &[(f64, f64)]| points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
        let largest = curves.iter().map(|curve| size(&curve.1)).fold(0.0, f64::max);
        let seen = curves.into_iter().filter(|curve| largest > 0.0 && size(&curve.1) > 0.01 * largest);
        seen.map(|(name, points)| Curve::new(name, Mark::Line, points)).collect()
    }

    /// All that was lost, aJ against time: the account of every stage begins with nothing.
    fn lost(&self) -> Vec<(f64, f64)> {
        let causes = self.columns.iter().filter(|column| column.starts_with("lost "));
        let mut before = 0.0;
        let mut points = Vec::new();
        for stage in self.stages() {
            let sums = causes.clone().map(|column| self.curve(stage, TIME, column)).reduce(|sums, points| {
                sums.into_iter().zip(points).map(|((time, sum), (_, lost))| (time, sum + lost)).collect()
            });
            points.extend(sums.unwrap_or_default().into_iter().map(|(time, lost)| (time, before + 1e-3 * lost)));
            before = points.last().map_or(0.0, |&(_, lost)| lost);
        }
        points
    }

    /// The points of one column against another in one stage, or in all for an empty name.
    pub fn curve(&self, stage: &str, x: &str, y: &str) -> Vec<(f64, f64)> {
        let place = |name: &str| self.columns.iter().position(|column| column == name);
        let (Some(x), Some(y)) = (place(x), place(y)) else { return Vec::new() };
        let of_stage = self.rows.iter().filter(|row| stage.is_empty() || row[0] == stage);
        of_stage.filter_map(|row| Some((row[x].parse().ok()?, row[y].parse().ok()?))).collect()
    }
}

/// A curve at a place, between its points.
pub fn between(curve: &[(f64, f64)], x: f64) -> Option<f64> {
    let mut ends = curve.windows(2).map(|ends| (ends[0], ends[1]));
    let ((a, f), (b, g)) = ends.find(|(p, q)| p.0 <= x && x <= q.0 && p.0 < q.0)?;
    Some(f + (g - f) * (x - a) / (b - a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_lost_adds_up_over_stages_and_each_keeps_its_own_curves() {
        let columns = ["stage", TIME, "lost to drag [zJ]", "lost at surfaces [zJ]", AT_SURFACES, "spin energy [zJ]"];
        let rows = [
            ["pulling", "0", "0", "0", "-1000", "5000"],
            ["pulling", "1", "1000", "2000", "-3000", "0"],
            ["pulling 2", "1", "0", "0", "-3000", "0"],
            ["pulling 2", "2", "500", "0", "-3000", "0"],
        ];
        let rows = rows.map(|row| row.map(String::from).to_vec()).to_vec();
        let series = Series { columns: columns.map(String::from).to_vec(), rows };
        assert_eq!(series.stages(), ["pulling", "pulling 2"]);
        let curves = series.energies().into_iter().map(|curve| (curve.label, curve.points[3].1));
        assert_eq!(
            curves.collect::<Vec<_>>(),
            [("at surfaces".into(), -2.0), ("spin".into(), -5.0), ("lost".into(), 3.5)]
        );
        assert!(is_a("pulling 2", "pulling") && !is_a("pulling up", "pull"));
    }
}
