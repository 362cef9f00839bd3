//! Surfaces in contact with spheres, such as a substrate or a tip. Their motion is prescribed.

use super::Mesh;
use crate::spec::Vec3;
use serde::{Deserialize, Serialize};

/// The shape of a surface before it has moved.
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

/// The prescribed motion of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum PrescribedMotion {
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

/// Springs of the contacts of a surface, matched by sphere and position: a contact that slides from a face to an edge persists.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactTable {
    /// Ids of the spheres, ascending, and the places on the surface before it moved.
    pub places: Vec<(u32, Vec3<f64>)>,
    /// Their springs, end to end.
    pub springs: Vec<f64>,
}

impl ContactTable {
    /// Those of a sphere.
    pub fn of(&self, sphere: u32) -> SphereContacts<'_> {
        let first = self.places.partition_point(|place| place.0 < sphere);
        let count = self.places[first..].iter().take_while(|place| place.0 == sphere).count();
        SphereContacts { contacts: self, left: (first..first + count).collect() }
    }

    fn springs_at(&self, k: usize) -> &[f64] {
        let width = self.springs.len() / self.places.len();
        &self.springs[k * width..(k + 1) * width]
    }
}

/// The contacts of one sphere that have not been found again yet.
pub struct SphereContacts<'a> {
    contacts: &'a ContactTable,
    left: Vec<usize>,
}

impl<'a> SphereContacts<'a> {
    /// The springs of the contact that was nearest to a place, if within `jump`.
    pub fn take(&mut self, place: Vec3<f64>, jump: f64) -> Option<&'a [f64]> {
        let distance = |k: usize| (self.contacts.places[k].1 - place).norm();
        let nearest =
            (0..self.left.len()).min_by(|&a, &b| distance(self.left[a]).total_cmp(&distance(self.left[b])))?;
        if distance(self.left[nearest]) > jump {
            return None;
        }
        Some(self.contacts.springs_at(self.left.remove(nearest)))
    }

    /// The places and springs of the contacts that have not been found again.
    pub fn rest(self) -> impl Iterator<Item = (Vec3<f64>, &'a [f64])> {
        self.left.into_iter().map(|k| (self.contacts.places[k].1, self.contacts.springs_at(k)))
    }
}

/// A surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Its name in the records of a run.
    pub name: String,
    /// Its material, an index into the materials of the model.
    pub material: usize,
    /// Its shape before it has moved.
    pub shape: Shape,
    /// Its prescribed motion.
    pub motion: PrescribedMotion,
    /// Its velocity, m/s.
    pub velocity: Vec3<f64>,
    /// Its displacement, nm.
    pub way: Vec3<f64>,
    /// The time for which it has moved, ns.
    pub age: f64,
    /// The forces of the spheres on it in the last step.
    pub force: Forces,
    /// The springs of its contacts.
    pub contacts: ContactTable,
}
