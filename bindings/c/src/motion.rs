//! The step of the engine: symplectic Euler, with velocities half a step behind the positions.

use std::ffi::c_int;
use veridem_spec::Vec3;
use veridem_spec::mechanics::drag::global_damping;
use veridem_spec::mechanics::kick_and_drift::{drift, kick};
use veridem_spec::mechanics::sphere::moment_of_inertia;
use veridem_spec::mechanics::symplectic_euler::symplectic_euler;
use veridem_spec::mechanics::work::drag_loss;

/// Spheres that move.
pub(crate) struct Moving<'a> {
    pub x: &'a mut [[f64; 3]],
    pub v: &'a mut [[f64; 3]],
    pub omega: &'a mut [[f64; 3]],
    pub radius: &'a [f64],
    pub mass: &'a [f64],
    pub force: &'a [[f64; 3]],
    pub torque: &'a [[f64; 3]],
    /// 1 for a sphere that moves under its forces, 2 for one that keeps its velocity, 0 for one that stays.
    pub moves: &'a [c_int],
}

/// Velocity of a wall under a load along each axis; one whose load is not a number keeps its velocity there.
pub(crate) fn push(velocity: Vec3<f64>, force: Vec3<f64>, load: Vec3<f64>, mass: f64, dt: f64) -> Vec3<f64> {
    let total = Vec3(std::array::from_fn(|a| if load.0[a].is_nan() { 0.0 } else { force.0[a] + load.0[a] }));
    kick(velocity, total, mass, dt)
}

/// Moves spheres by one step; returns the energy lost to the damping.
pub(crate) fn advance(of: Moving, damping: f64, dt: f64) -> f64 {
    let mut lost = 0.0;
    for p in 0..of.x.len() {
        let (x, v, omega) = (Vec3(of.x[p]), Vec3(of.v[p]), Vec3(of.omega[p]));
        if of.moves[p] == 2 {
            of.x[p] = drift(x, v, dt).0;
        } else if of.moves[p] == 1 {
            let (m, r) = (of.mass[p], of.radius[p]);
            let (force, torque) = (Vec3(of.force[p]) + global_damping(damping, v), Vec3(of.torque[p]));
            let (velocity, place, spin) = symplectic_euler(x, v, omega, force, torque, m, moment_of_inertia(m, r), dt);
            lost += drag_loss(damping, v, dt);
            (of.v[p], of.x[p], of.omega[p]) = (velocity.0, place.0, spin.0);
        }
    }
    lost
}
