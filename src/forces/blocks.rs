//! The neighbour list cut into blocks that one core works on alone.
//!
//! A block owns a run of particles and the pairs whose first sphere is among them; the other spheres of those pairs are its
//! halo. Positions are copied in, forces are summed inside the block in a fixed order, and what the halo received is handed to
//! the owners afterwards, again in a fixed order. The cut depends on the particles alone, so the sums, and with them every
//! bit of the trajectory, do not depend on how many threads share the work.

use super::Load;
use super::layout::{CAPACITY, LANES, bond, no_loads};
use super::pairs::{FarPairs, Pairs, Places, seat};
use crate::error::Reason;
use crate::geometry::Neighbour;
use crate::spec::{PairModel, Vec3};
use crate::system::Springs;
use crate::system::{Domain, Image, Particles};
use rayon::prelude::*;
use std::ops::Range;

/// Some particles, their pairs, and the spheres around them.
pub struct Block<M: PairModel> {
    /// The particles it owns.
    pub own: Range<usize>,
    /// Spheres of other blocks, or copies of its own, that its pairs need.
    pub halo: Vec<(u32, Image)>,
    /// Its pairs.
    pub pairs: Pairs<M>,
    /// Those of them that cannot touch.
    pub far: FarPairs,
    /// What other blocks' halos hold for it: its particle (counted within the block), the block, the place within that block.
    pub incoming: Vec<(u32, u32, u32)>,
    /// The loads on its spheres in the last step, own and halo.
    pub loads: Box<[Load; CAPACITY]>,
}

impl<M: PairModel> Block<M> {
    /// How many spheres there are in it, its own and its halo.
    #[expect(clippy::len_without_is_empty, reason = "none is empty")]
    pub fn len(&self) -> usize {
        self.own.len() + self.halo.len()
    }

    /// The particle and the copy of it that a place within the block means.
    pub fn member(&self, place: u16) -> (usize, Image) {
        let place = usize::from(place);
        if place < self.own.len() {
            (self.own.start + place, [0; 3])
        } else {
            let (q, image) = self.halo[place - self.own.len()];
            (q as usize, image)
        }
    }

    /// Its pairs, but for the far ones, one by one: places within the block, row and lane.
    pub fn each_pair(&self) -> impl Iterator<Item = (u16, u16, usize, usize)> {
        self.pairs.seats().map(|(row, lane)| (self.pairs.i[row][lane], self.pairs.j[row][lane], row, lane))
    }

    /// The far pairs one by one: places within the block.
    pub fn each_far(&self) -> impl Iterator<Item = (u16, u16)> {
        (0..self.far.len).map(|k| {
            let (row, lane) = seat(k, self.far.len);
            (self.far.i[row][lane], self.far.j[row][lane])
        })
    }
}

/// Two spheres are laid among the near ones from this gap downwards, in sums of radii.
const NEAR: f64 = 0.01;

/// Cuts the pairs, sorted by first sphere, into blocks; springs are found again in `springs`. `x` and `domain` are those that the
/// pairs were found with, `skin` is how much closer two spheres may come before they are found anew. Only the first
/// `moving` particles have pairs; `shares` is what moment of inertia each particle contributes to a contact.
pub fn partition<M: PairModel>(
    model: &M,
    particles: &Particles,
    (x, domain, skin): (&[Vec3<f64>], &Domain, f64),
    pairs: &[Neighbour],
    necks: &[(u32, u32)],
    springs: &Springs,
    (moving, shares): (usize, &[f64]),
) -> Result<Vec<Block<M>>, Reason> {
    let n = moving;
    let mut first = vec![0usize; n + 1];
    for pair in pairs {
        first[pair.p as usize + 1] += 1;
    }
    for p in 0..n {
        first[p + 1] += first[p];
    }
    // Enough blocks to keep the cores busy, large enough for their halos to be small.
    let size = (n / 16).clamp(192, 1024);
    let mut cut = Vec::new();
    for start in (0..n).step_by(size) {
        cut_to_fit(start..(start + size).min(n), particles, pairs, &first, &mut cut)?;
    }
    let mut blocks: Vec<Block<M>> = cut
        .into_par_iter()
        .map(|(own, halo)| {
            let pairs = &pairs[first[own.start]..first[own.end]];
            let (mut joined, mut near, mut others, mut far) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
            for &pair in pairs {
                let (p, q) = (pair.p as usize, pair.q as usize);
                let radii = particles.radius[p] + particles.radius[q];
                let gap = (x[p] - (x[q] + domain.shift(pair.image))).norm() - radii;
                let (i, j, _) = bond(particles, p, q, pair.image);
                if necks.binary_search(&(i, j)).is_ok() {
                    joined.push(pair);
                } else if !M::MOSTLY_FAR || gap <= NEAR * radii {
                    near.push(pair);
                } else if gap < skin {
                    others.push(pair);
                } else {
                    far.push(pair);
                }
            }
            near.extend(joined.split_off(joined.len() / LANES * LANES));
            let places = Places { particles, own: &own, halo: &halo };
            let far = FarPairs::lay(&places, &far);
            let pairs = Pairs::lay(model, &places, [&joined, &near, &others], necks, springs, shares);
            Block { own, halo, pairs, far, incoming: Vec::new(), loads: no_loads() }
        })
        .collect();
    hand_out(n, &mut blocks);
    Ok(blocks)
}

type Cut = (Range<usize>, Vec<(u32, Image)>);

/// Halves a run of particles until each part fits a block with its halo.
fn cut_to_fit(
    own: Range<usize>,
    particles: &Particles,
    pairs: &[Neighbour],
    first: &[usize],
    cut: &mut Vec<Cut>,
) -> Result<(), Reason> {
    let mut halo: Vec<(u32, Image)> = pairs[first[own.start]..first[own.end]]
        .iter()
        .filter(|pair| !(own.contains(&(pair.q as usize)) && pair.image == [0; 3]))
        .map(|pair| (pair.q, pair.image))
        .collect();
    halo.sort_unstable();
    halo.dedup();
    if own.len() + halo.len() < CAPACITY {
        cut.push((own, halo));
    } else if own.len() > 1 {
        let middle = own.start + own.len() / 2;
        cut_to_fit(own.start..middle, particles, pairs, first, cut)?;
        cut_to_fit(middle..own.end, particles, pairs, first, cut)?;
    } else {
        return Err(Reason::TooManyNeighbours { particle: particles.id[own.start] });
    }
    Ok(())
}

/// All places of all blocks: particle, block, place within the block.
pub fn places<M: PairModel>(blocks: &[Block<M>]) -> impl Iterator<Item = (usize, u32, u32)> {
    blocks.iter().zip(0..).flat_map(|(block, number)| {
        (0..block.len()).map(move |place| (block.member(place as u16).0, number, place as u32))
    })
}

/// Tells every block what the halos of the others hold for it.
fn hand_out<M: PairModel>(n: usize, blocks: &mut [Block<M>]) {
    let mut owner = vec![0u32; n];
    for (number, block) in blocks.iter().enumerate() {
        owner[block.own.clone()].fill(number as u32);
    }
    let mut incoming = vec![Vec::new(); blocks.len()];
    for (number, block) in blocks.iter().enumerate() {
        for (place, &(q, _)) in block.halo.iter().enumerate() {
            let to = owner[q as usize] as usize;
            let place = (block.own.len() + place) as u32;
            incoming[to].push((q - blocks[to].own.start as u32, number as u32, place));
        }
    }
    for (block, mut list) in blocks.iter_mut().zip(incoming) {
        list.sort_unstable();
        block.incoming = list;
    }
}
