//! A simulation that left its domain of validity.

use std::fmt;

/// When and why a simulation halted.
#[derive(Clone, PartialEq)]
pub struct Halt {
    /// The step that failed.
    pub step: u64,
    /// Simulated time, ns.
    pub time: f64,
    /// The reason.
    pub reason: Reason,
}

/// The reason of a halt.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// A position or velocity is not a finite number.
    NotFinite {
        /// Id of the sphere.
        particle: u32,
    },
    /// A quantity that was to be written is not a finite number.
    NotANumber {
        /// Its name.
        quantity: String,
    },
    /// The overlap of two spheres exceeds the limit.
    Overlap {
        /// Ids of the spheres.
        pair: (u32, u32),
        /// Overlap as a fraction of the sum of the radii.
        ratio: f64,
        /// The largest fraction allowed.
        limit: f64,
    },
    /// The overlap of a sphere with a surface exceeds the limit.
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
        /// The time step, ns.
        dt: f64,
        /// The limit, ns.
        limit: f64,
        /// Id of the sphere that sets it.
        particle: u32,
    },
    /// A setting with which no simulation can be advanced.
    Setting {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The values that it may have.
        expected: &'static str,
    },
    /// A neck joins a sphere that does not exist.
    NoSphere {
        /// Its id.
        particle: u32,
    },
    /// Two spheres joined by a neck belong to the same rigid body or wall.
    Neck {
        /// Ids of the spheres.
        pair: (u32, u32),
    },
    /// The neighbours of a sphere do not fit into one block of the pair loop.
    TooManyNeighbours {
        /// Id of the sphere.
        particle: u32,
    },
}

impl fmt::Display for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {} (t = {} ns): ", self.step, self.time)?;
        match &self.reason {
            Reason::NotFinite { particle } => {
                write!(f, "the position or velocity of particle {particle} is not finite")
            }
            Reason::NotANumber { quantity } => write!(f, "`{quantity}` is not a finite number"),
            Reason::Overlap { pair: (i, j), ratio, limit } => {
                write!(f, "particles {i} and {j} overlap by {ratio:.3} of the sum of their radii (limit {limit})")
            }
            Reason::Sunk { particle, ratio, limit } => {
                write!(f, "particle {particle} overlaps a surface by {ratio:.3} of its radius (limit {limit})")
            }
            Reason::TimeStep { dt, limit, particle } => {
                write!(f, "time step {dt} ns is not below the stability limit {limit} ns of particle {particle}")
            }
            Reason::Setting { name, value, expected } => {
                write!(f, "the setting `{name}` is {value}, expected {expected}")
            }
            Reason::NoSphere { particle } => write!(f, "a neck joins particle {particle}, which does not exist"),
            Reason::Neck { pair: (i, j) } => {
                write!(f, "particles {i} and {j} are joined by a neck but belong to the same rigid body or wall")
            }
            Reason::TooManyNeighbours { particle } => write!(f, "particle {particle} has too many neighbours"),
        }
    }
}

/// As it is displayed: `main` prints an error so.
impl fmt::Debug for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Halt {}
