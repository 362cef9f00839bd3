//! Sinks of a run: a folder, memory, or a closure.

use super::{RunState, RunningStage, Study};
use crate::error::{Error, Halt};
use crate::output::Cell;
use std::ops::ControlFlow;

/// The outcome of a step.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Events reported by observers and interventions.
    pub events: &'a [String],
    /// Whether the stage ends here.
    pub last: bool,
}

/// Receives everything that happens in a run.
pub trait Sink<S: Study> {
    /// A stage begins.
    ///
    /// # Errors
    ///
    /// If the sink cannot take it; the run ends then.
    fn begin(&mut self, _stage: &mut RunningStage<'_, S>, _run: &RunState) -> Result<(), Error> {
        Ok(())
    }
    /// A step has been taken. A sink may end the stage here.
    ///
    /// # Errors
    ///
    /// If the sink cannot take it; the run ends then.
    fn step(
        &mut self,
        _stage: &mut RunningStage<'_, S>,
        _run: &RunState,
        _step: &Step,
    ) -> Result<ControlFlow<()>, Error> {
        Ok(ControlFlow::Continue(()))
    }
    /// A stage has ended.
    ///
    /// # Errors
    ///
    /// If the sink cannot take it; the run ends then.
    fn end(&mut self, _stage: &mut RunningStage<'_, S>, _run: &RunState) -> Result<(), Error> {
        Ok(())
    }
    /// A stage has failed, for this reason.
    ///
    /// # Errors
    ///
    /// If the sink cannot take it; the run ends then.
    fn fail(&mut self, _stage: &mut RunningStage<'_, S>, _reason: &str) -> Result<(), Error> {
        Ok(())
    }
    /// The run is interrupted here: saves a checkpoint. Returns the error with which the run ends.
    fn stop(&mut self, _stage: &mut RunningStage<'_, S>, _run: &RunState) -> Error {
        Error::Interrupted
    }
    /// The simulation has halted. Returns the error with which the run ends.
    fn halt(&mut self, _stage: &mut RunningStage<'_, S>, halt: Halt) -> Error {
        Error::Halted(halt, None)
    }
}

/// The sink that discards everything.
impl<S: Study> Sink<S> for () {}

/// A closure that observes every step, and may end the stage.
pub struct Each<F>(pub F);

impl<S: Study, F: FnMut(&mut RunningStage<'_, S>, &Step) -> ControlFlow<()>> Sink<S> for Each<F> {
    fn step(&mut self, stage: &mut RunningStage<'_, S>, _: &RunState, step: &Step) -> Result<ControlFlow<()>, Error> {
        Ok((self.0)(stage, step))
    }
}

/// A run in memory: the rows of its series, and its events.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    /// Number of steps between rows; 0 for only the first and the last row of each stage.
    pub every: u64,
    /// The rows; their columns are those of [`columns`](super::columns).
    pub rows: Vec<Vec<Cell>>,
    /// Stage, time (ns) and text of each event.
    pub events: Vec<(String, f64, String)>,
}

impl Memory {
    fn look<S: Study>(&mut self, stage: &mut RunningStage<'_, S>) -> Result<(), Error> {
        stage.simulation.place_members();
        self.rows.push(stage.measure()?.cells);
        Ok(())
    }
}

impl<S: Study> Sink<S> for Memory {
    fn begin(&mut self, stage: &mut RunningStage<'_, S>, _: &RunState) -> Result<(), Error> {
        self.look(stage)
    }
    fn step(&mut self, stage: &mut RunningStage<'_, S>, _: &RunState, step: &Step) -> Result<ControlFlow<()>, Error> {
        let system = stage.simulation.system();
        let due = self.every > 0 && system.step.is_multiple_of(self.every);
        let event = |text: &String| (stage.name.clone(), system.time, text.clone());
        self.events.extend(step.events.iter().map(event));
        if due || step.last {
            self.look(stage)?;
        }
        Ok(ControlFlow::Continue(()))
    }
}
