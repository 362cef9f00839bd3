//! Springs that pull centres of mass.

use crate::spec::Vec3;
use crate::spec::mechanics::drive::steering;
use crate::spec::mechanics::oscillation::period;
use crate::spec::mechanics::work::path_work;
use crate::system::{Particles, Steering};

impl Steering {
    /// A relaxed spring at the centre of mass of the spheres with these ids.
    pub fn new(particles: &Particles, spheres: Vec<u32>, stiffness: f64, velocity: Vec3<f64>) -> Self {
        let zero = Vec3::zero();
        let mut new = Self { spheres, stiffness, velocity, origin: zero, travel: zero, force: zero, age: 0.0 };
        (new.origin, _) = new.centre(particles);
        new
    }

    /// The indices of its spheres.
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

    /// Period of oscillation of its spheres on the spring, ns, after which the initial acceleration has ended.
    pub fn swing(&self, particles: &Particles) -> f64 {
        period(self.centre(particles).1, self.stiffness)
    }

    /// Displacement of the far end of the spring, nm.
    pub fn drawn(&self) -> Vec3<f64> {
        self.velocity * self.age
    }

    /// Evaluates the spring and advances it by a step; returns its work since the step before, zJ.
    pub fn pull(&mut self, centre: Vec3<f64>, dt: f64) -> f64 {
        let (force, travel) = (self.force, self.travel);
        self.travel = centre - self.origin;
        let along = |a: usize| steering(self.stiffness, self.travel.0[a], 0.0, self.velocity.0[a], self.age);
        self.force = Vec3([along(0), along(1), along(2)]);
        self.age += dt;
        path_work(force, self.force, self.travel - travel)
    }
}
