//! The tetrahedral tip of the atomic force microscope.

use crate::spec::Vec3;
use crate::system::Mesh;

/// Section 3.1.2: the tetrahedral tip for spheres of radius `r`, apex at the origin.
pub fn tetrahedron(r: f64) -> Mesh {
    let apex = Vec3::zero();
    let [left, right, front] = [[-6.0, -3.0, 5.0], [6.0, -3.0, 5.0], [0.0, 6.0, 5.0]].map(|corner| Vec3(corner) * r);
    let triangles = [[apex, right, left], [apex, front, right], [apex, left, front], [left, right, front]];
    Mesh::new(&triangles).expect("four triangles that meet at six edges")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_is_a_closed_body_with_its_apex_below() {
        let tip = tetrahedron(14.0);
        assert!(tip.is_closed());
        assert_eq!(tip.bounds(), [Vec3([-84.0, -42.0, 0.0]), Vec3([84.0, 84.0, 70.0])]);
        let mut seen = Vec::new();
        tip.distance_minima(Vec3([0.0, 0.0, -3.0]), 14.0, &mut seen);
        assert_eq!(seen.len(), 1);
        assert_eq!((seen[0].n, seen[0].distance), (Vec3([0.0, 0.0, -1.0]), 3.0));
        // A sphere inside it has a negative distance.
        seen.clear();
        tip.distance_minima(Vec3([0.0, 0.0, 30.0]), 100.0, &mut seen);
        assert_eq!(seen.len(), 1);
        assert!(seen[0].distance < 0.0);
    }
}
