//! Writes the output of a run as it proceeds.

use crate::error::Error;
use crate::output::{Appending, Cell, RunFolder, SURFACES, extended_xyz, frame_name, row, wavefront, write_atomically};
use crate::system::System;
use serde::{Deserialize, Serialize};
use serde_json::json;

/// The length of the record at a checkpoint, to which its files are truncated when the run is resumed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct RecordLength {
    series: u64,
    events: u64,
    frames: u64,
}

/// The growing files of a run folder.
pub(super) struct Record {
    folder: RunFolder,
    series: Appending,
    events: Appending,
    frames: u64,
}

impl Record {
    /// Creates the record of a new run.
    pub(super) fn begin(folder: &RunFolder, columns: &[String]) -> Result<Self, Error> {
        let mut series = Appending::create(folder.series())?;
        series.line(&columns.join(","))?;
        Ok(Self { folder: folder.clone(), series, events: Appending::create(folder.events())?, frames: 0 })
    }

    /// Restores a record to its state at a checkpoint.
    pub(super) fn resume(folder: &RunFolder, length: RecordLength) -> Result<Self, Error> {
        let series = Appending::resume(folder.series(), length.series)?;
        let events = Appending::resume(folder.events(), length.events)?;
        let outdated = (length.frames..).map(|number| folder.frames().join(frame_name(number)));
        for frame in outdated.take_while(|path| path.exists()) {
            for path in [frame.with_extension(SURFACES), frame].into_iter().filter(|path| path.exists()) {
                std::fs::remove_file(&path).map_err(|cause| Error::Io(path, cause))?;
            }
        }
        Ok(Self { folder: folder.clone(), series, events, frames: length.frames })
    }

    /// The present length.
    pub(super) fn length(&self) -> RecordLength {
        RecordLength { series: self.series.length(), events: self.events.length(), frames: self.frames }
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
        let path = self.folder.frames().join(frame_name(self.frames));
        // Surfaces are written first, so that an existing frame is complete.
        if !system.surfaces.is_empty() {
            write_atomically(&path.with_extension(SURFACES), wavefront(system).as_bytes())?;
        }
        write_atomically(&path, extended_xyz(system, stage).as_bytes())?;
        self.frames += 1;
        Ok(())
    }
}
