//! Aggregates that differ only in their seed, under one coating.

use crate::case::quantity::{Quantity, Scaled, Time};
use crate::case::section::defaults;
use crate::case::{Aggregate, Limits, NeckSet, Restructuring, Soot, SootStage, Torsion};
use crate::error::Error;
use crate::observe::statistics::Mean;
use crate::run::Study;
use crate::run::soot::Plan;
use crate::run::soot::watch::{Shape, shape};
use crate::simulation::Simulation;
use rayon::prelude::*;

/// What is done to every aggregate. All else are the authors' published inputs.
#[derive(Clone, Debug)]
pub struct Protocol {
    /// Number of aggregates.
    pub aggregates: u64,
    /// The springs of their necks.
    pub necks: NeckSet,
    /// Time step.
    pub dt: Quantity<Time>,
    /// How long they are watched.
    pub duration: Quantity<Time>,
}

/// How often they are looked at, ns.
pub const LOOK: f64 = 0.5;

/// The members of an ensemble share this.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kind {
    /// Part of the contacts that are necks.
    pub neck_fraction: f64,
    /// How a twist is resisted.
    pub torsion: Torsion,
}

/// What became of the members on average: at the beginning, and after every [`LOOK`].
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// What they share.
    pub kind: Kind,
    /// Coordination number.
    pub coordination: Vec<Mean>,
    /// Convexity.
    pub convexity: Vec<Mean>,
}

/// One ensemble of each kind; the aggregates of all are the same, and each runs on one core.
pub fn ensembles(protocol: &Protocol, kinds: &[Kind]) -> Result<Vec<Ensemble>, Error> {
    let seeds = 1..=protocol.aggregates;
    let members: Vec<(Kind, u64)> =
        kinds.iter().flat_map(|&kind| seeds.clone().map(move |seed| (kind, seed))).collect();
    let courses: Vec<Vec<Shape>> = members
        .into_par_iter()
        .with_max_len(1)
        .map(|(kind, seed)| course(&plan(protocol, kind, seed)))
        .collect::<Result<_, Error>>()?;
    let of_a_kind = courses.chunks(protocol.aggregates as usize);
    Ok(kinds.iter().zip(of_a_kind).map(|(&kind, courses)| Ensemble::of(kind, courses)).collect())
}

fn plan(protocol: &Protocol, kind: Kind, seed: u64) -> Plan {
    Plan {
        seed,
        max_overlap: defaults::<Limits>().overlap,
        soot: Soot { necks: protocol.necks, torsion: kind.torsion, ..defaults() },
        sample: Aggregate { neck_fraction: kind.neck_fraction, ..defaults() },
        stages: vec![SootStage::Restructuring(Restructuring {
            duration: Scaled::Absolute(protocol.duration.clone()),
            dt: protocol.dt.clone(),
            ..defaults()
        })],
    }
}

/// The shape of one aggregate, at the beginning and after every [`LOOK`].
fn course(plan: &Plan) -> Result<Vec<Shape>, Error> {
    let system = plan.initial()?;
    let settings = plan.settings(0, &system);
    let mut simulation = Simulation::new(plan.model(0), system, settings)?;
    let every = (LOOK / settings.dt).round() as u64;
    let mut course = vec![shape(simulation.system())];
    for _ in 0..plan.steps(0, settings.dt) / every {
        for _ in 0..every {
            simulation.step()?;
        }
        course.push(shape(simulation.system()));
    }
    Ok(course)
}

impl Ensemble {
    fn of(kind: Kind, courses: &[Vec<Shape>]) -> Self {
        let looks = courses.iter().map(Vec::len).min().unwrap_or(0);
        let mean = |of: usize| {
            let at = |look: usize| Mean::of(&courses.iter().map(|course| course[look][of]).collect::<Vec<_>>());
            (0..looks).map(at).collect()
        };
        Self { kind, coordination: mean(0), convexity: mean(1) }
    }
}

/// The mean at the end.
pub fn terminal(means: &[Mean]) -> Mean {
    *means.last().expect("an ensemble is looked at before its first step")
}

/// Time after which no less than 95 % of the change are done, ns.
pub fn settled(means: &[Mean]) -> f64 {
    let (first, last) = (means[0].value, terminal(means).value);
    let under_way = |mean: &Mean| (last - mean.value).abs() > 0.05 * (last - first).abs();
    means.iter().rposition(under_way).map_or(0.0, |look| (look + 1) as f64 * LOOK)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let time = |text: &str| Quantity::parse(text).expect("a time");
        let protocol = Protocol { aggregates: 2, necks: NeckSet::S, dt: time("50 fs"), duration: time("1 ns") };
        let kind = |neck_fraction| Kind { neck_fraction, torsion: Torsion::Spring };
        let found = ensembles(&protocol, &[kind(0.0), kind(1.0)]).expect("a stable step");
        let first = |k: usize| found[k].coordination[0];
        assert_eq!(found[0].coordination.len(), 3);
        assert_eq!(first(0), first(1));
        assert!((298.0 / 150.0..2.1).contains(&first(0).value), "a tree, and some near misses");
        assert!(terminal(&found[0].coordination).value > first(0).value);
    }
}
