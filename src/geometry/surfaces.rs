//! Nearest points of a surface.

use super::triangles::DistanceMinimum;
use crate::spec::Vec3;
use crate::system::{Shape, Surface};

impl Surface {
    /// Where it is nearest to `x`, if within `reach`, and every other place within `touch` where the distance has a minimum. Places are those before it moved.
    pub fn distance_minima(&self, x: Vec3<f64>, reach: f64, touch: f64, found: &mut Vec<DistanceMinimum>) {
        let p = x - self.way;
        match &self.shape {
            Shape::Plane { point, normal } => {
                let distance = (p - *point).dot(*normal);
                if distance <= reach {
                    found.push(DistanceMinimum { n: *normal, distance, place: p - *normal * distance });
                }
            }
            Shape::Mesh(mesh) => mesh.distance_minima(p, reach, touch, found),
        }
    }
}
