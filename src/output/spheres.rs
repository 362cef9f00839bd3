//! Spheres as files of programs for optics and mobility. Lengths are in nm.

use crate::geometry::Sphere;
use crate::spec::Vec3;
use std::collections::HashMap;
use std::fmt::Write;

/// Rows `x y z r`: the spheres of MSTM 4, whose `length_scale_factor` is then 2 π over the wavelength in nm.
pub fn mstm(spheres: &[Sphere]) -> String {
    rows("", spheres)
}

/// Rows `SPHERE x y z r`: a body of ZENO.
pub fn bod(spheres: &[Sphere]) -> String {
    rows("SPHERE ", spheres)
}

fn rows(word: &str, spheres: &[Sphere]) -> String {
    let row = |Sphere { centre: Vec3([x, y, z]), radius }: &Sphere| format!("{word}{x} {y} {z} {radius}\n");
    spheres.iter().map(row).collect()
}

/// A mesh in the PLY format: 320 triangles a sphere, with corners on its surface. Where spheres overlap, so do their meshes.
pub fn ply(spheres: &[Sphere]) -> String {
    let (corners, faces) = unit_sphere();
    let [vertices, triangles] = [&corners.len(), &faces.len()].map(|count| count * spheres.len());
    let mut text = format!(
        "ply\nformat ascii 1.0\ncomment lengths in nm\nelement vertex {vertices}\nproperty double x\nproperty double y\n\
         property double z\nelement face {triangles}\nproperty list uchar uint vertex_indices\nend_header\n"
    );
    for sphere in spheres {
        for &corner in &corners {
            let Vec3([x, y, z]) = sphere.centre + corner * sphere.radius;
            writeln!(text, "{x} {y} {z}").expect("text can be written");
        }
    }
    for first in (0..spheres.len()).map(|sphere| sphere * corners.len()) {
        for [a, b, c] in &faces {
            writeln!(text, "3 {} {} {}", first + a, first + b, first + c).expect("text can be written");
        }
    }
    text
}

/// A mesh of the unit sphere, seen from outside counterclockwise: an icosahedron, each of whose triangles is divided into four, twice.
fn unit_sphere() -> (Vec<Vec3<f64>>, Vec<[usize; 3]>) {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let unit = |v: Vec3<f64>| v * (1.0 / v.norm());
    let mut corners = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(|corner| unit(Vec3(corner))));
    }
    let edge = 2.0 / (golden * golden + 1.0).sqrt();
    let near = |a: usize, b: usize| (corners[a] - corners[b]).norm() < 1.01 * edge;
    let mut faces = Vec::new();
    for (a, b, c) in (0..12).flat_map(|a| (0..a).flat_map(move |b| (0..b).map(move |c| (a, b, c)))) {
        if near(a, b) && near(b, c) && near(c, a) {
            let outward = corners[a].dot(corners[b].cross(corners[c])) > 0.0;
            faces.push(if outward { [a, b, c] } else { [a, c, b] });
        }
    }
    for _ in 0..2 {
        let mut middles = HashMap::new();
        let mut middle = |a: usize, b: usize| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                corners.push(unit(corners[a] + corners[b]));
                corners.len() - 1
            })
        };
        let divided = faces.iter().flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        });
        faces = divided.collect();
    }
    (corners, faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mesh_of_a_sphere_is_closed_and_nearly_as_large() {
        let (corners, faces) = unit_sphere();
        assert_eq!((corners.len(), faces.len()), (162, 320));
        let sides = |face: &[usize; 3]| [0, 1, 2].map(|k| (face[k], face[(k + 1) % 3]));
        let edges: std::collections::HashSet<_> = faces.iter().flat_map(sides).collect();
        assert!(edges.len() == 960 && edges.iter().all(|&(a, b)| edges.contains(&(b, a))));
        let volume: f64 = faces.iter().map(|f| corners[f[0]].dot(corners[f[1]].cross(corners[f[2]])) / 6.0).sum();
        let sphere = 4.0 / 3.0 * std::f64::consts::PI;
        assert!(0.95 * sphere < volume && volume < sphere, "{volume}");
    }
}
