//! An agglomerate stretched without a run folder.

use super::Plan;
use super::case::Case;
use super::stage::Act;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::run::{Driver, Each, Study};
use std::ops::ControlFlow;

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
    ///
    /// # Errors
    ///
    /// A halt, or an interruption.
    pub fn of(case: &Case, every: f64, interrupt: &Interrupt) -> Result<Self, Error> {
        let (plan, mut pull) = (Plan::of(case), Self::default());
        let rows = plan.steps_in(every);
        let mut see = Each(|stage: &mut crate::run::Stage<'_, Plan>, step: &crate::run::Step| {
            if matches!(plan.stages[stage.number].act, Act::Pull { .. }) {
                let (watch, simulation) = (&mut stage.watch, &stage.simulation);
                pull.events.extend(step.events.iter().map(|event| (watch.pulled(simulation), event.clone())));
                if simulation.system().step.is_multiple_of(rows) {
                    plan.look(watch, simulation);
                    pull.curve.push((watch.pulled(simulation), watch.mean_pull()));
                    pull.largest = watch.largest_pull();
                }
            }
            ControlFlow::Continue(())
        });
        Driver::new(&plan, interrupt).run(&mut see)?;
        Ok(pull)
    }

    /// Forces at the detachments, pN, each the mean before.
    pub fn at_detachments(&self) -> Vec<f64> {
        let before = |drawn: f64| self.curve.iter().rev().find(|point| point.0 <= drawn).map(|point| point.1);
        let detachments = self.events.iter().filter(|(_, event)| event.starts_with("detachment"));
        detachments.filter_map(|&(drawn, _)| before(drawn)).collect()
    }
}
