//! Two bodies joined by a cylinder (Section 4), carved out of a relaxed sample.

use crate::spec::Vec3;
use crate::system::{Domain, Motion, System};

/// The initial body of a sphere, shown by its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum JunctionPart {
    /// The lower slab.
    Bottom = 1,
    /// The upper slab.
    Top = 2,
    /// The lower half of the junction.
    JunctionBottom = 3,
    /// The upper half of the junction.
    JunctionTop = 4,
}

impl JunctionPart {
    /// Whether a tag marks a sphere of the junction.
    pub fn is_junction(tag: u32) -> bool {
        tag == Self::JunctionBottom as u32 || tag == Self::JunctionTop as u32
    }
}

/// How two bodies cut out of a sample are held, pressed together and driven.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slide {
    /// Thickness of the rigid layers at the lower and the upper end, nm.
    pub wall: f64,
    /// Velocity of the upper wall along x, m/s.
    pub velocity: f64,
    /// Normal stress on the upper wall, MPa; positive in compression.
    pub pressure: f64,
}

impl Slide {
    /// Keeps the spheres of which `body` says to which body they belong, by their centre; opens the box along y, and makes the two walls. Spheres get
    /// new ids, because their number has changed.
    pub fn carve(&self, full: &System, body: impl Fn(Vec3<f64>) -> Option<JunctionPart>) -> System {
        let sides = full.domain.sides;
        let places: Vec<u32> = (0..full.particles.len() as u32)
            .filter(|&i| body(full.domain.folded(full.particles.x[i as usize])).is_some())
            .collect();
        let mut particles = full.particles.pick(&places);
        for i in 0..particles.len() {
            particles.x[i] = full.domain.folded(particles.x[i]);
            particles.id[i] = i as u32;
            particles.tag[i] = body(particles.x[i]).map_or(0, |body| body as u32);
        }
        let mut system = System::new(particles, Domain { sides, periodic: [true, false, true] });
        let held = Motion::Velocity(0.0);
        system.add_wall([held; 3], |p, i| p.x[i].0[1] < self.wall);
        let force = -self.pressure * sides[0] * sides[2];
        let sheared = [Motion::Velocity(self.velocity), Motion::Load(force), held];
        system.add_wall(sheared, |p, i| p.x[i].0[1] > sides[1] - self.wall);
        system
    }
}

/// A junction: axis along y through the centre of the box, sheared along x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Junction {
    /// Diameter of the cylinder, nm.
    pub diameter: f64,
    /// Distance between the two bodies, nm.
    pub height: f64,
    /// How the bodies are held, pressed together and driven.
    pub slide: Slide,
}

impl Junction {
    /// Removes the spheres whose centres lie between the bodies and outside the cylinder.
    pub fn carve(&self, full: &System) -> System {
        let sides = full.domain.sides;
        self.slide.carve(full, |x| self.body(x, sides))
    }

    /// The body that a sphere centred at `x` belongs to; none if it is removed.
    fn body(&self, x: Vec3<f64>, sides: [f64; 3]) -> Option<JunctionPart> {
        let [x, y, z] = std::array::from_fn(|a| x.0[a] - 0.5 * sides[a]);
        let radius = 0.5 * self.diameter;
        if y <= -0.5 * self.height {
            Some(JunctionPart::Bottom)
        } else if y >= 0.5 * self.height {
            Some(JunctionPart::Top)
        } else if x * x + z * z <= radius * radius {
            Some(if y < 0.0 { JunctionPart::JunctionBottom } else { JunctionPart::JunctionTop })
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::initial::hcp;
    use crate::spec::Real;

    fn carved() -> System {
        let junction =
            Junction { diameter: 10.0, height: 5.0, slide: Slide { wall: 1.5, velocity: 10.0, pressure: 100.0 } };
        junction.carve(&hcp(1.0, [24, 10, 12], 1.0))
    }

    #[test]
    fn a_cylinder_of_the_given_diameter_and_height_links_two_slabs() {
        let system = carved();
        let count = |body: JunctionPart| system.particles.tag.iter().filter(|&&tag| tag == body as u32).count() as f64;
        let density = 2f64.sqrt(); // spheres of diameter 1 per unit volume
        let [lx, ly, lz] = system.domain.sides;
        let slab = density * lx * lz * 0.5 * (ly - 5.0);
        let half = density * f64::pi() * 25.0 * 2.5;
        // Only whole rows are counted: a face is off by half the row spacing at most, the edge of the cylinder by its surface.
        assert!(
            (count(JunctionPart::Bottom) / slab - 1.0).abs() < 0.5 * 0.87 / (0.5 * (ly - 5.0)),
            "{}",
            count(JunctionPart::Bottom) / slab
        );
        assert!((count(JunctionPart::Top) / slab - 1.0).abs() < 0.5 * 0.87 / (0.5 * (ly - 5.0)));
        assert!((count(JunctionPart::JunctionBottom) / half - 1.0).abs() < 0.2);
        assert!((count(JunctionPart::JunctionTop) / half - 1.0).abs() < 0.2);
        assert_eq!(system.particles.tag.iter().filter(|&&tag| tag == 0).count(), 0);
    }

    #[test]
    fn the_lower_wall_is_held_and_the_upper_is_sheared_and_pressed() {
        let system = carved();
        let [lx, ly, lz] = system.domain.sides;
        for i in 0..system.particles.len() {
            let y = system.particles.x[i].0[1];
            let wall = if y < 1.5 {
                1
            } else if y > ly - 1.5 {
                2
            } else {
                0
            };
            assert_eq!(system.particles.wall[i], wall);
        }
        assert_eq!(system.walls[0].motion, [Motion::Velocity(0.0); 3]);
        assert_eq!(
            system.walls[1].motion,
            [Motion::Velocity(10.0), Motion::Load(-100.0 * lx * lz), Motion::Velocity(0.0)]
        );
        assert_eq!(system.domain.periodic, [true, false, true]);
    }
}
