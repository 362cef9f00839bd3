//! The driver: sets up, steps, intervenes, follows, stops. Whatever takes steps does it here.

use super::{Progress, Sink, Step, Study};
use crate::error::{Error, Halt};
use crate::forces::Instructions;
use crate::interrupt::Interrupt;
use crate::output::Finding;
use crate::simulation::{Settings, Simulation};
use crate::system::System;
use serde::{Deserialize, Serialize};

/// A stage under way.
pub struct Stage<'a, S: Study> {
    /// The study that it belongs to.
    pub study: &'a S,
    /// Its number, from zero.
    pub number: usize,
    /// Its name, unique in the run.
    pub name: String,
    /// What is simulated.
    pub simulation: Simulation<S::Model>,
    /// What its observer remembers.
    pub watch: S::Watch,
}

impl<S: Study> Stage<'_, S> {
    /// Its last step, at the latest.
    pub fn last_step(&self) -> u64 {
        self.study.steps(self.number, self.simulation.settings().dt)
    }
}

/// What goes from stage to stage.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Course {
    /// Steps of all stages together.
    pub steps: u64,
    /// The sample, once a stage has needed it.
    pub sample: Option<System>,
    /// What the stages that have ended amount to.
    pub findings: Vec<Finding>,
}

/// What is left at the end of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What its stages amount to.
    pub findings: Vec<Finding>,
    /// The state at the end.
    pub system: System,
}

/// Drives a study through its stages.
pub struct Driver<'a, S: Study> {
    study: &'a S,
    interrupt: &'a Interrupt,
    /// If not those that the study asks for.
    instructions: Option<Instructions>,
    names: Vec<String>,
    /// Steps of this process.
    taken: u64,
}

impl<'a, S: Study> Driver<'a, S> {
    /// A driver that stops when `interrupt` says so.
    pub fn new(study: &'a S, interrupt: &'a Interrupt) -> Self {
        Self { study, interrupt, instructions: None, names: study.names(), taken: 0 }
    }

    /// The same with these vector instructions, if any are given: for checks, as results do not depend on them.
    pub fn using(self, instructions: Option<Instructions>) -> Self {
        Self { instructions, ..self }
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
    /// What the study cannot build, a halt, a stage that fails, an interruption, or what the sink cannot do.
    pub fn run(&mut self, sink: &mut impl Sink<S>) -> Result<Outcome, Error> {
        let initial = self.study.initial(self.interrupt)?;
        self.run_from(initial, sink)
    }

    /// Runs all stages from the state before the first.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn run_from(&mut self, initial: System, sink: &mut impl Sink<S>) -> Result<Outcome, Error> {
        self.go_on(0, initial, Course::default(), sink)
    }

    /// Runs the rest of a stage, and the stages after it.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run).
    pub fn resume(
        &mut self,
        mut stage: Stage<'a, S>,
        mut course: Course,
        sink: &mut impl Sink<S>,
    ) -> Result<Outcome, Error> {
        let next = stage.number + 1;
        self.advance(&mut stage, &mut course, sink)?;
        let system = self.end(stage, &mut course, sink)?;
        self.go_on(next, system, course, sink)
    }

    /// A stage that is taken up in the middle.
    pub fn stage(&self, number: usize, simulation: Simulation<S::Model>, watch: S::Watch) -> Stage<'a, S> {
        Stage { study: self.study, number, name: self.names[number].clone(), simulation, watch }
    }

    fn go_on(
        &mut self,
        first: usize,
        mut system: System,
        mut course: Course,
        sink: &mut impl Sink<S>,
    ) -> Result<Outcome, Error> {
        for number in first..self.names.len() {
            let mut stage = self.begin(number, system, &mut course, sink)?;
            self.advance(&mut stage, &mut course, sink)?;
            system = self.end(stage, &mut course, sink)?;
        }
        Ok(Outcome { findings: course.findings, system })
    }

    /// Sets a stage up.
    fn begin(
        &mut self,
        number: usize,
        before: System,
        course: &mut Course,
        sink: &mut impl Sink<S>,
    ) -> Result<Stage<'a, S>, Error> {
        let clock = before.time;
        let from = if self.study.starts_from_sample(number) {
            if course.sample.is_none() {
                self.study.keep_sample(&before)?;
            }
            course.sample.get_or_insert(before).clone()
        } else {
            before
        };
        let mut system = self.study.set_up(number, from)?;
        // Steps are counted stage by stage; time goes on, whatever the stage starts from.
        (system.step, system.time) = (0, clock);
        let settings = self.settings(number, &system);
        let simulation = Simulation::new(self.study.model(number), system, settings)?;
        let watch = self.study.watch(number, &simulation);
        let mut stage = self.stage(number, simulation, watch);
        sink.begin(&mut stage, course)?;
        Ok(stage)
    }

    /// Steps to the end of a stage.
    fn advance(&mut self, stage: &mut Stage<'a, S>, course: &mut Course, sink: &mut impl Sink<S>) -> Result<(), Error> {
        let number = stage.number;
        loop {
            if self.interrupt.stops(self.taken) {
                return Err(sink.stop(stage, course));
            }
            let events = match self.step(stage) {
                Ok(events) => events,
                Err(halt) => return Err(sink.halt(stage, halt)),
            };
            self.taken += 1;
            course.steps += 1;
            let progress = self.study.progress(number, &stage.watch, &stage.simulation);
            let flow = sink.step(stage, course, &Step { events: &events, last: progress != Progress::Going })?;
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

    /// One step, and what may happen between two steps.
    fn step(&self, stage: &mut Stage<'a, S>) -> Result<Vec<String>, Halt> {
        stage.simulation.step()?;
        let mut events = self.study.intervene(stage.number, &mut stage.simulation)?;
        events.extend(self.study.follow(stage.number, &mut stage.watch, &stage.simulation));
        Ok(events)
    }

    fn end(&self, mut stage: Stage<'a, S>, course: &mut Course, sink: &mut impl Sink<S>) -> Result<System, Error> {
        sink.end(&mut stage, course)?;
        let Stage { number, simulation, watch, .. } = stage;
        course.findings.extend(self.study.findings(number, &watch, &simulation)?);
        self.study.end(number, simulation)
    }
}
