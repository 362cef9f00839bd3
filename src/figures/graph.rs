//! The graphs of a report.

use crate::output::Column;
use crate::output::columns::{RELATIVE_RESIDUAL, TIME};

/// A graph of a report: one column of the series against another.
#[derive(Clone, Copy, Debug)]
pub struct Graph {
    /// Its name, also of the file of the figure.
    pub name: &'static str,
    /// The stages that it shows; none for all together.
    pub stages: &'static [&'static str],
    /// The horizontal axis.
    pub x: Column,
    /// The vertical axis.
    pub y: Column,
    /// Words of the events that are marked on the curve of the last stage.
    pub marks: &'static [&'static str],
}

/// The graph of every run.
pub(super) const LEDGER: Graph = Graph { name: "ledger", stages: &[], x: TIME, y: RELATIVE_RESIDUAL, marks: &[] };
/// Name of the graph of the energies of all causes.
pub(super) const ENERGIES: &str = "energies";

/// The names of all graphs of the report of a run whose paper has these.
pub fn graph_names(graphs: &[Graph]) -> impl Iterator<Item = &str> {
    graphs.iter().map(|graph| graph.name).chain([LEDGER.name, ENERGIES])
}
