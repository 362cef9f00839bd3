//! The files beside a run folder that a run reads and saves.

use super::paths::{CasePath, absolute};
use crate::error::{Error, Problem, not_opened};
use crate::output::{Manifest, Place, RunFolder, sha256_file};
use std::io;
use std::path::{Path, PathBuf};

/// Checks that a file can be read.
pub(super) fn is_there(file: &CasePath) -> Result<(), Error> {
    std::fs::metadata(&file.place).map(drop).map_err(|cause| {
        let cause = match file.from.as_deref().map(absolute) {
            Some(from) => {
                let goes = format!("`{}` goes from {}, the folder of the case", file.written.display(), from.display());
                io::Error::new(cause.kind(), format!("{cause}; {goes}"))
            }
            None => cause,
        };
        not_opened(&file.place, cause)
    })
}

/// Checks that files have not changed since a run was started.
pub(super) fn unchanged<'a>(files: impl Iterator<Item = &'a CasePath>, manifest: &Manifest) -> Result<(), Error> {
    for file in files {
        is_there(file)?;
        if manifest.hash_of(&file.written) != Some(&sha256_file(&file.place)?) {
            return Err(Error::input(&file.place, "has changed since the run was started"));
        }
    }
    Ok(())
}

/// Checks that files can be saved, each by the section that asks for it: the folder exists or is created by the run, and no file is
/// saved twice, read, or written by a run into its folder.
pub(super) fn savable(saves: &[(String, CasePath)], reads: &[&Path], root: &Path) -> Result<(), Error> {
    for (number, (section, CasePath { written, place: file, .. })) in saves.iter().enumerate() {
        // The parent of a mere name is empty.
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
        let no_folder =
            folder.is_some_and(|folder| !folder.is_dir() && !root.ancestors().any(|of_run| of_run == folder));
        let path = absolute(file);
        let other = saves[..number].iter().find(|(_, other)| absolute(&other.place) == path);
        let expected = if no_folder {
            "a file in a folder that exists".into()
        } else if let Some((other, _)) = other {
            format!("another file than `{other}.save`")
        } else if reads.iter().any(|read| absolute(read) == path) {
            "another file than those that the case reads".into()
        } else if belongs_to_a_run(&path, root) {
            "a file that no run writes into its folder".into()
        } else {
            continue;
        };
        return Err(wrong(section, written, &expected));
    }
    Ok(())
}

/// Checks that the files to be saved do not exist yet.
pub(super) fn free(saves: &[(String, CasePath)]) -> Result<(), Error> {
    match saves.iter().find(|(_, file)| std::fs::symlink_metadata(&file.place).is_ok()) {
        Some((section, file)) => {
            Err(wrong(section, &file.written, "a file that does not exist yet; use --force to replace it"))
        }
        None => Ok(()),
    }
}

/// Checks that no file that is read lies in a folder that is to be replaced.
pub(super) fn outside<'a>(root: &Path, reads: impl IntoIterator<Item = &'a Path>) -> Result<(), Error> {
    let folder = absolute(root);
    match reads.into_iter().find(|file| absolute(file).starts_with(&folder)) {
        Some(file) => Err(Error::Usage(format!(
            "{}: is not replaced, because it holds {}, which the run reads",
            root.display(),
            file.display()
        ))),
        None => Ok(()),
    }
}

fn wrong(section: &str, file: &Path, expected: &str) -> Error {
    let what = format!("found `{}`, expected {expected}", file.display());
    Error::Input(vec![Problem { file: PathBuf::new(), line: None, key: format!("{section}.save"), what }])
}

fn belongs_to_a_run(path: &Path, root: &Path) -> bool {
    let is_run = |folder: &RunFolder| matches!(Place::of(folder), Ok(Place::Run(_)));
    let around = path.ancestors().skip(1).take(2).map(RunFolder::at);
    RunFolder::at(&absolute(root)).makes(path) || around.into_iter().any(|folder| folder.makes(path) && is_run(&folder))
}
