//! A force curve without a run folder.

use super::{Plan, Stage};
use crate::case::Case;
use crate::error::Error;
use crate::run::Study;
use crate::run::study::run_stage;
use crate::spec::titania::Tabulated;

/// What comes out of a film under a tip.
#[derive(Clone, Debug, Default)]
pub struct Spectrum {
    /// How far the tip had moved, nm, and the mean force on it, pN: coming down.
    pub approach: Vec<(f64, f64)>,
    /// The same going up.
    pub retraction: Vec<(f64, f64)>,
    /// What happened while it went up, and how far it had moved then.
    pub events: Vec<(f64, String)>,
    /// Largest pull, last peak of the pull, pN, and the way from the setpoint to the rupture, nm; what there was.
    pub largest: f64,
    /// The last peak before nothing pulls any more.
    pub last: Option<f64>,
    /// The way.
    pub rupture: Option<f64>,
}

impl Spectrum {
    /// How far the tip had moved at the last peak of the pull, nm.
    pub fn peak(&self) -> f64 {
        self.retraction.iter().rev().find(|point| self.last == Some(-point.1)).map_or(0.0, |point| point.0)
    }

    /// Runs a case that is about a film of rigid aggregates.
    pub fn of(case: &Case) -> Result<Self, Error> {
        let plan = Plan::<Tabulated>::of(case);
        let (mut system, mut spectrum) = (plan.initial()?, Self::default());
        for (number, &stage) in plan.stages.iter().enumerate() {
            let watch;
            (watch, system) = run_stage(&plan, number, system, |_, simulation, events| {
                if stage == Stage::Retraction {
                    let moved = simulation.system().walls[super::TIP].travel.0[2];
                    spectrum.events.extend(events.into_iter().map(|event| (moved, event)));
                }
            })?;
            match stage {
                Stage::Relaxation => {}
                Stage::Approach => spectrum.approach = watch.curve().to_vec(),
                Stage::Retraction => {
                    spectrum.retraction = watch.curve().to_vec();
                    (spectrum.largest, spectrum.last) = watch.largest_and_last_pull();
                    spectrum.rupture = watch.way_to_rupture();
                }
            }
        }
        Ok(spectrum)
    }
}
