//! Files that are either complete or absent, also after a power failure.

use crate::error::{AtPath, Error};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Writes a file under a temporary name, syncs and renames it, and syncs its folder: a reader sees the complete file or none, and
/// once this returns the file survives a power failure.
///
/// # Errors
///
/// If the file cannot be written.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(".part");
    let temporary = PathBuf::from(temporary);
    let written = File::create(&temporary).and_then(|mut file| {
        file.write_all(bytes)?;
        file.sync_all()
    });
    if written.is_err() {
        // The remainder is useless, and the disk may be full.
        std::fs::remove_file(&temporary).ok();
    }
    written.at(path)?;
    std::fs::rename(&temporary, path).at(path)?;
    sync_folder(folder_of(path))
}

/// Creates a folder and those that it is in, unless they exist; the new ones survive a power failure.
///
/// # Errors
///
/// If a folder cannot be created.
pub fn create_folder(path: &Path) -> Result<(), Error> {
    if path.is_dir() {
        return Ok(());
    }
    let parent = folder_of(path);
    create_folder(parent)?;
    match std::fs::create_dir(path) {
        // Another process may have been faster.
        Err(cause) if cause.kind() == ErrorKind::AlreadyExists && path.is_dir() => {}
        created => created.at(path)?,
    }
    sync_folder(parent)
}

/// Makes the names of the files in a folder, as they were created, renamed and removed, survive a power failure.
///
/// # Errors
///
/// If the operating system cannot write them.
pub fn sync_folder(folder: &Path) -> Result<(), Error> {
    use ErrorKind::{InvalidInput, PermissionDenied, Unsupported};
    if cfg!(unix) {
        match File::open(folder).and_then(|folder| folder.sync_all()) {
            // Some file systems write them at once instead; a folder that cannot be listed cannot be opened.
            Err(cause) if [InvalidInput, PermissionDenied, Unsupported].contains(&cause.kind()) => {}
            synced => synced.at(folder)?,
        }
    }
    Ok(())
}

/// The folder that a file or folder is in.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
        Some(parent) => parent,
        None => path,
    }
}

/// The SHA-256 of some bytes, in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(Sha256::new_with_prefix(bytes))
}

fn hexadecimal(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A path with an extension appended: what stands behind the last dot of a name like `d = 1.5` is a part of the name.
pub fn with_suffix(path: PathBuf, extension: &str) -> PathBuf {
    let mut path = path.into_os_string();
    path.push(".");
    path.push(extension);
    path.into()
}

/// The SHA-256 of a file, in hexadecimal.
///
/// # Errors
///
/// If the file cannot be read.
pub fn sha256_file(path: &Path) -> Result<String, Error> {
    let mut hash = Sha256::new();
    in_pieces(File::open(path).at(path)?, path, |piece| hash.update(piece))?;
    Ok(hexadecimal(hash))
}

/// Shows a file piece by piece.
pub(super) fn in_pieces(mut file: impl Read, path: &Path, mut show: impl FnMut(&[u8])) -> Result<(), Error> {
    let mut buffer = vec![0; 1 << 16];
    loop {
        match file.read(&mut buffer) {
            Ok(0) => return Ok(()),
            Ok(n) => show(&buffer[..n]),
            Err(cause) if cause.kind() == ErrorKind::Interrupted => {}
            Err(cause) => return Err(Error::Io(path.into(), cause)),
        }
    }
}
