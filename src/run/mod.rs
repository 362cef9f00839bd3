//! A run: the stages of a case, one after another, watched, recorded, and kept so that it can be taken up again bit by bit.

mod control;
mod plan;
mod record;
mod report;
mod row;
mod watch;

pub use control::Control;
pub use plan::Plan;
pub use report::{Series, report};

use crate::build::protocol::{Progress, Setup, Stage};
use crate::case::{Case, InSteps};
use crate::error::Error;
use crate::output::{Finding, Manifest, RunFolder, Status, extended_xyz, write_atomically};
use crate::simulation::{Settings, Simulation, Snapshot};
use crate::spec::wear::Wear;
use crate::system::System;
use record::{Extent, Record};
use serde::{Deserialize, Serialize};
use watch::Watch;

/// The complete state of a run.
#[derive(Serialize, Deserialize)]
struct State {
    stage: usize,
    /// Steps of all stages together.
    steps: u64,
    dt: f64,
    damping: f64,
    skin: f64,
    snapshot: Snapshot,
    watch: Watch,
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
pub struct Run<'a> {
    case: &'a Case,
    plan: Plan,
    folder: &'a RunFolder,
    manifest: Manifest,
    control: &'a Control,
    /// Steps of this process.
    taken: u64,
    show: &'a mut dyn FnMut(Glance),
}

/// A stage under way.
struct Current {
    number: usize,
    simulation: Simulation<Wear>,
    watch: Watch,
    glance: (f64, f64),
}

/// What goes from stage to stage.
struct Course {
    record: Record,
    sample: Option<System>,
    findings: Vec<Finding>,
    steps: u64,
}

impl<'a> Run<'a> {
    /// A run of a case in a folder; `show` is told how it is doing.
    pub fn new(
        case: &'a Case,
        folder: &'a RunFolder,
        manifest: Manifest,
        control: &'a Control,
        show: &'a mut dyn FnMut(Glance),
    ) -> Self {
        Self { case, plan: Plan::of(case), folder, manifest, control, taken: 0, show }
    }

    /// Begins at the beginning.
    pub fn start(&mut self, initial: System) -> Result<Vec<Finding>, Error> {
        self.manifest.write(self.folder)?;
        let record = Record::begin(self.folder, &row::columns())?;
        let course = Course { record, sample: None, findings: Vec::new(), steps: 0 };
        self.conclude(|run| run.go_on(course, Some(initial), None))
    }

    /// Goes on from the latest checkpoint.
    pub fn resume(&mut self) -> Result<Vec<Finding>, Error> {
        let State { stage, steps, dt, damping, skin, snapshot, watch, sample, findings, extent } =
            self.folder.checkpoints().latest()?;
        self.manifest.resume();
        self.manifest.write(self.folder)?;
        let record = Record::resume(self.folder, extent)?;
        let course = Course { record, sample, findings, steps };
        self.conclude(|run| {
            let protocol = run.stage(stage);
            let model = run.case.material().law(protocol.interaction);
            let settings = run.settings(&protocol, snapshot.system());
            let settings = Settings { dt, damping, skin, ..settings };
            let simulation = Simulation::resume(model, settings, snapshot).map_err(|halt| Error::Halted(halt, None))?;
            let current = Current { number: stage, simulation, watch, glance: (0.0, 0.0) };
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

    fn stage(&self, number: usize) -> Stage {
        self.plan.stages().nth(number).expect("a run has as many stages as its case").clone()
    }

    fn settings(&self, stage: &Stage, system: &System) -> Settings {
        stage.settings(system, &self.case.material().spec(), self.max_overlap(stage))
    }

    /// Random spheres overlap without limit until they have been pushed apart.
    fn max_overlap(&self, stage: &Stage) -> f64 {
        if stage.interaction == crate::spec::wear::Interaction::Repulsive {
            f64::INFINITY
        } else {
            self.case.limits.overlap
        }
    }

    fn go_on(
        &mut self,
        mut course: Course,
        initial: Option<System>,
        resumed: Option<Current>,
    ) -> Result<Vec<Finding>, Error> {
        let first = resumed.as_ref().map_or(0, |current| current.number);
        let (mut before, mut resumed) = (initial, resumed);
        for number in first..self.plan.stages().count() {
            let stage = self.stage(number);
            let mut current = match resumed.take() {
                Some(current) => current,
                None => self.begin(&stage, number, before.take(), &mut course)?,
            };
            self.advance(&stage, &mut current, &mut course)?;
            let simulation = current.simulation;
            self.picture(&stage, simulation.system(), "end")?;
            course.record.event(stage.name, simulation.system(), "end")?;
            course.findings.extend(current.watch.findings(&stage, self.case, &simulation));
            before = Some(stage.end(simulation));
        }
        let results = serde_yaml::to_string(&course.findings).expect("findings are plain data");
        write_atomically(&self.folder.results(), results.as_bytes())?;
        report(self.case, self.folder, &course.findings)?;
        self.folder.checkpoints().forget_stopped()?;
        Ok(course.findings)
    }

    fn begin(
        &mut self,
        stage: &Stage,
        number: usize,
        before: Option<System>,
        course: &mut Course,
    ) -> Result<Current, Error> {
        if self.plan.starts_from_sample(number) && course.sample.is_none() {
            let sample = before.clone().expect("the first stage that needs a sample comes after its preparation");
            self.plan.keep_sample(&sample)?;
            course.sample = Some(sample);
        }
        let from = course.sample.clone().or(before).expect("a run begins with particles");
        let material = self.case.material().spec();
        let begun = stage.begin(from, &material, self.max_overlap(stage));
        let simulation = begun.map_err(|halt| Error::Halted(halt, None))?;
        let watch = Watch::begin(stage, self.case, &simulation);
        let mut current = Current { number, simulation, watch, glance: (0.0, 0.0) };
        course.record.event(stage.name, current.simulation.system(), "begin")?;
        course.record.frame(stage.name, current.simulation.system())?;
        self.picture(stage, current.simulation.system(), "begin")?;
        look(stage, &mut current, course)?;
        self.show(stage, &current);
        Ok(current)
    }

    /// Steps to the end of a stage.
    fn advance(&mut self, stage: &Stage, current: &mut Current, course: &mut Course) -> Result<(), Error> {
        let dt = current.simulation.settings().dt;
        let every = |interval: &InSteps| ((interval.value(dt) / dt).round() as u64).max(1);
        let output = &self.case.output;
        let (series, frames, checkpoints) = (every(&output.series), every(&output.frames), every(&output.checkpoints));
        let third = (stage.steps(dt) / 3).max(1);
        loop {
            if self.control.stops(self.taken) {
                self.folder.checkpoints().keep_stopped(&state(current, course))?;
                return Err(Error::Stopped(self.folder.root().into()));
            }
            if let Err(halt) = current.simulation.step() {
                return Err(self.halted(stage, current, course, halt));
            }
            self.taken += 1;
            course.steps += 1;
            let step = current.simulation.system().step;
            let progress = if current.watch.ended() { Progress::Done } else { stage.progress(&current.simulation) };
            let last = progress != Progress::Going;
            if last || step.is_multiple_of(series) {
                look(stage, current, course)?;
                self.show(stage, current);
            }
            if last || step.is_multiple_of(frames) {
                course.record.frame(stage.name, current.simulation.system())?;
            }
            if matches!(stage.setup, Setup::Junction(_)) && step.is_multiple_of(third) && !last {
                self.picture(stage, current.simulation.system(), &format!("after {} of 3 parts", step / third))?;
            }
            match progress {
                Progress::Going => {}
                Progress::Done => return Ok(()),
                Progress::Failed => {
                    course.record.event(stage.name, current.simulation.system(), "not relaxed in time")?;
                    let what = format!("{}: stresses are not below the limit after {step} steps", stage.name);
                    return Err(Error::Verification(what));
                }
            }
            if step.is_multiple_of(checkpoints) {
                course.record.event(stage.name, current.simulation.system(), "checkpoint")?;
                self.folder.checkpoints().keep(course.steps, &state(current, course))?;
            }
        }
    }

    fn picture(&self, stage: &Stage, system: &System, when: &str) -> Result<(), Error> {
        report::picture(self.folder, &format!("{} {when}", stage.name), system, system.domain.sides[1])
    }

    fn show(&mut self, stage: &Stage, current: &Current) {
        let system = current.simulation.system();
        let (residual, overlap) = current.glance;
        let steps = stage.steps(current.simulation.settings().dt);
        let particles = system.particles.len();
        (self.show)(Glance { stage: stage.name, step: system.step, steps, particles, residual, overlap });
    }

    /// Dumps the state that could not be left.
    fn halted(&self, stage: &Stage, current: &Current, course: &mut Course, halt: crate::system::Halt) -> Error {
        let system = current.simulation.system();
        let dumped = course
            .record
            .event(stage.name, system, &format!("halted at {halt}"))
            .and_then(|()| write_atomically(&self.folder.halted(), extended_xyz(system, stage.name).as_bytes()));
        match dumped {
            Ok(()) => Error::Halted(halt, Some(self.folder.halted())),
            Err(error) => error,
        }
    }
}

fn state(current: &Current, course: &Course) -> State {
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

/// Measures, and appends a row to the series.
fn look(stage: &Stage, current: &mut Current, course: &mut Course) -> Result<(), Error> {
    let (cells, glance) = row::measure(stage.name, &current.simulation, &mut current.watch);
    current.glance = glance;
    course.record.row(&cells)
}
