//! Whether a state that was read from a file is one that a run can have. The engine relies on it without asking again.

use super::{Body, ContactTable, Domain, Mesh, Motion, Particles, PrescribedMotion, Shape, Springs, Steering, Surface};
use super::{Forces, Pose, System, Wall};
use crate::spec::Vec3;
use std::collections::BTreeSet;

/// Largest coordinate, speed or other component in the engine's units: no sample has such a size, and its cube is finite.
const LARGEST: f64 = 1e100;

/// Whether all numbers are finite, and none is larger than a sample can have it.
pub(crate) fn bounded<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> bool {
    numbers.into_iter().all(|number| (-LARGEST..=LARGEST).contains(number))
}

fn vectors<'a>(vectors: impl IntoIterator<Item = &'a Vec3<f64>>) -> bool {
    vectors.into_iter().all(|vector| bounded(&vector.0))
}

fn positive<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> bool {
    numbers.into_iter().all(|&number| number > 0.0 && number <= LARGEST)
}

impl System {
    /// Whether all vectors have the same length, all numbers are bounded, and all indices and ids are those of something.
    pub fn is_sound(&self) -> bool {
        let Self { particles, domain, bodies, walls, surfaces, steerings, necks, springs, time, step: _, lag } = self;
        let spheres = particles.len() as u32;
        particles.is_sound(bodies.len(), walls.len())
            && domain.suits(particles, &particles.x)
            && bodies.iter().all(|body| body.is_sound(walls.len()))
            && walls.iter().all(Wall::is_sound)
            && surfaces.iter().all(|surface| surface.is_sound(spheres))
            && steerings.iter().all(|steering| steering.is_sound(spheres))
            && necks.iter().all(|&(i, j)| i < j && j < spheres)
            && necks.is_sorted_by(|a, b| a < b)
            && springs.is_sound(spheres)
            && bounded([time, lag])
    }
}

impl Particles {
    fn is_sound(&self, bodies: usize, walls: usize) -> bool {
        let Self { x, v, w, radius, mass, wall, body, arm, id, tag } = self;
        let lengths =
            [v.len(), w.len(), radius.len(), mass.len(), wall.len(), body.len(), arm.len(), id.len(), tag.len()];
        let ids: BTreeSet<u32> = id.iter().copied().collect();
        !x.is_empty()
            && lengths.iter().all(|&length| length == x.len())
            && vectors([x, v, w, arm].into_iter().flatten())
            && positive(radius.iter().chain(mass))
            && wall.iter().all(|&number| number as usize <= walls)
            && body.iter().all(|&number| number as usize <= bodies)
            && tag.iter().all(|&tag| tag as usize <= x.len())
            && ids.len() == x.len()
            && ids.last().is_some_and(|&last| (last as usize) < x.len())
    }
}

/// Farthest that a sphere may have moved through a periodic box, in sides of the box: copies are counted in 16 bits.
const FAR: f64 = 4e3;

impl Domain {
    /// Whether spheres fit into it and are not beyond the copies of it that are counted.
    pub(crate) fn suits(&self, particles: &Particles, places: &[Vec3<f64>]) -> bool {
        let mut periodic = (0..3).filter(|&a| self.periodic[a]);
        let fits = |a: usize| {
            let (side, farthest) = (self.sides[a], self.sides[a] * FAR);
            particles.radius.iter().all(|&radius| radius <= side) && places.iter().all(|x| x.0[a].abs() <= farthest)
        };
        positive(&self.sides) && periodic.all(fits)
    }
}

impl Pose {
    /// Whether its numbers are bounded.
    pub(crate) fn is_sound(&self) -> bool {
        let Self { x, q_0, q } = self;
        vectors([x, q]) && bounded([q_0])
    }
}

impl Body {
    fn is_sound(&self, walls: usize) -> bool {
        let Self { pose, v, l, mass, moments, extent, count, lever, spread, wall, id: _ } = self;
        pose.is_sound()
            && vectors([v, l, lever].into_iter().chain(spread))
            && positive(moments.0.iter().chain([mass, count]))
            && bounded([extent])
            && *wall as usize <= walls
    }
}

impl Wall {
    fn is_sound(&self) -> bool {
        let Self { motion, velocity, mass, spin, force, torque, travel, age } = self;
        let moves = |motion: &Motion| match motion {
            Motion::Velocity(value) | Motion::Load(value) => bounded([value]),
            Motion::Return { speed, turn } => bounded([speed]) && positive([turn]),
        };
        motion.iter().all(moves) && vectors([velocity, spin, force, torque, travel]) && bounded([mass, age])
    }
}

impl Surface {
    fn is_sound(&self, spheres: u32) -> bool {
        let Self { name: _, material: _, shape, motion, velocity, way, age, force, contacts } = self;
        let Forces { contact, friction, van_der_waals } = force;
        let shaped = match shape {
            Shape::Plane { point, normal } => vectors([point, normal]),
            Shape::Mesh(mesh) => mesh.is_sound(),
        };
        let moves = match motion {
            PrescribedMotion::Still => true,
            PrescribedMotion::Reversal { velocity, rate, turn } => bounded([velocity, rate, turn]),
        };
        shaped
            && moves
            && vectors([velocity, way, contact, friction, van_der_waals])
            && bounded([age])
            && contacts.is_sound(spheres)
    }
}

impl Mesh {
    fn is_sound(&self) -> bool {
        let Self { vertices, triangles, across, faces, corners, closed: _, bounds, tree: _ } = self;
        !triangles.is_empty()
            && across.len() == triangles.len()
            && faces.len() == triangles.len()
            && corners.len() == vertices.len()
            && triangles.iter().flatten().all(|&corner| (corner as usize) < vertices.len())
            && across.iter().flatten().all(|&other| other == u32::MAX || (other as usize) < triangles.len())
            && vectors([vertices, faces, corners].into_iter().flatten().chain(bounds))
    }
}

impl ContactTable {
    fn is_sound(&self, spheres: u32) -> bool {
        let Self { places, springs } = self;
        let whole = if places.is_empty() { springs.is_empty() } else { springs.len().is_multiple_of(places.len()) };
        whole
            && places.is_sorted_by_key(|place| place.0)
            && places.iter().all(|place| place.0 < spheres)
            && vectors(places.iter().map(|place| &place.1))
            && bounded(springs)
    }
}

impl Steering {
    fn is_sound(&self, of_system: u32) -> bool {
        let Self { spheres, stiffness, velocity, ramp, origin, travel, force, age } = self;
        let different: BTreeSet<&u32> = spheres.iter().collect();
        !spheres.is_empty()
            && different.len() == spheres.len()
            && spheres.iter().all(|&sphere| sphere < of_system)
            && stiffness.0.iter().all(|k| *k >= 0.0)
            && *ramp >= 0.0
            && vectors([stiffness, velocity, origin, travel, force])
            && bounded([age, ramp])
    }
}

impl Springs {
    fn is_sound(&self, spheres: u32) -> bool {
        let Self { bonds, numbers, width } = self;
        let within = |&((i, j, _), start): &(super::Bond, u32)| {
            i < spheres && j < spheres && (start as usize).saturating_add(*width) <= numbers.len()
        };
        bonds.is_sorted_by(|a, b| a.0 < b.0) && bonds.iter().all(within) && bounded(numbers)
    }
}

#[cfg(test)]
mod tests;
