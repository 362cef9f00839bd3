//! `veridem check`: checks a case without running it.

use super::run::Limits;
use super::{OutputMode, print};
use crate::error::Error;
use crate::papers::Papers;
use crate::run::Job;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
}

/// Checks the case and prints it with its defaults and derived values, and the plan of its run.
pub(super) fn run(arguments: &Arguments, papers: Papers, excess: bool, manner: OutputMode) -> Result<(), Error> {
    let interrupt = Limits::default().interrupt()?;
    let job = Job { excess, ..papers.read(&arguments.case)? };
    interrupt.check()?;
    let checked = job.checked(&interrupt)?;
    for doubt in &job.doubts {
        manner.say(format!("warning: {doubt}"));
    }
    if manner.json {
        print(&format!("{:#}\n", serde_json::to_value(&checked).expect("a mapping with keys that are words")))
    } else {
        print(&serde_yaml::to_string(&checked).expect("a mapping is plain data"))
    }
}
