//! A simulation that left its domain.

use std::fmt;

/// Why and when a simulation cannot go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Halt {
    /// The step that failed.
    pub step: u64,
    /// Simulated time, ns.
    pub time: f64,
    /// What went wrong.
    pub reason: Reason,
}

/// What went wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// A position or velocity is not a finite number.
    NotFinite {
        /// Id of the sphere.
        particle: u32,
    },
    /// Two spheres overlap by more than was allowed.
    Overlap {
        /// Ids of the spheres.
        pair: (u32, u32),
        /// Overlap as a fraction of the sum of the radii.
        ratio: f64,
        /// The largest fraction allowed.
        limit: f64,
    },
    /// A sphere is too deep in a surface.
    Sunk {
        /// Id of the sphere.
        particle: u32,
        /// Overlap as a fraction of its radius.
        ratio: f64,
        /// The largest fraction allowed.
        limit: f64,
    },
    /// The time step is above the stability limit.
    TimeStep {
        /// The step asked for, ns.
        dt: f64,
        /// The limit, ns.
        limit: f64,
        /// Id of the sphere that sets it.
        particle: u32,
    },
    /// Two spheres that a neck joins belong to one rigid body or wall.
    Neck {
        /// Ids of the spheres.
        pair: (u32, u32),
    },
    /// A sphere is so large, or has so many neighbours, that a block of the pair loop cannot hold them.
    TooManyNeighbours {
        /// Id of the sphere.
        particle: u32,
    },
}

impl fmt::Display for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {} (t = {} ns): ", self.step, self.time)?;
        match &self.reason {
            Reason::NotFinite { particle } => write!(f, "particle {particle} has no finite position or velocity"),
            Reason::Overlap { pair: (i, j), ratio, limit } => {
                write!(f, "particles {i} and {j} overlap by {ratio:.3} of the sum of their radii (limit {limit})")
            }
            Reason::Sunk { particle, ratio, limit } => {
                write!(f, "particle {particle} is in a surface by {ratio:.3} of its radius (limit {limit})")
            }
            Reason::TimeStep { dt, limit, particle } => {
                write!(f, "time step {dt} ns is not below the stability limit {limit} ns of particle {particle}")
            }
            Reason::Neck { pair: (i, j) } => {
                write!(f, "particles {i} and {j} are joined by a neck, but belong to one rigid body or wall")
            }
            Reason::TooManyNeighbours { particle } => write!(f, "particle {particle} has too many neighbours"),
        }
    }
}

impl std::error::Error for Halt {}
