//! The report of a run: its findings, graphs of its record, and its pictures.

use super::graph::{ENERGIES, LEDGER, graph_names};
use super::{Axis, Curve, Graph, Mark, Plot, Report};
use crate::error::{AtPath, Error};
use crate::output::columns::{self, AT_SURFACES, TIME};
use crate::output::{Column, Event, Finding, RunFolder, Series, between, with_suffix, write_atomically};

/// Largest number of marked events of a kind; more would hide the curve.
const MOST_MARKS: usize = 200;

/// Creates figures and report of a finished run from its record.
///
/// # Errors
///
/// If the record cannot be read, or figures and report cannot be written.
pub fn report(title: &str, graphs: &[Graph], folder: &RunFolder, findings: &[Finding]) -> Result<(), Error> {
    let mut page = Report::new(title);
    let rows: Vec<[String; 4]> =
        findings.iter().map(|f| [f.name.clone(), f.text(), f.unit.clone(), f.target_text()]).collect();
    page.table(&["quantity", "value", "unit", "target"], &rows);
    let (series, events) = (Series::read(folder)?, Event::all(folder)?);
    let done = series.stages();
    for &Graph { name, stages, x, y, marks } in graphs.iter().chain(&[LEDGER]) {
        let these: Vec<&str> =
            done.iter().copied().filter(|name| stages.iter().any(|stage| is_a(name, stage))).collect();
        let label = |stage| if these.len() > 1 { stage } else { "" };
        let of = if stages.is_empty() { &[""][..] } else { &these };
        let curves = of.iter().map(|stage| Curve::new(label(stage), Mark::Line, series.curve(stage, x, y)));
        let mut curves: Vec<Curve> = curves.filter(|curve| curve.points.len() > 1).collect();
        for stage in these.iter().filter(|stage| stages.last().is_some_and(|last| is_a(stage, last))) {
            let marked =
                marks.iter().map(|word| Curve::new(*word, Mark::Points, marked(&series, &events, stage, word, x, y)));
            curves.extend(marked.filter(|curve| (1..=MOST_MARKS).contains(&curve.points.len())));
        }
        let (x, y) = (Axis::linear(&x.to_string()), Axis::linear(&y.to_string()));
        draw(folder, &mut page, name, Plot { title: name.into(), x, y, curves })?;
    }
    let (x, y) = (Axis::linear(&TIME.to_string()), Axis::linear("change of energy [aJ]"));
    draw(folder, &mut page, ENERGIES, Plot { title: ENERGIES.into(), x, y, curves: energies(&series) })?;
    for (name, svg) in pictures(folder, graphs, &done)? {
        page.figure(&svg, &name);
    }
    write_atomically(&folder.report(), page.finish().as_bytes())
}

fn draw(folder: &RunFolder, page: &mut Report, name: &str, plot: Plot) -> Result<(), Error> {
    if plot.curves.is_empty() {
        return Ok(());
    }
    let svg = plot.svg();
    write_atomically(&with_suffix(folder.figures().join(name), "svg"), svg.as_bytes())?;
    page.figure(&svg, &format!("{} against {}", plot.y.label, plot.x.label));
    Ok(())
}

/// Snapshots taken during the run, in the order of time.
fn pictures(folder: &RunFolder, graphs: &[Graph], stages: &[&str]) -> Result<Vec<(String, String)>, Error> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder.figures()).at(&folder.figures())? {
        let path = entry.at(&folder.figures())?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().to_string();
        if graph_names(graphs).all(|graph| graph != name) {
            found.push((name, std::fs::read_to_string(&path).at(&path)?));
        }
    }
    found.sort_by_cached_key(|(name, _)| (moment(name, stages), name.clone()));
    Ok(found)
}

/// The place of a picture in time: its stage, and the part of the stage after which it was taken.
fn moment(name: &str, stages: &[&str]) -> Option<(usize, usize)> {
    stages.iter().enumerate().find_map(|(number, stage)| {
        let part = match name.strip_prefix(stage)?.strip_prefix(' ')? {
            "begin" => 0,
            "end" => usize::MAX,
            part => part.strip_prefix("after ")?.split(' ').next()?.parse().ok()?,
        };
        Some((number, part))
    })
}

/// Whether the name of a stage is `kind`, with or without a number.
fn is_a(name: &str, kind: &str) -> bool {
    name.strip_prefix(kind).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
}

/// Positions of the events with a word on the curve of a stage.
fn marked(series: &Series, events: &[Event], stage: &str, word: &str, x: Column, y: Column) -> Vec<(f64, f64)> {
    let [x, y] = [x, y].map(|column| series.curve(stage, TIME, column));
    let these = events.iter().filter(|event| event.stage == stage && event.event.contains(word));
    these.filter_map(|event| Some((between(&x, event.time_ns)?, between(&y, event.time_ns)?))).collect()
}

/// Changes of the energies of all causes, and of the dissipated energy, since the beginning, aJ against time; negligible ones are omitted.
fn energies(series: &Series) -> Vec<Curve> {
    let change = |column: &str| -> Vec<(f64, f64)> {
        let points = series.curve_of("", &TIME.to_string(), column);
        points.iter().map(|point| (point.0, 1e-3 * (point.1 - points[0].1))).collect()
    };
    let at_surfaces = AT_SURFACES.to_string();
    let cause = |column| columns::cause_of_stored(column).or((column == at_surfaces).then_some("at surfaces"));
    let held = |column| Some((cause(column)?, change(column)));
    let mut curves: Vec<(&str, Vec<(f64, f64)>)> =
        series.tables[0].columns.iter().filter_map(|column| held(column)).collect();
    curves.push(("lost", lost(series)));
    let size = |points: &[(f64, f64)]| points.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
    let largest = curves.iter().map(|curve| size(&curve.1)).fold(0.0, f64::max);
    let seen = curves.into_iter().filter(|curve| largest > 0.0 && size(&curve.1) > 0.01 * largest);
    seen.map(|(name, points)| Curve::new(name, Mark::Line, points)).collect()
}

/// The dissipated energy, aJ against time, summed over stages, each of which starts from zero.
fn lost(series: &Series) -> Vec<(f64, f64)> {
    let causes = series.tables[0].columns.iter().filter(|column| columns::is_lost(column));
    let mut before = 0.0;
    let mut points = Vec::new();
    for stage in series.stages() {
        let sums =
            causes.clone().map(|column| series.curve_of(stage, &TIME.to_string(), column)).reduce(|sums, points| {
                sums.into_iter().zip(points).map(|((time, sum), (_, lost))| (time, sum + lost)).collect()
            });
        points.extend(sums.unwrap_or_default().into_iter().map(|(time, lost)| (time, before + 1e-3 * lost)));
        before = points.last().map_or(0.0, |&(_, lost)| lost);
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::ReadTable;

    #[test]
    fn pictures_follow_each_other_in_time() {
        let stages = ["relaxation", "pulling", "pulling 2"];
        let in_time = [
            "relaxation begin",
            "relaxation end",
            "pulling begin",
            "pulling after 2 of 12 parts",
            "pulling after 10 of 12 parts",
            "pulling end",
            "pulling 2 begin",
        ];
        assert!(in_time.is_sorted_by_key(|name| moment(name, &stages).expect("a picture of a stage")));
        assert_eq!(moment("mine", &stages), None);
    }

    #[test]
    fn what_is_lost_adds_up_over_stages_and_each_keeps_its_own_curves() {
        let columns = [
            "stage",
            "time [ns]",
            "lost to drag [zJ]",
            "lost at surfaces [zJ]",
            "energy at surfaces [zJ]",
            "spin energy [zJ]",
        ];
        let rows = [
            ["pulling", "0", "0", "0", "-1000", "5000"],
            ["pulling", "1", "1000", "2000", "-3000", "0"],
            ["pulling 2", "1", "0", "0", "-3000", "0"],
            ["pulling 2", "2", "500", "0", "-3000", "0"],
        ];
        let rows = rows.map(|row| row.map(String::from).to_vec()).to_vec();
        let file = "series.csv".into();
        let series = Series { tables: vec![ReadTable { file, columns: columns.map(String::from).to_vec(), rows }] };
        assert_eq!(series.stages(), ["pulling", "pulling 2"]);
        let curves = energies(&series).into_iter().map(|curve| (curve.label, curve.points[3].1));
        assert_eq!(
            curves.collect::<Vec<_>>(),
            [("at surfaces".into(), -2.0), ("spin".into(), -5.0), ("lost".into(), 3.5)]
        );
        assert!(is_a("pulling 2", "pulling") && !is_a("pulling up", "pull"));
    }
}
