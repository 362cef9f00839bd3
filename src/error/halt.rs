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
    /// A sphere for which the time step may have been too long.
    pub unstable: Option<Box<Stability>>,
}

/// The stability of a sphere with all its contacts and necks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// The time step, ns.
    pub dt: f64,
    /// Id of the sphere.
    pub particle: u32,
    /// Number of its contacts.
    pub contacts: usize,
    /// Number of its necks.
    pub necks: usize,
    /// Time step below which it is stable with all of them, ns.
    pub limit: f64,
}

impl Stability {
    /// Whether the time step is below the limit.
    pub fn holds(&self) -> bool {
        self.dt < self.limit
    }
}

/// A number with five significant digits.
fn short(number: f64) -> f64 {
    format!("{number:.4e}").parse().expect("a formatted number is a number")
}

fn in_fs(time: f64) -> String {
    format!("{} fs", short(1e6 * time))
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counted = |number: usize, one: &str| format!("{number} {one}{}", if number == 1 { "" } else { "s" });
        let held = match (self.contacts, self.necks) {
            (0, necks) => counted(necks, "neck"),
            (contacts, 0) => counted(contacts, "contact"),
            (contacts, necks) => format!("{} and {}", counted(necks, "neck"), counted(contacts, "contact")),
        };
        let below = if self.holds() { "is below" } else { "may be too long: it is not below" };
        let (dt, limit, particle) = (in_fs(self.dt), in_fs(self.limit), self.particle);
        write!(f, "the time step {dt} {below} {limit}, where particle {particle} with {held} is stable")
    }
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
    /// It was to stop before its first step.
    Interrupted,
    /// A saved state is not one of this model with these settings.
    Snapshot,
    /// The neighbours of a sphere do not fit into one block of the pair loop.
    TooManyNeighbours {
        /// Id of the sphere.
        particle: u32,
    },
}

impl fmt::Display for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {} (t = {} ns): ", self.step, short(self.time))?;
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
                let (dt, limit) = (in_fs(*dt), in_fs(*limit));
                write!(f, "time step {dt} is not below the stability limit {limit} of particle {particle}")
            }
            Reason::Setting { name, value, expected } => {
                write!(f, "the setting `{name}` is {value}, expected {expected}")
            }
            Reason::NoSphere { particle } => write!(f, "a neck joins particle {particle}, which does not exist"),
            Reason::Neck { pair: (i, j) } => {
                write!(f, "particles {i} and {j} are joined by a neck but belong to the same rigid body or wall")
            }
            Reason::Interrupted => f.write_str("interrupted"),
            Reason::Snapshot => f.write_str("the saved state is not one of this model with these settings"),
            Reason::TooManyNeighbours { particle } => write!(f, "particle {particle} has too many neighbours"),
        }?;
        self.unstable.as_ref().map_or(Ok(()), |stability| write!(f, "; {stability}"))
    }
}

/// As it is displayed: `main` prints an error so.
impl fmt::Debug for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Halt {}
