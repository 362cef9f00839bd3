//! The driver: set-up, steps, interventions, observation and end of every stage. All steps are taken here.

use super::{Progress, Sink, Step, Study};
use crate::case::Output;
use crate::error::{Error, Halt};
use crate::forces::Instructions;
use crate::interrupt::Interrupt;
use crate::output::{Finding, Frame};
use crate::simulation::{Settings, Simulation};
use crate::spec::PairModel;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// A stage under way.
pub struct RunningStage<'a, S: Study> {
    /// Its study.
    pub study: &'a S,
    /// Its number, from zero.
    pub number: usize,
    /// Its name, unique in the run.
    pub name: String,
    /// The simulation.
    pub simulation: Simulation<S::Model>,
    /// The state of its observer.
    pub watch: S::Watch,
}

impl<S: Study> RunningStage<'_, S> {
    /// Its state as a frame.
    pub fn frame(&self, output: &Output) -> Frame<'_> {
        let kind = |contact: &_| self.study.kind(contact);
        let flags = self.study.flags(&self.watch, &self.simulation);
        let strengths = self.study.strengths(&self.watch);
        Frame::of(&self.simulation, &self.name, kind, flags, strengths, output.digits, &output.columns)
    }

    /// Its largest number of steps.
    pub fn last_step(&self) -> u64 {
        self.study.steps(self.number, self.simulation.settings().dt)
    }
}

/// The state passed from stage to stage.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RunState {
    /// Total number of steps of all stages.
    pub steps: u64,
    /// The sample, once a stage has needed it.
    pub sample: Option<System>,
    /// The findings of the stages that have ended.
    pub findings: Vec<Finding>,
}

/// The outcome of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The findings of its stages.
    pub findings: Vec<Finding>,
    /// The final state.
    pub system: System,
}

/// Drives a study through its stages.
pub struct Driver<'a, S: Study> {
    study: &'a S,
    interrupt: &'a Interrupt,
    /// If not those that the study asks for.
    instructions: Option<Instructions>,
    names: Vec<String>,
    /// Number of steps taken by this process.
    taken: u64,
}

impl<'a, S: Study> Driver<'a, S> {
    /// A driver that stops when `interrupt` requests it.
    pub fn new(study: &'a S, interrupt: &'a Interrupt) -> Self {
        Self { study, interrupt, instructions: None, names: study.names(), taken: 0 }
    }

    /// The same with these vector instructions, if any are given: for checks, as results do not depend on them.
    pub fn using(self, instructions: Option<Instructions>) -> Self {
        Self { instructions, ..self }
    }

    /// The study that it drives.
    pub fn study(&self) -> &'a S {
        self.study
    }

    /// How a stage advances its system.
    pub fn settings(&self, number: usize, system: &System) -> Settings {
        let settings = self.study.settings(number, system);
        Settings { instructions: self.instructions.unwrap_or(settings.instructions), ..settings }
    }

    /// Runs all stages, from placing the particles to the findings.
    ///
    /// # Errors
    ///
    /// If the study cannot build its system, the simulation halts, a stage fails, the run is interrupted, or the sink fails.
    pub fn run(&mut self, sink: &mut impl Sink<S>) -> Result<Outcome, Error> {
        let initial = self.study.initial(self.interrupt)?;
        self.run_from(initial, sink)
    }

    /// Runs all stages from the initial state.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn run_from(&mut self, initial: System, sink: &mut impl Sink<S>) -> Result<Outcome, Error> {
        self.go_on(0, initial, RunState::default(), sink)
    }

    /// Runs the rest of a stage, and the stages after it.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn resume(
        &mut self,
        mut stage: RunningStage<'a, S>,
        mut run: RunState,
        sink: &mut impl Sink<S>,
    ) -> Result<Outcome, Error> {
        let next = stage.number + 1;
        self.advance(&mut stage, &mut run, sink)?;
        let system = self.end(stage, &mut run, sink)?;
        self.go_on(next, system, run, sink)
    }

    /// Resumes a stage in the middle.
    pub fn stage(&self, number: usize, simulation: Simulation<S::Model>, watch: S::Watch) -> RunningStage<'a, S> {
        RunningStage { study: self.study, number, name: self.names[number].clone(), simulation, watch }
    }

    fn go_on(
        &mut self,
        first: usize,
        mut system: System,
        mut run: RunState,
        sink: &mut impl Sink<S>,
    ) -> Result<Outcome, Error> {
        for number in first..self.names.len() {
            let mut stage = self.begin(number, system, &mut run, sink)?;
            self.advance(&mut stage, &mut run, sink)?;
            system = self.end(stage, &mut run, sink)?;
        }
        Ok(Outcome { findings: run.findings, system })
    }

    /// Begins a stage.
    fn begin(
        &mut self,
        number: usize,
        before: System,
        run: &mut RunState,
        sink: &mut impl Sink<S>,
    ) -> Result<RunningStage<'a, S>, Error> {
        let clock = before.time;
        let from = if self.study.starts_from_sample(number) {
            if run.sample.is_none() {
                self.study.keep_sample(&before)?;
            }
            run.sample.get_or_insert(before).clone()
        } else {
            before
        };
        let mut stage = self.set_up(number, System { time: clock, ..from })?;
        sink.begin(&mut stage, run)?;
        Ok(stage)
    }

    /// Sets a stage up from this state and its time.
    pub(super) fn set_up(&self, number: usize, from: System) -> Result<RunningStage<'a, S>, Error> {
        // Steps are counted per stage; time continues through all stages, whatever state they start from.
        let clock = from.time;
        let system = System { step: 0, time: clock, ..self.study.set_up(number, from)? };
        let settings = self.settings(number, &system);
        let model = self.study.model(number, &system);
        let simulation = Simulation::new_unless(model, system, settings, self.interrupt)?;
        let watch = self.study.watch(number, &simulation, self.interrupt)?;
        Ok(self.stage(number, simulation, watch))
    }

    /// Steps to the end of a stage.
    fn advance(
        &mut self,
        stage: &mut RunningStage<'a, S>,
        run: &mut RunState,
        sink: &mut impl Sink<S>,
    ) -> Result<(), Error> {
        let number = stage.number;
        loop {
            if self.interrupt.stops(self.taken) {
                return Err(sink.stop(stage, run));
            }
            let events = match self.step(stage) {
                Ok(events) => events,
                Err(halt) => return Err(sink.halt(stage, halt)),
            };
            self.taken += 1;
            run.steps += 1;
            let progress = self.study.progress(number, &stage.watch, &stage.simulation);
            let flow = sink.step(stage, run, &Step { events: &events, last: progress != Progress::Going })?;
            match progress {
                Progress::Going if flow.is_continue() => {}
                Progress::Going | Progress::Done => return Ok(()),
                Progress::Failed(reason) => {
                    sink.fail(stage, reason)?;
                    let step = stage.simulation.system().step;
                    return Err(Error::Verification(format!("{}: {reason} after {step} steps", stage.name)));
                }
            }
        }
    }

    /// One step, and the interventions between two steps.
    pub(super) fn step(&self, stage: &mut RunningStage<'a, S>) -> Result<Vec<String>, Halt> {
        let done = stage.simulation.step();
        done.map_err(|halt| stage.simulation.explained(halt))?;
        let mut events = self.study.intervene(stage.number, &stage.watch, &mut stage.simulation)?;
        events.extend(self.study.follow(stage.number, &mut stage.watch, &stage.simulation));
        Ok(events)
    }

    fn end(
        &self,
        mut stage: RunningStage<'a, S>,
        run: &mut RunState,
        sink: &mut impl Sink<S>,
    ) -> Result<System, Error> {
        sink.end(&mut stage, run)?;
        let findings = self.study.findings(stage.number, &stage.watch, &stage.simulation, self.interrupt)?;
        if let Some(finding) = findings.iter().find(|finding| !finding.is_finite()) {
            let halt = stage.simulation.not_a_number(&finding.name);
            return Err(sink.halt(&mut stage, halt));
        }
        let RunningStage { number, simulation, .. } = stage;
        run.findings.extend(findings);
        self.study.end(number, simulation)
    }
}

/// Advances a simulation that belongs to no study.
///
/// # Errors
///
/// If the simulation leaves its domain.
pub fn advance<M: PairModel>(simulation: &mut Simulation<M>, steps: u64) -> Result<(), Halt> {
    let last = simulation.system().step.saturating_add(steps);
    advance_until(simulation, |simulation| simulation.system().step == last)
}

/// Advances a simulation that belongs to no study until `done` says so, which is asked before every step and may intervene.
///
/// # Errors
///
/// If the simulation leaves its domain.
pub fn advance_until<M: PairModel>(
    simulation: &mut Simulation<M>,
    mut done: impl FnMut(&mut Simulation<M>) -> bool,
) -> Result<(), Halt> {
    while !done(simulation) {
        simulation.step()?;
    }
    Ok(())
}
