//! Where the energy went.
//!
//! Two accounts are kept. The *discrete* one follows the scheme: a kick by `F` changes the kinetic energy by exactly
//! `F . v dt + F^2 dt^2 / 2m`, so the powers of all pairs and walls must add up to the kinetic energy to rounding; it fails if
//! action is not reaction or a torque has the wrong arm. The *physical* one compares with the potentials: it closes to first
//! order in the time step.

use crate::forces::Totals;
use crate::motion::{Moved, WallWork};
use serde::{Deserialize, Serialize};

/// Energies since the start, zJ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Kinetic energy of the free spheres and the loaded walls.
    pub kinetic: f64,
    /// Potential of the normal forces, as of the last look.
    pub normal: f64,
    /// Tangential springs, as of the last look.
    pub tangential: f64,
    /// Lost in normal dashpots.
    pub lost_normal: f64,
    /// Lost in tangential dashpots.
    pub lost_tangential: f64,
    /// Lost by springs that slid or let go.
    pub lost_slip: f64,
    /// Lost to the global damping.
    pub lost_drag: f64,
    /// Work of walls of prescribed velocity.
    pub work_walls: f64,
    /// Work of the loads on walls.
    pub work_loads: f64,
    /// Work of the sides of the box.
    pub work_box: f64,
    /// Kinetic, normal and tangential energy at the start.
    pub start: [f64; 3],
    /// Work of all pairs, at the velocities they saw.
    pub work_pairs: f64,
    /// What the integration scheme added to the kinetic energy.
    pub scheme: f64,
}

impl Ledger {
    pub(super) fn enter(&mut self, totals: &Totals, walls: &WallWork, moved: &Moved, box_work: f64, dt: f64) {
        self.kinetic = moved.kinetic + walls.kinetic;
        self.lost_normal += totals.losses[0];
        self.lost_tangential += totals.losses[1];
        self.lost_slip += totals.losses[2];
        self.lost_drag += moved.drag;
        self.work_walls += walls.prescribed;
        self.work_loads += walls.load;
        self.work_box += box_work;
        self.work_pairs += totals.power * dt;
        self.scheme += moved.scheme + walls.scheme;
    }

    /// All that was lost.
    pub fn lost(&self) -> f64 {
        self.lost_normal + self.lost_tangential + self.lost_slip + self.lost_drag
    }

    /// All work done from outside.
    pub fn work(&self) -> f64 {
        self.work_walls + self.work_loads + self.work_box
    }

    /// The energy that the residuals are to be compared with: all that moved between accounts.
    pub fn turnover(&self) -> f64 {
        let held = [self.kinetic, self.normal, self.tangential];
        let held: f64 = held.iter().zip(self.start).map(|(now, start)| now.abs() + start.abs()).sum();
        held + self.lost() + self.work_walls.abs() + self.work_loads.abs() + self.work_box.abs()
    }

    /// What the discrete account does not explain, zJ: rounding.
    pub fn discrete_residual(&self) -> f64 {
        let gained = self.work_pairs + self.work_walls + self.work_loads + self.scheme - self.lost_drag;
        self.kinetic - self.start[0] - gained
    }

    /// What the physical account does not explain, zJ: first order in the time step.
    pub fn physical_residual(&self) -> f64 {
        self.kinetic + self.normal + self.tangential - self.start.iter().sum::<f64>() + self.lost() - self.work()
    }
}
