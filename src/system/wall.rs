//! Rigid walls made of spheres.

use crate::spec::Vec3;
use serde::{Deserialize, Serialize};

/// What drives a wall along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Moves at this velocity, m/s, whatever acts on it.
    Velocity(f64),
    /// Is pushed by this force, pN, besides its spheres' neighbours, and moves as one body of its mass.
    Load(f64),
}

/// Spheres that move as one body and do not turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// What drives it, axis by axis.
    pub motion: [Motion; 3],
    /// Its velocity, m/s.
    pub velocity: Vec3<f64>,
    /// Its mass, ag.
    pub mass: f64,
    /// The force of the other spheres on it in the last step, pN.
    pub force: Vec3<f64>,
}

impl Wall {
    /// A wall at its prescribed velocity, at rest where it is load-controlled.
    pub fn new(motion: [Motion; 3], mass: f64) -> Self {
        let velocity = motion.map(|m| match m {
            Motion::Velocity(v) => v,
            Motion::Load(_) => 0.0,
        });
        Self { motion, velocity: Vec3(velocity), mass, force: Vec3::zero() }
    }
}
