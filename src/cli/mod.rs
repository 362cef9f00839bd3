//! The command line: one file per subcommand.

#[cfg(feature = "book")]
mod book;
mod check;
mod completions;
mod eq;
mod export;
#[cfg(feature = "verify")]
mod golden;
mod import;
mod inspect;
mod movie;
mod progress;
mod report;
mod reproduce;
mod resume;
mod run;
mod schema;
mod sweep;
mod units;

use crate::error::{Error, message, silence};
use crate::forces::Instructions;
use crate::interrupt::outlive_file_limits;
use crate::papers::Papers;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use serde_json::json;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Executable specification and fast engine of contact models for the discrete element method.
#[derive(Parser)]
#[command(name = "veridem", version, max_term_width = 100, after_help = EXIT_CODES)]
pub struct CommandLine {
    /// Write one JSON document to standard output: the result, or {"error": {"exit", "what", "file", "line", "key", "problems"}}
    #[arg(long, global = true)]
    json: bool,
    /// Write no messages
    #[arg(long, short, global = true)]
    quiet: bool,
    /// Number of threads; all cores by default
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Vector instructions, for checks: results do not depend on them
    #[arg(long, global = true, value_name = "SET", hide = true)]
    instructions: Option<String>,
    /// Accept cases that ask for more steps, output or memory than is usual, and more threads
    #[arg(long, global = true)]
    yes: bool,
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "Exit status: 0 done, 2 wrong command line, 4 verification failed, 5 simulation halted, \
65 wrong input, 66 no input, 70 broken invariant, 74 I/O failure, or interrupted with nothing to resume, 75 stopped and resumable";

#[derive(Subcommand)]
enum Command {
    /// Run a case
    Run(run::Arguments),
    /// Resume a stopped run
    Resume(resume::Arguments),
    /// Check a case and print it with every default and derived value
    Check(check::Arguments),
    /// Run a case for several values of its keys, on all cores
    Sweep(sweep::Arguments),
    /// Compute the claims of a paper
    Reproduce(reproduce::Arguments),
    /// Read an aggregate from another program's file and describe it
    Import(import::Arguments),
    /// Write the state of a case or a run for another program
    Export(export::Arguments),
    /// Summarise a run, or compare two
    Inspect(inspect::Arguments),
    /// Write the report of a run again
    Report(report::Arguments),
    /// Draw the frames of a run into a film, an animated GIF
    Movie(movie::Arguments),
    /// List, show and evaluate the equations
    Eq(eq::Arguments),
    /// Write the equations as pages for a browser, with their curves
    #[cfg(feature = "book")]
    Book(book::Arguments),
    /// Check the golden vectors and trajectories, or regenerate the vectors
    #[cfg(feature = "verify")]
    Golden(golden::Arguments),
    /// List the keys of a case file
    Schema(schema::Arguments),
    /// List the units of quantities
    Units(units::Arguments),
    /// Write completions for a shell
    Completions(completions::Arguments),
}

/// The user's choice of output.
#[derive(Clone, Copy, Debug)]
pub struct OutputMode {
    /// JSON on standard output.
    pub json: bool,
    /// No messages.
    pub quiet: bool,
}

impl OutputMode {
    /// Prints a message to the user.
    pub fn say(self, text: impl AsRef<str>) {
        if !self.quiet {
            message(text.as_ref());
        }
    }
}

/// The command line of a program for these papers.
pub fn command(papers: Papers) -> clap::Command {
    CommandLine::command().mut_subcommand("reproduce", |command| reproduce::known(command, papers))
}

/// Runs the program for these papers: parses the command line, executes the command, and returns the exit status.
pub fn main(papers: Papers) -> ExitCode {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| execute(papers))).unwrap_or(ExitCode::from(BROKEN))
}

/// Number of threads beyond which they are started only on request.
const MANY_THREADS: usize = 1024;

/// The exit status after a panic.
const BROKEN: u8 = 70;

fn execute(papers: Papers) -> ExitCode {
    let parsed = command(papers).try_get_matches().and_then(|matches| CommandLine::from_arg_matches(&matches));
    let command_line = match parsed {
        Ok(command_line) => command_line,
        Err(error) => return refuse(&error),
    };
    let manner = OutputMode { json: command_line.json, quiet: command_line.quiet };
    std::panic::set_hook(Box::new(move |panic| {
        let what = format!("broken invariant: {panic}");
        message(&what);
        if manner.json {
            print_error(&json!({ "exit": BROKEN, "what": what }));
        }
    }));
    if manner.quiet {
        silence();
    }
    // The main thread works too: handing every step over to another thread and waiting for it would cost more than a small step.
    let threads = command_line.threads.map_or(0, usize::from);
    if threads > MANY_THREADS && !command_line.yes {
        let what = format!("--threads: found {threads}, expected at most {MANY_THREADS}; with --yes more are accepted");
        return exit(Err(Error::Usage(what)), manner.json);
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread();
    pool.build_global().expect("the thread pool is set up once, before it is used");
    outlive_file_limits().ok();
    let done = choose_instructions(command_line.instructions.as_deref()).and_then(|()| match command_line.command {
        Command::Run(arguments) => run::run(&arguments, papers, command_line.yes, manner),
        Command::Resume(arguments) => resume::run(&arguments, papers, manner),
        Command::Check(arguments) => check::run(&arguments, papers, command_line.yes, manner),
        Command::Reproduce(arguments) => reproduce::run(&arguments, papers, manner),
        Command::Sweep(arguments) => sweep::run(&arguments, papers, command_line.yes, manner),
        Command::Import(arguments) => import::run(&arguments, papers, manner),
        Command::Export(arguments) => export::run(&arguments, papers, manner),
        Command::Inspect(arguments) => inspect::run(&arguments, papers, manner),
        Command::Report(arguments) => report::run(&arguments, papers, manner),
        Command::Movie(arguments) => movie::run(&arguments, manner),
        Command::Eq(arguments) => eq::run(&arguments, papers, manner),
        #[cfg(feature = "book")]
        Command::Book(arguments) => book::run(&arguments, papers, manner),
        #[cfg(feature = "verify")]
        Command::Golden(arguments) => golden::run(&arguments, papers, manner),
        Command::Schema(arguments) => schema::run(&arguments, papers, manner),
        Command::Units(arguments) => units::run(&arguments, manner),
        Command::Completions(arguments) => completions::run(&arguments, papers, manner),
    });
    exit(done, manner.json)
}

fn exit(done: Result<(), Error>, json: bool) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            message(&error.to_string());
            if json {
                print_error(&error.to_json());
            }
            error.exit_code().into()
        }
    }
}

/// Chooses the vector instructions with this name.
fn choose_instructions(name: Option<&str>) -> Result<(), Error> {
    let Some(name) = name else { return Ok(()) };
    let Some(chosen) = Instructions::named(name) else {
        let names: Vec<&str> = Instructions::available().into_iter().map(Instructions::name).collect();
        let what = format!("--instructions: this processor has no `{name}`, it has `{}`", names.join("`, `"));
        return Err(Error::Usage(what));
    };
    chosen.choose();
    Ok(())
}

/// Answers a wrong command line, or with the help that was asked for, which is data.
fn refuse(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() {
        return exit(printed(error.print()), false);
    }
    if std::env::args_os().any(|argument| argument == "--json") {
        print_error(&Error::Usage(error.to_string().trim_end().into()).to_json());
    }
    error.print().ok();
    ExitCode::from(2)
}

/// Prints an error as JSON, unless the command has printed its result already: standard output holds one document.
fn print_error(error: &serde_json::Value) {
    if !PRINTED.load(Ordering::Relaxed) {
        // The exit status tells as much.
        let _ = print(&format!("{:#}\n", json!({ "error": error })));
    }
}

/// Whether anything was printed.
static PRINTED: AtomicBool = AtomicBool::new(false);

/// Writes to standard output; a closed pipe is not an error.
///
/// # Errors
///
/// If standard output cannot be written.
pub fn print(text: &str) -> Result<(), Error> {
    use std::io::Write;
    PRINTED.store(true, Ordering::Relaxed);
    let mut out = std::io::stdout().lock();
    printed(out.write_all(text.as_bytes()).and_then(|()| out.flush()))
}

fn printed(written: std::io::Result<()>) -> Result<(), Error> {
    match written {
        Err(cause) if cause.kind() != std::io::ErrorKind::BrokenPipe => Err(Error::Io("standard output".into(), cause)),
        _ => Ok(()),
    }
}
