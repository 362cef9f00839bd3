//! The report of a sweep: its runs, and its results against the swept keys.

use super::Point;
use super::axis::Axis;
use super::summary::Summary;
use crate::case::units::{number_and_unit, shifted, unit};
use crate::error::Error;
use crate::figures::{self, Cell, Curve, Mark, Plot, Report};
use crate::output::{Finding, RunFolder, write_atomically};
use std::path::Path;

/// Most plots of a page.
const MOST_PLOTS: usize = 24;

/// Writes the page into the folder of the sweep.
pub(super) fn report(title: &str, axes: &[Axis], points: &[Point], out: &Path, summary: &Summary) -> Result<(), Error> {
    let findings: Vec<Vec<Finding>> =
        points.iter().map(|point| Finding::of_run(&RunFolder::at(&out.join(&point.name)))).collect::<Result<_, _>>()?;
    let mut page = Report::new(title);
    page.verdict(&verdict(axes, points, &findings));
    let plots = plots(axes, points, &findings);
    if !plots.is_empty() {
        page.heading("Results against keys");
        page.grid(|page| {
            plots.iter().take(MOST_PLOTS).for_each(|plot| {
                page.figure(&plot.svg(), &format!("{} against {}", plot.y.label, plot.x.label));
            });
        });
        if plots.len() > MOST_PLOTS {
            page.note(&format!("{} of {} plots; all results are in summary.csv.", MOST_PLOTS, plots.len()));
        }
    }
    page.heading("Runs");
    let results = columns(&findings);
    let mut head: Vec<&str> = axes.iter().map(|axis| &*axis.key).collect();
    head.push("status");
    head.extend(results.iter().map(String::as_str));
    let row = |(point, found): (&Point, &Vec<Finding>)| -> Vec<Cell> {
        let row = summary.row(&point.name);
        let status = row.map_or(String::new(), |row| row.status.clone());
        let reason = row.map_or("", |row| &*row.reason);
        let status = if reason.is_empty() { status } else { format!("{status}: {reason}") };
        let page = format!("{}/report.html", point.name);
        let status = if out.join(&page).exists() { Cell::link(status, &page) } else { status.into() };
        let of = |header: &String| {
            found.iter().find(|finding| finding.header() == *header).map_or(String::new(), Finding::text)
        };
        let keys = point.values.iter().cloned().map(Cell::from);
        keys.chain([status]).chain(results.iter().map(of).map(Cell::from)).collect()
    };
    page.table(&head, points.iter().zip(&findings).map(row));
    page.heading("Files");
    page.files([("summary.csv", "all runs of all sweeps into this folder, with their keys, status and results")]);
    page.made_by(&[crate::output::command_line()]);
    write_atomically(&out.join("report.html"), page.finish().as_bytes())
}

fn verdict(axes: &[Axis], points: &[Point], findings: &[Vec<Finding>]) -> String {
    let keys: Vec<String> = axes.iter().map(|axis| format!("{} ({} values)", axis.key, axis.values.len())).collect();
    let done = findings.iter().filter(|found| !found.is_empty()).count();
    format!("{done} of {} runs have finished; varied: {}.", points.len(), keys.join(", "))
}

/// The names and units of all results, in their order.
fn columns(findings: &[Vec<Finding>]) -> Vec<String> {
    let mut columns = Vec::new();
    for header in findings.iter().flatten().map(Finding::header) {
        if !columns.contains(&header) {
            columns.push(header);
        }
    }
    columns
}

/// Every result that is a number against the first key that has several numbers, with a curve for each combination of the others.
fn plots(axes: &[Axis], points: &[Point], findings: &[Vec<Finding>]) -> Vec<Plot> {
    let Some((key, name, numbers)) = axes.iter().enumerate().find_map(|(k, axis)| {
        let (name, numbers) = numbers(axis)?;
        Some((k, name, numbers))
    }) else {
        return Vec::new();
    };
    let place = |point: &Point| {
        let value = axes[key].values.iter().position(|value| *value == point.values[key])?;
        Some(numbers[value])
    };
    let others = |point: &Point| {
        let others =
            axes.iter().zip(&point.values).enumerate().filter(|(k, (axis, _))| *k != key && axis.values.len() > 1);
        others.map(|(_, (axis, value))| format!("{} = {value}", axis.key)).collect::<Vec<_>>().join(", ")
    };
    let mut plots = Vec::new();
    for header in columns(findings) {
        let mut curves: Vec<Curve> = Vec::new();
        for (point, found) in points.iter().zip(findings) {
            let value = found.iter().find(|finding| finding.header() == header).and_then(Finding::value);
            let (Some(x), Some(y)) = (place(point), value) else { continue };
            let label = others(point);
            match curves.iter_mut().find(|curve| curve.label == label) {
                Some(curve) => curve.points.push((x, y)),
                None => curves.push(Curve::new(label, Mark::Dots, vec![(x, y)])),
            }
        }
        curves.iter_mut().for_each(|curve| curve.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
        if curves.iter().any(|curve| curve.points.len() > 1) {
            let title = header.split(" [").next().unwrap_or_default().into();
            let (x, y) = (figures::Axis::linear(&name), figures::Axis::linear(&header));
            plots.push(Plot { title, x, y, curves });
        }
    }
    plots
}

/// The name of a key with the unit of its first value, and its values in this unit, if there are several and all are numbers.
fn numbers(axis: &Axis) -> Option<(String, Vec<f64>)> {
    let parts: Vec<(&str, &str)> = axis.values.iter().map(|value| number_and_unit(value)).collect::<Option<_>>()?;
    let (_, common) = *parts.first().filter(|_| parts.len() > 1)?;
    let power = |text: &str| if text.is_empty() { Some(0) } else { unit(text).map(|unit| unit.1) };
    let base = power(common)?;
    let numbers =
        parts.iter().map(|(number, unit)| Some(shifted(number, power(unit)? - base)).filter(|x| x.is_finite()));
    let name = if common.is_empty() { axis.key.clone() } else { format!("{} [{common}]", axis.key) };
    Some((name, numbers.collect::<Option<_>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::Column;

    fn axis(key: &str, values: &[&str]) -> Axis {
        Axis { key: key.into(), values: values.iter().map(|value| value.to_string()).collect() }
    }

    #[test]
    fn values_in_different_units_stand_on_one_axis() {
        assert_eq!(numbers(&axis("dt", &["1 ps", "2 ps", "0.5 ns"])), Some(("dt [ps]".into(), vec![1.0, 2.0, 500.0])));
        assert_eq!(numbers(&axis("seed", &["1", "2"])), Some(("seed".into(), vec![1.0, 2.0])));
        assert!(numbers(&axis("necks", &["S", "M"])).is_none() && numbers(&axis("seed", &["1"])).is_none());
    }

    #[test]
    fn results_stand_against_the_first_number_with_a_curve_for_each_other_value() {
        let axes = [axis("necks", &["S", "M"]), axis("dt", &["2 ps", "1 ps"])];
        let mut points = Vec::new();
        for values in [["S", "2 ps"], ["S", "1 ps"], ["M", "2 ps"], ["M", "1 ps"]] {
            let values = values.map(String::from).to_vec();
            points.push(Point {
                name: values.join(","),
                values,
                file: "a".into(),
                text: String::new(),
                saves: vec![],
                resolved: String::new(),
            });
        }
        let result = |name, unit| Column { name, unit, about: "" };
        let found =
            |force| vec![Finding::number(result("force", "pN"), force), Finding::words(result("fate", ""), "cut")];
        let found = [3.0, 4.0, 5.0].map(found);
        let findings: Vec<_> = found.into_iter().chain([Vec::new()]).collect();
        let plots = plots(&axes, &points, &findings);
        assert_eq!((plots.len(), &*plots[0].x.label, &*plots[0].y.label), (1, "dt [ps]", "force [pN]"));
        let curves: Vec<_> = plots[0].curves.iter().map(|curve| (&*curve.label, &*curve.points)).collect();
        assert_eq!(curves, [("necks = S", &[(1.0, 4.0), (2.0, 3.0)][..]), ("necks = M", &[(2.0, 5.0)])]);
    }
}
