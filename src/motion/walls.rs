//! Rigid walls under their drives and the forces of their neighbours.

use crate::spec::Vec3;
use crate::spec::mechanics::drive::tip;
use crate::spec::mechanics::kick_and_drift::{drift, kick};
use crate::spec::mechanics::kinetic_energy::{axial_energy, excess_of_a_kick};
use crate::spec::mechanics::work::{axial_work, work as work_of};
use crate::system::{Motion, Wall};

/// Energy that crossed the walls in one step, zJ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallWork {
    /// Done on the spheres by walls of prescribed velocity.
    pub prescribed: f64,
    /// Done by the loads on the walls they push.
    pub load: f64,
    /// What the integration scheme adds to the kinetic energy of the loaded walls: `dt^2 F^2 / 2m`.
    pub scheme: f64,
    /// Kinetic energy of the loaded walls after the step.
    pub kinetic: f64,
}

impl Wall {
    /// The velocity along an axis with a prescribed schedule, m/s.
    pub fn timed(&self, axis: usize) -> Option<f64> {
        match self.motion[axis] {
            Motion::Return { speed, turn } => Some(tip(speed, turn, self.age).0),
            _ => None,
        }
    }
}

/// Kinetic energy of a wall along the axes on which a load drives it, zJ.
pub fn kinetic_energy(wall: &Wall) -> f64 {
    let moved = |a: &usize| wall.load(*a).is_some();
    (0..3).filter(moved).map(|a| axial_energy(wall.mass, wall.velocity.0[a])).sum()
}

/// Advances the velocities of the walls by one step under the forces and torques of the spheres on them.
pub fn drive(walls: &mut [Wall], acting: &[(Vec3<f64>, Vec3<f64>)], dt: f64) -> WallWork {
    let mut work = WallWork::default();
    for (wall, &(force, torque)) in walls.iter_mut().zip(acting) {
        (wall.force, wall.torque) = (force, torque);
        work.prescribed -= work_of(Vec3::zero(), wall.velocity, torque, wall.spin, dt);
        let mut total = Vec3::zero();
        for a in 0..3 {
            let v = wall.velocity.0[a];
            match wall.load(a) {
                None => work.prescribed -= axial_work(force.0[a], v, dt),
                Some(load) => {
                    total.0[a] = force.0[a] + load;
                    work.load += axial_work(load, v, dt);
                }
            }
        }
        wall.velocity = kick(wall.velocity, total, wall.mass, dt);
        for a in 0..3 {
            wall.velocity.0[a] = wall.timed(a).unwrap_or(wall.velocity.0[a]);
        }
        wall.travel = drift(wall.travel, wall.velocity, dt);
        wall.age += dt;
        work.scheme += excess_of_a_kick(total, wall.mass, dt);
        work.kinetic += kinetic_energy(wall);
    }
    work
}
