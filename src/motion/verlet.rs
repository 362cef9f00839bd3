//! Velocity Verlet for free spheres: half a kick and the drift, then, with the new forces, the other half kick.

use super::{MotionTotals, inertia};
use crate::spec::Vec3;
use crate::spec::mechanics::kinetic_energy::kinetic_energy;
use crate::spec::mechanics::verlet::{half_step_start, verlet_begin, verlet_end};
use crate::system::Particles;

/// The time integration: velocities staggered by half a step, or synchronous with the positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Half a step behind them: [`half_step`](crate::spec::mechanics::verlet::half_step), the symplectic Euler method with its velocities so understood.
    #[default]
    HalfStep,
    /// At the same time: velocity Verlet. For free spheres and surfaces, without global damping, in a box of fixed sides.
    VelocityVerlet,
}

/// Takes the velocities back by a time, ns, with the loads at the positions.
pub fn delay(particles: &mut Particles, loads: &[[f64; 6]], time: f64) {
    for p in 0..particles.len() {
        let (force, torque) = split(&loads[p]);
        let (_, v, w, m, i) = state(particles, p);
        (particles.v[p], particles.w[p]) = half_step_start(v, w, force, torque, m, i, 2.0 * time);
    }
}

/// Moves spheres to their next positions, with the loads where they were and the velocities there; leaves the velocities in the middle of the step.
pub fn begin(particles: &mut Particles, loads: &[[f64; 6]], listed: &[Vec3<f64>], dt: f64) -> MotionTotals {
    let mut moved = MotionTotals::default();
    for p in 0..particles.len() {
        let (force, torque) = split(&loads[p]);
        let (x, v, w, m, i) = state(particles, p);
        let (half, x, spin) = verlet_begin(x, v, w, force, torque, m, i, dt);
        moved.scheme += kinetic_energy(m, half - v, i, spin - w);
        moved.stray(x - listed[p]);
        (particles.x[p], particles.v[p], particles.w[p]) = (x, half, spin);
    }
    moved
}

/// Ends the step with the loads at the new positions.
pub fn end(particles: &mut Particles, loads: &[[f64; 6]], dt: f64) -> MotionTotals {
    let mut moved = MotionTotals::default();
    for p in 0..particles.len() {
        let (force, torque) = split(&loads[p]);
        let (_, half, w, m, i) = state(particles, p);
        let (v, spin) = verlet_end(half, w, force, torque, m, i, dt);
        moved.scheme += kinetic_energy(m, v - half, i, spin - w);
        moved.kinetic += kinetic_energy(m, v, i, spin);
        moved.add_momentum_flux(m, v);
        (particles.v[p], particles.w[p]) = (v, spin);
    }
    moved
}

/// Force and torque.
fn split(&[fx, fy, fz, tx, ty, tz]: &[f64; 6]) -> (Vec3<f64>, Vec3<f64>) {
    (Vec3([fx, fy, fz]), Vec3([tx, ty, tz]))
}

type State = (Vec3<f64>, Vec3<f64>, Vec3<f64>, f64, f64);

fn state(particles: &Particles, p: usize) -> State {
    (particles.x[p], particles.v[p], particles.w[p], particles.mass[p], inertia(particles, p))
}
