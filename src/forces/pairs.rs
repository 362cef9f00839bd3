//! The pairs of a block, laid out for the pair loop.

use super::blocks::{LANES, NOWHERE, bond};
use super::{Neighbour, Springs};
use crate::spec::numbers::Lanes;
use crate::spec::{Flat, PairModel, Vec3};
use crate::system::{Domain, Image, Particles};
use std::ops::Range;

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

/// Two spheres are laid among the near ones from this gap downwards, in sums of radii.
const NEAR: f64 = 0.01;

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

    /// Lays out the pairs of a block with the spheres `own` and `halo`.
    pub fn lay(
        model: &M,
        particles: &Particles,
        (x, domain): (&[Vec3<f64>], &Domain),
        pairs: &[Neighbour],
        own: &Range<usize>,
        halo: &[(u32, Image)],
        necks: &[(u32, u32)],
        springs: &Springs,
    ) -> Self {
        let place_of = |q: u32, image: Image| {
            if own.contains(&(q as usize)) && image == [0; 3] {
                q as usize - own.start
            } else {
                own.len() + halo.partition_point(|&entry| entry < (q, image))
            }
        };
        let mut laid = Self {
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
        let (far, near): (Vec<&Neighbour>, Vec<&Neighbour>) =
            pairs.iter().partition(|pair| M::MOSTLY_FAR && apart(pair));
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
            let same =
                |last: &M::Coefficients<_>| (0..M::Coefficients::<f64>::LEN).all(|k| last.at(k) == constants.at(k));
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
}
