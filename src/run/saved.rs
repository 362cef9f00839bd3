//! The state of a run as a checkpoint holds it, and whether a study can be resumed from it.

use super::record::Recorded;
use super::row::layout;
use super::{Driver, RunState, RunningStage, Study};
use crate::error::Error;
use crate::output::RunFolder;
use crate::simulation::{Settings, Simulation, Snapshot};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The complete state of a run.
#[derive(Serialize, Deserialize)]
pub(super) struct State<W> {
    pub(super) stage: usize,
    pub(super) dt: f64,
    pub(super) damping: f64,
    pub(super) skin: f64,
    pub(super) snapshot: Snapshot,
    pub(super) watch: W,
    pub(super) run: RunState,
    pub(super) recorded: Recorded,
}

/// What a run is resumed from.
pub(super) struct Resumable<'a, S: Study> {
    pub(super) stage: RunningStage<'a, S>,
    pub(super) run: RunState,
    pub(super) recorded: Recorded,
    /// Frames that are no longer there.
    pub(super) missing: Vec<PathBuf>,
}

/// How much larger or smaller a setting of a stage may be than it would be if the stage began from its present state.
const DRIFT: f64 = 10.0;

/// Most steps of a run: far more than any computer takes.
const MOST: u64 = 1 << 60;

impl<W> State<W> {
    /// Restores the stage under way, if the state is one that the study can have, and its record that of the folder.
    pub(super) fn accepted<'a, S: Study<Watch = W>>(
        self,
        path: &Path,
        folder: &RunFolder,
        driver: &Driver<'a, S>,
    ) -> Result<Resumable<'a, S>, Error> {
        let unfit = || Error::input(path, "holds numbers or lengths that this run cannot have");
        let Self { stage, dt, damping, skin, snapshot, watch, run, recorded } = self;
        let study = driver.study();
        let system = snapshot.system();
        let sound = stage < study.names().len()
            && snapshot.is_sound()
            && run.sample.as_ref().is_none_or(|sample| sample.is_sound())
            && (system.step..MOST).contains(&run.steps)
            && study.can_hold(stage, system, &watch);
        if !sound {
            return Err(unfit());
        }
        let settings = driver.settings(stage, system);
        let drifted = |is: f64, was: f64| is != was && !(was / DRIFT..=was * DRIFT).contains(&is);
        let settings_drifted =
            drifted(dt, settings.dt) || drifted(damping, settings.damping) || drifted(skin, settings.skin);
        if settings_drifted || system.step > study.steps(stage, dt) {
            return Err(unfit());
        }
        let missing = recorded.check(folder, &layout(study))?;
        let settings = Settings { dt, damping, skin, ..settings };
        let simulation = Simulation::resume(study.model(stage, system), settings, snapshot)
            .map_err(|halt| Error::input(path, format!("cannot be resumed: {halt}")))?;
        Ok(Resumable { stage: driver.stage(stage, simulation, watch), run, recorded, missing })
    }
}
