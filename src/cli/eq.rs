//! `veridem eq`: the equations of the specification, listed, shown, evaluated.

mod batch;
mod call;
mod show;

use super::{OutputMode, print};
use crate::error::{AtPath, Error};
use call::Registry;
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
        /// Read lines {"id": ..., "in": {name: number or array, ...}} in SI from stdin, write one line each
        #[arg(long, conflicts_with_all = ["id", "arguments"])]
        batch: bool,
    },
}

/// Lists, shows or evaluates equations.
pub(super) fn run(arguments: &Arguments, manner: OutputMode) -> Result<(), Error> {
    let registry = Registry::new();
    match &arguments.action {
        Action::List if manner.json => print(&show::list_as_json(&registry)),
        Action::List => print(&show::list(&registry)),
        Action::Show { id } => print(&show::entry(registry.find(id).map_err(Error::Usage)?)),
        Action::Eval { batch: true, .. } => {
            batch::run(&registry, &mut std::io::stdin().lock(), &mut std::io::stdout().lock()).at(Path::new("batch"))
        }
        Action::Eval { id, arguments, .. } => {
            let id = id.as_deref().unwrap_or_default();
            let results = registry.eval(id, arguments).map_err(Error::Usage)?;
            print(&if manner.json { batch::value(&results) + "\n" } else { show::results(&results) })
        }
    }
}
