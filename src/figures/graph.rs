//! The graphs that a report shows.

use crate::output::Column;

/// A graph of a report: one column of the series against another.
#[derive(Clone, Copy, Debug)]
pub struct Graph {
    /// Its name, of the figure's file too.
    pub name: &'static str,
    /// The stages that it shows; none for all together.
    pub stages: &'static [&'static str],
    /// The horizontal axis.
    pub x: Column,
    /// The vertical axis.
    pub y: Column,
    /// Words of events that are marked where they happened in the last of the stages.
    pub marks: &'static [&'static str],
}
