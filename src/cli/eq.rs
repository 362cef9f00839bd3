//! `veridem eq`: the equations of the specification, listed, shown, evaluated, exported.

mod batch;
mod export;
#[cfg(feature = "verify")]
mod prove;
#[cfg(feature = "verify")]
mod ranges;
mod show;

use super::{OutputMode, print};
use crate::equations::Registry;
use crate::error::Error;
use crate::output::write_atomically;
use crate::papers::Papers;
use batch::Lines;
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    action: Action,
}

#[derive(clap::Subcommand)]
enum Action {
    /// List every equation; with --json names, symbols, units, domains and laws too
    List,
    /// Show an equation: formula as printed and as computed, reading, table, laws, source file
    Show {
        /// Its id, such as mechanics-sphere-volume
        id: String,
    },
    /// Prove what is claimed of an equation over a box of arguments: finite, signs, monotonicity, rounding. Each claim is stated with
    /// the number of parts into which the box was divided, or with the part where the proof stops
    #[cfg(feature = "verify")]
    Prove {
        /// Its id, such as mechanics-sphere-volume
        #[arg(required_unless_present = "all")]
        id: Option<String>,
        /// Prove the claims of every equation and print docs/proofs.md
        #[arg(long, conflicts_with = "id")]
        all: bool,
    },
    /// Evaluate an equation, such as: veridem eq eval mechanics-sphere-volume r="14 nm"
    Eval {
        /// Its id, such as mechanics-sphere-volume
        #[arg(required_unless_present = "batch")]
        id: Option<String>,
        /// Arguments as name="value unit", vectors as n="1 0 0" or v="[1, 0, 0] m/s"; a value without unit is in SI. With a range such as
        /// r="1 nm .. 10 nm" the results are intervals: they contain the results for all arguments in the ranges, exact and in f64
        arguments: Vec<String>,
        /// Read lines {"id": ..., "in": {name: number or array, ...}} in SI from stdin and answer each, blank and wrong ones too, with a
        /// line {"id": ..., "out": ...} or {"id": ..., "error": "..."}. `out` is a number or an array for an equation with one
        /// result, an object of these by name for one with several. The exit status is 65 if a line was answered with an error
        #[arg(long, conflicts_with_all = ["id", "arguments"])]
        batch: bool,
    },
    /// Write equations as a header or module of another language, with the bits of this program; all of them unless some are named
    Export {
        /// The language
        #[arg(long, value_enum)]
        language: export::Name,
        /// Their ids, such as mechanics-sphere-volume
        ids: Vec<String>,
        /// The file to write instead of standard output
        #[arg(long)]
        out: Option<PathBuf>,
    },
}

/// Lists, shows, evaluates or exports equations.
pub(super) fn run(arguments: &Arguments, papers: Papers, manner: OutputMode) -> Result<(), Error> {
    let registry = Registry::new();
    match &arguments.action {
        Action::List if manner.json => {
            print(&format!("{:#}\n", registry.0.iter().map(show::as_json).collect::<serde_json::Value>()))
        }
        Action::List => print(&show::list(&registry)),
        Action::Show { id } => {
            let entry = registry.find(id).map_err(Error::Usage)?;
            print(&if manner.json { format!("{:#}\n", show::entry_as_json(entry)) } else { show::entry(entry) })
        }
        #[cfg(feature = "verify")]
        Action::Prove { all: true, .. } => print(&crate::proofs::page(&registry.0)),
        #[cfg(feature = "verify")]
        Action::Prove { id, .. } => {
            let entry = registry.find(id.as_deref().unwrap_or_default()).map_err(Error::Usage)?;
            print(&if manner.json { prove::json(entry) } else { prove::text(entry) })
        }
        Action::Eval { batch: true, .. } => match batch::run(&registry, &mut std::io::stdin().lock(), print)? {
            Lines { failed: 0, .. } => Ok(()),
            Lines { read, failed } => Err(Error::input(
                Path::new("standard input"),
                format!("{failed} of {read} lines were answered with an error"),
            )),
        },
        Action::Eval { id, arguments, .. } => {
            let id = id.as_deref().unwrap_or_default();
            #[cfg(feature = "verify")]
            if arguments.iter().any(|argument| argument.contains("..")) {
                let entry = registry.find(id).map_err(Error::Usage)?;
                let results = ranges::eval(entry, arguments).map_err(Error::Usage)?;
                return print(&if manner.json { ranges::json(entry, &results) } else { ranges::text(entry, &results) });
            }
            let results = registry.eval(id, arguments).map_err(Error::Usage)?;
            print(&if manner.json { batch::value(&results) + "\n" } else { show::results(&results) })
        }
        Action::Export { language, ids, out } => {
            let module = export::module(&registry, papers, *language, ids).map_err(Error::Usage)?;
            match out {
                Some(file) => write_atomically(file, module.as_bytes()),
                None => print(&module),
            }
        }
    }
}
