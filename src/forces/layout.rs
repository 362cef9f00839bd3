//! How blocks are laid out: what they and their pairs must agree on.

use super::Load;
use crate::system::{Bond, Image, Particles};
use num_traits::Zero;

/// Pairs that are evaluated side by side.
pub const LANES: usize = 8;
/// Most spheres in a block, halo included, plus one: place `CAPACITY - 1` is a sphere far from everything, the partner of
/// lanes without a pair.
pub const CAPACITY: usize = 2048;
/// The place of that sphere.
pub const NOWHERE: u16 = CAPACITY as u16 - 1;

/// Loads on the spheres of a block, all zero.
pub fn no_loads() -> Box<[Load; CAPACITY]> {
    vec![Load::zero(); CAPACITY].try_into().expect("as many as it is made of")
}

/// The lasting name of a pair of places, `q` displaced by `image`.
pub fn bond(particles: &Particles, p: usize, q: usize, image: Image) -> Bond {
    let (a, b) = (particles.id[p], particles.id[q]);
    if a <= b { (a, b, image) } else { (b, a, image.map(|k| -k)) }
}
