//! Relaxation of a box: its sides follow the stress until it vanishes.
//!
//! Each side moves as the homogeneous deformation it imposes would: with the inertia of the spheres it carries along,
//! damped critically for the modulus of the material, so that the box is never slower than the sound that crosses it.

use crate::spec::mechanics::box_relaxation::{box_inertia, box_strain_rate, growing_rate, growth};
use crate::system::Domain;
use serde::{Deserialize, Serialize};

/// The motion of the sides of a box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BoxMotion {
    /// Rates of strain, 1/ns.
    pub rate: [f64; 3],
    /// Sum of the rates of the steps before in which a side did not grow, as that would have been by less than the rounding of a position, 1/ns.
    pub owed: [f64; 3],
}

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
    pub fn grow(&self, motion: &mut BoxMotion, stress: [f64; 3], domain: &Domain, mass: f64, dt: f64) -> [f64; 3] {
        let BoxMotion { rate, owed } = motion;
        std::array::from_fn(|a| {
            let inertia = box_inertia(mass, domain.sides[a]);
            let excess = stress[a] - self.target[a];
            rate[a] = box_strain_rate(rate[a], excess, self.modulus, domain.volume(), inertia, dt);
            let growing;
            (growing, owed[a]) = growing_rate(rate[a], owed[a], dt);
            growth(growing, dt)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODULUS: f64 = 100.0;

    fn grown(target: [f64; 3], stress: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let mut motion = BoxMotion::default();
        let factors = BoxRelaxation { target, modulus: MODULUS }.grow(&mut motion, stress, &domain(), 2.0, 0.01);
        (motion.rate, factors)
    }

    fn domain() -> Domain {
        Domain::periodic([10.0, 20.0, 40.0])
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

    #[test]
    fn a_box_creeps_by_less_than_a_rounding_error_a_step() {
        // Each step asks for a strain of 1e-17.
        let (steps, rate) = (10_000, 1e-15);
        let relaxation = BoxRelaxation { target: [0.0; 3], modulus: 0.0 };
        let mut motion = BoxMotion { rate: [rate; 3], owed: [0.0; 3] };
        let mut side = 1.5;
        for _ in 0..steps {
            let [factor, ..] = relaxation.grow(&mut motion, [0.0; 3], &domain(), 2.0, 0.01);
            side *= factor;
        }
        let strain = f64::from(steps) * rate * 0.01;
        assert!(((side - 1.5) / 1.5 / strain - 1.0).abs() < 0.2, "{side}");
    }
}
