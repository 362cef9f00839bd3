//! The claim of a folder for a new run: nothing is lost but what an earlier run has made, and that only when the new one begins.

use super::folder::{CHECKPOINTS, FIGURES, FRAMES, INPUTS};
use super::lock::LOCK;
use super::series::is_table;
use super::{Lock, Manifest, RunFolder, Status, is_of_frames, sha256, sync_folder, write_atomically};
use crate::error::{AtPath, Error};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The state of the place of a run folder.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// Nothing, or what a run leaves that is killed before its manifest is written.
    Free,
    /// A run folder: its manifest knows its case.
    Run(Box<Manifest>),
    /// Something else.
    Other,
}

/// The right to begin a run in a folder.
pub struct Claim {
    folder: RunFolder,
    lock: Option<Lock>,
}

impl Claim {
    /// Claims a folder; an existing one is replaced only if forced, and only if it is a run folder. Nothing is replaced yet.
    ///
    /// # Errors
    ///
    /// If the folder exists and is not to be replaced, is no run folder, or is being written.
    pub fn new(root: &Path, force: bool) -> Result<Self, Error> {
        let folder = RunFolder::at(root);
        may_begin(&folder, force)?;
        let lock = if root.is_dir() { Some(Lock::take(root)?) } else { None };
        // The process that held the lock may have changed the place.
        may_begin(&folder, force)?;
        Ok(Self { folder, lock })
    }

    /// Whether a run is there that is to be replaced.
    pub fn replaces(&self) -> bool {
        matches!(Place::of(&self.folder), Ok(Place::Run(_)))
    }

    /// Begins a run: removes the files of an earlier one, and writes manifest, case, and copies of other inputs. Returns the folder, its lock, and the files
    /// of others that were left in it.
    ///
    /// # Errors
    ///
    /// If another process has begun a run there, or a file cannot be written or removed.
    pub fn begin(
        self,
        manifest: &Manifest,
        case: &str,
        resolved: &str,
        copies: &[(String, Vec<u8>)],
    ) -> Result<(RunFolder, Lock, Vec<PathBuf>), Error> {
        let Self { folder, lock } = self;
        super::create_folder(folder.root())?;
        let lock = match lock {
            Some(lock) => lock,
            None => {
                let lock = Lock::take(folder.root())?;
                may_begin(&folder, false)?;
                lock
            }
        };
        let mut made = Made::default();
        if let Place::Run(mut earlier) = Place::of(&folder)? {
            // Whenever the removal ends half way, no run is there that seems to be finished.
            earlier.status = Status::Stopped;
            earlier.write(&folder)?;
            made = Made { graphs: earlier.graphs, files: earlier.files };
        }
        let left = clear(&folder, &made)?;
        // The manifest comes first: by it a run folder is known. The case comes last: with it the run can be resumed.
        manifest.write(&folder)?;
        if !copies.is_empty() {
            super::create_folder(&folder.inputs())?;
        }
        for (name, bytes) in copies {
            write_atomically(&folder.inputs().join(name), bytes)?;
        }
        write_atomically(&folder.case(), case.as_bytes())?;
        write_atomically(&folder.resolved(), resolved.as_bytes())?;
        folder.complete()?;
        Ok((folder, lock, left))
    }
}

fn may_begin(folder: &RunFolder, force: bool) -> Result<(), Error> {
    let what = match Place::of(folder)? {
        Place::Free => return Ok(()),
        Place::Run(_) if force => return Ok(()),
        Place::Run(_) => "exists already; use --force to replace it, or --name for another",
        Place::Other => "is not a run folder and is not replaced; use --name for another",
    };
    Err(Error::Usage(format!("{}: {what}", folder.root().display())))
}

impl Place {
    /// What is at the place of a run folder.
    ///
    /// # Errors
    ///
    /// If it cannot be read.
    pub fn of(folder: &RunFolder) -> Result<Self, Error> {
        let root = folder.root();
        if std::fs::symlink_metadata(root).is_err_and(|cause| cause.kind() == ErrorKind::NotFound) {
            return Ok(Self::Free);
        }
        if !root.is_dir() {
            return Ok(Self::Other);
        }
        if let Ok(manifest) = Manifest::read(folder) {
            let known = match std::fs::read(folder.case()) {
                Ok(case) => manifest.knows(&sha256(&case)),
                // It was killed before it wrote its case, or while it was replaced.
                Err(cause) => cause.kind() == ErrorKind::NotFound,
            };
            return Ok(if known { Self::Run(Box::new(manifest)) } else { Self::Other });
        }
        let left = |path: PathBuf| -> Result<bool, Error> {
            let empty = || Ok::<_, Error>(entries(&path)?.is_empty());
            let name = path.file_name().unwrap_or_default();
            let folders = [FRAMES, FIGURES, CHECKPOINTS, INPUTS].iter().any(|folder| name == *folder);
            if folders { empty() } else { Ok(name == LOCK || is_part_of(name, &|name| own(name))) }
        };
        for path in entries(root)? {
            if !left(path)? {
                return Ok(Self::Other);
            }
        }
        Ok(Self::Free)
    }
}

/// What the manifest of a run says of the names of its files.
#[derive(Default)]
struct Made {
    graphs: Vec<String>,
    files: BTreeMap<String, String>,
}

/// Removes the files of an earlier run, but its manifest; returns the others.
fn clear(folder: &RunFolder, Made { graphs, files }: &Made) -> Result<Vec<PathBuf>, Error> {
    let figure = |name: &OsStr| name.to_str().is_some_and(|name| is_picture(name) || graphs.iter().any(|g| g == name));
    let copy = |name: &OsStr| files.values().any(|place| Path::new(place) == Path::new(INPUTS).join(name));
    let mut left = Vec::new();
    // Checkpoints come first: none survives the record that it speaks of.
    for name in [CHECKPOINTS, FRAMES, FIGURES, INPUTS] {
        let made: &dyn Fn(&OsStr) -> bool = match name {
            CHECKPOINTS => &is_checkpoint,
            FRAMES => &is_of_frames,
            INPUTS => &copy,
            _ => &figure,
        };
        let path = folder.root().join(name);
        match std::fs::symlink_metadata(&path) {
            Ok(found) if found.is_dir() => {
                left.extend(remove(&path, made)?);
                sync_folder(&path)?;
            }
            // A link is removed, not followed.
            Ok(_) => std::fs::remove_file(&path).at(&path)?,
            Err(_) => {}
        }
    }
    let others = remove(folder.root(), &|name| name != "manifest.json" && own(name))?;
    // A run that reads nothing has no such folder.
    std::fs::remove_dir(folder.inputs()).ok();
    let known = [FRAMES, FIGURES, CHECKPOINTS, INPUTS, LOCK, "manifest.json"];
    left.extend(others.into_iter().filter(|path| !known.iter().any(|name| path.file_name() == Some(OsStr::new(name)))));
    sync_folder(folder.root())?;
    Ok(left)
}

/// Removes the files in a folder that a run has `made`, and their remainders under a temporary name; returns the others.
fn remove(folder: &Path, made: &dyn Fn(&OsStr) -> bool) -> Result<Vec<PathBuf>, Error> {
    let mut left = Vec::new();
    for path in entries(folder)? {
        let name = path.file_name().unwrap_or_default();
        let is_folder = std::fs::symlink_metadata(&path).at(&path)?.is_dir();
        if !is_folder && (made(name) || is_part_of(name, made)) {
            std::fs::remove_file(&path).at(&path)?;
        } else {
            left.push(path);
        }
    }
    Ok(left)
}

fn entries(path: &Path) -> Result<Vec<PathBuf>, Error> {
    std::fs::read_dir(path).at(path)?.map(|entry| Ok(entry.at(path)?.path())).collect()
}

/// Whether a run writes a file of this name into the root of its folder.
fn own(name: &OsStr) -> bool {
    name.to_str().is_some_and(|name| super::folder::FILES.contains(&name) || is_table(name))
}

/// Whether this is the temporary name of a file that is `made`.
fn is_part_of(name: &OsStr, made: &dyn Fn(&OsStr) -> bool) -> bool {
    name.to_str().and_then(|name| name.strip_suffix(".part")).is_some_and(|name| made(OsStr::new(name)))
}

fn is_number(text: &str, digits: usize) -> bool {
    text.len() >= digits && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn is_checkpoint(name: &OsStr) -> bool {
    let number = name.to_str().and_then(|name| name.strip_suffix(".checkpoint"));
    number.is_some_and(|number| number == "stopped" || is_number(number, 12))
}

/// Whether a picture of a stage has this name: `shearing begin.svg`, `pulling 2 after 1 of 4 parts.svg`.
fn is_picture(name: &str) -> bool {
    let words: Vec<&str> = name.strip_suffix(".svg").unwrap_or_default().split(' ').collect();
    match words.as_slice() {
        [_, .., "after", part, "of", parts, "parts"] => is_number(part, 1) && is_number(parts, 1),
        [_, .., "begin" | "end"] => true,
        _ => false,
    }
}

impl RunFolder {
    /// Whether a file is one of those that a run writes into this folder, or may be.
    pub fn makes(&self, path: &Path) -> bool {
        let Ok(within) = path.strip_prefix(self.root()) else { return false };
        let name = within.file_name().unwrap_or_default();
        match within.components().count() {
            1 => own(name) || name == LOCK || is_part_of(name, &|name| own(name)),
            2 => [FRAMES, FIGURES, CHECKPOINTS, INPUTS].iter().any(|folder| within.starts_with(folder)),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_of_a_run_are_known_by_their_names() {
        for name in ["shearing begin.svg", "pulling 2 end.svg", "shearing after 2 of 3 parts.svg"] {
            assert!(is_picture(name), "{name}");
        }
        for name in ["begin.svg", "end", "mine.svg", "shearing after x of 3 parts.svg", "shearing begin.png"] {
            assert!(!is_picture(name), "{name}");
        }
        let folder = RunFolder::at(Path::new("run/x"));
        let makes = |name: &str| folder.makes(&Path::new("run/x").join(name));
        assert!(
            makes("series.csv")
                && makes("series.shear.csv")
                && makes("windows.csv")
                && makes("profiles.csv")
                && makes("series.csv.part")
                && makes("frames/a.bin")
                && makes("lock")
        );
        assert!(!makes("sample.bin") && !makes("mine/series.csv") && !folder.makes(Path::new("run/series.csv")));
    }
}
