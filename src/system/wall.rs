//! Rigid walls made of spheres.

use crate::spec::Vec3;
use serde::{Deserialize, Serialize};

/// The drive of a wall along one axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Moves at this velocity, m/s, whatever acts on it.
    Velocity(f64),
    /// Is pushed by this force, pN, in addition to the forces of neighbouring spheres, and moves as one body of its mass.
    Load(f64),
    /// Prescribed approach along the axis, reversal and retraction.
    Return {
        /// Speed of approach and retraction, m/s.
        speed: f64,
        /// Duration of the reversal, ns.
        turn: f64,
    },
}

/// Spheres that move as one body, which does not turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// What drives it, axis by axis.
    pub motion: [Motion; 3],
    /// Its velocity, m/s.
    pub velocity: Vec3<f64>,
    /// Its mass, ag.
    pub mass: f64,
    /// The angular velocity of each of its spheres about its own centre, whatever acts on it, 1/ns.
    pub spin: Vec3<f64>,
    /// The force of the other spheres on it in the last step, pN.
    pub force: Vec3<f64>,
    /// The sum of their torques on its spheres in the last step, pN nm.
    pub torque: Vec3<f64>,
    /// Its displacement, nm.
    pub travel: Vec3<f64>,
    /// The time for which it has moved, ns.
    pub age: f64,
}

impl Wall {
    /// A wall at its prescribed velocity, at rest where it is load-controlled.
    pub fn new(motion: [Motion; 3], mass: f64) -> Self {
        let velocity = motion.map(|m| match m {
            Motion::Velocity(velocity) => velocity,
            Motion::Load(_) => 0.0,
            Motion::Return { speed, .. } => -speed,
        });
        let zero = Vec3::zero();
        Self { motion, velocity: Vec3(velocity), mass, spin: zero, force: zero, torque: zero, travel: zero, age: 0.0 }
    }

    /// The force that drives it along an axis, pN; none where its velocity is prescribed.
    pub fn load(&self, axis: usize) -> Option<f64> {
        match self.motion[axis] {
            Motion::Velocity(_) | Motion::Return { .. } => None,
            Motion::Load(force) => Some(force),
        }
    }

    /// Changes its drives; an axis of prescribed velocity continues with the new velocity.
    pub fn redirect(&mut self, motion: [Motion; 3]) {
        (self.motion, self.age) = (motion, 0.0);
    }
}
