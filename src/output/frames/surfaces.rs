//! The surfaces beside a frame, as a Wavefront file.

use crate::spec::Vec3;
use crate::system::{Domain, Shape, Surface, System};
use std::fmt::Write;

/// All surfaces at their present positions: names, corners in nm, and triangles.
pub(super) fn outlines(system: &System) -> impl Iterator<Item = (&str, Vec<Vec3<f64>>, Vec<[u32; 3]>)> {
    system.surfaces.iter().map(|surface| {
        let (corners, faces) = outline(surface, &system.domain);
        (&*surface.name, corners.into_iter().map(|corner| corner + surface.way).collect(), faces)
    })
}

/// All surfaces at their present positions, as objects of a Wavefront file. Unit: nm.
pub(super) fn wavefront(system: &System) -> String {
    let (mut text, mut count) = (String::new(), 1);
    for (name, corners, faces) in outlines(system) {
        let place = |corner: &Vec3<f64>| corner.0.map(|x| x as f32);
        writeln!(text, "o {name}")
            .and_then(|()| corners.iter().map(place).try_for_each(|[x, y, z]| writeln!(text, "v {x} {y} {z}")))
            .and_then(|()| {
                let numbered = faces.iter().map(|face| face.map(|corner| corner + count));
                numbered.into_iter().try_for_each(|[a, b, c]| writeln!(text, "f {a} {b} {c}"))
            })
            .expect("a string can always grow");
        count += corners.len() as u32;
    }
    text
}

/// Vertices and triangles of a surface before it moved; for a plane, the part in or below the box.
fn outline(surface: &Surface, domain: &Domain) -> (Vec<Vec3<f64>>, Vec<[u32; 3]>) {
    match &surface.shape {
        Shape::Mesh(mesh) => (mesh.vertices().to_vec(), mesh.triangles().to_vec()),
        Shape::Plane { point, normal } => {
            let middle = Vec3(domain.sides) * 0.5;
            let middle = middle - *normal * (middle - *point).dot(*normal);
            let half = domain.sides.into_iter().fold(0.0, f64::max);
            let [x, y, z] = normal.0.map(f64::abs);
            let least = [x, y, z].iter().position(|c| *c <= x && *c <= y && *c <= z).expect("one is the least");
            let mut axis = Vec3::zero();
            axis.0[least] = 1.0;
            let across = axis.perpendicular_to(*normal);
            let across = across * (half / across.norm());
            let along = normal.cross(across);
            (
                vec![
                    middle - across - along,
                    middle + across - along,
                    middle + across + along,
                    middle - across + along,
                ],
                vec![[0, 1, 2], [0, 2, 3]],
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::papers::soot::tip::tetrahedron;
    use crate::system::{Particles, PrescribedMotion};

    #[test]
    fn surfaces_are_drawn_where_they_have_moved_to() {
        let mut system = System::new(Particles::default(), Domain { sides: [2.0; 3], periodic: [false; 3] });
        let (up, still) = (Vec3([0.0, 0.0, 1.0]), PrescribedMotion::Still);
        system.surfaces.push(Surface::new("substrate", 0, Shape::Plane { point: Vec3::zero(), normal: up }, still));
        system.surfaces.push(Surface::new("tip", 1, Shape::Mesh(tetrahedron(1.0)), still));
        system.surfaces[1].way = up;
        let text = wavefront(&system);
        assert_eq!((text.matches("v ").count(), text.matches("f ").count()), (8, 6));
        assert!(text.contains("v 3 3 0\n") && text.contains("v 0 0 1\n"), "{text}");
        assert!(text.ends_with("f 6 7 8\n") || text.contains(" 8\n"), "{text}");
    }
}
