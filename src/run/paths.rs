//! The paths in a case: from which folder they go, and what a run keeps of the files.

use crate::error::{Error, read_file};
use crate::output::{INPUTS, Manifest, RunFolder, sha256, sha256_file};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Largest size of a file of which a run keeps a copy, bytes.
const KEPT: u64 = 1 << 20;

/// A path in a case.
#[derive(Clone, Debug, PartialEq)]
pub struct CasePath {
    /// As it is written.
    pub written: PathBuf,
    /// The folder of the case, if the path goes from there.
    pub from: Option<PathBuf>,
    /// The file.
    pub place: PathBuf,
}

/// Where the paths in a case lead.
#[derive(Debug)]
pub struct Paths {
    folder: PathBuf,
    /// The files of a run, by the paths in its case.
    known: BTreeMap<String, String>,
}

impl Paths {
    /// The paths in a case file: relative ones go from its folder, or from the working directory if the case is not in a file, as in a pipe. In the case of a run folder they lead
    /// to the files of that run: to the copies in it, wherever the originals are now.
    pub fn of(case: &Path) -> Self {
        if std::fs::metadata(case).is_ok_and(|found| !found.is_file()) {
            return Self { folder: PathBuf::new(), known: BTreeMap::new() };
        }
        let folder = case.parent().map_or(PathBuf::new(), Path::to_path_buf);
        let run = RunFolder::at(&folder);
        let manifest = if run.case() == case { Manifest::read(&run).ok() } else { None };
        Self { folder, known: manifest.map_or(BTreeMap::new(), |manifest| manifest.files) }
    }

    /// Replaces a path by the file to which it leads.
    pub fn lead(&self, path: &mut PathBuf) -> CasePath {
        let written = path.clone();
        let known = self.known.get(&written.display().to_string());
        *path = self.folder.join(known.map_or(written.as_path(), Path::new));
        let from = (known.is_none() && written.is_relative()).then(|| self.folder.clone());
        CasePath { written, from, place: path.clone() }
    }
}

/// The files of a run.
#[derive(Debug, Default)]
pub(super) struct Files {
    /// Where they are, by the paths in the case: copies relative to the run folder, all others by absolute paths.
    pub places: BTreeMap<String, String>,
    /// Hashes of those that are read, by their places.
    pub hashes: BTreeMap<String, String>,
    /// Copies of those that are small, by their names.
    pub copies: Vec<(String, Vec<u8>)>,
}

impl Files {
    /// Reads the small files of a case, and takes the hashes of all.
    ///
    /// # Errors
    ///
    /// If a file cannot be read.
    pub(super) fn of<'a>(reads: &[CasePath], saves: impl Iterator<Item = &'a CasePath>) -> Result<Self, Error> {
        let mut files = Self::default();
        for CasePath { written, place, .. } in reads {
            let written = written.display().to_string();
            if files.places.contains_key(&written) {
                continue;
            }
            let is_small = std::fs::metadata(place).is_ok_and(|file| file.len() <= KEPT);
            let (at, hash) = if is_small {
                let bytes = read_file(place)?;
                let hash = sha256(&bytes);
                (format!("{INPUTS}/{}", files.keep(place, bytes)), hash)
            } else {
                (absolute(place).display().to_string(), sha256_file(place)?)
            };
            files.hashes.insert(at.clone(), hash);
            files.places.insert(written, at);
        }
        for CasePath { written, place, .. } in saves {
            files.places.insert(written.display().to_string(), absolute(place).display().to_string());
        }
        Ok(files)
    }

    /// Keeps a copy; returns its name, which is that of the file unless another has it.
    fn keep(&mut self, file: &Path, bytes: Vec<u8>) -> String {
        if let Some((name, _)) = self.copies.iter().find(|(_, kept)| *kept == bytes) {
            return name.clone();
        }
        let own = file.file_name().unwrap_or_default().to_string_lossy();
        let taken = |name: &str| self.copies.iter().any(|(other, _)| other == name);
        let numbered = (2..).map(|number| format!("{number} {own}"));
        let name = std::iter::once(own.to_string()).chain(numbered).find(|name| !taken(name)).expect("a free name");
        self.copies.push((name.clone(), bytes));
        name
    }
}

/// The one path of a file, which need not exist.
pub(super) fn absolute(path: &Path) -> PathBuf {
    // The parent of a mere name is empty.
    let canonical = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        std::fs::canonicalize(path).ok()
    };
    let in_folder = || Some(canonical(path.parent()?)?.join(path.file_name()?));
    canonical(path).or_else(in_folder).or_else(|| std::path::absolute(path).ok()).unwrap_or_else(|| path.into())
}
