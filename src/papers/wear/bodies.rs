//! Two bodies with asperities that slide on each other for long, cut out of a relaxed sample.

use super::junction::{JunctionPart, Slide};
use crate::spec::Vec3;
use crate::system::System;

/// Two bodies whose faces are waves along x, the direction of sliding, one the mirror image of the other: their crests meet in the
/// middle of the height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bodies {
    /// Number of asperities of each body.
    pub asperities: u64,
    /// Height of the asperities from valley to crest, nm; two flat faces, of height 0, are welded together.
    pub height: f64,
    /// How the bodies are held, pressed together and driven.
    pub slide: Slide,
}

impl Bodies {
    /// Removes the spheres whose centres lie between the bodies.
    pub fn carve(&self, full: &System) -> System {
        let sides = full.domain.sides;
        self.slide.carve(full, |x| self.body(x, sides))
    }

    /// The body that a sphere centred at `x` belongs to; none if it is removed.
    fn body(&self, x: Vec3<f64>, sides: [f64; 3]) -> Option<JunctionPart> {
        let waves = self.asperities as f64 * (x.0[0] / sides[0] - 0.5);
        // Half the distance of the two faces: zero in the middle of the box, where crests meet.
        let depth = 0.5 * self.height * (1.0 - libm::cos(std::f64::consts::TAU * waves));
        let y = x.0[1] - 0.5 * sides[1];
        if y < -depth { Some(JunctionPart::Bottom) } else { (y >= depth).then_some(JunctionPart::Top) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::hcp;

    fn carved(asperities: u64, height: f64) -> (System, System) {
        let full = hcp(1.0, [48, 12, 4], 1.0);
        let slide = Slide { wall: 1.5, velocity: 10.0, pressure: 100.0 };
        (Bodies { asperities, height, slide }.carve(&full), full)
    }

    #[test]
    fn flat_faces_cut_a_sample_in_two_and_leave_every_sphere() {
        let (system, full) = carved(1, 0.0);
        assert_eq!(system.particles.len(), full.particles.len());
        let middle = 0.5 * system.domain.sides[1];
        for (x, &tag) in system.particles.x.iter().zip(&system.particles.tag) {
            assert_eq!(tag == JunctionPart::Top as u32, x.0[1] >= middle);
        }
        assert_eq!(system.walls.len(), 2);
    }

    #[test]
    fn waves_leave_gaps_of_twice_their_height_and_crests_that_meet() {
        let height = 3.0;
        let (system, full) = carved(2, height);
        // A wave of the distance of the faces has the mean of half its height, on either side.
        let [lx, ly, _] = system.domain.sides;
        let removed = 1.0 - system.particles.len() as f64 / full.particles.len() as f64;
        assert!((removed / (height / ly) - 1.0).abs() < 0.1, "{removed}");
        let between = |x: f64| {
            let near = |at: &&Vec3<f64>| (at.0[0] - x).abs() < 1.0;
            let side = |tag: JunctionPart| {
                let own = |(at, &of): (&Vec3<f64>, &u32)| (of == tag as u32).then_some(*at);
                system.particles.x.iter().zip(&system.particles.tag).filter_map(own).collect::<Vec<_>>()
            };
            let top = side(JunctionPart::Top).iter().filter(near).map(|at| at.0[1]).fold(f64::INFINITY, f64::min);
            let bottom = side(JunctionPart::Bottom).iter().filter(near).map(|at| at.0[1]).fold(0.0, f64::max);
            top - bottom
        };
        for quarter in [0.0, 2.0] {
            assert!(between(0.25 * quarter * lx) < 1.3, "crests are a row of spheres apart");
            assert!(
                between(0.25 * (quarter + 1.0) * lx) > 2.0 * height - 0.2,
                "{}",
                between(0.25 * (quarter + 1.0) * lx)
            );
        }
    }
}
