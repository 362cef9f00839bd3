//! `veridem check`: checks a case without running it.

use super::{OutputMode, print};
use crate::error::Error;
use crate::papers::Papers;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
}

/// Checks the case and prints it with its defaults and derived values.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let job = papers.read(&arguments.case)?;
    job.examine()?;
    let resolved = job.resolved;
    if manner.json {
        let value: serde_json::Value = serde_yaml::from_str(&resolved).expect("a resolved case is plain data");
        print(&format!("{value:#}\n"))
    } else {
        print(&resolved)
    }
}
