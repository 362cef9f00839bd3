//! The columns of the tables of a run and its results: constants shared by their writers, plots and readers.

use std::fmt;

/// A quantity that a run writes: a column of a table, or a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: &'static str,
    /// Its unit; empty for a pure number or words.
    pub unit: &'static str,
    /// Its definition.
    pub about: &'static str,
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.unit.is_empty() { f.write_str(self.name) } else { write!(f, "{} [{}]", self.name, self.unit) }
    }
}

/// Declares a list of quantities, and a constant for each: name, unit, and the definition as its documentation.
#[macro_export]
macro_rules! columns {
    ($(#[doc = $of:literal])* $vis:vis const $all:ident {
        $($(#[doc = $about:literal])* $name:ident = $text:literal $(in $unit:literal)?;)*
    }) => {
        $($(#[doc = $about])* $vis const $name: $crate::output::Column = $crate::output::Column {
            name: $text,
            unit: concat!("" $(, $unit)?),
            about: concat!($($about,)*),
        };)*
        $(#[doc = $of])* $vis const $all: &[$crate::output::Column] = &[$($name),*];
    };
}
pub use columns;

columns! {
    /// The columns of every run, beside the energies and losses of pairs by cause.
    pub const EVERY {
        /// Name of the stage.
        STAGE = "stage";
        /// Number of steps of the stage.
        STEP = "step";
        /// Simulated time.
        TIME = "time" in "ns";
        /// Kinetic energy of all free spheres and bodies.
        KINETIC = "kinetic energy" in "zJ";
        /// Energy dissipated by the global damping.
        LOST_TO_DRAG = "lost to drag" in "zJ";
        /// Energy stored in necks when they broke.
        LOST_TO_BREAKING = "lost to breaking" in "zJ";
        /// Work done by walls of prescribed velocity.
        WORK_OF_WALLS = "work of walls" in "zJ";
        /// Work done by loads.
        WORK_OF_LOADS = "work of loads" in "zJ";
        /// Work done by the deformation of the box.
        WORK_OF_BOX = "work of box" in "zJ";
        /// Residual of the discrete energy balance.
        DISCRETE_RESIDUAL = "discrete residual" in "zJ";
        /// Residual of the physical energy balance.
        PHYSICAL_RESIDUAL = "physical residual" in "zJ";
        /// The physical residual relative to the energy that was converted.
        RELATIVE_RESIDUAL = "relative residual";
        /// Largest overlap, relative to the sum of the radii.
        LARGEST_OVERLAP = "largest overlap";
        /// Normal stress of the whole box along x, positive in tension.
        STRESS_XX = "stress xx" in "MPa";
        /// The same along y.
        STRESS_YY = "stress yy" in "MPa";
        /// The same along z.
        STRESS_ZZ = "stress zz" in "MPa";
        /// Length of the box along x.
        SIDE_X = "side x" in "nm";
        /// The same along y.
        SIDE_Y = "side y" in "nm";
        /// The same along z.
        SIDE_Z = "side z" in "nm";
    }
}

columns! {
    /// The columns of stages with surfaces.
    pub const OF_SURFACES {
        /// Energy stored in contacts with surfaces, and of the attraction by surfaces.
        AT_SURFACES = "energy at surfaces" in "zJ";
        /// Energy dissipated at surfaces.
        LOST_AT_SURFACES = "lost at surfaces" in "zJ";
    }
}

/// Normal stresses of the whole box.
pub const STRESS: [Column; 3] = [STRESS_XX, STRESS_YY, STRESS_ZZ];
/// Side lengths of the box.
pub const SIDES: [Column; 3] = [SIDE_X, SIDE_Y, SIDE_Z];

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
