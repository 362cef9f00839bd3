//! Files that are either complete or absent, and files that grow by complete lines.

use crate::error::{AtPath, Error};
use sha2::{Digest, Sha256};
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Writes a file under a temporary name, syncs and renames it: a reader sees the complete file or none.
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
    std::fs::rename(&temporary, path).at(path)
}

/// Reads a whole input file.
///
/// # Errors
///
/// If the file cannot be read.
pub fn read(path: &Path) -> Result<Vec<u8>, Error> {
    std::fs::read(path).map_err(|cause| Error::NoInput(path.into(), cause))
}

/// The SHA-256 of a file, in hexadecimal.
///
/// # Errors
///
/// If the file cannot be read.
pub fn sha256_file(path: &Path) -> Result<String, Error> {
    let mut file = File::open(path).at(path)?;
    let (mut hash, mut buffer) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer) {
            Ok(0) => return Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()),
            Ok(n) => hash.update(&buffer[..n]),
            Err(cause) if cause.kind() == ErrorKind::Interrupted => {}
            Err(cause) => return Err(Error::Io(path.into(), cause)),
        }
    }
}

/// A file that only grows, with a known length at every checkpoint.
pub struct Appending {
    path: PathBuf,
    file: File,
    length: u64,
}

impl Appending {
    /// A new, empty file.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn create(path: PathBuf) -> Result<Self, Error> {
        let file = File::create(&path).at(&path)?;
        Ok(Self { path, file, length: 0 })
    }

    /// Reopens a file at an earlier length; what was written later is truncated.
    ///
    /// # Errors
    ///
    /// If the file cannot be opened, or is shorter than `length`.
    pub fn resume(path: PathBuf, length: u64) -> Result<Self, Error> {
        let file = OpenOptions::new().append(true).open(&path).at(&path)?;
        let found = file.metadata().at(&path)?.len();
        if found < length {
            return Err(Error::input(&path, format!("has {found} bytes, but had {length} at the checkpoint")));
        }
        file.set_len(length).at(&path)?;
        Ok(Self { path, file, length })
    }

    /// Appends a line without buffering.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn line(&mut self, text: &str) -> Result<(), Error> {
        let line = format!("{text}\n");
        self.file.write_all(line.as_bytes()).at(&self.path)?;
        self.length += line.len() as u64;
        Ok(())
    }

    /// The length in bytes.
    pub fn length(&self) -> u64 {
        self.length
    }
}
