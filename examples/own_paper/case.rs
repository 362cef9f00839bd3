//! The sections of the case file: every key with its type, its default, and its meaning.

use veridem::case::InSteps;
use veridem::case::quantity::{Density, Length, Quantity, Scale, Scaled, SphereRadius, Stiffness, Time, Velocity};
use veridem::case::section::{choice, section};

/// Marks multiples of the duration of a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTime;
impl Scale for ContactTime {
    const SYMBOL: &'static str = "t_c";
}

choice! {
    /// The contact model.
    pub enum Model {
        /// Cundall & Strack 1979: linear springs with dashpots.
        Linear = "linear": Material,
    }
}
section! {
    /// A material.
    pub struct Material {
        /// Stiffness of the spring.
        stiffness: Quantity<Stiffness>,
        /// Damping factor over the critical one, below 1.
        damping_ratio: f64 = 0.1,
        /// Density of the spheres.
        density: Quantity<Density>,
    }
}
choice! {
    /// The spheres.
    pub enum Sample {
        /// Two equal spheres.
        Pair = "pair": Pair,
    }
}
section! {
    /// Two equal spheres.
    pub struct Pair {
        /// Their radius.
        radius: Quantity<Length>,
        /// The gap between them.
        gap: Scaled<Length, SphereRadius> = Scaled::times(0.1),
    }
}
choice! {
    /// What is done to them.
    pub enum Experiment {
        /// They collide head-on.
        Collision = "collision": Collision,
    }
}
section! {
    /// A head-on collision.
    pub struct Collision {
        /// The velocity with which they approach each other.
        velocity: Quantity<Velocity>,
        /// Time step, as a fraction of the duration of the contact.
        dt: Scaled<Time, ContactTime> = Scaled::times(0.01),
        /// The longest that either stage may take.
        most: InSteps = Scaled::times(100_000.0),
    }
}
