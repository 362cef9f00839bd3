//! What a driver needs to know of whatever it runs.

use crate::error::{Error, Halt};
use crate::interrupt::Interrupt;
use crate::output::{Cell, Column, Finding};
use crate::simulation::{Settings, Simulation};
use crate::spec::PairModel;
use crate::system::System;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::PathBuf;

/// Where a stage is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Before its end.
    Going,
    /// At its end.
    Done,
    /// Beyond the step at which it should have ended; says what is missing.
    Failed(&'static str),
}

/// An experiment as stages, each with its model, its settings, and what is watched in it. Stages are counted from zero.
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
    /// Looks at what it needs beside itself, short of computing anything.
    fn examine(&self) -> Result<(), Error> {
        Ok(())
    }
    /// The files that the stages after this one read.
    fn reads_after(&self, _stage: usize) -> Vec<PathBuf> {
        Vec::new()
    }
    /// The particles before the first stage. What takes long asks `interrupt` whether to stop.
    fn initial(&self, interrupt: &Interrupt) -> Result<System, Error>;
    /// True for a stage that starts from the sample, false for one that starts where the stage before has ended.
    fn starts_from_sample(&self, _stage: usize) -> bool {
        false
    }
    /// Keeps the sample, if that is asked for.
    fn keep_sample(&self, _system: &System) -> Result<(), Error> {
        Ok(())
    }
    /// What a stage makes of the system that it is given.
    fn set_up(&self, _stage: usize, system: System) -> Result<System, Error> {
        Ok(system)
    }
    /// The model of a stage.
    fn model(&self, stage: usize) -> Self::Model;
    /// How a stage advances its system.
    fn settings(&self, stage: usize, system: &System) -> Settings;
    /// The last step of a stage, at the latest.
    fn steps(&self, stage: usize, dt: f64) -> u64;
    /// Whether a stage has come to its end: by default at its last step.
    fn progress(&self, stage: usize, _watch: &Self::Watch, simulation: &Simulation<Self::Model>) -> Progress {
        let last = self.steps(stage, simulation.settings().dt);
        if simulation.system().step >= last { Progress::Done } else { Progress::Going }
    }
    /// The system at the end of a stage, with the springs of all contacts.
    fn end(&self, _stage: usize, simulation: Simulation<Self::Model>) -> Result<System, Error> {
        Ok(simulation.into_system_with_springs())
    }
    /// Into how many parts pictures cut a stage.
    fn parts(&self, _stage: usize) -> u64 {
        1
    }
    /// The axis that points up in pictures, the second or the third.
    fn upwards(&self) -> usize {
        1
    }

    /// The columns that observers add to the series.
    fn columns(&self) -> Vec<Column> {
        Vec::new()
    }
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
    fn look(&self, _watch: &mut Self::Watch, _simulation: &Simulation<Self::Model>) -> Vec<Cell> {
        Vec::new()
    }
    /// What it amounts to.
    fn findings(
        &self,
        _stage: usize,
        _watch: &Self::Watch,
        _simulation: &Simulation<Self::Model>,
    ) -> Result<Vec<Finding>, Error> {
        Ok(Vec::new())
    }
}
