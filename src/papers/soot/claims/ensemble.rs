//! Ensembles of aggregates that differ only in their seed, under a coating.

use crate::error::Error;
use crate::observe::statistics::Mean;
use crate::output::aggregate::{CONVEXITY, COORDINATION, FRACTAL_DIMENSION};
use crate::output::columns::TIME;
use crate::output::{Finding, RunFolder, Series};
use crate::papers::soot::case::Torsion;
use crate::reproduce::Setting;
use crate::run::Reader;
use crate::run::sweep::{Point, set};
use serde_yaml::Value;
use std::path::Path;

/// The case from which all members are derived.
const CASE: &str = include_str!("../../../../cases/soot/restructuring.yaml");
const FILE: &str = "cases/soot/restructuring.yaml";

/// The protocol of every aggregate.
#[derive(Clone, Copy, Debug)]
pub struct Protocol<'a> {
    /// Number of aggregates.
    pub aggregates: u64,
    /// Keys that differ from the case, with their values.
    pub keys: &'a [(&'a str, &'a str)],
}

/// The keys of reduced protocols: necks of set S, which are stable at longer time steps.
pub const COARSE: &[(&str, &str)] = &[
    ("model.soot.necks", "S"),
    ("experiment.restructuring.dt", "40 fs"),
    ("experiment.restructuring.attraction_every", "1"),
];

/// Interval between measurements, ns.
pub const LOOK: f64 = 0.5;

/// The parameters shared by the members of an ensemble.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kind {
    /// Fraction of the contacts that are necks.
    pub neck_fraction: f64,
    /// Resistance to torsion.
    pub torsion: Torsion,
}

/// Averages over the members, at the beginning and after every [`LOOK`].
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// The shared parameters.
    pub kind: Kind,
    /// Number of members.
    pub members: usize,
    /// Coordination number.
    pub coordination: Vec<Mean>,
    /// Convexity.
    pub convexity: Vec<Mean>,
    /// Relative increase of the coordination number from beginning to end.
    pub rise: Mean,
    /// Fractal dimension at the beginning and at the end.
    pub dimension: [Mean; 2],
}

/// One ensemble of each kind, with the same aggregates in all. If stopped, it returns the ensembles of those
/// aggregates of which all kinds have finished, at least two.
///
/// # Errors
///
/// If a run fails.
pub fn ensembles(protocol: &Protocol, kinds: &[Kind], setting: &Setting) -> Result<Vec<Ensemble>, Error> {
    let keys: Vec<_> = kinds.iter().map(keys).collect();
    let runs = setting.run_all(&points(protocol, &keys, setting.read)?)?;
    let courses = runs.folders.iter().map(|folder| folder.as_ref().map(course).transpose());
    let courses: Vec<Option<Course>> = courses.collect::<Result<_, Error>>()?;
    let whole: Vec<&[Option<Course>]> =
        courses.chunks(kinds.len()).filter(|kinds| kinds.iter().all(Option::is_some)).collect();
    if runs.stopped && whole.len() < 2 {
        return Err(Error::Stopped(None));
    }
    let of_kind = |k: usize| whole.iter().filter_map(|kinds| kinds[k].as_ref()).collect::<Vec<_>>();
    Ok(kinds.iter().enumerate().map(|(k, &kind)| Ensemble::of(kind, &of_kind(k))).collect())
}

/// The keys of a kind.
fn keys(kind: &Kind) -> Vec<(&'static str, String)> {
    vec![
        ("sample.aggregate.neck_fraction", kind.neck_fraction.to_string()),
        ("model.soot.torsion", kind.torsion.to_string()),
    ]
}

/// All kinds of the first aggregate, then of the next, so that a stopped computation has complete sets.
///
/// # Errors
///
/// If a key or value is wrong.
pub fn points(protocol: &Protocol, kinds: &[Vec<(&str, String)>], read: Reader) -> Result<Vec<Point>, Error> {
    let mut base: Value = serde_yaml::from_str(CASE).expect("the case is well formed");
    let look = format!("{LOOK} ns");
    let output = [("output.series", &*look), ("output.frames", "1 µs")];
    for (key, value) in output.into_iter().chain(protocol.keys.iter().copied()) {
        set(&mut base, key, value, read)?;
    }
    let seeds = (1..=protocol.aggregates).map(|seed| seed.to_string());
    let members = seeds.flat_map(|seed| kinds.iter().map(move |kind| (seed.clone(), kind)));
    members
        .map(|(seed, kind)| {
            let own = kind.iter().map(|(key, value)| (*key, &**value));
            let keys: Vec<(&str, &str)> = [("seed", &*seed)].into_iter().chain(own).collect();
            Point::new(Path::new(FILE), &base, &keys, read)
        })
        .collect()
}

/// Coordination number and convexity of one aggregate, and its fractal dimension at the beginning and at the end.
struct Course {
    series: [Vec<f64>; 2],
    dimension: [f64; 2],
}

/// The record of a run.
fn course(folder: &RunFolder) -> Result<Course, Error> {
    let (series, findings) = (Series::read(folder)?, Finding::of_run(folder)?);
    let column = |column| series.curve("", TIME, column).into_iter().map(|point| point.1).collect();
    let dimension = |when: &str| {
        let name = format!("{when} {}", FRACTAL_DIMENSION.name);
        findings.iter().find(|finding| finding.name == name).and_then(Finding::value).unwrap_or(f64::NAN)
    };
    Ok(Course { series: [COORDINATION, CONVEXITY].map(column), dimension: ["initial", "final"].map(dimension) })
}

impl Ensemble {
    fn of(kind: Kind, courses: &[&Course]) -> Self {
        let looks = courses.iter().map(|course| course.series[0].len()).min().unwrap_or(0);
        let mean = |of: usize| {
            let at = |look: usize| Mean::of(&courses.iter().map(|course| course.series[of][look]).collect::<Vec<_>>());
            (0..looks).map(at).collect()
        };
        let rises = courses
            .iter()
            .map(|Course { series: [coordination, _], .. }| coordination[looks - 1] / coordination[0] - 1.0);
        let rise = Mean::of(&rises.collect::<Vec<_>>());
        let dimension =
            [0, 1].map(|when| Mean::of(&courses.iter().map(|course| course.dimension[when]).collect::<Vec<_>>()));
        Self { kind, members: courses.len(), coordination: mean(0), convexity: mean(1), rise, dimension }
    }
}

/// The mean at the end.
///
/// # Panics
///
/// If there are no means.
pub fn terminal(means: &[Mean]) -> Mean {
    *means.last().expect("an ensemble is measured before its first step")
}

/// Time after which at least 95 % of the change have occurred, ns.
pub fn settled(means: &[Mean]) -> f64 {
    let (first, last) = (means[0].value, terminal(means).value);
    let under_way = |mean: &Mean| (last - mean.value).abs() > 0.05 * (last - first).abs();
    means.iter().rposition(under_way).map_or(0.0, |look| (look + 1) as f64 * LOOK)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interrupt::Interrupt;
    use crate::papers::AnyPaper;
    use crate::papers::soot::Soot;
    use crate::reproduce::Extent;

    #[test]
    fn a_change_is_settled_when_it_is_within_a_twentieth_of_its_end_for_good() {
        let course = |values: &[f64]| values.iter().map(|&value| Mean { value, margin: 0.0 }).collect::<Vec<_>>();
        assert_eq!(settled(&course(&[1.0, 1.96, 1.5, 1.96, 2.0])), 3.0 * LOOK);
        assert_eq!(settled(&course(&[1.0, 1.0])), 0.0);
        assert_eq!(settled(&course(&[2.0, 0.0])), LOOK);
        assert_eq!(settled(&course(&[1.0])), 0.0);
    }

    #[test]
    fn a_coating_brings_the_same_aggregates_together_in_every_ensemble() {
        let keys = [
            ("model.soot.necks", "S"),
            ("experiment.restructuring.dt", "50 fs"),
            ("experiment.restructuring.duration", "1 ns"),
        ];
        let protocol = Protocol { aggregates: 2, keys: &keys };
        let place = tempfile::tempdir().expect("a place");
        let setting = Setting {
            extent: Extent::Reduced,
            runs: place.path().join("runs"),
            read: &|file, text| Soot.read(file, text),
            interrupt: &Interrupt::default(),
            tell: &|_| {},
        };
        let kind = |neck_fraction| Kind { neck_fraction, torsion: Torsion::Spring };
        let found = || ensembles(&protocol, &[kind(0.0), kind(1.0)], &setting).expect("a stable step");
        let (found, again) = (found(), found());
        let first = |k: usize| found[k].coordination[0];
        assert_eq!((found[0].members, found[0].coordination.len()), (2, 3));
        assert_eq!(first(0), first(1));
        assert!((298.0 / 150.0..2.1).contains(&first(0).value), "a tree, and some near misses");
        assert!(terminal(&found[0].coordination).value > first(0).value);
        assert_eq!(found[0].convexity, again[0].convexity);
        let [fresh, coated] = found[0].dimension;
        assert!((1.5..2.1).contains(&fresh.value) && coated.value != fresh.value, "{fresh} {coated}");
    }
}
