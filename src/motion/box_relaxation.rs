//! Relaxation of a box: its sides follow the stress until it vanishes.
//!
//! Each side moves as the homogeneous deformation it imposes would: with the inertia of the spheres it carries along,
//! damped critically for the modulus of the material, so that the box is never slower than the sound that crosses it.

use crate::spec::mechanics::box_relaxation::{box_inertia, box_strain_rate, growth};
use crate::system::Domain;

/// The parameters of the relaxation of the box.
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
            let inertia = box_inertia(mass, domain.sides[a]);
            let excess = stress[a] - self.target[a];
            rate[a] = box_strain_rate(rate[a], excess, self.modulus, domain.volume(), inertia, dt);
            growth(rate[a], dt)
        })
    }
}
