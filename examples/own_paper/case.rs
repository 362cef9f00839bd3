//! The sections of the case file: every key with its type, default and meaning.

use veridem::case::InSteps;
use veridem::case::quantity::{Density, Length, Quantity, Scale, Scaled, SphereRadius, Stiffness, Time, Velocity};
use veridem::case::section::{choice, section};

/// Marks multiples of the duration of a contact.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContactTime;
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
        /// Damping ratio: damping coefficient relative to the critical one, below 1.
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
        /// Radius of the spheres.
        radius: Quantity<Length>,
        /// The gap between them.
        gap: Scaled<Length, SphereRadius> = Scaled::times(0.1),
    }
}
choice! {
    /// The experiment.
    pub enum Experiment {
        /// A head-on collision.
        Collision = "collision": Collision,
    }
}
section! {
    /// A head-on collision.
    pub struct Collision {
        /// Velocity of approach.
        velocity: Quantity<Velocity>,
        /// Time step, as a fraction of the duration of the contact.
        dt: Scaled<Time, ContactTime> = Scaled::times(0.01),
        /// Largest duration of either stage.
        most: InSteps = Scaled::times(100_000.0),
    }
}
