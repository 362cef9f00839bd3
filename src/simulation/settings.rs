//! The settings of a simulation.

use super::Integrator;
use crate::forces::Instructions;
use crate::motion::BoxRelaxation;

/// The settings of a simulation. Units: ns, ag/ns, nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Time step.
    pub dt: f64,
    /// The time integration.
    pub integrator: Integrator,
    /// Whether the velocities at the start have the lag of the system, none if they are given; otherwise they are taken for those that the
    /// integrator needs. For free spheres and surfaces.
    pub synchronous_start: bool,
    /// Coefficient `c` of the global damping force `-c v` on every free sphere.
    pub damping: f64,
    /// The skin of the neighbour list.
    pub skin: f64,
    /// Largest overlap allowed, as a fraction of the sum of the radii; infinite for no limit.
    pub max_overlap: f64,
    /// Lets the sides of the box follow the stress.
    pub relax_box: Option<BoxRelaxation>,
    /// Interval, in steps, at which the central forces of far pairs are recomputed.
    pub far_every: u64,
    /// Vector instructions of the pair loop.
    pub instructions: Instructions,
}

impl Settings {
    /// A time step in ns, and defaults otherwise: velocities half a step behind positions, no damping, neighbours listed
    /// no farther than their range, no limit of overlap, fixed sides, the widest vector instructions.
    pub fn new(dt: f64) -> Self {
        Self {
            dt,
            integrator: Integrator::HalfStep,
            synchronous_start: false,
            damping: 0.0,
            skin: 0.0,
            max_overlap: f64::INFINITY,
            relax_box: None,
            far_every: 1,
            instructions: Instructions::best(),
        }
    }

    /// Another integrator.
    pub fn integrator(self, integrator: Integrator) -> Self {
        Self { integrator, ..self }
    }

    /// Velocities at the start that are those at its time.
    pub fn synchronous_start(self) -> Self {
        Self { synchronous_start: true, ..self }
    }

    /// A global damping coefficient, ag/ns.
    pub fn damping(self, damping: f64) -> Self {
        Self { damping, ..self }
    }

    /// A skin of the neighbour list, nm: the larger it is, the longer the list, and the more seldom it is built.
    pub fn skin(self, skin: f64) -> Self {
        Self { skin, ..self }
    }

    /// A limit of the overlap, as a fraction of the sum of the radii.
    pub fn max_overlap(self, max_overlap: f64) -> Self {
        Self { max_overlap, ..self }
    }

    /// Sides of the box that follow the stress.
    pub fn relax_box(self, relax_box: BoxRelaxation) -> Self {
        Self { relax_box: Some(relax_box), ..self }
    }

    /// The interval, in steps, at which far pairs are evaluated.
    pub fn far_every(self, far_every: u64) -> Self {
        Self { far_every, ..self }
    }

    /// Other vector instructions; results are the same.
    pub fn instructions(self, instructions: Instructions) -> Self {
        Self { instructions, ..self }
    }
}
