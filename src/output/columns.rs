//! The columns of the time series: each is a constant that its writer, its plots and its readers share.

use std::fmt;

/// A column of the time series: a quantity and its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The quantity.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
}

impl Column {
    /// A quantity with its unit.
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, unit }
    }
    /// A pure number.
    pub const fn pure(name: &'static str) -> Self {
        Self { name, unit: "" }
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.unit.is_empty() { f.write_str(self.name) } else { write!(f, "{} [{}]", self.name, self.unit) }
    }
}

/// The stage.
pub const STAGE: Column = Column::pure("stage");
/// Steps of the stage.
pub const STEP: Column = Column::pure("step");
/// Simulated time.
pub const TIME: Column = Column::new("time", "ns");
/// Kinetic energy of what moves freely.
pub const KINETIC: Column = Column::new("kinetic energy", "zJ");
/// Energy lost to the global damping.
pub const LOST_TO_DRAG: Column = Column::new("lost to drag", "zJ");
/// Energy lost with broken necks.
pub const LOST_TO_BREAKING: Column = Column::new("lost to breaking", "zJ");
/// Work of walls of prescribed velocity.
pub const WORK_OF_WALLS: Column = Column::new("work of walls", "zJ");
/// Work of loads.
pub const WORK_OF_LOADS: Column = Column::new("work of loads", "zJ");
/// Work of the sides of the box.
pub const WORK_OF_BOX: Column = Column::new("work of box", "zJ");
/// Energy that the discrete account does not explain.
pub const DISCRETE_RESIDUAL: Column = Column::new("discrete residual", "zJ");
/// Energy that the physical account does not explain.
pub const PHYSICAL_RESIDUAL: Column = Column::new("physical residual", "zJ");
/// The physical residual over the energy that moved between accounts.
pub const RELATIVE_RESIDUAL: Column = Column::pure("relative residual");
/// Largest overlap over the sum of the radii.
pub const LARGEST_OVERLAP: Column = Column::pure("largest overlap");
/// Diagonal of the stress of the whole box.
pub const STRESS: [Column; 3] =
    [Column::new("stress xx", "MPa"), Column::new("stress yy", "MPa"), Column::new("stress zz", "MPa")];
/// Sides of the box.
pub const SIDES: [Column; 3] = [Column::new("side x", "nm"), Column::new("side y", "nm"), Column::new("side z", "nm")];
/// Energy of contacts with surfaces and of their attraction.
pub const AT_SURFACES: Column = Column::new("energy at surfaces", "zJ");
/// Energy lost at surfaces.
pub const LOST_AT_SURFACES: Column = Column::new("lost at surfaces", "zJ");

/// Header of the energy that pairs store, by cause.
pub fn stored(cause: &str) -> String {
    format!("{cause} energy [zJ]")
}

/// The cause of a header that [`stored`] made; the kinetic energy is one too.
pub fn cause_of_stored(header: &str) -> Option<&str> {
    header.strip_suffix(" energy [zJ]")
}

/// Header of the energy that pairs lose, by cause.
pub fn lost(cause: &str) -> String {
    format!("lost to {cause} [zJ]")
}

/// Whether a column holds energy that was lost.
pub fn is_lost(header: &str) -> bool {
    header.starts_with("lost ")
}
