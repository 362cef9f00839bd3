//! Neighbours within an aggregate, and its connected components.

use crate::error::Error;
use crate::geometry::clusters::Clusters;
use crate::geometry::{Sphere, pairs_within};
use crate::interrupt::Interrupt;
use crate::spec::soot::eq26_coordination::are_neighbours;

/// Largest gap between neighbours, as a fraction of their mean diameter (Eq. 26).
pub const NEIGHBOURLY: f64 = 0.01;

/// The pairs of neighbours in the sense of Eq. 26.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn neighbouring(spheres: &[Sphere], interrupt: &Interrupt) -> Result<Vec<(usize, usize)>, Error> {
    let mut pairs = pairs_within(spheres, |r, s| (1.0 + 2.0 * NEIGHBOURLY) * (r + s), interrupt)?;
    pairs.retain(|&(i, j)| {
        let (a, b) = (&spheres[i], &spheres[j]);
        are_neighbours(a.centre, b.centre, a.radius, b.radius, NEIGHBOURLY) > 0.0
    });
    Ok(pairs)
}

/// The number of connected components of the neighbour graph.
///
/// # Errors
///
/// [`Error::Interrupted`].
pub fn components(spheres: &[Sphere], interrupt: &Interrupt) -> Result<usize, Error> {
    Ok(Clusters::new(spheres.len(), neighbouring(spheres, interrupt)?).count())
}
