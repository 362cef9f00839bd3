//! Spheres from a file: their nominal radii, the rigid bodies that they form, and their velocities.

use super::chain::Particle;
use super::law::radii;
use crate::error::{Error, notice};
use crate::initial::aggregate::import::{Extras, Import, read};
use crate::interrupt::Interrupt;
use crate::spec::Vec3;
use crate::system::System;
use std::path::Path;

/// Most sizes for which the attraction is tabulated, for every two of them: a few seconds.
const SIZES: usize = 100;

/// The particles of a file, and what it says beyond their places and sizes.
pub(super) fn particles(import: &Import, interrupt: &Interrupt) -> Result<(Vec<Particle>, Extras), Error> {
    let imported = read(&import.file, &import.options(), interrupt)?;
    Ok((imported.spheres.iter().map(|sphere| (sphere.centre, 2.0 * sphere.radius)).collect(), imported.extras))
}

/// Makes the bodies of a file whose spheres have the same order as those of the system, and sets all in motion.
pub(super) fn join_and_move(file: &Path, extras: &Extras, system: &mut System) -> Result<(), Error> {
    few_sizes(file, system)?;
    for members in extras.members() {
        if let [single] = members[..] {
            notice(format!("{}: a body of one sphere, {single}, is a sphere by itself", file.display()));
            continue;
        }
        for &p in &members {
            system.particles.tag[p] = members[0] as u32;
        }
        system.add_body(&members);
    }
    move_all(extras, system);
    Ok(())
}

/// Checks that the attraction can be tabulated.
pub(super) fn few_sizes(file: &Path, system: &System) -> Result<(), Error> {
    let sizes = radii(system).len();
    if sizes > SIZES {
        let what = format!("found spheres of {sizes} different sizes, expected at most {SIZES}");
        return Err(Error::input(file, what));
    }
    Ok(())
}

/// Sets spheres and bodies in motion, but what is held by a wall: a body has the momentum and the angular momentum that its spheres would have without it.
pub(super) fn move_all(extras: &Extras, system: &mut System) {
    if extras.v.is_empty() && extras.w.is_empty() {
        return;
    }
    let number = system.particles.len();
    let given = |list: &[Vec3<f64>]| if list.is_empty() { vec![Vec3::zero(); number] } else { list.to_vec() };
    let (v, w) = (given(&extras.v), given(&extras.w));
    let mut members = vec![Vec::new(); system.bodies.len()];
    for p in (0..number).filter(|&p| system.particles.wall[p] == 0) {
        match (system.particles.body[p] as usize).checked_sub(1) {
            Some(body) => members[body].push(p),
            None => (system.particles.v[p], system.particles.w[p]) = (v[p], w[p]),
        }
    }
    for (body, members) in members.iter().enumerate().filter(|(_, members)| !members.is_empty()) {
        system.move_body(body, members, (&v, &w));
    }
}
