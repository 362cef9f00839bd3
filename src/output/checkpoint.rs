//! Complete states on disk: a heading, a checksum, and the state.

use super::files::{sha256, sync_folder, with_suffix, write_atomically};
use super::{Manifest, read};
use crate::error::{AtPath, Error, Problem};
use crate::system::System;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The kind of a saved state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SavedKind {
    /// A checkpoint, from which a run can be resumed.
    Checkpoint,
    /// An equilibrated sample.
    Sample,
}

impl SavedKind {
    fn heading(self) -> &'static [u8] {
        match self {
            Self::Checkpoint => b"veridem checkpoint 2\n",
            Self::Sample => b"veridem sample 1\n",
        }
    }
}

/// Writes a state.
///
/// # Errors
///
/// If the file cannot be written.
fn save_state<T: Serialize>(path: &Path, what: SavedKind, state: &T) -> Result<(), Error> {
    let body = postcard::to_allocvec(state).expect("a state is plain data");
    let checksum = crc32fast::hash(&body).to_le_bytes();
    write_atomically(path, &[what.heading(), &checksum, &body].concat())
}

/// Writes a sample with the parameters that it was made from.
///
/// # Errors
///
/// If the file cannot be written.
pub fn save_sample(path: &Path, origin: &str, system: &System) -> Result<(), Error> {
    save_state(path, SavedKind::Sample, &(origin, system))
}

/// Reads a sample that was made from these parameters, among them `parts`.
///
/// # Errors
///
/// If the file cannot be read, is damaged, or holds another sample or none that a run can have.
pub fn load_sample(path: &Path, origin: &str, parts: &str) -> Result<System, Error> {
    let (found, system): (String, System) = load_state(path, SavedKind::Sample)?;
    if found != origin {
        return Err(Error::input(path, format!("was made with another {parts}")));
    }
    if system.is_sound() { Ok(system) } else { Err(Error::input(path, "holds numbers or lengths that no sample has")) }
}

/// Reads a state.
fn load_state<T: DeserializeOwned>(path: &Path, what: SavedKind) -> Result<T, Error> {
    postcard::from_bytes(&body(path, what)?).map_err(|_| Error::input(path, "was written by another version"))
}

/// The part of a saved state that the checksum protects.
fn body(path: &Path, what: SavedKind) -> Result<Vec<u8>, Error> {
    let bytes = read(path)?;
    let rest = bytes.strip_prefix(what.heading());
    let (checksum, body) = rest.and_then(|rest| rest.split_at_checked(4)).ok_or_else(|| {
        let heading = String::from_utf8_lossy(what.heading());
        Error::input(path, format!("does not begin with `{}`", heading.trim_end()))
    })?;
    if crc32fast::hash(body).to_le_bytes() != checksum {
        return Err(Error::input(path, "is damaged: its checksum does not match"));
    }
    Ok(body.to_vec())
}

/// The size of a saved state, in bytes.
pub fn encoded_size<T: Serialize>(state: &T) -> usize {
    postcard::to_allocvec(state).expect("a state is plain data").len()
}

/// The SHA-256 of a state: every number of it, bit by bit.
pub fn state_hash<T: Serialize>(state: &T) -> String {
    sha256(&postcard::to_allocvec(state).expect("a state is plain data"))
}

/// The run that a checkpoint belongs to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    version: String,
    inputs: BTreeMap<String, String>,
}

impl Origin {
    /// The run of a manifest.
    pub fn of(manifest: &Manifest) -> Self {
        Self { version: env!("CARGO_PKG_VERSION").into(), inputs: manifest.inputs.clone() }
    }

    /// The files in which two runs differ.
    fn differences<'a>(&'a self, other: &'a Self) -> Vec<&'a str> {
        let missing = |a: &'a Self, b: &'a Self| a.inputs.iter().filter(|input| b.inputs.get(input.0) != Some(input.1));
        let mut names: Vec<&str> =
            missing(self, other).chain(missing(other, self)).map(|input| input.0.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
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
        with_suffix(self.folder.join(name), EXTENSION)
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
        let entries = match std::fs::read_dir(&self.folder) {
            Err(cause) if cause.kind() == ErrorKind::NotFound => return Ok(found),
            entries => entries.at(&self.folder)?,
        };
        for entry in entries {
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
    pub fn save<T: Serialize>(&self, steps: u64, origin: &Origin, state: &T) -> Result<(), Error> {
        save_state(&self.path(&format!("{steps:012}")), SavedKind::Checkpoint, &(origin, state))?;
        self.prune()
    }

    /// Removes all but the last two, and the checkpoint of a stop, which the resumed run has passed.
    ///
    /// # Errors
    ///
    /// If a file cannot be removed.
    pub fn prune(&self) -> Result<(), Error> {
        let due = self.due()?;
        let stopped = Some(self.path(STOPPED)).filter(|path| path.exists());
        let passed: Vec<&PathBuf> = due[..due.len().saturating_sub(2)].iter().chain(&stopped).collect();
        passed.iter().try_for_each(|path| std::fs::remove_file(path).at(path))?;
        if passed.is_empty() { Ok(()) } else { sync_folder(&self.folder) }
    }

    /// Saves the state in which a run is stopped.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn keep_stopped<T: Serialize>(&self, origin: &Origin, state: &T) -> Result<(), Error> {
        save_state(&self.path(STOPPED), SavedKind::Checkpoint, &(origin, state))
    }

    /// What `accept` makes of the latest state that it accepts, and the problems of those that were passed over.
    ///
    /// # Errors
    ///
    /// If there is none, or one of another run; if a file cannot be read.
    pub fn latest<T: DeserializeOwned, U>(
        &self,
        origin: &Origin,
        mut accept: impl FnMut(&Path, T) -> Result<U, Error>,
    ) -> Result<(U, Vec<Problem>), Error> {
        let candidates = [self.path(STOPPED)].into_iter().filter(|path| path.exists());
        let mut passed_over = Vec::new();
        for path in candidates.chain(self.due()?.into_iter().rev()) {
            let body = match body(&path, SavedKind::Checkpoint) {
                Ok(body) => body,
                Err(Error::Input(problems)) => {
                    passed_over.extend(problems);
                    continue;
                }
                Err(error) => return Err(error),
            };
            let unknown = |by: &str| Error::input(&path, format!("was written by another version{by}"));
            let state = postcard::take_from_bytes::<Origin>(&body).map_err(|_| unknown("")).and_then(|(of, state)| {
                let others = of.differences(origin);
                if !others.is_empty() {
                    return Ok(Err(Error::input(
                        &path,
                        format!("belongs to another run than manifest.json: {} differs", others.join(", ")),
                    )));
                }
                let (state, rest) =
                    postcard::take_from_bytes(state).map_err(|_| unknown(&format!(", {}", of.version)))?;
                if !rest.is_empty() {
                    return Err(Error::input(&path, "holds more than the state of a run"));
                }
                accept(&path, state).map(Ok)
            });
            match state {
                // It was put here by hand: the user decides.
                Ok(Err(stranger)) => return Err(stranger),
                Ok(Ok(state)) => return Ok((state, passed_over)),
                Err(Error::Input(problems)) => passed_over.extend(problems),
                Err(error) => return Err(error),
            }
        }
        let what = "holds no checkpoint from which the run can be resumed".into();
        passed_over.push(Problem { file: self.folder.clone(), line: None, key: String::new(), what });
        Err(Error::Input(passed_over))
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
            format!("{}: does not begin with `veridem checkpoint 2`", path.display())
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
        let of = |hash: &str| Origin { version: "1".into(), inputs: [("a.yaml".into(), hash.into())].into() };
        let origin = of("a");
        for step in [10u64, 200, 3000] {
            checkpoints.save(step, &origin, &step).unwrap();
        }
        assert_eq!(checkpoints.due().unwrap().len(), 2);
        let latest = |fits: &dyn Fn(&u64) -> bool| {
            let accept = |_: &Path, state: u64| {
                if fits(&state) { Ok(state) } else { Err(Error::input(folder.path(), "differs")) }
            };
            checkpoints.latest(&origin, accept).map(|(state, passed_over)| (state, passed_over.len()))
        };
        assert_eq!(latest(&|_| true).unwrap(), (3000, 0));
        assert_eq!(latest(&|&state| state < 3000).unwrap(), (200, 1));
        std::fs::write(checkpoints.path("000000003000"), b"half a file").unwrap();
        assert_eq!(latest(&|_| true).unwrap(), (200, 1));
        assert_eq!(latest(&|_| false).unwrap_err().to_string().lines().count(), 3);
        checkpoints.keep_stopped(&origin, &2500u64).unwrap();
        assert_eq!(latest(&|_| true).unwrap(), (2500, 0));
        checkpoints.save(4000, &origin, &4000u64).unwrap();
        assert_eq!(latest(&|_| true).unwrap(), (4000, 0));
        assert!(!checkpoints.path(STOPPED).exists());
        checkpoints.save(5000, &of("b"), &5000u64).unwrap();
        let refused = latest(&|_| true).unwrap_err().to_string();
        assert!(
            refused.ends_with("000000005000.checkpoint: belongs to another run than manifest.json: a.yaml differs"),
            "{refused}"
        );
    }
}
