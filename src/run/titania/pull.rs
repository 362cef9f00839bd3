//! An agglomerate stretched without a run folder.

use super::stage::Act;
use super::{Plan, Study};
use crate::case::Case;
use crate::error::Error;
use crate::run::study::run_stage;

/// What comes out of an agglomerate that is stretched.
#[derive(Clone, Debug, Default)]
pub struct Pull {
    /// How far the end of the spring had been drawn, nm, and the mean force of the spring, pN.
    pub curve: Vec<(f64, f64)>,
    /// Largest force after the particles were set in motion, pN.
    pub largest: f64,
    /// What happened, and how far it had been drawn then.
    pub events: Vec<(f64, String)>,
}

impl Pull {
    /// Runs a case that is about a stretched agglomerate; forces are means over `every`, ns.
    pub fn of(case: &Case, every: f64) -> Result<Self, Error> {
        let plan = Plan::of(case);
        let (mut system, mut pull) = (plan.initial()?, Self::default());
        let rows = plan.steps_in(every);
        for (number, stage) in plan.stages.iter().enumerate() {
            let pulls = matches!(stage.act, Act::Pull { .. });
            (_, system) = run_stage(&plan, number, system, |watch, simulation, events| {
                if !pulls {
                    return;
                }
                pull.events.extend(events.into_iter().map(|event| (watch.pulled(simulation), event)));
                if simulation.system().step.is_multiple_of(rows) {
                    plan.look(watch, simulation);
                    pull.curve.push((watch.pulled(simulation), watch.mean_pull()));
                    pull.largest = watch.largest_pull();
                }
            })?;
        }
        Ok(pull)
    }

    /// Forces at the detachments, pN, each the mean before.
    pub fn at_detachments(&self) -> Vec<f64> {
        let before = |drawn: f64| self.curve.iter().rev().find(|point| point.0 <= drawn).map(|point| point.1);
        let detachments = self.events.iter().filter(|(_, event)| event.starts_with("detachment"));
        detachments.filter_map(|&(drawn, _)| before(drawn)).collect()
    }
}
