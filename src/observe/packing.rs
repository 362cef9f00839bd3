//! Packing: volume fraction and coordination number.

use super::Link;
use crate::spec::mechanics::packing;
use crate::system::System;

/// The fraction of the box that is filled by spheres, overlaps counted twice.
pub fn volume_fraction(system: &System) -> f64 {
    let cubes = system.particles.radius.iter().map(|&r| 8.0 * r * r * r).sum();
    packing::volume_fraction(cubes, system.domain.volume())
}

/// Mean number of neighbours that a sphere touches (`touching`) or at least attracts.
pub fn coordination(system: &System, links: &[Link], touching: bool) -> f64 {
    let counted = links.iter().filter(|link| !touching || link.gap <= 0.0).count();
    2.0 * counted as f64 / system.particles.len() as f64
}
