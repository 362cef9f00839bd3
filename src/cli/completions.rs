//! `veridem completions`: completions of the command line for a shell.

use super::{OutputMode, command, print};
use crate::error::Error;
use crate::papers::Papers;

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The shell
    shell: clap_complete::Shell,
}

/// Writes the completions to standard output.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command(papers), "veridem", &mut script);
    let script = String::from_utf8_lossy(&script);
    if manner.json {
        let shell = arguments.shell.to_string();
        return print(&format!("{:#}\n", serde_json::json!({ "shell": shell, "script": script })));
    }
    print(&script)
}
