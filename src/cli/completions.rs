//! `veridem completions`: completions of the command line for a shell.

use super::{command, print};
use crate::error::Error;
use crate::papers::Papers;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The shell
    shell: clap_complete::Shell,
}

/// Writes the completions to standard output.
pub(super) fn run(arguments: &Arguments, papers: Papers) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command(papers), "veridem", &mut script);
    print(&String::from_utf8_lossy(&script))
}
