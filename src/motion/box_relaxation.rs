//! A box that gives way to the stress inside it until none is left.
//!
//! Each side moves as the homogeneous deformation it imposes would: with the inertia of the spheres it carries along,
//! damped critically for the modulus of the material, so that the box is never slower than the sound that crosses it.

use crate::system::Domain;

/// How the sides of the box move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxRelaxation {
    /// Diagonal stress to reach, MPa, positive in tension.
    pub target: [f64; 3],
    /// Young's modulus of the material, MPa: sets the damping.
    pub modulus: f64,
}

impl BoxRelaxation {
    /// Advances the rates of strain of the sides, 1/ns, and returns the factors by which the box and all positions grow.
    pub fn grow(&self, rate: &mut [f64; 3], stress: [f64; 3], domain: &Domain, mass: f64, dt: f64) -> [f64; 3] {
        std::array::from_fn(|a| {
            // A slab of uniform density whose points move in proportion to their distance from the middle.
            let inertia = mass * domain.sides[a] * domain.sides[a] / 12.0;
            let frequency = (domain.volume() * self.modulus / inertia).sqrt();
            let pull = domain.volume() * (stress[a] - self.target[a]) / inertia;
            rate[a] -= (pull + 2.0 * frequency * rate[a]) * dt;
            1.0 + rate[a] * dt
        })
    }
}
