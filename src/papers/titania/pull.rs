//! Stretching of an agglomerate without a run folder.

use super::Plan;
use super::case::Case;
use super::stage::StageAct;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::run::{Driver, Each};
use crate::spec::titania::Tabulated;
use std::ops::ControlFlow;

/// The result of stretching an agglomerate.
#[derive(Clone, Debug, Default)]
pub struct Pull {
    /// The force curve: displacement of the far end of the spring, nm, and mean force of the spring, pN.
    pub curve: Vec<(f64, f64)>,
    /// Largest force after the initial oscillation, pN.
    pub largest: f64,
    /// Events, with the displacement at which they occurred.
    pub events: Vec<(f64, String)>,
}

impl Pull {
    /// Runs a case of a stretched agglomerate.
    ///
    /// # Errors
    ///
    /// A halt, or an interruption.
    pub fn of(case: &Case, interrupt: &Interrupt) -> Result<Self, Error> {
        let (plan, mut pull) = (Plan::<Tabulated>::of(case), Self::default());
        let mut see = Each(|stage: &mut crate::run::RunningStage<'_, Plan<Tabulated>>, step: &crate::run::Step| {
            if matches!(plan.stages[stage.number].act, StageAct::Pull { .. }) {
                let (watch, simulation) = (&stage.watch, &stage.simulation);
                pull.events.extend(step.events.iter().map(|event| (watch.pulled(simulation), event.clone())));
                if let Some(mean) = watch.mean_pull() {
                    pull.curve.push((watch.pulled(simulation), mean));
                    pull.largest = watch.largest_pull().unwrap_or(0.0);
                }
            }
            ControlFlow::Continue(())
        });
        Driver::new(&plan, interrupt).run(&mut see)?;
        Ok(pull)
    }

    /// Forces at the detachments, pN, each the last mean before the event.
    pub fn at_detachments(&self) -> Vec<f64> {
        let before = |drawn: f64| self.curve.iter().rev().find(|point| point.0 <= drawn).map(|point| point.1);
        let detachments = self.events.iter().filter(|(_, event)| event.starts_with("detachment"));
        detachments.filter_map(|&(drawn, _)| before(drawn)).collect()
    }
}
