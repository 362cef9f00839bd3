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

#[cfg(test)]
mod tests {
    use super::*;

    const MODULUS: f64 = 100.0;

    fn grown(target: [f64; 3], stress: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let mut rate = [0.0; 3];
        let domain = Domain::periodic([10.0, 20.0, 40.0]);
        let factors = BoxRelaxation { target, modulus: MODULUS }.grow(&mut rate, stress, &domain, 2.0, 0.01);
        (rate, factors)
    }

    #[test]
    fn a_box_rests_at_its_target_and_gives_way_along_each_axis_to_the_excess() {
        assert_eq!(grown([1.0, -2.0, 3.0], [1.0, -2.0, 3.0]), ([0.0; 3], [1.0; 3]));
        // Tension that exceeds the target pulls the sides together.
        let (rate, factors) = grown([1.0, -2.0, 3.0], [5.0, -2.0, 2.0]);
        assert!(rate[0] < 0.0 && rate[1] == 0.0 && rate[2] > 0.0);
        assert!(factors[0] < 1.0 && factors[1] == 1.0 && factors[2] > 1.0);
        assert_eq!((rate, factors), grown([0.0; 3], [4.0, 0.0, -1.0]));
    }
}
