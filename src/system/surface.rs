//! Surfaces that spheres lean on: the substrate, the tip. They move as they are told, whatever acts on them.

use super::mesh::{Mesh, Seen};
use crate::spec::Vec3;
use crate::spec::soot::eq25_tip::tip_velocity;
use serde::{Deserialize, Serialize};

/// What a surface looks like before it has moved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// The half-space behind a plane.
    Plane {
        /// A point of the plane, nm.
        point: Vec3<f64>,
        /// Its outward normal.
        normal: Vec3<f64>,
    },
    /// Triangles.
    Mesh(Mesh),
}

/// How a surface moves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Course {
    /// Not at all.
    Still,
    /// Along z, down and up again, Eq. 25.
    Tip {
        /// Final velocity, m/s.
        velocity: f64,
        /// Rate of the turn, 1/ns.
        rate: f64,
        /// Time of the turn, ns.
        turn: f64,
    },
}

impl Course {
    /// Velocity at a time since the start, m/s.
    pub fn velocity(&self, time: f64) -> Vec3<f64> {
        match *self {
            Self::Still => Vec3::zero(),
            Self::Tip { velocity, rate, turn } => Vec3([0.0, 0.0, tip_velocity(time, velocity, rate, turn)]),
        }
    }
}

/// Forces by their cause, pN.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Forces {
    /// Along the normals of contacts.
    pub contact: Vec3<f64>,
    /// Across them.
    pub friction: Vec3<f64>,
    /// Van der Waals attraction.
    pub van_der_waals: Vec3<f64>,
}

impl Forces {
    /// No force.
    pub fn zero() -> Self {
        Self { contact: Vec3::zero(), friction: Vec3::zero(), van_der_waals: Vec3::zero() }
    }

    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            contact: self.contact + other.contact,
            friction: self.friction + other.friction,
            van_der_waals: self.van_der_waals + other.van_der_waals,
        }
    }

    /// Those of the other side.
    pub fn reversed(self) -> Self {
        Self { contact: -self.contact, friction: -self.friction, van_der_waals: -self.van_der_waals }
    }

    /// Whatever the cause.
    pub fn total(&self) -> Vec3<f64> {
        self.contact + self.friction + self.van_der_waals
    }
}

/// Springs of the contacts of a surface, found again by sphere and place: a contact that slides from a face to an edge goes on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grips {
    /// Ids of the spheres, ascending, and the places on the surface before it moved.
    pub places: Vec<(u32, Vec3<f64>)>,
    /// Their springs, end to end.
    pub springs: Vec<f64>,
}

impl Grips {
    /// Those of a sphere.
    pub fn of(&self, sphere: u32) -> GripsOf<'_> {
        let first = self.places.partition_point(|place| place.0 < sphere);
        let count = self.places[first..].iter().take_while(|place| place.0 == sphere).count();
        GripsOf { grips: self, left: (first..first + count).collect() }
    }

    fn springs_at(&self, k: usize) -> &[f64] {
        let width = self.springs.len() / self.places.len();
        &self.springs[k * width..(k + 1) * width]
    }
}

/// The contacts of one sphere that have not been found again yet.
pub struct GripsOf<'a> {
    grips: &'a Grips,
    left: Vec<usize>,
}

impl<'a> GripsOf<'a> {
    /// The springs of the contact that was nearest to a place, if within `jump`.
    pub fn take(&mut self, place: Vec3<f64>, jump: f64) -> Option<&'a [f64]> {
        let distance = |k: usize| (self.grips.places[k].1 - place).norm();
        let nearest =
            (0..self.left.len()).min_by(|&a, &b| distance(self.left[a]).total_cmp(&distance(self.left[b])))?;
        if distance(self.left[nearest]) > jump {
            return None;
        }
        Some(self.grips.springs_at(self.left.remove(nearest)))
    }

    /// The places and springs of the contacts that have not been found again.
    pub fn rest(self) -> impl Iterator<Item = (Vec3<f64>, &'a [f64])> {
        self.left.into_iter().map(|k| (self.grips.places[k].1, self.grips.springs_at(k)))
    }
}

/// A surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Its name in the records of a run.
    pub name: String,
    /// What it is made of: the model knows.
    pub material: usize,
    /// Its shape before it has moved.
    pub shape: Shape,
    /// How it moves.
    pub course: Course,
    /// Its velocity, m/s.
    pub velocity: Vec3<f64>,
    /// How far it has moved, nm.
    pub way: Vec3<f64>,
    /// For how long, ns.
    pub age: f64,
    /// The forces of the spheres on it in the last step.
    pub force: Forces,
    /// The springs of its contacts.
    pub grips: Grips,
}

impl Surface {
    /// A surface that begins to move.
    pub fn new(name: &str, material: usize, shape: Shape, course: Course) -> Self {
        let zero = Vec3::zero();
        let (velocity, force) = (course.velocity(0.0), Forces::zero());
        Self {
            name: name.into(),
            material,
            shape,
            course,
            velocity,
            way: zero,
            age: 0.0,
            force,
            grips: Grips::default(),
        }
    }

    /// Where it is nearest to `x`, if within `reach`, and every other place within `touch` where the distance has a minimum. Places are those before it moved.
    pub fn see(&self, x: Vec3<f64>, reach: f64, touch: f64, found: &mut Vec<Seen>) {
        let p = x - self.way;
        match &self.shape {
            Shape::Plane { point, normal } => {
                let distance = (p - *point).dot(*normal);
                if distance <= reach {
                    found.push(Seen { n: *normal, distance, place: p - *normal * distance });
                }
            }
            Shape::Mesh(mesh) => mesh.see(p, reach, touch, found),
        }
    }

    /// Moves it by one step, with the velocity in the middle of the step.
    pub fn advance(&mut self, dt: f64) {
        self.velocity = self.course.velocity(self.age + 0.5 * dt);
        self.way = self.way + self.velocity * dt;
        self.age += dt;
    }
}
