//! The neighbour list cut into blocks that one core works on alone.
//!
//! A block owns a run of particles and the pairs whose first sphere is among them; the other spheres of those pairs are its
//! halo. Positions are copied in, forces are summed inside the block in a fixed order, and what the halo received is handed to
//! the owners afterwards, again in a fixed order. The cut depends on the particles alone, so the sums, and with them every
//! bit of the trajectory, do not depend on how many threads share the work.

use super::{Bond, Load, Neighbour, Springs};
use crate::spec::numbers::Lanes;
use crate::spec::{Flat, PairModel, Vec3};
use crate::system::{Domain, Image, Particles, Reason};
use num_traits::Zero;
use rayon::prelude::*;
use std::ops::Range;

/// Pairs that are evaluated side by side.
pub const LANES: usize = 8;
/// Most spheres in a block, halo included, plus one: place `CAPACITY - 1` is a sphere far from everything, the partner of
/// lanes without a pair.
pub const CAPACITY: usize = 2048;
const NOWHERE: u16 = CAPACITY as u16 - 1;

/// Some particles, their pairs, and the spheres around them.
pub struct Block<M: PairModel> {
    /// The particles it owns.
    pub own: Range<usize>,
    /// Spheres of other blocks, or copies of its own, that its pairs need.
    pub halo: Vec<(u32, Image)>,
    /// Its pairs.
    pub pairs: Pairs<M>,
    /// What other blocks' halos hold for it: its particle (counted within the block), the block, the place within that block.
    pub incoming: Vec<(u32, u32, u32)>,
    /// The loads on its spheres in the last step, own and halo.
    pub loads: Box<[Load; CAPACITY]>,
}

/// Pairs, eight to a row: those that were near when they were listed, then the far ones. In each part every lane has a stretch of
/// the list of its own, so that neighbouring lanes load different spheres. Spheres are counted within the block: its own first, then the halo. The sphere with the lower id is `i`.
pub struct Pairs<M: PairModel> {
    /// First spheres.
    pub i: Vec<[u16; LANES]>,
    /// Second spheres.
    pub j: Vec<[u16; LANES]>,
    /// Which constants each row has: those of one material and size are all alike.
    pub kind: Vec<u32>,
    /// Constants.
    pub coefficients: Vec<M::Coefficients<Lanes<LANES>>>,
    /// Springs.
    pub memory: Vec<M::Memory<Lanes<LANES>>>,
    /// Number of pairs; the rest of the last rows of both parts is padding.
    pub len: usize,
    /// How many of them were near.
    pub near: usize,
}

impl<M: PairModel> Block<M> {
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

    /// Its pairs one by one: places within the block, row and lane.
    pub fn each_pair(&self) -> impl Iterator<Item = (u16, u16, usize, usize)> {
        (0..self.pairs.len).map(|k| {
            let (row, lane) = self.pairs.seat(k);
            (self.pairs.i[row][lane], self.pairs.j[row][lane], row, lane)
        })
    }
}

impl<M: PairModel> Pairs<M> {
    /// The constants of a row.
    pub fn constants(&self, row: usize) -> &M::Coefficients<Lanes<LANES>> {
        &self.coefficients[self.kind[row] as usize]
    }

    /// Row and lane of the pair `k`.
    pub fn seat(&self, k: usize) -> (usize, usize) {
        let (before, k, of) = if k < self.near {
            (0, k, self.near)
        } else {
            (self.near.div_ceil(LANES), k - self.near, self.len - self.near)
        };
        let rows = of.div_ceil(LANES);
        (before + k % rows, k / rows)
    }
}

/// Cuts the pairs, sorted by first sphere, into blocks; springs are found again in `springs`. `x` and `domain` are those that the
/// pairs were found with.
pub fn partition<M: PairModel>(
    model: &M,
    particles: &Particles,
    (x, domain): (&[Vec3<f64>], &Domain),
    pairs: &[Neighbour],
    necks: &[(u32, u32)],
    springs: &Springs,
) -> Result<Vec<Block<M>>, Reason> {
    let n = particles.len();
    let mut first = vec![0usize; n + 1];
    for pair in pairs {
        first[pair.p as usize + 1] += 1;
    }
    for p in 0..n {
        first[p + 1] += first[p];
    }
    // Enough blocks to keep the cores busy, large enough for their halos to be small.
    let size = (n / 16).clamp(64, 1024);
    let mut cut = Vec::new();
    for start in (0..n).step_by(size) {
        cut_to_fit(start..(start + size).min(n), particles, pairs, &first, &mut cut)?;
    }
    let mut blocks: Vec<Block<M>> = cut
        .into_par_iter()
        .map(|(own, halo)| {
            let pairs = &pairs[first[own.start]..first[own.end]];
            let pairs = lay(model, particles, (x, domain), pairs, &own, &halo, necks, springs);
            let loads = vec![Load::zero(); CAPACITY].try_into().expect("as many as it is made of");
            Block { own, halo, pairs, incoming: Vec::new(), loads }
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

/// Two spheres are laid among the near ones from this gap downwards, in sums of radii.
const NEAR: f64 = 0.01;

fn lay<M: PairModel>(
    model: &M,
    particles: &Particles,
    (x, domain): (&[Vec3<f64>], &Domain),
    pairs: &[Neighbour],
    own: &Range<usize>,
    halo: &[(u32, Image)],
    necks: &[(u32, u32)],
    springs: &Springs,
) -> Pairs<M> {
    let place_of = |q: u32, image: Image| {
        if own.contains(&(q as usize)) && image == [0; 3] {
            q as usize - own.start
        } else {
            own.len() + halo.partition_point(|&entry| entry < (q, image))
        }
    };
    let mut laid = Pairs {
        i: Vec::new(),
        j: Vec::new(),
        kind: Vec::new(),
        coefficients: Vec::new(),
        memory: Vec::new(),
        len: pairs.len(),
        near: pairs.len(),
    };
    let apart = |pair: &&Neighbour| {
        let (p, q) = (pair.p as usize, pair.q as usize);
        let distance = (x[p] - (x[q] + domain.shift(pair.image))).norm();
        distance > (1.0 + NEAR) * (particles.radius[p] + particles.radius[q])
    };
    let (far, near): (Vec<&Neighbour>, Vec<&Neighbour>) = pairs.iter().partition(|pair| M::MOSTLY_FAR && apart(pair));
    laid.near = near.len();
    let in_rows = |part: &[&Neighbour]| {
        let rows = part.len().div_ceil(LANES);
        (0..rows)
            .map(|row| part.iter().skip(row).step_by(rows).map(|pair| **pair).collect())
            .collect::<Vec<Vec<Neighbour>>>()
    };
    for row in in_rows(&near).into_iter().chain(in_rows(&far)) {
        let mut places = [[NOWHERE; LANES], [0; LANES]];
        let (mut coefficients, mut filler) = (Vec::with_capacity(LANES), None);
        let mut memory = Vec::with_capacity(LANES);
        for (lane, pair) in row.iter().enumerate() {
            let mut ends =
                [(pair.p as usize - own.start, pair.p as usize), (place_of(pair.q, pair.image), pair.q as usize)];
            let key = bond(particles, pair.p as usize, pair.q as usize, pair.image);
            if particles.id[pair.p as usize] != key.0 {
                ends.reverse();
            }
            let [(i, p), (j, q)] = ends;
            places[0][lane] = i as u16;
            places[1][lane] = j as u16;
            let (r, m) = (&particles.radius, &particles.mass);
            let constants = model.coefficients(r[p], r[q], m[p], m[q]);
            filler.get_or_insert(constants);
            let joined = necks.binary_search(&(key.0, key.1)).is_ok();
            coefficients.push(if joined { model.joined(constants) } else { constants });
            memory.push(springs.of(key));
        }
        laid.i.push(places[0]);
        laid.j.push(places[1]);
        // Lanes without a pair have the constants of the first, but no neck, which would act at any distance: their partner is nowhere.
        let filler = filler.expect("a row has a pair");
        let constants: M::Coefficients<Lanes<LANES>> =
            Flat::from_fn(|k| Lanes(std::array::from_fn(|lane| *coefficients.get(lane).unwrap_or(&filler).at(k))));
        let same = |last: &M::Coefficients<_>| (0..M::Coefficients::<f64>::LEN).all(|k| last.at(k) == constants.at(k));
        if !laid.coefficients.last().is_some_and(same) {
            laid.coefficients.push(constants);
        }
        laid.kind.push(laid.coefficients.len() as u32 - 1);
        laid.memory.push(Flat::from_fn(|k| {
            Lanes(std::array::from_fn(|lane| memory.get(lane).copied().flatten().map_or(0.0, |numbers| numbers[k])))
        }));
    }
    laid
}

/// The lasting name of a pair of places, `q` displaced by `image`.
pub fn bond(particles: &Particles, p: usize, q: usize, image: Image) -> Bond {
    let (a, b) = (particles.id[p], particles.id[q]);
    if a <= b { (a, b, image) } else { (b, a, image.map(|k| -k)) }
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
