//! The layout of a run folder.

use super::{Checkpoints, create_folder};
use crate::error::{AtPath, Error};
use std::path::{Path, PathBuf};

/// The folder of one run.
#[derive(Clone, Debug)]
pub struct RunFolder {
    root: PathBuf,
}

impl RunFolder {
    /// Creates a new folder; an existing one is replaced only if forced, and only if it is a run folder.
    ///
    /// # Errors
    ///
    /// If the folder exists and is not to be replaced, is no run folder, or cannot be written.
    pub fn create(root: &Path, force: bool) -> Result<Self, Error> {
        let folder = Self { root: root.into() };
        if root.exists() {
            if !force {
                let what =
                    format!("{}: exists already; use --force to replace it, or --name for another", root.display());
                return Err(Error::Usage(what));
            }
            if !folder.case().exists() {
                return Err(Error::Usage(format!("{}: is not a run folder and is not replaced", root.display())));
            }
            std::fs::remove_dir_all(root).at(root)?;
        }
        folder.complete()?;
        Ok(folder)
    }

    /// Removes a folder left by a run that was killed before its manifest was written; returns whether the folder is gone.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read or removed.
    pub fn clear(root: &Path) -> Result<bool, Error> {
        let folder = Self { root: root.into() };
        if !root.exists() {
            return Ok(true);
        }
        let entries = |path: &Path| -> Result<Vec<PathBuf>, Error> {
            std::fs::read_dir(path).at(path)?.map(|entry| Ok(entry.at(path)?.path())).collect()
        };
        let folders = [folder.frames(), folder.checkpoint_folder(), folder.figures()];
        for path in entries(root)? {
            let left = if path.is_dir() {
                folders.contains(&path) && entries(&path)?.is_empty()
            } else {
                [folder.case(), folder.resolved()].contains(&path) || path.extension().is_some_and(|e| e == "part")
            };
            if !left {
                return Ok(false);
            }
        }
        std::fs::remove_dir_all(root).at(root)?;
        Ok(true)
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
    /// The time series.
    pub fn series(&self) -> PathBuf {
        self.root.join("series.csv")
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
        self.root.join("frames")
    }
    /// The pictures.
    pub fn figures(&self) -> PathBuf {
        self.root.join("figures")
    }
    /// The report, for a first look.
    pub fn report(&self) -> PathBuf {
        self.root.join("report.html")
    }
    /// The state in which the simulation halted.
    pub fn halted(&self) -> PathBuf {
        self.root.join("halted.xyz")
    }
    fn checkpoint_folder(&self) -> PathBuf {
        self.root.join("checkpoints")
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
        let mut found = vec![self.case(), self.resolved(), self.series(), self.events(), self.results()];
        for entry in std::fs::read_dir(self.frames()).at(&self.frames())? {
            found.push(entry.at(&self.frames())?.path());
        }
        found.retain(|path| path.exists());
        found.sort();
        Ok(found)
    }
}
