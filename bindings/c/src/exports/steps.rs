//! Planes and motion.

use super::VeridemLaw;
use crate::error::{border, wrong};
use crate::motion;
use crate::plane::Plane;
use crate::pointers::{held, held_mut, lent, lent_mut, vector};
use crate::spheres::{RawSpheres, Totals, spheres};
use std::ffi::c_int;

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_plane_step(
    law: *const VeridemLaw,
    raw: *mut RawSpheres,
    material: usize,
    point: *const f64,
    normal: *const f64,
    velocity: *const f64,
    history: *mut f64,
    dt: f64,
    advance: c_int,
    force: *mut f64,
    losses: *mut f64,
    loss_count: usize,
    stored: *mut f64,
    stored_count: usize,
) -> c_int {
    border(|| {
        // SAFETY: a law, spheres, vectors, the history of all owned spheres, and sums of these lengths or null.
        unsafe {
            let (law, mut spheres) = (held(law, "law")?, spheres(raw)?);
            if law.0.plane_range(material, 1.0).is_none() {
                return wrong("this law has no such surface");
            }
            let width = law.0.history().len() - 1;
            let mut plane = Plane {
                material,
                point: vector(point)?,
                normal: vector(normal)?,
                velocity: vector(velocity)?,
                history: lent_mut(history, width * spheres.owned),
                force: vector(force)?,
                dt,
                advance: advance != 0,
            };
            let (losses, stored) = (lent_mut(losses, loss_count), lent_mut(stored, stored_count));
            law.0.plane(&mut plane, &mut spheres, &mut Totals { losses, stored, virial: &mut [] })?;
            *held_mut(force.cast::<[f64; 3]>(), "force")? = plane.force.0;
            Ok(())
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_advance(
    count: usize,
    x: *mut f64,
    v: *mut f64,
    omega: *mut f64,
    radius: *const f64,
    mass: *const f64,
    force: *const f64,
    torque: *const f64,
    moves: *const c_int,
    damping: f64,
    dt: f64,
    drag: *mut f64,
) -> c_int {
    border(|| {
        if [x.cast_const(), v, omega, radius, mass, force, torque].iter().any(|array| array.is_null())
            || moves.is_null()
        {
            return wrong("an array of the motion is a null pointer");
        }
        // SAFETY: arrays of `count` spheres that do not overlap, and a place for the result.
        unsafe {
            let spheres = motion::Moving {
                x: lent_mut(x.cast(), count),
                v: lent_mut(v.cast(), count),
                omega: lent_mut(omega.cast(), count),
                radius: lent(radius, count),
                mass: lent(mass, count),
                force: lent(force.cast(), count),
                torque: lent(torque.cast(), count),
                moves: lent(moves, count),
            };
            *held_mut(drag, "result")? += motion::advance(spheres, damping, dt);
            Ok(())
        }
    })
}

/// # Safety
///
/// Pointers as the header says.
#[unsafe(no_mangle)]
unsafe extern "C" fn veridem_push_wall(
    velocity: *mut f64,
    force: *const f64,
    load: *const f64,
    mass: f64,
    dt: f64,
) -> c_int {
    border(|| {
        // SAFETY: vectors of the caller.
        unsafe {
            let pushed = motion::push(vector(velocity)?, vector(force)?, vector(load)?, mass, dt);
            *held_mut(velocity.cast::<[f64; 3]>(), "velocity")? = pushed.0;
            Ok(())
        }
    })
}
