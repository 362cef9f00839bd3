//! Surfaces that spheres lean on: the substrate, the tip. They move as they are told, whatever acts on them.

use super::Mesh;
use crate::spec::Vec3;
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
    /// Along z: approach, reversal and withdrawal, by a hyperbolic tangent.
    Reversal {
        /// Final velocity, m/s.
        velocity: f64,
        /// Rate of the reversal, 1/ns.
        rate: f64,
        /// Time of the reversal, ns.
        turn: f64,
    },
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
