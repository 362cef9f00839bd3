//! Where a run comes from: enough to make it again.

use super::{RunFolder, sha256_file, write_atomically};
use crate::error::Error;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How a run stands.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It is under way, or was killed.
    Running,
    /// It was stopped and can be resumed.
    Stopped,
    /// The simulation left its domain.
    Halted,
    /// A stage did not come to the end that it should.
    Failed,
    /// A file could not be read or written; it can be resumed.
    Interrupted,
    /// It is complete.
    Finished,
}

/// The provenance of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// How the run stands.
    pub status: Status,
    /// Version of this program.
    pub version: String,
    /// Commit it was built from.
    pub commit: String,
    /// Compiler it was built with.
    pub compiler: String,
    /// Machine it was built for.
    pub target: String,
    /// Number of threads.
    pub threads: usize,
    /// Command lines, that of the last resumption last.
    pub command_lines: Vec<String>,
    /// Seed of every random stream.
    pub seed: u64,
    /// SHA-256 of the files that went in.
    pub inputs: BTreeMap<String, String>,
    /// SHA-256 of the files that came out.
    pub outputs: BTreeMap<String, String>,
}

impl Manifest {
    /// The manifest of a run that begins in this process.
    pub fn begin(seed: u64, inputs: BTreeMap<String, String>) -> Self {
        Self {
            status: Status::Running,
            version: env!("CARGO_PKG_VERSION").into(),
            commit: env!("VERIDEM_COMMIT").into(),
            compiler: env!("VERIDEM_COMPILER").into(),
            target: env!("VERIDEM_TARGET").into(),
            threads: rayon::current_num_threads(),
            command_lines: vec![command_line()],
            seed,
            inputs,
            outputs: BTreeMap::new(),
        }
    }

    /// Reads that of a run folder.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let path = folder.manifest();
        let bytes = super::read(&path)?;
        serde_json::from_slice(&bytes).map_err(|error| Error::input(&path, error.to_string()))
    }

    /// Whether this build of the program began the run.
    pub fn is_ours(&self) -> bool {
        (&*self.version, &*self.commit) == (env!("CARGO_PKG_VERSION"), env!("VERIDEM_COMMIT"))
    }

    /// Takes the run up again in this process.
    pub fn resume(&mut self) {
        self.status = Status::Running;
        self.threads = rayon::current_num_threads();
        self.command_lines.push(command_line());
    }

    /// Writes it.
    pub fn write(&self, folder: &RunFolder) -> Result<(), Error> {
        let text = serde_json::to_string_pretty(self).expect("a manifest is plain data");
        write_atomically(&folder.manifest(), (text + "\n").as_bytes())
    }

    /// Ends the run with a status; a finished one lists what it has made.
    pub fn end(&mut self, folder: &RunFolder, status: Status) -> Result<(), Error> {
        if status == Status::Finished {
            for path in folder.outputs()? {
                let name = path.strip_prefix(folder.root()).expect("an output lies in its folder");
                self.outputs.insert(name.display().to_string(), sha256_file(&path)?);
            }
        }
        self.status = status;
        self.write(folder)
    }
}

fn command_line() -> String {
    std::env::args().collect::<Vec<_>>().join(" ")
}
