//! The layout of a run folder.

use super::series::{PROFILES, SERIES, WINDOWS, is_table, stage_file};
use super::{Checkpoints, create_folder};
use crate::error::{AtPath, Error};
use std::path::{Path, PathBuf};

pub(super) const FRAMES: &str = "frames";
pub(super) const FIGURES: &str = "figures";
pub(super) const CHECKPOINTS: &str = "checkpoints";
/// The folder of copies of the files that a run reads.
pub const INPUTS: &str = "inputs";

/// The files that a run writes into its folder, beside those folders, its lock and its tables.
pub(super) const FILES: [&str; 8] = [
    "case.yaml",
    "case.resolved.yaml",
    "manifest.json",
    "events.jsonl",
    "results.yaml",
    "report.html",
    "movie.gif",
    "halted.xyz",
];

/// The folder of one run.
#[derive(Clone, Debug)]
pub struct RunFolder {
    root: PathBuf,
}

impl RunFolder {
    /// The folder of a run that need not exist.
    pub fn at(root: &Path) -> Self {
        Self { root: root.into() }
    }

    /// The folder of an existing run.
    ///
    /// # Errors
    ///
    /// If it is no run folder.
    pub fn open(root: &Path) -> Result<Self, Error> {
        let folder = Self { root: root.into() };
        std::fs::metadata(folder.case()).map_err(|cause| Error::NoInput(folder.case(), cause))?;
        Ok(folder)
    }

    /// Creates the folders in it that are missing.
    ///
    /// # Errors
    ///
    /// If a folder cannot be created.
    pub fn complete(&self) -> Result<(), Error> {
        [self.frames(), self.checkpoint_folder(), self.figures()].iter().try_for_each(|path| create_folder(path))
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }
    /// The user's file, verbatim.
    pub fn case(&self) -> PathBuf {
        self.root.join("case.yaml")
    }
    /// The case with every default and derived value.
    pub fn resolved(&self) -> PathBuf {
        self.root.join("case.resolved.yaml")
    }
    /// The provenance of the run.
    pub fn manifest(&self) -> PathBuf {
        self.root.join("manifest.json")
    }
    /// The time series of all stages.
    pub fn series(&self) -> PathBuf {
        self.root.join(SERIES)
    }
    /// The time series of the columns that only this stage has.
    pub fn series_of(&self, stage: &str) -> PathBuf {
        self.root.join(stage_file(stage))
    }
    /// The means over windows.
    pub fn windows(&self) -> PathBuf {
        self.root.join(WINDOWS)
    }
    /// The profiles: a row for every layer.
    pub fn profiles(&self) -> PathBuf {
        self.root.join(PROFILES)
    }
    /// The tables, that of all stages first.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read.
    pub fn tables(&self) -> Result<Vec<PathBuf>, Error> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(&self.root).at(&self.root)? {
            let path = entry.at(&self.root)?.path();
            if path.file_name().and_then(|name| name.to_str()).is_some_and(is_table) {
                found.push(path);
            }
        }
        found.sort();
        found.sort_by_key(|path| *path != self.series());
        Ok(found)
    }
    /// The events, one JSON object per line.
    pub fn events(&self) -> PathBuf {
        self.root.join("events.jsonl")
    }
    /// The final quantities.
    pub fn results(&self) -> PathBuf {
        self.root.join("results.yaml")
    }
    /// The frames: states of the particles, one file each.
    pub fn frames(&self) -> PathBuf {
        self.root.join(FRAMES)
    }
    /// The pictures.
    pub fn figures(&self) -> PathBuf {
        self.root.join(FIGURES)
    }
    /// The report, for a first look.
    pub fn report(&self) -> PathBuf {
        self.root.join("report.html")
    }
    /// The film, if one was asked for.
    pub fn movie(&self) -> PathBuf {
        self.root.join("movie.gif")
    }
    /// The state in which the simulation halted.
    pub fn halted(&self) -> PathBuf {
        self.root.join("halted.xyz")
    }
    /// Copies of the files that the run reads.
    pub fn inputs(&self) -> PathBuf {
        self.root.join(INPUTS)
    }
    fn checkpoint_folder(&self) -> PathBuf {
        self.root.join(CHECKPOINTS)
    }
    /// The checkpoints.
    pub fn checkpoints(&self) -> Checkpoints {
        Checkpoints::new(self.checkpoint_folder())
    }

    /// The reproducible files of a finished run, the same on any machine at any time, sorted.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read.
    pub fn outputs(&self) -> Result<Vec<PathBuf>, Error> {
        let mut found = vec![self.case(), self.resolved(), self.events(), self.results()];
        found.extend(self.tables()?);
        for entry in std::fs::read_dir(self.frames()).at(&self.frames())? {
            found.push(entry.at(&self.frames())?.path());
        }
        found.retain(|path| path.exists());
        found.sort();
        Ok(found)
    }
}
