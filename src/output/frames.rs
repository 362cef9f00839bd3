//! Frames: the state of all particles as an extended XYZ file, which OVITO opens with radii, velocities and bodies.

use crate::system::System;
use std::fmt::Write;

/// The name of a frame in its folder.
pub fn frame_name(number: u64) -> String {
    format!("{number:06}.xyz")
}

/// All particles in the order of their ids, folded into the box, with seven digits. Units: nm, ns.
pub fn extended_xyz(system: &System, stage: &str) -> String {
    let (p, domain) = (&system.particles, &system.domain);
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by_key(|&k| p.id[k]);
    let [a, b, c] = domain.sides;
    let periodic = domain.periodic.map(|yes| if yes { "T" } else { "F" }).join(" ");
    let mut text = format!(
        "{}\nLattice=\"{a} 0 0 0 {b} 0 0 0 {c}\" Origin=\"0 0 0\" pbc=\"{periodic}\" Time={} stage={stage} \
         Properties=species:S:1:id:I:1:body:I:1:wall:I:1:radius:R:1:mass:R:1:pos:R:3:velo:R:3:angular_velocity:R:3\n",
        p.len(),
        system.time,
    );
    for k in order {
        let [x, v, w] = [domain.folded(p.x[k]), p.v[k], p.w[k]].map(|u| u.0.map(|component| component as f32));
        let (radius, mass) = (p.radius[k] as f32, p.mass[k] as f32);
        write!(text, "body{} {} {} {} {radius} {mass}", p.tag[k], p.id[k], p.tag[k], p.wall[k])
            .and_then(|()| [x, v, w].iter().flatten().try_for_each(|number| write!(text, " {number}")))
            .expect("a string can always grow");
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::Vec3;
    use crate::system::{Domain, Particles};

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
             body2 0 2 0 0.25 3 1.5 1 2 0 0 0 0 0 0\nbody1 1 1 0 0.5 4 1.5 4.5 2 0 0 0 0 0 0\n"
        );
    }
}
