//! The graphs of a report.

use crate::output::Column;

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
