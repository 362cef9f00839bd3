//! The aggregate of a case of the soot paper: grown, or read from a file.

use crate::case::quantity::{Length, Quantity, quantity};
use crate::case::section::{section, words};
use crate::initial::aggregate::import::Format;
use crate::initial::aggregate::necks::NECK_DISTANCE;
use std::path::PathBuf;

section! {
    /// A fractal aggregate of touching spheres, by cluster-cluster aggregation: N = k_f (R_g / r)^D_f.
    pub struct Aggregate {
        /// Number of spheres N.
        spheres: u64 = 150,
        /// Their radius r.
        radius: Quantity<Length> = quantity("14 nm"),
        /// Fractal dimension D_f.
        fractal_dimension: f64 = 1.8,
        /// Fractal prefactor k_f.
        prefactor: f64 = 1.4,
        /// Geometric standard deviation of the radii, whose median is r; 1 for equal spheres. None is more than two of it from the median.
        deviation: f64 = 1.0,
        /// In which order the spheres come together.
        growth: Growth = Growth::Clusters,
        /// Reads the spheres from a file instead of growing them; the keys above then have no meaning.
        import: Option<Import> = None,
        /// File with a deposited aggregate to start from; it must have been made with the same keys beside this one and the same model. Another
        /// seed then breaks other necks and indents another sphere.
        deposited: Option<PathBuf> = None,
        /// Part of the contacts that are necks; which ones is drawn from the seed.
        neck_fraction: f64 = 0.5,
        /// Largest gap that a neck bridges: enough for rounding. A neck across a real gap, whose springs are relaxed at contact, would begin
        /// stretched; the authors bridge up to 1 nm.
        neck_distance: Quantity<Length> = quantity(&format!("{NECK_DISTANCE} nm")),
        /// Whether necks may close a ring; the authors leave out a neck between spheres that hang together by others.
        neck_cycles: bool = false,
    }
}

words! {
    /// In which order the spheres of an aggregate come together.
    pub enum Growth {
        /// Clusters of like size are joined.
        Clusters = "clusters",
        /// One sphere after the other: the way to compact aggregates.
        Spheres = "spheres",
    }
}

section! {
    /// An aggregate from FLAGE, MSTM, FracVAL, PyFracVAL, soot-dem (VTK), LAMMPS, or an XYZ file.
    pub struct Import {
        /// The file.
        file: PathBuf,
        /// Its format, where the content does not tell.
        format: Option<Format> = None,
        /// A file of necks that soot-dem wrote beside the spheres: of these, not of all contacts, a part is kept.
        necks: Option<PathBuf> = None,
        /// Its unit of length, where it has none of its own.
        unit: Option<Quantity<Length>> = None,
        /// The radius of all spheres, where it has none.
        radius: Option<Quantity<Length>> = None,
        /// Accepts spheres that do not hang together.
        disconnected: bool = false,
    }
}

impl Aggregate {
    /// The smallest and the largest radius that spheres may have, nm, if they are grown.
    pub fn radii(&self) -> Option<[f64; 2]> {
        let (r, widest) = (self.radius.value, self.deviation * self.deviation);
        (self.import.is_none() && self.deposited.is_none()).then_some([r / widest, r * widest])
    }
}
