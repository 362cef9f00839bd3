//! Orders particles so that neighbours in space are close in memory.

use crate::spec::Vec3;
use crate::system::Domain;
use rayon::prelude::*;

/// The places of the particles along a Z-shaped curve through cubes of the given side; a stable order, so that particles
/// already in order stay in place.
pub fn spatial_order(x: &[Vec3<f64>], domain: &Domain, side: f64) -> Vec<u32> {
    let lowest = x.iter().fold([f64::INFINITY; 3], |low, p| std::array::from_fn(|a| low[a].min(p.0[a])));
    let key = |p: &Vec3<f64>| {
        let folded = domain.folded(*p);
        (0..3).fold(0u64, |key, a| {
            let from = if domain.periodic[a] { 0.0 } else { lowest[a] };
            let cell = ((folded.0[a] - from) / side) as u64;
            key | spread(cell) << a
        })
    };
    let mut keyed: Vec<(u64, u32)> = x.iter().zip(0..).map(|(p, place)| (key(p), place)).collect();
    keyed.par_sort_unstable();
    keyed.into_iter().map(|(_, place)| place).collect()
}

/// The lowest 21 bits of a number, two zeros between each.
fn spread(cell: u64) -> u64 {
    let mut bits = cell & 0x1f_ffff;
    for (shift, mask) in [
        (32, 0x001f_0000_0000_ffff),
        (16, 0x001f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ] {
        bits = (bits | bits << shift) & mask;
    }
    bits
}
