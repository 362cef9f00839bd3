//! Prescribed motion of surfaces, independent of the forces on them.

use crate::spec::Vec3;
use crate::spec::mechanics::approach::tip_velocity;
use crate::spec::mechanics::kick_and_drift::drift;
use crate::system::{ContactTable, Forces, PrescribedMotion, Shape, Surface};

impl PrescribedMotion {
    /// Velocity at a time since the start, m/s.
    pub fn velocity(&self, time: f64) -> Vec3<f64> {
        match *self {
            Self::Still => Vec3::zero(),
            Self::Reversal { velocity, rate, turn } => Vec3([0.0, 0.0, tip_velocity(time, velocity, rate, turn)]),
        }
    }
}

impl Surface {
    /// A surface that begins to move.
    pub fn new(name: &str, material: usize, shape: Shape, motion: PrescribedMotion) -> Self {
        let zero = Vec3::zero();
        let (velocity, force) = (motion.velocity(0.0), Forces::zero());
        Self {
            name: name.into(),
            material,
            shape,
            motion,
            velocity,
            way: zero,
            age: 0.0,
            force,
            contacts: ContactTable::default(),
        }
    }

    /// Moves it by one step, with the velocity in the middle of the step.
    pub fn advance(&mut self, dt: f64) {
        self.velocity = self.motion.velocity(self.age + 0.5 * dt);
        self.way = drift(self.way, self.velocity, dt);
        self.age += dt;
    }
}
