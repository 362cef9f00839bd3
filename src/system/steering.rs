//! A spring at the centre of mass of some spheres.

use crate::spec::Vec3;
use serde::{Deserialize, Serialize};

/// Free spheres whose centre of mass a spring draws, as in steered molecular dynamics. They share its force by their masses, and move and turn as they like.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steering {
    /// Their ids.
    pub spheres: Vec<u32>,
    /// Stiffness of the spring along each axis, pN/nm.
    pub stiffness: f64,
    /// Velocity of its other end, m/s.
    pub velocity: Vec3<f64>,
    /// The centre of mass when the spring was relaxed, nm.
    pub origin: Vec3<f64>,
    /// How far the centre of mass has moved since, nm.
    pub travel: Vec3<f64>,
    /// The force of the spring in the last step, pN.
    pub force: Vec3<f64>,
    /// For how long it has drawn, ns.
    pub age: f64,
}
