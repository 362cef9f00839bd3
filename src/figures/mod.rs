//! Figures: curves, snapshots, and the report page with a table of results.

mod graph;
#[cfg(feature = "cli")]
mod movie;
#[cfg(feature = "cli")]
mod page;
#[cfg(feature = "cli")]
mod plot;
#[cfg(feature = "cli")]
mod raised;
#[cfg(feature = "cli")]
mod report;
mod round;
mod snapshot;
#[cfg(feature = "cli")]
mod ticks;
#[cfg(feature = "cli")]
mod view;

pub use graph::{Graph, graph_names};
#[cfg(feature = "cli")]
pub use movie::movie;
#[cfg(feature = "cli")]
pub use page::{Cell, Report};
#[cfg(feature = "cli")]
pub use plot::{Axis, Curve, Mark, Plot};
#[cfg(feature = "cli")]
pub use report::report;
pub use snapshot::{picture, snapshot};

/// The colours of curves and bodies, distinguishable with any colour vision (Okabe and Ito, with olive in place of their yellow).
pub(crate) const COLOURS: [(u8, u8, u8); 8] = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
    (80, 80, 80),
    (136, 136, 34),
];
