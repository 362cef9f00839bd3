//! A plane, such as a substrate, that acts on spheres.

use crate::error::{Done, Trouble, wrong};
use crate::spheres::{Spheres, Totals};
use veridem_spec::{Flat, PairModel, Touch, Vec3};

/// A plane and the history of its contacts.
pub(crate) struct Plane<'a> {
    /// Which of the surfaces of the law it is.
    pub material: usize,
    /// A point of it.
    pub point: Vec3<f64>,
    /// Unit vector to the side of the spheres.
    pub normal: Vec3<f64>,
    /// Its velocity.
    pub velocity: Vec3<f64>,
    /// The springs of each owned sphere.
    pub history: &'a mut [f64],
    /// Force of the spheres on it, to which those of this step are added.
    pub force: Vec3<f64>,
    /// Time step.
    pub dt: f64,
    /// Whether springs advance.
    pub advance: bool,
}

/// Adds the forces of a plane on the owned spheres.
pub(crate) fn act<M: PairModel>(model: &M, plane: &mut Plane, spheres: &mut Spheres, totals: &mut Totals) -> Done {
    let width = M::Memory::<f64>::LEN;
    if plane.material >= M::SURFACES {
        return wrong("this law has no such surface");
    }
    if plane.history.len() != width * spheres.owned {
        return wrong(format!("the history of a plane has {width} numbers for each owned sphere"));
    }
    for p in 0..spheres.owned {
        let springs = &mut plane.history[width * p..][..width];
        let holds = springs.iter().any(|&number| number != 0.0);
        let (r, distance) = (spheres.radius[p], (Vec3(spheres.x[p]) - plane.point).dot(plane.normal));
        if distance > model.surface_range(plane.material, r) && !holds {
            continue;
        }
        let (n, v, omega) = (plane.normal, Vec3(spheres.v[p]) - plane.velocity, Vec3(spheres.omega[p]));
        let touch = Touch { n, gap: distance - r, v, omega, r };
        let (mut force, mut torque) = (-(n * model.surface_pull(plane.material, &touch)), Vec3::zero());
        // A contact that has just ended is evaluated once more: its springs release their energy.
        if touch.gap < 0.0 || holds {
            let memory = Flat::from_fn(|k| springs[k]);
            let outcome = model.surface_contact(plane.material, &touch, memory, plane.dt);
            (force, torque) = (force + outcome.wrench.force, outcome.wrench.torque_i);
            if plane.advance {
                for (k, number) in springs.iter_mut().enumerate() {
                    *number = if touch.gap < 0.0 { *outcome.memory.at(k) } else { 0.0 };
                }
                for (k, sum) in totals.losses.iter_mut().enumerate() {
                    *sum += *outcome.losses.at(k);
                }
            }
        }
        if !force.0.iter().all(|f| f.is_finite()) {
            let id = spheres.id[p];
            return Err(Trouble::Domain(format!("the force of a plane on sphere {id} is not finite")));
        }
        for a in 0..3 {
            spheres.force[p][a] += force.0[a];
            spheres.torque[p][a] += torque.0[a];
        }
        plane.force = plane.force - force;
        if !totals.stored.is_empty() {
            let stored = model.surface_stored(plane.material, &touch, &Flat::from_fn(|k| springs[k]), 1.0);
            for (k, sum) in totals.stored.iter_mut().enumerate() {
                *sum += *stored.at(k);
            }
        }
    }
    Ok(())
}
