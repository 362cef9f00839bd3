//! A spring at the centre of mass of some spheres.

use super::Particles;
use crate::spec::Vec3;
use crate::spec::titania::def_drive::steering;
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

impl Steering {
    /// A relaxed spring at the centre of mass of the spheres with these ids.
    pub fn new(particles: &Particles, spheres: Vec<u32>, stiffness: f64, velocity: Vec3<f64>) -> Self {
        let zero = Vec3::zero();
        let mut new = Self { spheres, stiffness, velocity, origin: zero, travel: zero, force: zero, age: 0.0 };
        (new.origin, _) = new.centre(particles);
        new
    }

    /// The places of its spheres.
    pub fn places<'a>(&'a self, particles: &'a Particles) -> impl Iterator<Item = usize> + 'a {
        (0..particles.len()).filter(|&p| self.spheres.contains(&particles.id[p]))
    }

    /// Their centre of mass, nm, and their mass, ag.
    pub fn centre(&self, particles: &Particles) -> (Vec3<f64>, f64) {
        let weigh = |(moment, mass): (Vec3<f64>, f64), p: usize| {
            (moment + particles.x[p] * particles.mass[p], mass + particles.mass[p])
        };
        let (moment, mass) = self.places(particles).fold((Vec3::zero(), 0.0), weigh);
        (moment * (1.0 / mass), mass)
    }

    /// How long its spheres would take to swing once if nothing else touched them, ns: what it takes to set them in motion is over then.
    pub fn swing(&self, particles: &Particles) -> f64 {
        2.0 * std::f64::consts::PI * (self.centre(particles).1 / self.stiffness).sqrt()
    }

    /// How far the other end has been drawn, nm.
    pub fn drawn(&self) -> Vec3<f64> {
        self.velocity * self.age
    }

    /// Sees the centre of mass, pulls, and goes on for a step; returns the work done on the way since the step before, zJ.
    pub fn pull(&mut self, centre: Vec3<f64>, dt: f64) -> f64 {
        let (force, travel) = (self.force, self.travel);
        self.travel = centre - self.origin;
        let along = |a: usize| steering(self.stiffness, self.travel.0[a], 0.0, self.velocity.0[a], self.age);
        self.force = Vec3([along(0), along(1), along(2)]);
        self.age += dt;
        0.5 * (force + self.force).dot(self.travel - travel)
    }
}
