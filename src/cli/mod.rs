//! The command line: one file per subcommand.

mod eq;
#[cfg(feature = "verify")]
mod golden;

use crate::error::Error;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Executable specification and fast engine of contact models for the discrete element method.
#[derive(Parser)]
#[command(name = "veridem", version, max_term_width = 100)]
pub struct CommandLine {
    /// Write results as JSON to standard output
    #[arg(long, global = true)]
    json: bool,
    /// Write no messages
    #[arg(long, short, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List, show and evaluate the equations
    Eq(eq::Arguments),
    /// Check the golden vectors, or mint them anew
    #[cfg(feature = "verify")]
    Golden(golden::Arguments),
}

/// How the user wants to be spoken to.
#[derive(Clone, Copy, Debug)]
pub struct Manner {
    /// JSON on standard output.
    pub json: bool,
    /// No messages.
    pub quiet: bool,
}

impl Manner {
    /// A message to the user.
    pub fn say(self, message: impl AsRef<str>) {
        if !self.quiet {
            eprintln!("{}", message.as_ref());
        }
    }
}

/// Runs the program: parses the command line, does what it says, and tells how it ended.
pub fn main() -> ExitCode {
    let command_line = CommandLine::parse();
    let manner = Manner { json: command_line.json, quiet: command_line.quiet };
    let done = match command_line.command {
        Command::Eq(arguments) => eq::run(&arguments, manner),
        #[cfg(feature = "verify")]
        Command::Golden(arguments) => golden::run(&arguments, manner),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            error.exit_code().into()
        }
    }
}

/// Writes to standard output; a reader that has gone away is no failure of ours.
pub fn print(text: &str) -> Result<(), Error> {
    use std::io::Write;
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(cause) if cause.kind() != std::io::ErrorKind::BrokenPipe => Err(Error::Io("standard output".into(), cause)),
        _ => Ok(()),
    }
}
