//! Writes the output of a run as it proceeds.

use crate::error::{AtPath, Error};
use crate::output::{
    Appending, Cell, Fingerprint, RunFolder, SURFACES, extended_xyz, frame_name, frame_number, row, wavefront,
    write_atomically,
};
use crate::system::System;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::path::PathBuf;

/// The record at a checkpoint, to which its files are truncated when the run is resumed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Recorded {
    series: Fingerprint,
    events: Fingerprint,
    /// Of each frame, and of the surfaces beside it.
    frames: Vec<(Fingerprint, Option<Fingerprint>)>,
}

impl Recorded {
    /// Checks that the record of a folder begins with this one; returns the frames that are missing, which a run does not need to be
    /// resumed.
    pub(super) fn check(&self, folder: &RunFolder) -> Result<Vec<PathBuf>, Error> {
        self.series.check(&folder.series())?;
        self.events.check(&folder.events())?;
        let mut missing = Vec::new();
        for (number, (frame, surfaces)) in (0..).zip(&self.frames) {
            let path = frame_path(folder, number);
            let files = [(path.with_extension(SURFACES), *surfaces), (path, Some(*frame))];
            for (path, fingerprint) in files.into_iter().filter_map(|(path, of)| Some((path, of?))) {
                if path.exists() { fingerprint.check(&path)? } else { missing.push(path) }
            }
        }
        Ok(missing)
    }
}

fn frame_path(folder: &RunFolder, number: usize) -> PathBuf {
    folder.frames().join(frame_name(number as u64))
}

/// The growing files of a run folder.
pub(super) struct Record {
    folder: RunFolder,
    series: Appending,
    events: Appending,
    frames: Vec<(Fingerprint, Option<Fingerprint>)>,
}

impl Record {
    /// Creates the record of a new run.
    pub(super) fn begin(folder: &RunFolder, columns: &[String]) -> Result<Self, Error> {
        remove_frames_after(folder, 0)?;
        let mut series = Appending::create(folder.series())?;
        series.line(&columns.join(","))?;
        Ok(Self { folder: folder.clone(), series, events: Appending::create(folder.events())?, frames: Vec::new() })
    }

    /// Restores a record to its state at a checkpoint.
    pub(super) fn resume(folder: &RunFolder, recorded: Recorded) -> Result<Self, Error> {
        let Recorded { series, events, frames } = recorded;
        let series = Appending::resume(folder.series(), &series)?;
        let events = Appending::resume(folder.events(), &events)?;
        remove_frames_after(folder, frames.len())?;
        Ok(Self { folder: folder.clone(), series, events, frames })
    }

    /// Makes the record survive a power failure; returns its present state.
    pub(super) fn sync(&self) -> Result<Recorded, Error> {
        Ok(Recorded { series: self.series.sync()?, events: self.events.sync()?, frames: self.frames.clone() })
    }

    /// Appends a row to the series.
    pub(super) fn row(&mut self, cells: &[Cell]) -> Result<(), Error> {
        self.series.line(&row(cells))
    }

    /// Appends an event.
    pub(super) fn event(&mut self, stage: &str, system: &System, event: &str) -> Result<(), Error> {
        let event = json!({ "stage": stage, "step": system.step, "time_ns": system.time, "event": event });
        self.events.line(&event.to_string())
    }

    /// Writes the next frame, and next to it the surfaces.
    pub(super) fn frame(&mut self, stage: &str, system: &System) -> Result<(), Error> {
        let path = frame_path(&self.folder, self.frames.len());
        let write = |path: PathBuf, text: String| {
            write_atomically(&path, text.as_bytes()).map(|()| Fingerprint::of(text.as_bytes()))
        };
        // Surfaces are written first, so that an existing frame is complete.
        let drawn = (!system.surfaces.is_empty()).then(|| write(path.with_extension(SURFACES), wavefront(system)));
        let surfaces = drawn.transpose()?;
        self.frames.push((write(path, extended_xyz(system, stage))?, surfaces));
        Ok(())
    }
}

/// Removes the frames that a process wrote after the checkpoint from which the run is resumed.
fn remove_frames_after(folder: &RunFolder, count: usize) -> Result<(), Error> {
    for entry in std::fs::read_dir(folder.frames()).at(&folder.frames())? {
        let path = entry.at(&folder.frames())?.path();
        if path.file_name().and_then(frame_number).is_some_and(|number| number >= count as u64) {
            std::fs::remove_file(&path).at(&path)?;
        }
    }
    Ok(())
}
