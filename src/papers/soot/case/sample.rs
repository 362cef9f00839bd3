//! The aggregate of a case of the soot paper: grown, or read from a file.

use crate::case::quantity::{Length, Quantity, quantity};
use crate::case::section::{section, words};
use crate::initial::aggregate::import::Import;
use crate::initial::aggregate::necks::{NECK_DISTANCE, NeckLength};
use std::path::PathBuf;

section! {
    /// A fractal aggregate of touching spheres, grown by cluster-cluster aggregation: N = k_f (R_g / r)^D_f.
    pub struct Aggregate {
        /// Number of spheres N.
        spheres: u64 = 150,
        /// Radius r of the spheres.
        radius: Quantity<Length> = quantity("14 nm"),
        /// Fractal dimension D_f.
        fractal_dimension: f64 = 1.8,
        /// Fractal prefactor k_f.
        prefactor: f64 = 1.4,
        /// Geometric standard deviation of the radii about their median r, truncated at two standard deviations; 1 for equal spheres.
        deviation: f64 = 1.0,
        /// Order of aggregation.
        growth: Growth = Growth::Clusters,
        /// Imports the spheres from a file instead of growing the aggregate; the keys above are then ignored. They are joined by necks, never rigid bodies; velocities in the file are those at
        /// the start, except in a deposition.
        import: Option<Import> = None,
        /// Whether the spheres of the file lie on the substrate, the plane z = 0, and stay where they are: a deposited aggregate of another program, for an indentation without a deposition.
        on_substrate: bool = false,
        /// File with a deposited aggregate to start from; it must have been made with the same model and the same values of the other keys. A different
        /// seed removes different necks and indents a different sphere.
        deposited: Option<PathBuf> = None,
        /// Fraction of the contacts, or of the necks of an imported file, that are necks, chosen at random.
        neck_fraction: f64 = 0.5,
        /// Largest gap or overlap of a neck; the default allows for rounding only. Unless `neck_length` says otherwise the springs of a neck are relaxed at contact, so
        /// a neck across a finite gap is stretched from the beginning; the authors allow 1 nm.
        neck_distance: Quantity<Length> = quantity(&format!("{NECK_DISTANCE} nm")),
        /// Length of necks at rest: `as-given` for sintered spheres and coordinates with few decimals. Spheres that overlap then have necks also beyond `neck_distance`, and
        /// touch where they are at the start, with a neck or without.
        neck_length: NeckLength = NeckLength::Touching,
        /// Largest energy that springs hold at the start, as a multiple of the energy that the aggregate can take without being torn apart: the sum of the kinetic
        /// energy of its deposition, of the adhesion of its contacts and of the thermal motion of its spheres at 298 K.
        initial_energy: f64 = 1.0,
        /// Whether necks may form closed rings; the authors omit a neck between spheres that other necks already connect.
        neck_cycles: bool = false,
    }
}

words! {
    /// Order of aggregation.
    pub enum Growth {
        /// Cluster-cluster aggregation: clusters of similar size are joined.
        Clusters = "clusters",
        /// Particle-cluster aggregation: one sphere after the other, for compact aggregates.
        Spheres = "spheres",
    }
}

impl Aggregate {
    /// The smallest and the largest radius that spheres may have, nm, if they are grown.
    pub fn radii(&self) -> Option<[f64; 2]> {
        let (r, widest) = (self.radius.value, self.deviation * self.deviation);
        (self.import.is_none() && self.deposited.is_none()).then_some([r / widest, r * widest])
    }
}
