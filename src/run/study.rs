//! What a paper's cases have in common for whoever runs them.

use crate::build::protocol::Progress;
use crate::error::Error;
use crate::output::{Cell, Finding};
use crate::simulation::{Settings, Simulation};
use crate::spec::PairModel;
use crate::system::{Halt, System};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A case of one paper as stages, each with its model, its settings, and what is watched in it. Stages are counted from zero.
pub trait Study {
    /// The contact model.
    type Model: PairModel;
    /// What an observer remembers between two looks.
    type Watch: Clone + Serialize + DeserializeOwned;

    /// The names of the stages.
    fn stages(&self) -> Vec<&'static str>;
    /// The same, with a number where a name comes again.
    fn names(&self) -> Vec<String> {
        let stages = self.stages();
        let before = |at: usize| stages[..at].iter().filter(|&name| *name == stages[at]).count();
        let name = |at| if before(at) == 0 { stages[at].into() } else { format!("{} {}", stages[at], before(at) + 1) };
        (0..stages.len()).map(name).collect()
    }
    /// Looks at what the case needs beside itself, short of computing anything.
    fn examine(&self) -> Result<(), Error> {
        Ok(())
    }
    /// The particles before the first stage.
    fn initial(&self) -> Result<System, Error>;
    /// True for a stage that starts from the sample, false for one that makes it.
    fn starts_from_sample(&self, stage: usize) -> bool;
    /// Keeps the sample, if the case wants it.
    fn keep_sample(&self, system: &System) -> Result<(), Error>;
    /// What a stage makes of the system that it is given.
    fn set_up(&self, stage: usize, system: System) -> Result<System, Error>;
    /// The model of a stage.
    fn model(&self, stage: usize) -> Self::Model;
    /// How a stage advances its system.
    fn settings(&self, stage: usize, system: &System) -> Settings;
    /// The last step of a stage, at the latest.
    fn steps(&self, stage: usize, dt: f64) -> u64;
    /// Whether a stage has come to its end.
    fn progress(&self, stage: usize, watch: &Self::Watch, simulation: &Simulation<Self::Model>) -> Progress;
    /// The system at the end of a stage.
    fn end(&self, stage: usize, simulation: Simulation<Self::Model>) -> Result<System, Error>;
    /// Into how many parts pictures cut a stage.
    fn parts(&self, stage: usize) -> u64;
    /// The axis that points up in pictures, the second or the third.
    fn upwards(&self) -> usize {
        1
    }

    /// The columns that observers add to the series.
    fn columns(&self) -> Vec<&'static str>;
    /// Begins to watch a stage.
    fn watch(&self, stage: usize, simulation: &Simulation<Self::Model>) -> Self::Watch;
    /// Changes what a stage lets change between two steps; says what happened.
    fn intervene(&self, _stage: usize, _simulation: &mut Simulation<Self::Model>) -> Result<Vec<String>, Halt> {
        Ok(Vec::new())
    }
    /// Sees every step; says what happened in it.
    fn follow(&self, _stage: usize, _watch: &mut Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<String> {
        Vec::new()
    }
    /// Measures: the cells of the columns of all observers, those of other stages empty.
    fn look(&self, watch: &mut Self::Watch, simulation: &Simulation<Self::Model>) -> Vec<Cell>;
    /// What it amounts to.
    fn findings(
        &self,
        stage: usize,
        watch: &Self::Watch,
        simulation: &Simulation<Self::Model>,
    ) -> Result<Vec<Finding>, Error>;
}

/// Runs a stage of a plan without a run folder: `see` is shown every step and what happened in it. Returns what has been watched, and the system for the next stage.
pub fn run_stage<S: Study>(
    plan: &S,
    stage: usize,
    system: System,
    mut see: impl FnMut(&mut S::Watch, &Simulation<S::Model>, Vec<String>),
) -> Result<(S::Watch, System), Error> {
    let system = plan.set_up(stage, system)?;
    let settings = plan.settings(stage, &system);
    let halted = |halt| Error::Halted(halt, None);
    let mut simulation = Simulation::new(plan.model(stage), system, settings).map_err(halted)?;
    let mut watch = plan.watch(stage, &simulation);
    while plan.progress(stage, &watch, &simulation) == Progress::Going {
        simulation.step().map_err(halted)?;
        let events = plan.follow(stage, &mut watch, &simulation);
        see(&mut watch, &simulation, events);
    }
    Ok((watch, plan.end(stage, simulation)?))
}
