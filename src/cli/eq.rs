//! `veridem eq`: the equations of the specification, listed, shown, evaluated.

mod batch;
mod show;

use super::{OutputMode, print};
use crate::equations::Registry;
use crate::error::Error;
use batch::Lines;
use std::path::Path;

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
    /// Show an equation: formula as printed, reading, table, laws, source file
    Show {
        /// Its id, such as mechanics-sphere-volume
        id: String,
    },
    /// Evaluate an equation, such as: veridem eq eval mechanics-sphere-volume r="14 nm"
    Eval {
        /// Its id, such as mechanics-sphere-volume
        #[arg(required_unless_present = "batch")]
        id: Option<String>,
        /// Arguments as name="value unit", vectors as n="1 0 0" or v="[1, 0, 0] m/s"; a value without unit is in SI
        arguments: Vec<String>,
        /// Read lines {"id": ..., "in": {name: number or array, ...}} in SI from stdin and answer each, blank and wrong ones too, with a
        /// line {"id": ..., "out": ...} or {"id": ..., "error": "..."}. `out` is a number or an array for an equation with one
        /// result, an object of these by name for one with several. The exit status is 65 if a line was answered with an error
        #[arg(long, conflicts_with_all = ["id", "arguments"])]
        batch: bool,
    },
}

/// Lists, shows or evaluates equations.
pub(super) fn run(arguments: &Arguments, manner: OutputMode) -> Result<(), Error> {
    let registry = Registry::new();
    match &arguments.action {
        Action::List if manner.json => {
            print(&format!("{:#}\n", registry.0.iter().map(show::as_json).collect::<serde_json::Value>()))
        }
        Action::List => print(&show::list(&registry)),
        Action::Show { id } => {
            let entry = registry.find(id).map_err(Error::Usage)?;
            print(&if manner.json { format!("{:#}\n", show::as_json(entry)) } else { show::entry(entry) })
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
            let results = registry.eval(id, arguments).map_err(Error::Usage)?;
            print(&if manner.json { batch::value(&results) + "\n" } else { show::results(&results) })
        }
    }
}
