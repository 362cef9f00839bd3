//! A run: the stages of a case, one after another, watched, recorded, and kept so that it can be taken up again bit by bit.

mod control;
mod record;
mod report;
mod row;
pub mod soot;
mod start;
mod study;
pub mod sweep;
mod titania;
mod wear;

pub use control::Control;
pub use report::{Event, Series, between, report};
pub use start::{complete, examine, launch, resume};
pub use study::Study;
pub use titania::{Pull, Spectrum, rolling_resistance};

use crate::build::protocol::Progress;
use crate::case::{Case, InSteps};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder, Status, extended_xyz, write_atomically};
use crate::simulation::{Settings, Simulation, Snapshot};
use crate::system::System;
use record::{Extent, Record};
use serde::{Deserialize, Serialize};

/// The complete state of a run.
#[derive(Serialize, Deserialize)]
struct State<W> {
    stage: usize,
    /// Steps of all stages together.
    steps: u64,
    dt: f64,
    damping: f64,
    skin: f64,
    snapshot: Snapshot,
    watch: W,
    sample: Option<System>,
    findings: Vec<Finding>,
    extent: Extent,
}

/// How a run is doing, for whoever waits for it.
#[derive(Clone, Copy, Debug)]
pub struct Glance<'a> {
    /// The stage.
    pub stage: &'a str,
    /// Steps of this stage so far.
    pub step: u64,
    /// Its last step, at the latest.
    pub steps: u64,
    /// Number of particles.
    pub particles: usize,
    /// Residual of the physical energy account over all that moved.
    pub residual: f64,
    /// Largest overlap over the sum of the radii.
    pub overlap: f64,
}

/// A run in its folder.
struct Run<'a, S: Study> {
    case: &'a Case,
    study: S,
    names: Vec<String>,
    folder: &'a RunFolder,
    manifest: Manifest,
    control: &'a Control,
    /// Steps of this process.
    taken: u64,
    show: &'a mut dyn FnMut(Glance),
}

/// A stage under way.
struct Current<S: Study> {
    number: usize,
    name: String,
    simulation: Simulation<S::Model>,
    watch: S::Watch,
    glance: (f64, f64),
}

/// What goes from stage to stage.
struct Course {
    record: Record,
    sample: Option<System>,
    findings: Vec<Finding>,
    steps: u64,
}

impl<'a, S: Study> Run<'a, S> {
    fn new(
        case: &'a Case,
        study: S,
        folder: &'a RunFolder,
        manifest: Manifest,
        control: &'a Control,
        show: &'a mut dyn FnMut(Glance),
    ) -> Self {
        Self { case, names: study.names(), study, folder, manifest, control, taken: 0, show }
    }

    /// Begins at the beginning.
    fn start(&mut self, initial: System) -> Result<Vec<Finding>, Error> {
        self.manifest.write(self.folder)?;
        let record = Record::begin(self.folder, &row::columns(&self.study))?;
        let course = Course { record, sample: None, findings: Vec::new(), steps: 0 };
        self.conclude(|run| run.go_on(course, Some(initial), None))
    }

    /// Goes on from the latest checkpoint.
    fn resume(&mut self) -> Result<Vec<Finding>, Error> {
        let State { stage, steps, dt, damping, skin, snapshot, watch, sample, findings, extent } =
            self.folder.checkpoints().latest()?;
        start::unchanged_after(stage, self.case, &self.manifest)?;
        self.manifest.resume();
        self.manifest.write(self.folder)?;
        let record = Record::resume(self.folder, extent)?;
        let course = Course { record, sample, findings, steps };
        self.conclude(|run| {
            let settings = Settings { dt, damping, skin, ..run.study.settings(stage, snapshot.system()) };
            let resumed = Simulation::resume(run.study.model(stage), settings, snapshot);
            let simulation = resumed.map_err(|halt| Error::Halted(halt, None))?;
            let current =
                Current { number: stage, name: run.names[stage].clone(), simulation, watch, glance: (0.0, 0.0) };
            run.go_on(course, None, Some(current))
        })
    }

    /// Leaves the manifest in a state that says how the run ended.
    fn conclude(&mut self, run: impl FnOnce(&mut Self) -> Result<Vec<Finding>, Error>) -> Result<Vec<Finding>, Error> {
        let result = run(self);
        let status = match &result {
            Ok(_) => Status::Finished,
            Err(Error::Halted(..)) => Status::Halted,
            Err(_) => Status::Stopped,
        };
        let written = self.manifest.end(self.folder, status);
        result.and_then(|findings| written.map(|()| findings))
    }

    fn go_on(
        &mut self,
        mut course: Course,
        initial: Option<System>,
        resumed: Option<Current<S>>,
    ) -> Result<Vec<Finding>, Error> {
        let first = resumed.as_ref().map_or(0, |current| current.number);
        let (mut before, mut resumed) = (initial, resumed);
        for number in first..self.names.len() {
            let mut current = match resumed.take() {
                Some(current) => current,
                None => self.begin(number, before.take(), &mut course)?,
            };
            self.advance(&mut current, &mut course)?;
            self.picture(&current, "end")?;
            course.record.event(&current.name, current.simulation.system(), "end")?;
            course.findings.extend(self.study.findings(number, &current.watch, &current.simulation)?);
            before = Some(self.study.end(number, current.simulation)?);
        }
        let results = serde_yaml::to_string(&course.findings).expect("findings are plain data");
        write_atomically(&self.folder.results(), results.as_bytes())?;
        report(self.case, self.folder, &course.findings)?;
        self.folder.checkpoints().forget_stopped()?;
        Ok(course.findings)
    }

    fn begin(&mut self, number: usize, before: Option<System>, course: &mut Course) -> Result<Current<S>, Error> {
        if self.study.starts_from_sample(number) && course.sample.is_none() {
            let sample = before.clone().expect("the first stage that needs a sample comes after its preparation");
            self.study.keep_sample(&sample)?;
            course.sample = Some(sample);
        }
        let from = course.sample.clone().or(before).expect("a run begins with particles");
        let system = self.study.set_up(number, from)?;
        let settings = self.study.settings(number, &system);
        let begun = Simulation::new(self.study.model(number), system, settings);
        let simulation = begun.map_err(|halt| Error::Halted(halt, None))?;
        let watch = self.study.watch(number, &simulation);
        let mut current = Current { number, name: self.names[number].clone(), simulation, watch, glance: (0.0, 0.0) };
        course.record.event(&current.name, current.simulation.system(), "begin")?;
        course.record.frame(&current.name, current.simulation.system())?;
        self.picture(&current, "begin")?;
        self.look(&mut current, course)?;
        self.show(&current);
        Ok(current)
    }

    /// Steps to the end of a stage.
    fn advance(&mut self, current: &mut Current<S>, course: &mut Course) -> Result<(), Error> {
        let dt = current.simulation.settings().dt;
        let every = |interval: &InSteps| ((interval.value(dt) / dt).round() as u64).max(1);
        let output = &self.case.output;
        let (series, frames, checkpoints) = (every(&output.series), every(&output.frames), every(&output.checkpoints));
        let (number, parts) = (current.number, self.study.parts(current.number));
        let part = (self.study.steps(number, dt) / parts).max(1);
        loop {
            if self.control.stops(self.taken) {
                self.show(current);
                self.folder.checkpoints().keep_stopped(&state(current, course))?;
                return Err(Error::Stopped(Some(self.folder.root().into())));
            }
            let stepped = current.simulation.step();
            let happened = match stepped.and_then(|()| self.study.intervene(number, &mut current.simulation)) {
                Ok(happened) => happened,
                Err(halt) => return Err(self.halted(current, course, halt)),
            };
            self.taken += 1;
            course.steps += 1;
            for event in happened.into_iter().chain(self.study.follow(number, &mut current.watch, &current.simulation))
            {
                course.record.event(&current.name, current.simulation.system(), &event)?;
            }
            let step = current.simulation.system().step;
            let progress = self.study.progress(number, &current.watch, &current.simulation);
            let last = progress != Progress::Going;
            if last || [series, frames, part].iter().any(|&interval| step.is_multiple_of(interval)) {
                current.simulation.place_members();
            }
            if last || step.is_multiple_of(series) {
                self.look(current, course)?;
                self.show(current);
            }
            if last || step.is_multiple_of(frames) {
                course.record.frame(&current.name, current.simulation.system())?;
            }
            if step.is_multiple_of(part) && !last {
                self.picture(current, &format!("after {} of {parts} parts", step / part))?;
            }
            match progress {
                Progress::Going => {}
                Progress::Done => return Ok(()),
                Progress::Failed => {
                    course.record.event(&current.name, current.simulation.system(), "not relaxed in time")?;
                    let what = format!("{}: stresses are not below the limit after {step} steps", current.name);
                    return Err(Error::Verification(what));
                }
            }
            if step.is_multiple_of(checkpoints) {
                course.record.event(&current.name, current.simulation.system(), "checkpoint")?;
                self.folder.checkpoints().keep(course.steps, &state(current, course))?;
            }
        }
    }

    fn picture(&self, current: &Current<S>, when: &str) -> Result<(), Error> {
        let system = current.simulation.system();
        report::picture(self.folder, &format!("{} {when}", current.name), system, self.study.upwards())
    }

    fn show(&mut self, current: &Current<S>) {
        let system = current.simulation.system();
        let (residual, overlap) = current.glance;
        let steps = self.study.steps(current.number, current.simulation.settings().dt);
        let particles = system.particles.len();
        (self.show)(Glance { stage: &current.name, step: system.step, steps, particles, residual, overlap });
    }

    /// Measures, and appends a row to the series.
    fn look(&self, current: &mut Current<S>, course: &mut Course) -> Result<(), Error> {
        let (cells, glance) = row::measure(&self.study, &current.name, &current.simulation, &mut current.watch);
        current.glance = glance;
        course.record.row(&cells)
    }

    /// Dumps the state that could not be left.
    fn halted(&self, current: &mut Current<S>, course: &mut Course, halt: crate::system::Halt) -> Error {
        current.simulation.place_members();
        let system = current.simulation.system();
        let dumped = course
            .record
            .event(&current.name, system, &format!("halted at {halt}"))
            .and_then(|()| write_atomically(&self.folder.halted(), extended_xyz(system, &current.name).as_bytes()));
        match dumped {
            Ok(()) => Error::Halted(halt, Some(self.folder.halted())),
            Err(error) => error,
        }
    }
}

fn state<S: Study>(current: &Current<S>, course: &Course) -> State<S::Watch> {
    let Settings { dt, damping, skin, .. } = *current.simulation.settings();
    State {
        stage: current.number,
        steps: course.steps,
        dt,
        damping,
        skin,
        snapshot: current.simulation.snapshot(),
        watch: current.watch.clone(),
        sample: course.sample.clone(),
        findings: course.findings.clone(),
        extent: course.record.extent(),
    }
}
