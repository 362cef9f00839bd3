//! Neighbours within an aggregate, and its connected components.

use crate::geometry::clusters::Clusters;
use crate::geometry::{Sphere, pairs_within};
use crate::spec::soot::eq26_coordination::are_neighbours;

/// Largest gap between neighbours, as a fraction of their mean diameter (Eq. 26).
pub const NEIGHBOURLY: f64 = 0.01;

/// The pairs of neighbours in the sense of Eq. 26.
pub fn neighbouring(spheres: &[Sphere]) -> Vec<(usize, usize)> {
    let mut pairs = pairs_within(spheres, |r, s| (1.0 + 2.0 * NEIGHBOURLY) * (r + s));
    pairs.retain(|&(i, j)| {
        let (a, b) = (&spheres[i], &spheres[j]);
        are_neighbours(a.centre, b.centre, a.radius, b.radius, NEIGHBOURLY) > 0.0
    });
    pairs
}

/// The number of connected components of the neighbour graph.
pub fn components(spheres: &[Sphere]) -> usize {
    Clusters::new(spheres.len(), neighbouring(spheres)).count()
}
