//! Measurements: stress, strain, elasticity, packing, clusters, and the motion of bodies.

pub mod aggregate;
pub mod film;
pub mod force_curve;
pub mod fractal;
mod loads;
pub mod morphology;
pub mod packing;
pub mod patch;
pub mod rotation;
pub mod shear_layer;
pub mod statistics;
pub mod strain;
pub mod stress;
pub mod third_body;

pub use loads::{ActingPair, Loads, PairKind};

use crate::simulation::Simulation;
use crate::spec::{PairModel, Vec3};
use crate::system::System;

/// A pair of spheres that act on each other, as an observer sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Place of the one sphere.
    pub i: usize,
    /// Place of the other.
    pub j: usize,
    /// From the centre of `i` to the centre of `j`, or of its nearest image, nm.
    pub branch: Vec3<f64>,
    /// Distance of the surfaces, nm.
    pub gap: f64,
    /// Force on `i`, pN.
    pub force: Vec3<f64>,
}

/// All pairs that act on each other now.
pub fn links<M: PairModel>(simulation: &Simulation<M>) -> Vec<Link> {
    let link = |pair: crate::simulation::Pair<M>| Link {
        i: pair.i,
        j: pair.j,
        branch: -pair.branch,
        gap: pair.contact.gap,
        force: pair.outcome.wrench.force,
    };
    simulation.pairs().map(link).collect()
}

/// Position of the second wall, represented by the first of its spheres.
///
/// # Panics
///
/// If there is no second wall.
pub fn upper_wall(system: &System) -> Vec3<f64> {
    let p = &system.particles;
    let first = (0..p.len()).filter(|&i| p.wall[i] == 2).min_by_key(|&i| p.id[i]);
    p.x[first.expect("there are two walls")]
}
