//! The provenance of a run: sufficient to reproduce it.

use super::{RunFolder, sha256_file, write_atomically};
use crate::error::{Error, Problem};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// The status of a run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It is running, or was killed.
    Running,
    /// It was stopped and can be resumed.
    Stopped,
    /// The simulation left its domain of validity.
    Halted,
    /// A stage failed to reach its end.
    Failed,
    /// A file could not be read or written; it can be resumed.
    Interrupted,
    /// It is complete.
    Finished,
}

/// The provenance of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// The status.
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
    /// Command lines of the start and of every resumption, in order.
    pub command_lines: Vec<String>,
    /// Seed of all random streams.
    pub seed: u64,
    /// SHA-256 of the input files, by their places.
    pub inputs: BTreeMap<String, String>,
    /// The places of the files that the case reads and saves, by the paths in the case: copies relative to the run folder, all others by absolute paths.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
    /// The names of the graphs of its report.
    #[serde(default)]
    pub graphs: Vec<String>,
    /// SHA-256 of the final state of a finished run: every number of the spheres, the box, walls, surfaces, springs and the time.
    #[serde(default)]
    pub final_state: Option<String>,
    /// SHA-256 of the output files.
    pub outputs: BTreeMap<String, String>,
}

impl Manifest {
    /// The manifest of a run started by this process.
    pub fn begin(
        seed: u64,
        inputs: BTreeMap<String, String>,
        files: BTreeMap<String, String>,
        graphs: Vec<String>,
    ) -> Self {
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
            files,
            graphs,
            final_state: None,
            outputs: BTreeMap::new(),
        }
    }

    /// Reads the manifest of a run folder.
    ///
    /// # Errors
    ///
    /// If the manifest is missing or damaged.
    pub fn read(folder: &RunFolder) -> Result<Self, Error> {
        let path = folder.manifest();
        Self::parse(&path, &super::read(&path)?)
    }

    /// Reads a manifest from the content of its file.
    ///
    /// # Errors
    ///
    /// If it is damaged.
    pub fn parse(path: &Path, bytes: &[u8]) -> Result<Self, Error> {
        let broken = |error: serde_json::Error| {
            let line = Some(error.line()).filter(|&line| line > 0);
            Error::Input(vec![Problem { file: path.into(), line, key: String::new(), what: error.to_string() }])
        };
        serde_json::from_slice(bytes).map_err(broken)
    }

    /// Whether the run was started by this build of the program.
    pub fn is_ours(&self) -> bool {
        (&*self.version, &*self.commit) == (env!("CARGO_PKG_VERSION"), env!("VERIDEM_COMMIT"))
    }

    /// Whether one of the inputs has this hash.
    pub fn knows(&self, hash: &str) -> bool {
        self.inputs.values().any(|input| input == hash)
    }

    /// The hash of the file to which a path in the case led.
    pub fn hash_of(&self, written: &Path) -> Option<&String> {
        self.inputs.get(self.files.get(&written.display().to_string())?)
    }

    /// The status in a word; a run whose process has ended without saying so was killed.
    pub fn status_word(&self, folder: &RunFolder) -> String {
        match self.status {
            Status::Running if !super::Lock::is_held(folder.root()) => "Killed".into(),
            _ => format!("{:?}", self.status),
        }
    }

    /// Updates the manifest for a resumption by this process.
    pub fn resume(&mut self) {
        self.status = Status::Running;
        self.threads = rayon::current_num_threads();
        self.command_lines.push(command_line());
    }

    /// Writes it.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn write(&self, folder: &RunFolder) -> Result<(), Error> {
        let text = serde_json::to_string_pretty(self).expect("a manifest is plain data");
        write_atomically(&folder.manifest(), (text + "\n").as_bytes())
    }

    /// Ends the run with a status; the manifest of a finished run lists its output files.
    ///
    /// # Errors
    ///
    /// If an output file cannot be read, or the manifest not be written.
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

/// The command line of this process.
pub fn command_line() -> String {
    let words = std::env::args_os().map(|word| word.to_string_lossy().into_owned());
    words.collect::<Vec<_>>().join(" ")
}
