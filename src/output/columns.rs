//! The columns of the time series: constants shared by their writers, plots and readers.

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

/// Name of the stage.
pub const STAGE: Column = Column::pure("stage");
/// Number of steps of the stage.
pub const STEP: Column = Column::pure("step");
/// Simulated time.
pub const TIME: Column = Column::new("time", "ns");
/// Kinetic energy of all free spheres and bodies.
pub const KINETIC: Column = Column::new("kinetic energy", "zJ");
/// Energy dissipated by the global damping.
pub const LOST_TO_DRAG: Column = Column::new("lost to drag", "zJ");
/// Energy stored in necks when they broke.
pub const LOST_TO_BREAKING: Column = Column::new("lost to breaking", "zJ");
/// Work done by walls of prescribed velocity.
pub const WORK_OF_WALLS: Column = Column::new("work of walls", "zJ");
/// Work done by loads.
pub const WORK_OF_LOADS: Column = Column::new("work of loads", "zJ");
/// Work done by the deformation of the box.
pub const WORK_OF_BOX: Column = Column::new("work of box", "zJ");
/// Residual of the discrete energy balance.
pub const DISCRETE_RESIDUAL: Column = Column::new("discrete residual", "zJ");
/// Residual of the physical energy balance.
pub const PHYSICAL_RESIDUAL: Column = Column::new("physical residual", "zJ");
/// The physical residual relative to the energy that was converted.
pub const RELATIVE_RESIDUAL: Column = Column::pure("relative residual");
/// Largest overlap, relative to the sum of the radii.
pub const LARGEST_OVERLAP: Column = Column::pure("largest overlap");
/// Normal stresses of the whole box.
pub const STRESS: [Column; 3] =
    [Column::new("stress xx", "MPa"), Column::new("stress yy", "MPa"), Column::new("stress zz", "MPa")];
/// Side lengths of the box.
pub const SIDES: [Column; 3] = [Column::new("side x", "nm"), Column::new("side y", "nm"), Column::new("side z", "nm")];
/// Energy stored in contacts with surfaces, and of the attraction by surfaces.
pub const AT_SURFACES: Column = Column::new("energy at surfaces", "zJ");
/// Energy dissipated at surfaces.
pub const LOST_AT_SURFACES: Column = Column::new("lost at surfaces", "zJ");

/// Header of the energy stored in pairs, by cause.
pub fn stored(cause: &str) -> String {
    format!("{cause} energy [zJ]")
}

/// The cause in a header made by [`stored`]; the kinetic energy counts as one.
pub fn cause_of_stored(header: &str) -> Option<&str> {
    header.strip_suffix(" energy [zJ]")
}

/// Header of the energy dissipated by pairs, by cause.
pub fn lost(cause: &str) -> String {
    format!("lost to {cause} [zJ]")
}

/// Whether a column holds dissipated energy.
pub fn is_lost(header: &str) -> bool {
    header.starts_with("lost ")
}
