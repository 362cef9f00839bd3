//! Frames: the state of all particles as an extended XYZ file, which OVITO and ASE open with radii, velocities, bodies and walls, and the surfaces as a Wavefront file.

use crate::spec::Vec3;
use crate::system::{Domain, Shape, Surface, System};
use std::ffi::OsStr;
use std::fmt::Write;

/// The name of a frame in its folder.
pub fn frame_name(number: u64) -> String {
    format!("{number:06}.xyz")
}

/// The number of the frame to which a file of this name belongs, as its particles or its surfaces.
pub fn frame_number(name: &OsStr) -> Option<u64> {
    let (stem, ending) = name.to_str()?.split_once('.')?;
    let number = stem.parse().ok()?;
    let is_frame = ["xyz", SURFACES].contains(&ending) && frame_name(number) == format!("{stem}.xyz");
    is_frame.then_some(number)
}

/// All particles in the order of their ids, folded into the box, with seven digits. Their species is `X`, which stands for no element; the
/// body is a column. Units: nm, ns.
pub fn extended_xyz(system: &System, stage: &str) -> String {
    let (p, domain) = (&system.particles, &system.domain);
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by_key(|&k| p.id[k]);
    let [a, b, c] = domain.sides;
    let periodic = domain.periodic.map(|yes| if yes { "T" } else { "F" }).join(" ");
    let mut text = format!(
        "{}\nLattice=\"{a} 0 0 0 {b} 0 0 0 {c}\" Origin=\"0 0 0\" pbc=\"{periodic}\" Time={} stage={} \
         Properties=species:S:1:id:I:1:body:I:1:wall:I:1:radius:R:1:mass:R:1:pos:R:3:velo:R:3:angular_velocity:R:3\n",
        p.len(),
        system.time,
        quoted(stage),
    );
    for k in order {
        let [x, v, w] = [domain.folded(p.x[k]), p.v[k], p.w[k]].map(|u| u.0.map(|component| component as f32));
        let (radius, mass) = (p.radius[k] as f32, p.mass[k] as f32);
        write!(text, "X {} {} {} {radius} {mass}", p.id[k], p.tag[k], p.wall[k])
            .and_then(|()| [x, v, w].iter().flatten().try_for_each(|number| write!(text, " {number}")))
            .expect("a string can always grow");
        text.push('\n');
    }
    text
}

/// A value of a comment, in quotes if it holds more than letters, digits and signs.
fn quoted(value: &str) -> String {
    let plain = !value.is_empty() && value.chars().all(|c| c.is_alphanumeric() || "_-.+".contains(c));
    if plain { value.into() } else { format!("\"{}\"", value.replace(['"', '\\'], "'")) }
}

/// The ending of the files of surfaces.
pub const SURFACES: &str = "obj";

/// All surfaces at their present positions, as objects of a Wavefront file. Unit: nm.
pub fn wavefront(system: &System) -> String {
    let (mut text, mut count) = (String::new(), 1);
    for surface in &system.surfaces {
        let (corners, faces) = outline(surface, &system.domain);
        let place = |corner: &Vec3<f64>| (*corner + surface.way).0.map(|x| x as f32);
        writeln!(text, "o {}", surface.name)
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

    #[test]
    fn a_frame_lists_the_particles_by_id_inside_the_box() {
        let mut particles = Particles::default();
        particles.push(Vec3([-0.5, 1.0, 2.0]), 0.25, 3.0, 2);
        particles.push(Vec3([1.5, 4.5, 2.0]), 0.5, 4.0, 1);
        let mut system =
            System::new(particles.pick(&[1, 0]), Domain { sides: [2.0, 4.0, 6.0], periodic: [true, false, true] });
        system.time = 0.5;
        assert_eq!(
            extended_xyz(&system, "shear"),
            "2\nLattice=\"2 0 0 0 4 0 0 0 6\" Origin=\"0 0 0\" pbc=\"T F T\" Time=0.5 stage=shear \
             Properties=species:S:1:id:I:1:body:I:1:wall:I:1:radius:R:1:mass:R:1:pos:R:3:velo:R:3:angular_velocity:R:3\n\
             X 0 2 0 0.25 3 1.5 1 2 0 0 0 0 0 0\nX 1 1 0 0.5 4 1.5 4.5 2 0 0 0 0 0 0\n"
        );
    }

    #[test]
    fn a_stage_of_two_words_is_quoted() {
        let system = System::new(Particles::default(), Domain { sides: [2.0; 3], periodic: [false; 3] });
        assert!(extended_xyz(&system, "restructuring 2").contains(" stage=\"restructuring 2\" Properties="));
        assert_eq!(quoted("a \"b\""), "\"a 'b'\"");
    }

    #[test]
    fn a_frame_is_imported_as_it_was() {
        use crate::initial::aggregate::import::{Options, parse};
        let mut particles = Particles::default();
        particles.push(Vec3([1.0; 3]), 0.5, 3.0, 2);
        particles.push(Vec3([1.0, 1.0, 2.0]), 0.5, 3.0, 2);
        let system = System::new(particles, Domain { sides: [4.0; 3], periodic: [false; 3] });
        let options = Options { unit: Some(1.0), ..Options::default() };
        let interrupt = Default::default();
        let text = extended_xyz(&system, "restructuring 2");
        let found = parse(std::path::Path::new("a.xyz"), text, &options, &interrupt);
        let found: Vec<_> =
            found.unwrap_or_else(|error| panic!("{error}")).spheres.iter().map(|s| (s.centre, s.radius)).collect();
        assert_eq!(found, [(Vec3([1.0; 3]), 0.5), (Vec3([1.0, 1.0, 2.0]), 0.5)]);
    }
}
