//! The layout of blocks, on which blocks and pairs must agree.

use super::Load;
use crate::system::{Bond, Image, Particles};
use num_traits::Zero;

/// Number of pairs that are evaluated in one row.
pub const LANES: usize = 8;
/// Largest number of spheres in a block, halo included, plus one: index `CAPACITY - 1` is a sphere far from everything, the partner of
/// lanes without a pair.
pub const CAPACITY: usize = 2048;
/// The index of that sphere.
pub(super) const NOWHERE: u16 = CAPACITY as u16 - 1;

/// Loads on the spheres of a block, all zero.
pub(super) fn no_loads() -> Box<[Load; CAPACITY]> {
    vec![Load::zero(); CAPACITY].try_into().expect("as many as it is made of")
}

/// The persistent key of a pair of particles, `q` displaced by `image`.
pub fn bond(particles: &Particles, p: usize, q: usize, image: Image) -> Bond {
    let (a, b) = (particles.id[p], particles.id[q]);
    if a <= b { (a, b, image) } else { (b, a, image.map(i16::saturating_neg)) }
}
