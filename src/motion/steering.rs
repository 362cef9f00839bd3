//! Springs that pull centres of mass.

use crate::spec::Vec3;
use crate::spec::mechanics::drive::{ramped_time, steering};
use crate::spec::mechanics::oscillation::period;
use crate::spec::mechanics::work::path_work;
use crate::system::{Particles, Steering};

impl Steering {
    /// A relaxed spring at the centre of mass of the spheres with these ids, equally stiff along all axes, whose far end moves at this velocity.
    pub fn new(particles: &Particles, spheres: Vec<u32>, stiffness: f64, velocity: Vec3<f64>) -> Self {
        let (zero, stiffness) = (Vec3::zero(), Vec3([stiffness; 3]));
        let mut new =
            Self { spheres, stiffness, velocity, ramp: 0.0, origin: zero, travel: zero, force: zero, age: 0.0 };
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

    /// The ramp, and the period of oscillation of its spheres on the spring, ns, after which the initial acceleration has ended.
    pub fn swing(&self, particles: &Particles) -> f64 {
        let stiffest = self.stiffness.0.into_iter().fold(0.0, f64::max);
        self.ramp + period(self.centre(particles).1, stiffest)
    }

    /// Displacement of the far end of the spring, nm.
    pub fn drawn(&self) -> Vec3<f64> {
        self.velocity * ramped_time(self.age, self.ramp)
    }

    /// Evaluates the spring and advances it by a step; returns its work since the step before, zJ.
    pub fn pull(&mut self, centre: Vec3<f64>, dt: f64) -> f64 {
        let (force, travel) = (self.force, self.travel);
        self.travel = centre - self.origin;
        let tau = ramped_time(self.age, self.ramp);
        let along = |a: usize| steering(self.stiffness.0[a], self.travel.0[a], 0.0, self.velocity.0[a], tau);
        self.force = Vec3([along(0), along(1), along(2)]);
        self.age += dt;
        path_work(force, self.force, self.travel - travel)
    }
}
