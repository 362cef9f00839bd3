//! Complete states on disk: a heading, a checksum, and the state.

use super::files::{read, write_atomically};
use crate::error::{AtPath, Error};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// The kind of a saved state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SavedKind {
    /// A checkpoint, from which a run can be resumed.
    Checkpoint,
    /// An equilibrated sample.
    Sample,
}

impl SavedKind {
    fn heading(self) -> &'static [u8] {
        match self {
            Self::Checkpoint => b"veridem checkpoint 1\n",
            Self::Sample => b"veridem sample 1\n",
        }
    }
}

/// Writes a state.
///
/// # Errors
///
/// If the file cannot be written.
pub fn save_state<T: Serialize>(path: &Path, what: SavedKind, state: &T) -> Result<(), Error> {
    let body = postcard::to_allocvec(state).expect("a state is plain data");
    let checksum = crc32fast::hash(&body).to_le_bytes();
    write_atomically(path, &[what.heading(), &checksum, &body].concat())
}

/// Reads a state.
///
/// # Errors
///
/// If the file cannot be read, is damaged, or holds another kind of state.
pub fn load_state<T: DeserializeOwned>(path: &Path, what: SavedKind) -> Result<T, Error> {
    let bytes = read(path)?;
    let rest = bytes.strip_prefix(what.heading());
    let (checksum, body) = rest.and_then(|rest| rest.split_at_checked(4)).ok_or_else(|| {
        let heading = String::from_utf8_lossy(what.heading());
        Error::input(path, format!("does not begin with `{}`", heading.trim_end()))
    })?;
    if crc32fast::hash(body).to_le_bytes() != checksum {
        return Err(Error::input(path, "is damaged: its checksum does not match"));
    }
    postcard::from_bytes(body).map_err(|_| Error::input(path, "was written by another version"))
}

/// The checkpoints of a run: the last two regular ones, and the one at which it was stopped.
pub struct Checkpoints {
    folder: PathBuf,
}

const EXTENSION: &str = "checkpoint";
const STOPPED: &str = "stopped";

impl Checkpoints {
    /// The checkpoints in `folder`.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name).with_extension(EXTENSION)
    }

    /// Whether there is no checkpoint.
    ///
    /// # Errors
    ///
    /// If the folder cannot be read.
    pub fn is_empty(&self) -> Result<bool, Error> {
        Ok(self.due()?.is_empty() && !self.path(STOPPED).exists())
    }

    /// The regular checkpoints, oldest first.
    fn due(&self) -> Result<Vec<PathBuf>, Error> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(&self.folder).at(&self.folder)? {
            let path = entry.at(&self.folder)?.path();
            if path.extension().is_some_and(|e| e == EXTENSION) && path != self.path(STOPPED) {
                found.push(path);
            }
        }
        found.sort();
        Ok(found)
    }

    /// Saves the state after a number of steps; removes all but the last two, and the checkpoint of an earlier stop.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn save<T: Serialize>(&self, steps: u64, state: &T) -> Result<(), Error> {
        save_state(&self.path(&format!("{steps:012}")), SavedKind::Checkpoint, state)?;
        let due = self.due()?;
        for path in &due[..due.len().saturating_sub(2)] {
            std::fs::remove_file(path).at(path)?;
        }
        self.forget_stopped()
    }

    /// Removes the checkpoint of a stop, which the resumed run has passed.
    ///
    /// # Errors
    ///
    /// If the file cannot be removed.
    pub fn forget_stopped(&self) -> Result<(), Error> {
        let stopped = self.path(STOPPED);
        if stopped.exists() { std::fs::remove_file(&stopped).at(&stopped) } else { Ok(()) }
    }

    /// Saves the state in which a run is stopped.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn keep_stopped<T: Serialize>(&self, state: &T) -> Result<(), Error> {
        save_state(&self.path(STOPPED), SavedKind::Checkpoint, state)
    }

    /// The latest readable state; the error of the latest if none is readable.
    ///
    /// # Errors
    ///
    /// If there is no checkpoint, or none can be read.
    pub fn latest<T: DeserializeOwned>(&self) -> Result<T, Error> {
        let candidates = [self.path(STOPPED)].into_iter().filter(|path| path.exists());
        let mut complaint = None;
        for path in candidates.chain(self.due()?.into_iter().rev()) {
            match load_state(&path, SavedKind::Checkpoint) {
                Ok(state) => return Ok(state),
                Err(error) => complaint = complaint.or(Some(error)),
            }
        }
        Err(complaint.unwrap_or_else(|| Error::input(&self.folder, "holds no checkpoint")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_comes_back_bit_by_bit_and_damage_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state");
        let state = vec![0.1, -0.0, f64::MIN_POSITIVE / 3.0, f64::INFINITY];
        save_state(&path, SavedKind::Sample, &state).unwrap();
        assert_eq!(load_state::<Vec<f64>>(&path, SavedKind::Sample).unwrap(), state);
        assert_eq!(
            load_state::<Vec<f64>>(&path, SavedKind::Checkpoint).unwrap_err().to_string(),
            format!("{}: does not begin with `veridem checkpoint 1`", path.display())
        );
        let mut bytes = std::fs::read(&path).unwrap();
        *bytes.last_mut().unwrap() ^= 1;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(
            load_state::<Vec<f64>>(&path, SavedKind::Sample).unwrap_err().to_string(),
            format!("{}: is damaged: its checksum does not match", path.display())
        );
    }

    #[test]
    fn the_last_two_are_kept_and_a_damaged_one_is_passed_over() {
        let folder = tempfile::tempdir().unwrap();
        let checkpoints = Checkpoints::new(folder.path().into());
        for step in [10u64, 200, 3000] {
            checkpoints.save(step, &step).unwrap();
        }
        assert_eq!(checkpoints.due().unwrap().len(), 2);
        assert_eq!(checkpoints.latest::<u64>().unwrap(), 3000);
        std::fs::write(checkpoints.path("000000003000"), b"half a file").unwrap();
        assert_eq!(checkpoints.latest::<u64>().unwrap(), 200);
        checkpoints.keep_stopped(&2500u64).unwrap();
        assert_eq!(checkpoints.latest::<u64>().unwrap(), 2500);
        checkpoints.save(4000, &4000u64).unwrap();
        assert_eq!(checkpoints.latest::<u64>().unwrap(), 4000);
    }
}
