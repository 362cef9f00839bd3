//! The triangles near a sphere, found anew only after it has moved a little.

use super::DistanceMinimum;
use crate::spec::Vec3;
use crate::system::{Mesh, Shape, Surface};

/// Displacement after which triangles are searched anew, as a fraction of the reach.
const LEEWAY: f64 = 0.02;

/// The triangles on which the distance from a sphere may have a minimum while it moves by less than the leeway.
#[derive(Clone, Debug, Default)]
pub struct NearTriangles {
    /// The place of the search and its reach.
    searched: Option<(Vec3<f64>, f64)>,
    triangles: Vec<u32>,
}

impl NearTriangles {
    /// As [`Surface::distance_minima`], at less cost for a sphere that moves little from call to call.
    pub fn distance_minima(&mut self, surface: &Surface, x: Vec3<f64>, reach: f64, found: &mut Vec<DistanceMinimum>) {
        match &surface.shape {
            Shape::Plane { .. } => surface.distance_minima(x, reach, found),
            Shape::Mesh(mesh) => {
                let p = x - surface.way;
                self.search(mesh, p, reach);
                mesh.minima_among(self.triangles.iter().map(|&t| t as usize), p, reach, found);
            }
        }
    }

    fn search(&mut self, mesh: &Mesh, p: Vec3<f64>, reach: f64) {
        let leeway = LEEWAY * reach;
        let valid = |(place, of): (Vec3<f64>, f64)| of == reach && (p - place).norm() <= leeway;
        if !self.searched.is_some_and(valid) {
            self.searched = Some((p, reach));
            self.triangles.clear();
            self.triangles.extend(mesh.candidates(p, reach, leeway).map(|t| t as u32));
        }
    }
}
