//! Rigid bodies made of spheres.

use crate::spec::{Tensor, Vec3};
use serde::{Deserialize, Serialize};

/// Position and orientation of a body: its centre of mass, nm, never folded back into the box, and the unit quaternion that takes
/// the frame of its principal axes to that of space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Centre of mass.
    pub x: Vec3<f64>,
    /// Scalar part of the orientation.
    pub q_0: f64,
    /// Vector part of the orientation.
    pub q: Vec3<f64>,
}

/// Spheres that move as one body, which turns. Units: nm, m/s, ag.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Its place and orientation.
    pub pose: Pose,
    /// Velocity of its centre of mass.
    pub v: Vec3<f64>,
    /// Angular momentum in its own frame, ag nm^2/ns.
    pub l: Vec3<f64>,
    /// Mass.
    pub mass: f64,
    /// Principal moments of inertia, ag nm^2.
    pub moments: Vec3<f64>,
    /// Distance of the farthest centre of a sphere.
    pub extent: f64,
    /// Number of spheres.
    pub count: f64,
    /// Sum of the places of the spheres in its frame, nm.
    pub lever: Vec3<f64>,
    /// Sum of `r^2 - r r` of the spheres in its frame, nm^2.
    pub spread: Tensor<f64>,
    /// 0 for a free body, `k` for one that moves with `walls[k - 1]` and does not turn.
    pub wall: u32,
    /// The body's name, unique and lasting; bodies change places as spheres do.
    pub id: u32,
}
