//! The neighbour list, divided into blocks, each of which is processed by one core.
//!
//! A block owns a run of particles and the pairs whose first sphere is among them; the other spheres of those pairs are its
//! halo. Positions are gathered, forces are summed inside the block in a fixed order, and the forces on the halo are scattered to
//! the owners afterwards, again in a fixed order. The cut depends on the particles alone, so the sums, and with them every
//! bit of the trajectory, do not depend on how many threads share the work.

use super::Load;
use super::layout::{CAPACITY, LANES, bond, no_loads};
use super::pairs::{FarPairs, Pairs, Places, row_and_lane};
use crate::error::Reason;
use crate::geometry::Neighbour;
use crate::geometry::triangles::NearTriangles;
use crate::spec::{PairModel, Vec3};
use crate::system::Springs;
use crate::system::{Domain, Image, Particles};
use rayon::prelude::*;
use std::ops::Range;

/// A pair that may touch, its row and lane.
#[derive(Clone, Copy, Debug)]
pub struct Touchable {
    /// Index and copy of each sphere.
    pub spheres: [(u32, Image); 2],
    /// Its row.
    pub row: u32,
    /// Its lane.
    pub lane: u8,
    /// Whether it touched when contacts were counted last.
    pub touches: bool,
    /// By how much its gap must change after neighbours were listed to come or go, nm.
    pub margin: f64,
}

/// Some particles, their pairs, and the spheres around them.
pub struct Block<M: PairModel> {
    /// The particles it owns.
    pub own: Range<usize>,
    /// Spheres of other blocks, or copies of its own, that its pairs need.
    pub halo: Vec<(u32, Image)>,
    /// Its pairs.
    pub pairs: Pairs<M>,
    /// Those of them that may touch before neighbours are listed anew, and that no neck joins, where friction stops what turns; by margin.
    pub touchable: Vec<Touchable>,
    /// The pairs that cannot touch.
    pub far: FarPairs,
    /// The copies of its particles in the halos of other blocks: particle (counted within the block), block, index within that block.
    pub incoming: Vec<(u32, u32, u32)>,
    /// The loads on its spheres in the last step, own and halo.
    pub loads: Box<[Load; CAPACITY]>,
    /// The triangles near its own spheres, for each surface.
    pub near: Vec<Vec<NearTriangles>>,
}

impl<M: PairModel> Block<M> {
    /// Number of spheres in it, its own and its halo.
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
        self.pairs.rows_and_lanes().map(|(row, lane)| (self.pairs.i[row][lane], self.pairs.j[row][lane], row, lane))
    }

    /// The pairs that may touch before neighbours are listed anew, but for those that necks join.
    fn list_touchable(
        &self,
        particles: &Particles,
        (x, domain, skin): (&[Vec3<f64>], &Domain, f64),
        necks: &[(u32, u32)],
    ) -> Vec<Touchable> {
        let may_touch = |(i, j, row, lane)| {
            let ((p, a), (q, b)) = (self.member(i), self.member(j));
            let gap = (x[p] + domain.shift(a) - (x[q] + domain.shift(b))).norm()
                - (particles.radius[p] + particles.radius[q]);
            let (first, second, _) = bond(particles, p, q, [0; 3]);
            let spheres = [(p as u32, a), (q as u32, b)];
            let (row, lane, margin) = (row as u32, lane as u8, gap.abs());
            (gap <= skin && necks.binary_search(&(first, second)).is_err()).then_some(Touchable {
                spheres,
                row,
                lane,
                touches: false,
                margin,
            })
        };
        let mut touchable: Vec<_> = self.each_pair().filter_map(may_touch).collect();
        touchable.sort_by(|a, b| a.margin.total_cmp(&b.margin));
        touchable
    }

    /// The far pairs one by one: places within the block.
    pub fn each_far(&self) -> impl Iterator<Item = (u16, u16)> {
        (0..self.far.len).map(|k| {
            let (row, lane) = row_and_lane(k, self.far.len);
            (self.far.i[row][lane], self.far.j[row][lane])
        })
    }
}

/// Largest gap at which a pair is listed as near, in sums of radii.
const NEAR: f64 = 0.01;

/// Cuts the pairs, sorted by first sphere, into blocks; springs are found again in `springs`. `x` and `domain` are those that the
/// pairs were found with, `skin` is the distance by which two spheres may approach before the next rebuild. Only the first
/// `moving` particles have pairs.
///
/// # Errors
///
/// If a sphere has more neighbours than a block can hold.
pub fn partition<M: PairModel>(
    model: &M,
    particles: &Particles,
    (x, domain, skin): (&[Vec3<f64>], &Domain, f64),
    pairs: Vec<Neighbour>,
    necks: &[(u32, u32)],
    springs: &Springs,
    moving: usize,
) -> Result<Vec<Block<M>>, Reason> {
    let n = moving;
    let mut first = vec![0usize; n + 1];
    for pair in &pairs {
        first[pair.p as usize + 1] += 1;
    }
    for p in 0..n {
        first[p + 1] += first[p];
    }
    // Enough blocks to keep the cores busy, large enough for their halos to be small.
    let size = (n / 16).clamp(192, 1024);
    let mut cut = Vec::new();
    for start in (0..n).step_by(size) {
        cut_to_fit(start..(start + size).min(n), particles, &pairs, &first, &mut cut)?;
    }
    // Each block frees its pairs when it has laid them out: as a whole they would outlive the largest part of what is made of them.
    let with_pairs = |(own, halo): Cut| {
        let pairs = pairs[first[own.start]..first[own.end]].to_vec();
        (own, halo, pairs)
    };
    let cut: Vec<_> = cut.into_iter().map(with_pairs).collect();
    drop(pairs);
    let mut blocks: Vec<Block<M>> = cut
        .into_par_iter()
        .map(|(own, halo, pairs)| {
            let (mut joined, mut near, mut others, mut far) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
            for pair in pairs {
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
            let far = FarPairs::arrange(&places, &far);
            let pairs = Pairs::arrange(model, &places, [&joined, &near, &others], necks, springs);
            let touchable = Vec::new();
            let mut block =
                Block { own, halo, pairs, touchable, far, incoming: Vec::new(), loads: no_loads(), near: Vec::new() };
            if M::FRICTION_STOPS {
                block.touchable = block.list_touchable(particles, (x, domain, skin), necks);
            }
            block
        })
        .collect();
    hand_out(n, &mut blocks);
    Ok(blocks)
}

type Cut = (Range<usize>, Vec<(u32, Image)>);

/// Bisects a run of particles until each part fits into a block with its halo.
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

/// Sets for every block the copies of its particles in the halos of other blocks.
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
