//! Nearest points of a surface.

use super::triangles::{DistanceMinimum, Support};
use crate::spec::Vec3;
use crate::system::{Shape, Surface};

impl Surface {
    /// Every minimum of the distance from `x` within `reach`, the nearest first. Places are those before it moved.
    pub fn distance_minima(&self, x: Vec3<f64>, reach: f64, found: &mut Vec<DistanceMinimum>) {
        let p = x - self.way;
        match &self.shape {
            Shape::Plane { point, normal } => {
                let distance = (p - *point).dot(*normal);
                if distance <= reach {
                    let (n, place) = (*normal, p - *normal * distance);
                    found.push(DistanceMinimum { n, distance, place, support: Support::Face });
                }
            }
            Shape::Mesh(mesh) => mesh.distance_minima(p, reach, found),
        }
    }
}
