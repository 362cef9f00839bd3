//! Files that grow by complete lines, and their fingerprints at a checkpoint.

use super::files::{folder_of, in_pieces, sync_folder};
use crate::error::{AtPath, Error};
use crc32fast::Hasher;
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// The length of a file, or of its beginning, and a checksum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    length: u64,
    crc32: u32,
}

impl Fingerprint {
    /// The fingerprint of the complete content of a file.
    pub fn of(bytes: &[u8]) -> Self {
        Self { length: bytes.len() as u64, crc32: crc32fast::hash(bytes) }
    }

    /// Checks that a file begins with the content that had this fingerprint.
    ///
    /// # Errors
    ///
    /// If the file is missing, shorter or different, or cannot be read.
    pub fn check(&self, path: &Path) -> Result<(), Error> {
        self.hash(path).map(drop)
    }

    /// The running checksum of the beginning of a file, if it is this one.
    fn hash(&self, path: &Path) -> Result<Hasher, Error> {
        let file = match File::open(path) {
            Err(cause) if cause.kind() == ErrorKind::NotFound => return Err(Error::input(path, "is missing")),
            file => file.at(path)?.take(self.length),
        };
        let (mut hasher, mut found) = (Hasher::new(), 0);
        in_pieces(file, path, |piece| {
            hasher.update(piece);
            found += piece.len() as u64;
        })?;
        if found < self.length {
            return Err(Error::input(path, format!("has {found} bytes, but had {} at the checkpoint", self.length)));
        }
        if hasher.clone().finalize() != self.crc32 {
            let what = format!("has changed since the checkpoint: the checksum of its first {found} bytes differs");
            return Err(Error::input(path, what));
        }
        Ok(hasher)
    }
}

/// A file that only grows, with a known fingerprint at every checkpoint.
pub struct Appending {
    path: PathBuf,
    file: File,
    length: u64,
    hasher: Hasher,
}

impl Appending {
    /// A new, empty file, whose name survives a power failure.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn create(path: PathBuf) -> Result<Self, Error> {
        let file = File::create(&path).at(&path)?;
        sync_folder(folder_of(&path))?;
        Ok(Self { path, file, length: 0, hasher: Hasher::new() })
    }

    /// Reopens a file as it was at a checkpoint; what was written later is truncated.
    ///
    /// # Errors
    ///
    /// If the file cannot be opened, or does not begin with the content that it had then.
    pub fn resume(path: PathBuf, then: &Fingerprint) -> Result<Self, Error> {
        let hasher = then.hash(&path)?;
        let file = OpenOptions::new().append(true).open(&path).at(&path)?;
        file.set_len(then.length).at(&path)?;
        Ok(Self { path, file, length: then.length, hasher })
    }

    /// Appends a line without buffering.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn line(&mut self, text: &str) -> Result<(), Error> {
        let line = format!("{text}\n");
        self.file.write_all(line.as_bytes()).at(&self.path)?;
        self.hasher.update(line.as_bytes());
        self.length += line.len() as u64;
        Ok(())
    }

    /// Makes the present content survive a power failure; returns its fingerprint.
    ///
    /// # Errors
    ///
    /// If the operating system cannot write it.
    pub fn sync(&self) -> Result<Fingerprint, Error> {
        self.file.sync_all().at(&self.path)?;
        Ok(Fingerprint { length: self.length, crc32: self.hasher.clone().finalize() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_goes_on_from_its_fingerprint_unless_it_has_changed_before() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lines");
        let mut file = Appending::create(path.clone()).unwrap();
        file.line("one").unwrap();
        let then = file.sync().unwrap();
        assert_eq!(then, Fingerprint::of(b"one\n"));
        file.line("two").unwrap();
        let mut again = Appending::resume(path.clone(), &then).unwrap();
        again.line("2").unwrap();
        assert_eq!(again.sync().unwrap(), Fingerprint::of(b"one\n2\n"));
        assert_eq!(std::fs::read(&path).unwrap(), b"one\n2\n");
        for (content, expected) in [
            (&b"on"[..], "has 2 bytes, but had 4 at the checkpoint"),
            (b"onE\n2\n", "has changed since the checkpoint: the checksum of its first 4 bytes differs"),
        ] {
            std::fs::write(&path, content).unwrap();
            let error = Appending::resume(path.clone(), &then).err().unwrap();
            assert_eq!(error.to_string(), format!("{}: {expected}", path.display()));
            assert_eq!(std::fs::read(&path).unwrap(), content, "it is left as it is");
        }
        std::fs::remove_file(&path).unwrap();
        assert_eq!(then.check(&path).unwrap_err().to_string(), format!("{}: is missing", path.display()));
    }
}
