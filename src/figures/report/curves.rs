//! The curves of a run: graphs of its record.

use crate::case::units::significant;
use crate::figures::graph::{ENERGIES, LEDGER};
use crate::figures::{Axis, Curve, Graph, Mark, Plot};
use crate::output::columns::{self, AT_SURFACES, TIME};
use crate::output::{Column, Event, Series, between};

/// Largest number of marked events of a kind; more would hide the curve.
const MOST_MARKS: usize = 200;

/// Largest number of profiles of a stage in a graph: as many as can be told apart.
const MOST_PROFILES: usize = 5;

/// The plots of these graphs that have curves, and those of every run.
pub(super) fn plots(graphs: &[Graph], series: &Series, events: &[Event]) -> Vec<Plot> {
    let own = graphs.iter().chain(&[LEDGER]).map(|graph| plot(graph, series, events));
    let (x, y) = (Axis::linear(&TIME.to_string()), Axis::linear("change of energy [aJ]"));
    let energies = Plot { title: ENERGIES.into(), x, y, curves: energies(series) };
    own.chain([energies]).filter(|plot| !plot.curves.is_empty()).collect()
}

fn plot(&Graph { name, stages, x, y, marks }: &Graph, series: &Series, events: &[Event]) -> Plot {
    let done = series.stages();
    let these: Vec<&str> = done.into_iter().filter(|name| stages.iter().any(|stage| is_a(name, stage))).collect();
    let label = |stage| if these.len() > 1 { stage } else { "" };
    let of = if stages.is_empty() { &[""][..] } else { &these };
    let curves = of.iter().map(|stage| Curve::new(label(stage), Mark::Line, series.curve(stage, x, y)));
    let mut curves: Vec<Curve> = curves.filter(|curve| curve.points.len() > 1).collect();
    for stage in these.iter().filter(|stage| stages.last().is_some_and(|last| is_a(stage, last))) {
        let marked =
            marks.iter().map(|word| Curve::new(*word, Mark::Points, marked(series, events, stage, word, x, y)));
        curves.extend(marked.filter(|curve| (1..=MOST_MARKS).contains(&curve.points.len())));
    }
    for stage in &these {
        let all = series.profiles(stage, x, y);
        let named = |(time, points)| Curve::new(format!("{} ns", significant(time, 3)), Mark::Line, points);
        curves.extend(spread(all, MOST_PROFILES).into_iter().map(named));
    }
    Plot { title: name.into(), x: Axis::linear(&x.to_string()), y: Axis::linear(&y.to_string()), curves }
}

/// At most `most` elements of a list, evenly spread and the last among them.
fn spread<T>(all: Vec<T>, most: usize) -> Vec<T> {
    let (n, kept) = (all.len(), all.len().min(most));
    let mut next = (1..=kept).map(|k| (k * n).div_ceil(kept) - 1).peekable();
    all.into_iter().enumerate().filter(|(at, _)| next.next_if_eq(at).is_some()).map(|(_, one)| one).collect()
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
    fn profiles_are_spread_over_a_run_and_the_last_is_one_of_them() {
        assert_eq!(spread((1..=12).collect(), 5), [3, 5, 8, 10, 12]);
        assert_eq!(spread(vec![1, 2, 3], 5), [1, 2, 3]);
        assert!(spread(Vec::<u8>::new(), 5).is_empty());
        let columns = ["stage", "step", "time [ns]", "speed", "height"];
        let rows = [
            ["a", "1", "0.5", "0", "1"],
            ["a", "1", "0.5", "3", "2"],
            ["a", "2", "1", "4", "1"],
            ["b", "3", "2", "7", "1"],
        ];
        let rows = rows.map(|row| row.map(String::from).to_vec()).to_vec();
        let table = ReadTable { file: "profiles.csv".into(), columns: columns.map(String::from).to_vec(), rows };
        let column = |name| Column { name, unit: "", about: "" };
        let found = Series { tables: vec![table] }.profiles("a", column("speed"), column("height"));
        assert_eq!(found, [(0.5, vec![(0.0, 1.0), (3.0, 2.0)]), (1.0, vec![(4.0, 1.0)])]);
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
