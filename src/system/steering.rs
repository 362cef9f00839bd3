//! A spring at the centre of mass of some spheres.

use crate::spec::Vec3;
use serde::{Deserialize, Serialize};

/// Free spheres whose centre of mass is pulled by a spring, as in steered molecular dynamics. The force is distributed by mass; the spheres move and rotate freely.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steering {
    /// Their ids.
    pub spheres: Vec<u32>,
    /// Stiffness of the spring along each axis, pN/nm; zero for an axis along which it does not act.
    pub stiffness: Vec3<f64>,
    /// Velocity of its far end, m/s, from the end of the ramp on.
    pub velocity: Vec3<f64>,
    /// Time in which this velocity grows from zero, ns.
    pub ramp: f64,
    /// The centre of mass when the spring was relaxed, nm.
    pub origin: Vec3<f64>,
    /// Displacement of the centre of mass since then, nm.
    pub travel: Vec3<f64>,
    /// The force of the spring in the last step, pN.
    pub force: Vec3<f64>,
    /// Time for which it has pulled, ns.
    pub age: f64,
}
