//! A film as a system of spheres.

use super::DepositedFilm;
use crate::geometry::Sphere;
use crate::initial::aggregate::necks::{NeckLength, necks};
use crate::interrupt::Interrupt;
use crate::system::{Domain, Motion, Particles, System};

/// The bonding of the particles of an aggregate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bonding {
    /// They are one rigid body.
    Rigid,
    /// Necks, where they touch.
    Necks,
}

/// Particles whose nominal spheres are less than this apart touch, nm: enough for rounding.
const TOUCH: f64 = 0.01;

impl DepositedFilm {
    /// The film in a box that ends above it. Aggregates on the floor are one fixed body, whatever holds the others together. `particle`
    /// returns the radius and the mass of a particle of a nominal diameter.
    pub fn system(&self, bonding: Bonding, particle: impl Fn(f64) -> (f64, f64)) -> System {
        let mut particles = Particles::default();
        let mut members = vec![Vec::new(); self.aggregates()];
        for sphere in &self.spheres {
            let (radius, mass) = particle(sphere.diameter);
            members[sphere.aggregate as usize].push(particles.len());
            particles.push(sphere.centre, radius, mass, sphere.aggregate);
        }
        let [width, depth] = self.sides;
        let domain = Domain { sides: [width, depth, self.thickness], periodic: [true, true, false] };
        let mut system = System::new(particles, domain);
        let mut floor = Vec::new();
        for (members, fixed) in members.iter().zip(&self.on_floor) {
            match bonding {
                _ if *fixed => floor.extend(members),
                Bonding::Rigid => system.add_body(members),
                Bonding::Necks => system.necks.extend(self.touching(members)),
            }
        }
        system.add_body(&floor);
        let fixed = system.bodies.len() as u32;
        system.add_wall([Motion::Velocity(0.0); 3], |p, i| p.body[i] == fixed);
        system
    }

    /// The pairs of some spheres that touch: their tree.
    fn touching<'a>(&self, members: &'a [usize]) -> impl Iterator<Item = (u32, u32)> + 'a {
        let sphere = |&k: &usize| Sphere { centre: self.spheres[k].centre, radius: 0.5 * self.spheres[k].diameter };
        let spheres: Vec<Sphere> = members.iter().map(sphere).collect();
        let touching = necks(&spheres, TOUCH, NeckLength::Touching, true, &Interrupt::default());
        let touching = touching.expect("nothing asks to stop").into_iter();
        touching.map(|(i, j)| (members[i] as u32, members[j] as u32))
    }
}
