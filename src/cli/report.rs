//! `veridem report`: writes the report of a run again, from its folder alone.

use super::{OutputMode, print};
use crate::error::Error;
use crate::output::{Lock, RunFolder};
use crate::papers::Papers;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The run folder
    run: PathBuf,
}

/// Writes figures and report.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let folder = RunFolder::open(&arguments.run)?;
    let job = papers.read(&folder.case())?;
    // A run under way writes its record, and in the end its own report.
    let _lock = Lock::take(folder.root())?;
    crate::figures::report(&job.title, job.graphs, &folder)?;
    let path = folder.report();
    match manner.json {
        true => print(&format!("{:#}\n", serde_json::json!({ "report": path }))),
        false => print(&format!("{}\n", path.display())),
    }
}
