//! The state of a job, or of its run, for another program.

use super::plan::Intervals;
use super::saved::State;
use super::{Driver, Job, RunningStage, Study};
use crate::case::Moments;
use crate::error::Error;
use crate::interrupt::Interrupt;
use crate::output;
use crate::output::{LammpsScript, Manifest, Origin, RunFolder};
use std::path::Path;

/// Files for LAMMPS with the plugin, by name: of the latest checkpoint of a run, or of the start of a job.
pub(super) fn for_lammps<S: Study>(
    study: &S,
    job: &Job,
    folder: Option<&RunFolder>,
    interrupt: &Interrupt,
) -> Result<Vec<(&'static str, String)>, Error> {
    let driver = Driver::new(study, interrupt).using(job.instructions);
    let mut stage: RunningStage<S> = match folder {
        Some(folder) => {
            let accepted = |path: &Path, state: State<S::Watch>| state.accepted(path, folder, &driver);
            folder.checkpoints().latest(&Origin::of(&Manifest::read(folder)?), accepted)?.0.stage
        }
        None => driver.set_up(0, study.initial(interrupt)?)?,
    };
    stage.simulation.place_members();
    let refused = |what: String| Error::input(&job.file, what);
    let style = study.pair_style(stage.number).map_err(refused)?;
    let (simulation, dt) = (&stage.simulation, stage.simulation.settings().dt);
    let steps = stage.last_step() - simulation.system().step;
    let frames = match &job.output.frames {
        Moments::Every(interval) => (interval.value(dt) / dt).round().max(1.0) as u64,
        Moments::At(_) => steps.max(1),
    };
    let title = format!("{}: {}, from step {}", job.title.replace('\n', " "), stage.name, simulation.system().step);
    let script = LammpsScript { title, style: &style, steps, series: Intervals::of(&job.output, dt).series, frames };
    output::for_lammps(simulation, &script).map_err(refused)
}
