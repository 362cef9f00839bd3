//! The sink that is a run folder: rows, frames, pictures, events and checkpoints.

use super::plan::{Intervals, frame_due};
use super::progress::{Message, RunProgress};
use super::record::{Record, Recorded};
use super::row::layout;
use super::saved::State;
use super::{RunState, RunningStage, Sink, Step, Study};
use crate::case::{Format, Output};
use crate::error::{Error, Halt};
use crate::figures::picture;
use crate::output::{Origin, RunFolder, write_atomically};
use crate::simulation::Settings;
use std::ops::ControlFlow;

/// Records a run in its folder.
pub(super) struct Recorder<'a> {
    folder: &'a RunFolder,
    origin: Origin,
    output: &'a Output,
    record: Record,
    tell: &'a mut dyn FnMut(Message),
    /// Relative residual and largest overlap of the last row.
    seen: (f64, f64),
    /// Number of the stage under way, the largest numbers of steps of those before it and of all, and whether it or one after it may end earlier.
    steps: Option<(usize, u64, u64, bool)>,
}

impl<'a> Recorder<'a> {
    /// Begins the record of a run.
    pub(super) fn begin<S: Study>(
        study: &S,
        folder: &'a RunFolder,
        origin: Origin,
        output: &'a Output,
        tell: &'a mut dyn FnMut(Message),
    ) -> Result<Self, Error> {
        let record = Record::begin(folder, layout(study))?;
        Ok(Self { folder, origin, output, record, tell, seen: (0.0, 0.0), steps: None })
    }

    /// Restores the record to its state at a checkpoint.
    pub(super) fn resume<S: Study>(
        study: &S,
        folder: &'a RunFolder,
        origin: Origin,
        output: &'a Output,
        recorded: Recorded,
        tell: &'a mut dyn FnMut(Message),
    ) -> Result<Self, Error> {
        Ok(Self {
            folder,
            origin,
            output,
            record: Record::resume(folder, layout(study), recorded)?,
            tell,
            seen: (0.0, 0.0),
            steps: None,
        })
    }

    fn event<S: Study>(&mut self, stage: &RunningStage<'_, S>, event: &str) -> Result<(), Error> {
        self.record.event(&stage.name, stage.simulation.system(), event)
    }

    fn picture<S: Study>(&self, stage: &RunningStage<'_, S>, when: &str) -> Result<(), Error> {
        let name = format!("{} {when}", stage.name);
        picture(self.folder, &name, stage.simulation.system(), stage.study.upwards())
    }

    /// Measures, and appends a row to the series.
    fn row<S: Study>(&mut self, stage: &mut RunningStage<'_, S>) -> Result<(), Error> {
        let row = stage.measure().map_err(|halt| self.halt(stage, halt))?;
        self.seen = (row.residual, row.overlap);
        self.record.row(stage.number, &row.cells)
    }

    /// Writes the next frame.
    fn frame<S: Study>(&mut self, stage: &mut RunningStage<'_, S>) -> Result<(), Error> {
        stage.simulation.check_frame().map_err(|halt| self.halt(stage, halt))?;
        let frame = stage.frame(self.output);
        if let Err(quantity) = frame.check() {
            drop(frame);
            let halt = stage.simulation.not_a_number(quantity);
            return Err(self.halt(stage, halt));
        }
        self.record.frame(&frame, &self.output.format)
    }

    fn show<S: Study>(&mut self, stage: &RunningStage<'_, S>) {
        let system = stage.simulation.system();
        let ((residual, overlap), steps, particles) = (self.seen, stage.last_step(), system.particles.len());
        // Settings may take as long as a step to compute: they are asked for once a stage.
        if self.steps.is_none_or(|(number, ..)| number != stage.number) {
            let study = stage.study;
            let most = |number| study.steps(number, study.settings(number, system).dt);
            let all: Vec<u64> = (0..study.stages().len()).map(most).collect();
            let sum = |steps: &[u64]| steps.iter().copied().fold(0, u64::saturating_add);
            let may_end_early = (stage.number..all.len()).any(|number| study.may_end_early(number));
            self.steps = Some((stage.number, sum(&all[..stage.number]), sum(&all), may_end_early));
        }
        let (_, before, all, may_end_early) = self.steps.unwrap_or((stage.number, 0, steps, false));
        let (stage, step) = (&stage.name, system.step);
        let progress = RunProgress { stage, step, steps, before, all, may_end_early, particles, residual, overlap };
        (self.tell)(Message::Progress(progress));
    }

    /// The state of a run whose record up to here survives a power failure.
    fn state<S: Study>(&self, stage: &RunningStage<'_, S>, run: &RunState) -> Result<State<S::Watch>, Error> {
        let Settings { dt, damping, skin, .. } = *stage.simulation.settings();
        Ok(State {
            stage: stage.number,
            dt,
            damping,
            skin,
            snapshot: stage.simulation.snapshot(),
            watch: stage.watch.clone(),
            run: run.clone(),
            recorded: self.record.sync()?,
        })
    }
}

impl<S: Study> Sink<S> for Recorder<'_> {
    fn begin(&mut self, stage: &mut RunningStage<'_, S>, _: &RunState) -> Result<(), Error> {
        self.event(stage, "begin")?;
        self.frame(stage)?;
        self.picture(stage, "begin")?;
        self.row(stage)?;
        self.show(stage);
        Ok(())
    }

    fn step(&mut self, stage: &mut RunningStage<'_, S>, run: &RunState, step: &Step) -> Result<ControlFlow<()>, Error> {
        for event in step.events {
            self.event(stage, event)?;
        }
        let dt = stage.simulation.settings().dt;
        let Intervals { series, checkpoints } = Intervals::of(self.output, dt);
        let parts = stage.study.parts(stage.number);
        let part = (stage.last_step() / parts).max(1);
        let (taken, last) = (stage.simulation.system().step, step.last);
        let framed = last || frame_due(&self.output.frames, dt, taken);
        if framed || [series, part].iter().any(|&interval| taken.is_multiple_of(interval)) {
            stage.simulation.place_members();
        }
        if let Some(cells) = stage.window().map_err(|halt| self.halt(stage, halt))? {
            self.record.window(&cells)?;
        }
        for cells in stage.profile().map_err(|halt| self.halt(stage, halt))? {
            self.record.profile(&cells)?;
        }
        if last || taken.is_multiple_of(series) {
            self.row(stage)?;
            self.show(stage);
        }
        if framed {
            self.frame(stage)?;
        }
        if taken.is_multiple_of(part) && !last {
            self.picture(stage, &format!("after {} of {parts} parts", taken / part))?;
        }
        if taken.is_multiple_of(checkpoints) && !last {
            self.event(stage, "checkpoint")?;
            self.folder.checkpoints().save(run.steps, &self.origin, &self.state(stage, run)?)?;
        }
        Ok(ControlFlow::Continue(()))
    }

    fn end(&mut self, stage: &mut RunningStage<'_, S>, _: &RunState) -> Result<(), Error> {
        self.picture(stage, "end")?;
        self.event(stage, "end")?;
        self.record.sync().map(drop)
    }

    fn fail(&mut self, stage: &mut RunningStage<'_, S>, reason: &str) -> Result<(), Error> {
        self.event(stage, &format!("failed: {reason}"))?;
        self.record.sync().map(drop)
    }

    fn stop(&mut self, stage: &mut RunningStage<'_, S>, run: &RunState) -> Error {
        self.show(stage);
        match self.state(stage, run).and_then(|state| self.folder.checkpoints().keep_stopped(&self.origin, &state)) {
            Ok(()) => Error::Stopped(Some(self.folder.root().into())),
            Err(error) => error,
        }
    }

    /// Writes the state in which the simulation halted.
    fn halt(&mut self, stage: &mut RunningStage<'_, S>, halt: Halt) -> Error {
        stage.simulation.place_members();
        let dumped = self.event(stage, &format!("halted at {halt}")).and_then(|()| {
            self.record.sync()?;
            let files = stage.frame(self.output).files(&[Format::Extxyz]);
            let (_, spheres) = files.last().expect("the spheres come last");
            write_atomically(&self.folder.halted(), spheres)
        });
        match dumped {
            Ok(()) => Error::Halted(halt, Some(self.folder.halted())),
            Err(error) => error,
        }
    }
}
