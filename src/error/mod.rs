//! Errors, and the exit status of the process for each.
//!
//! A wrong input is a [`Problem`]; a simulation that left its domain is a [`Halt`]; a broken invariant is a panic.

mod halt;
mod notice;

pub use halt::{Halt, Reason, Stability};
#[cfg(test)]
pub(crate) use notice::was_said;
pub use notice::{message, notice, silence};

use serde_json::{Value, json};
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// An error in the user's input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file, as the user named it.
    pub file: PathBuf,
    /// The line, counted from 1, if known.
    pub line: Option<usize>,
    /// The key with its enclosing sections; empty for the file as a whole.
    pub key: String,
    /// What was found and what was expected.
    pub what: String,
}

impl Problem {
    /// The problem for programs; what is not known is null.
    fn to_json(&self) -> Value {
        let known = |text: String| (!text.is_empty()).then_some(text);
        let (file, key) = (known(self.file.display().to_string()), known(self.key.clone()));
        json!({ "file": file, "line": self.line, "key": key, "what": self.what })
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.file.as_os_str().is_empty() {
            write!(f, "{}:", self.file.display())?;
            self.line.map_or(Ok(()), |line| write!(f, "{line}:"))?;
            f.write_str(" ")?;
        }
        if !self.key.is_empty() {
            write!(f, "{}: ", self.key)?;
        }
        f.write_str(&self.what)
    }
}

/// The reason why a command failed.
pub enum Error {
    /// The input is wrong; nothing was written.
    Input(Vec<Problem>),
    /// An input file cannot be opened.
    NoInput(PathBuf, io::Error),
    /// The command line is invalid.
    Usage(String),
    /// The simulation left its domain.
    Halted(Halt, Option<PathBuf>),
    /// A verification failed.
    Verification(String),
    /// Some of several runs failed: how many, and the name and error of the first, which decides the exit status.
    Runs(String, String, Box<Error>),
    /// Writing a file failed, or reading one after it was opened.
    Io(PathBuf, io::Error),
    /// A run was stopped and can be resumed from its checkpoint; without a path: several runs, which the same command resumes.
    Stopped(Option<PathBuf>),
    /// A command was stopped of which nothing is left to resume.
    Interrupted,
}

impl Error {
    /// The exit status of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(_) => 2,
            Self::Verification(_) => 4,
            Self::Halted(..) => 5,
            Self::Runs(_, _, first) => first.exit_code(),
            Self::Input(_) => 65,
            Self::NoInput(..) => 66,
            Self::Io(..) | Self::Interrupted => 74,
            Self::Stopped(_) => 75,
        }
    }

    /// The error for programs: its exit status, its text, and file, line and key of every problem of the input.
    pub fn to_json(&self) -> Value {
        let first = if let Self::Runs(_, _, first) = self { first } else { self };
        let problems = match first {
            Self::Input(problems) => problems.iter().map(Problem::to_json).collect(),
            _ => Vec::new(),
        };
        let (file, line, key) = match (first, &problems[..]) {
            (_, [first, ..]) => (first["file"].clone(), first["line"].clone(), first["key"].clone()),
            (Self::NoInput(path, _) | Self::Io(path, _), _) => {
                (path.display().to_string().into(), Value::Null, Value::Null)
            }
            _ => Default::default(),
        };
        json!({ "exit": self.exit_code(), "what": self.to_string(), "file": file, "line": line, "key": key, "problems": problems })
    }

    /// A problem with the value of a key of the case, found when the file is no longer open.
    pub fn of_key(key: impl Into<String>, what: impl Into<String>) -> Self {
        Self::Input(vec![Problem { file: PathBuf::new(), line: None, key: key.into(), what: what.into() }])
    }

    /// A problem with a file as a whole.
    pub fn input(file: &Path, what: impl Into<String>) -> Self {
        Self::Input(vec![Problem { file: file.into(), line: None, key: String::new(), what: what.into() }])
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(problems) => {
                let lines: Vec<String> = problems.iter().map(Problem::to_string).collect();
                f.write_str(&lines.join("\n"))
            }
            Self::NoInput(path, cause) => write!(f, "{}: cannot be read: {cause}", path.display()),
            Self::Usage(what) | Self::Verification(what) => f.write_str(what),
            Self::Runs(what, name, first) => write!(f, "{what}; the first, {name}: {first}"),
            Self::Halted(halt, None) => write!(f, "halted at {halt}"),
            Self::Halted(halt, Some(state)) => write!(f, "halted at {halt}; the state is in {}", state.display()),
            Self::Io(path, cause) => write!(f, "{}: {cause}", path.display()),
            Self::Stopped(Some(run)) => write!(f, "stopped; resume with `{} resume {}`", program(), run.display()),
            Self::Interrupted => f.write_str("interrupted; nothing was kept, and there is nothing to resume"),
            Self::Stopped(None) => f.write_str("stopped; the same command resumes it"),
        }
    }
}

/// The name of the running program, which may be that of a paper of one's own.
fn program() -> String {
    let path = std::env::args_os().next().unwrap_or_default();
    Path::new(&path).file_stem().unwrap_or_default().to_string_lossy().into()
}

/// As it is displayed: `main` prints an error so.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Error {}

impl From<Halt> for Error {
    fn from(halt: Halt) -> Self {
        if halt.reason == Reason::Interrupted { Self::Interrupted } else { Self::Halted(halt, None) }
    }
}

/// The error of a file that cannot be opened for reading.
pub fn not_opened(path: &Path, cause: io::Error) -> Error {
    use io::ErrorKind::{InvalidFilename, IsADirectory, NotADirectory, NotFound, PermissionDenied};
    let of_the_name = [NotFound, PermissionDenied, IsADirectory, NotADirectory, InvalidFilename];
    if of_the_name.contains(&cause.kind()) { Error::NoInput(path.into(), cause) } else { Error::Io(path.into(), cause) }
}

/// Reads a whole input file.
///
/// # Errors
///
/// [`Error::NoInput`] if there is no file of that name to be read, [`Error::Io`] if reading it fails.
pub fn read_file(path: &Path) -> Result<Vec<u8>, Error> {
    std::fs::read(path).map_err(|cause| not_opened(path, cause))
}

/// Adds the path to an I/O error.
pub trait AtPath<T> {
    /// Adds the path of the file concerned.
    ///
    /// # Errors
    ///
    /// The same failure, as [`Error::Io`].
    fn at(self, path: &Path) -> Result<T, Error>;
}

impl<T> AtPath<T> for io::Result<T> {
    fn at(self, path: &Path) -> Result<T, Error> {
        self.map_err(|cause| Error::Io(path.into(), cause))
    }
}
