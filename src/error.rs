//! What can go wrong on the way from the user to the engine and back, and how the process ends then.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a command did not succeed.
#[derive(Debug)]
pub enum Error {
    /// The command line asks for something that cannot be done.
    Usage(String),
    /// A verification failed.
    Verification(String),
    /// A file could not be written, or its reading broke off.
    Io(PathBuf, io::Error),
}

impl Error {
    /// The status that the process ends with.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Verification(_) => 4,
            Self::Io(..) => 74,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(what) | Self::Verification(what) => f.write_str(what),
            Self::Io(path, cause) => write!(f, "{}: {cause}", path.display()),
        }
    }
}

impl std::error::Error for Error {}

/// Names the path in an I/O failure.
pub trait AtPath<T> {
    /// The path that the failure is about.
    fn at(self, path: &Path) -> Result<T, Error>;
}

impl<T> AtPath<T> for io::Result<T> {
    fn at(self, path: &Path) -> Result<T, Error> {
        self.map_err(|cause| Error::Io(path.into(), cause))
    }
}
