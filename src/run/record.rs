//! Writes the output of a run as it proceeds.

use crate::case::Format;
use crate::error::{AtPath, Error};
use crate::output::{Appending, Cell, Fingerprint, Frame, FrameName, Layout, RunFolder, collections, write_atomically};
use crate::system::System;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::path::PathBuf;

/// The record at a checkpoint, to which its files are truncated when the run is resumed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Recorded {
    /// Of each table.
    tables: Vec<Fingerprint>,
    events: Fingerprint,
    frames: Vec<Framed>,
}

/// A frame that has been written: its files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Framed {
    name: FrameName,
    /// Time, ns.
    time: f64,
    files: Vec<(String, Fingerprint)>,
}

impl Framed {
    /// Its files: name, ending and time.
    fn listed(&self) -> impl Iterator<Item = (&FrameName, &str, f64)> {
        self.files.iter().map(|(ending, _)| (&self.name, &**ending, self.time))
    }
}

impl Recorded {
    /// Checks that the record of a folder begins with this one; returns the files of frames that are missing, which a run does not need to be
    /// resumed.
    pub(super) fn check(&self, folder: &RunFolder, layout: &Layout) -> Result<Vec<PathBuf>, Error> {
        if self.tables.len() != layout.tables.len() {
            return Err(Error::input(folder.root(), "has other tables than the checkpoint knows"));
        }
        for (fingerprint, table) in self.tables.iter().zip(&layout.tables) {
            fingerprint.check(&folder.root().join(&table.file))?;
        }
        self.events.check(&folder.events())?;
        let mut missing = Vec::new();
        for Framed { name, files, .. } in &self.frames {
            for (ending, fingerprint) in files {
                let path = folder.frames().join(name.file(ending));
                if path.exists() { fingerprint.check(&path)? } else { missing.push(path) }
            }
        }
        Ok(missing)
    }
}

/// The growing files of a run folder.
pub(super) struct Record {
    folder: RunFolder,
    layout: Layout,
    tables: Vec<Appending>,
    events: Appending,
    frames: Vec<Framed>,
}

impl Record {
    /// Creates the record of a new run.
    pub(super) fn begin(folder: &RunFolder, layout: Layout) -> Result<Self, Error> {
        remove_frames_but(folder, &[])?;
        let mut tables = Vec::new();
        for table in &layout.tables {
            let mut file = Appending::create(folder.root().join(&table.file))?;
            file.line(&table.columns.join(","))?;
            tables.push(file);
        }
        let events = Appending::create(folder.events())?;
        Ok(Self { folder: folder.clone(), layout, tables, events, frames: Vec::new() })
    }

    /// Restores a record to its state at a checkpoint.
    pub(super) fn resume(folder: &RunFolder, layout: Layout, recorded: Recorded) -> Result<Self, Error> {
        let Recorded { tables, events, frames } = recorded;
        let file = |(then, table): (&Fingerprint, &crate::output::Table)| {
            Appending::resume(folder.root().join(&table.file), then)
        };
        let tables = tables.iter().zip(&layout.tables).map(file).collect::<Result<_, _>>()?;
        let events = Appending::resume(folder.events(), &events)?;
        remove_frames_but(folder, &frames)?;
        Ok(Self { folder: folder.clone(), layout, tables, events, frames })
    }

    /// Makes the record survive a power failure; returns its present state.
    pub(super) fn sync(&self) -> Result<Recorded, Error> {
        for (name, text) in collections(self.frames.iter().flat_map(Framed::listed)) {
            write_atomically(&self.folder.frames().join(name), text.as_bytes())?;
        }
        let tables = self.tables.iter().map(Appending::sync).collect::<Result<_, _>>()?;
        Ok(Recorded { tables, events: self.events.sync()?, frames: self.frames.clone() })
    }

    /// Appends a row of a stage to the series.
    pub(super) fn row(&mut self, stage: usize, cells: &[Cell]) -> Result<(), Error> {
        self.layout.lines(stage, cells).into_iter().try_for_each(|(table, line)| self.tables[table].line(&line))
    }

    /// Appends a row to the table of windows.
    pub(super) fn window(&mut self, cells: &[Cell]) -> Result<(), Error> {
        let table = self.layout.windows().expect("a study with windows has columns of them");
        self.tables[table].line(&crate::output::row(cells))
    }

    /// Appends a row to the table of profiles.
    pub(super) fn profile(&mut self, cells: &[Cell]) -> Result<(), Error> {
        let table = self.layout.profiles().expect("a study with profiles has columns of them");
        self.tables[table].line(&crate::output::row(cells))
    }

    /// Appends an event.
    pub(super) fn event(&mut self, stage: &str, system: &System, event: &str) -> Result<(), Error> {
        let event = json!({ "stage": stage, "step": system.step, "time_ns": system.time, "event": event });
        self.events.line(&event.to_string())
    }

    /// Writes the next frame of a stage in the formats asked for.
    pub(super) fn frame(&mut self, frame: &Frame, formats: &[Format]) -> Result<(), Error> {
        let name = FrameName::after(self.frames.last().map(|frame| &frame.name), frame.stage());
        let mut files = Vec::new();
        // That of the spheres comes last, so that an existing frame is complete.
        for (ending, bytes) in frame.files(formats) {
            write_atomically(&self.folder.frames().join(name.file(&ending)), &bytes)?;
            files.push((ending, Fingerprint::of(&bytes)));
        }
        self.frames.push(Framed { name, time: frame.time(), files });
        Ok(())
    }
}

/// Removes the frames that a process wrote after the checkpoint from which the run is resumed.
fn remove_frames_but(folder: &RunFolder, kept: &[Framed]) -> Result<(), Error> {
    let kept: std::collections::BTreeSet<String> =
        kept.iter().flat_map(|frame| frame.files.iter().map(|(ending, _)| frame.name.file(ending))).collect();
    for entry in std::fs::read_dir(folder.frames()).at(&folder.frames())? {
        let path = entry.at(&folder.frames())?.path();
        let name = path.file_name().unwrap_or_default();
        if FrameName::of_file(name).is_some() && name.to_str().is_none_or(|name| !kept.contains(name)) {
            std::fs::remove_file(&path).at(&path)?;
        }
    }
    Ok(())
}
