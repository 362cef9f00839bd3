//! `veridem resume`: resumes a stopped run, as if it had never been stopped.

use super::OutputMode;
use super::progress::Progress;
use super::run::{Limits, conclude};
use crate::error::Error;
use crate::output::RunFolder;
use crate::papers::Papers;
use std::path::PathBuf;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The run folder
    run: PathBuf,
    #[command(flatten)]
    limits: Limits,
}

/// Resumes from the latest checkpoint.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let interrupt = arguments.limits.interrupt()?;
    let folder = RunFolder::open(&arguments.run)?;
    let job = papers.read(&folder.case())?;
    let mut progress = Progress::new(manner);
    let findings = job.resume(&folder, &interrupt, &mut |message| progress.tell(message));
    progress.finish();
    conclude(&folder, &findings?, manner)
}
