//! The pairs of a block, laid out for the pair loop.

use super::Load;
use super::layout::{CAPACITY, LANES, NOWHERE, bond, no_loads};
use crate::geometry::Neighbour;
use crate::spec::numbers::Lanes;
use crate::spec::{Flat, PairModel};
use crate::system::{Bond, Springs};
use crate::system::{Image, Particles};
use std::ops::Range;

/// Pairs that are evaluated in full, eight to a row: complete rows of pairs joined by necks, pairs that were near when they were listed,
/// then the others. In each part every lane has a stretch of the list of its own, so that neighbouring lanes load different spheres. Spheres are counted
/// within the block: its own first, then the halo. The sphere with the lower id is `i`.
pub struct Pairs<M: PairModel> {
    /// First spheres.
    pub i: Vec<[u16; LANES]>,
    /// Second spheres.
    pub j: Vec<[u16; LANES]>,
    /// Index of the constants of each row: pairs of one material and size share theirs.
    pub kind: Vec<u32>,
    /// Constants.
    pub coefficients: Vec<M::Coefficients<Lanes<LANES>>>,
    /// Springs.
    pub memory: Vec<M::Memory<Lanes<LANES>>>,
    /// Number of pairs in each part; the rest of its last row is padding.
    parts: [usize; 3],
}

/// Pairs that cannot touch before the next rebuild of the neighbour list, in the same layout: they have no springs, and only central forces.
/// These forces change little from step to step and can be held constant.
pub struct FarPairs {
    /// First spheres.
    pub i: Vec<[u16; LANES]>,
    /// Second spheres.
    pub j: Vec<[u16; LANES]>,
    /// Index of the radii of each row.
    pub kind: Vec<u32>,
    /// Radii of first and second spheres.
    pub radii: Vec<[Lanes<LANES>; 2]>,
    /// Number of pairs.
    pub len: usize,
    /// The loads on the spheres of the block when they were evaluated last; none without pairs.
    pub loads: Option<Box<[Load; CAPACITY]>>,
    /// The diagonal of their sum of branch vector times force then.
    pub virial: [f64; 3],
}

/// Where the pair `k` of `of` is: row and lane.
pub(super) fn row_and_lane(k: usize, of: usize) -> (usize, usize) {
    let rows = of.div_ceil(LANES);
    (k % rows, k / rows)
}

/// The pairs of each row.
fn in_rows<T: Copy>(pairs: &[T]) -> impl Iterator<Item = Vec<T>> {
    let rows = pairs.len().div_ceil(LANES);
    (0..rows).map(move |row| pairs.iter().skip(row).step_by(rows).copied().collect())
}

/// Eight numbers, those of missing pairs like the first.
fn lanes(numbers: &[f64]) -> Lanes<LANES> {
    Lanes(std::array::from_fn(|lane| *numbers.get(lane).unwrap_or(&numbers[0])))
}

/// The spheres of a block.
pub struct Places<'a> {
    /// The spheres of the whole system.
    pub particles: &'a Particles,
    /// The particles that the block owns.
    pub own: &'a Range<usize>,
    /// Its halo, sorted.
    pub halo: &'a [(u32, Image)],
}

/// A pair in a block: its persistent key, and the indices of its spheres in the block and in the system.
#[derive(Clone, Copy)]
struct Placed {
    bond: Bond,
    i: u16,
    j: u16,
    p: usize,
    q: usize,
}

impl Places<'_> {
    fn place(&self, q: u32, image: Image) -> usize {
        if self.own.contains(&(q as usize)) && image == [0; 3] {
            q as usize - self.own.start
        } else {
            self.own.len() + self.halo.partition_point(|&entry| entry < (q, image))
        }
    }

    /// The sphere with the lower id comes first.
    fn of(&self, pair: &Neighbour) -> Placed {
        let (p, q) = (pair.p as usize, pair.q as usize);
        let bond = bond(self.particles, p, q, pair.image);
        let (i, j) = ((p - self.own.start) as u16, self.place(pair.q, pair.image) as u16);
        if self.particles.id[p] == bond.0 {
            Placed { bond, i, j, p, q }
        } else {
            Placed { bond, i: j, j: i, p: q, q: p }
        }
    }
}

impl<M: PairModel> Pairs<M> {
    /// The constants of a row.
    pub fn constants(&self, row: usize) -> &M::Coefficients<Lanes<LANES>> {
        &self.coefficients[self.kind[row] as usize]
    }

    /// Changes the constants of a pair whose row has its own.
    pub fn change_constants(
        &mut self,
        row: usize,
        lane: usize,
        change: impl FnOnce(M::Coefficients<f64>) -> M::Coefficients<f64>,
    ) {
        let constants = &mut self.coefficients[self.kind[row] as usize];
        let changed = change(Flat::from_fn(|k| constants.at(k).0[lane]));
        for k in 0..M::Coefficients::<f64>::LEN {
            constants.at_mut(k).0[lane] = *changed.at(k);
        }
    }

    /// The springs of a pair.
    pub fn memory_of(&self, row: usize, lane: usize) -> M::Memory<f64> {
        Flat::from_fn(|k| self.memory[row].at(k).0[lane])
    }

    /// Number of leading rows of pairs joined by necks.
    pub fn joined(&self) -> usize {
        self.parts[0] / LANES
    }

    /// Rows and lanes of the pairs, in order.
    pub fn rows_and_lanes(&self) -> impl Iterator<Item = (usize, usize)> + use<M> {
        let parts = self.parts;
        (0..parts.len()).flat_map(move |part| {
            let before: usize = parts[..part].iter().map(|pairs| pairs.div_ceil(LANES)).sum();
            (0..parts[part]).map(move |k| row_and_lane(k, parts[part])).map(move |(row, lane)| (before + row, lane))
        })
    }

    /// Lays out joined pairs, near pairs, and others that may come near.
    pub fn arrange(
        model: &M,
        places: &Places,
        parts: [&[Neighbour]; 3],
        necks: &[(u32, u32)],
        springs: &Springs,
    ) -> Self {
        let rows = parts.iter().map(|pairs| pairs.len().div_ceil(LANES)).sum();
        let mut laid = Self {
            i: Vec::with_capacity(rows),
            j: Vec::with_capacity(rows),
            kind: Vec::with_capacity(rows),
            coefficients: Vec::with_capacity(if M::FRICTION_STOPS { rows } else { 0 }),
            memory: Vec::with_capacity(rows),
            parts: parts.map(<[_]>::len),
        };
        for row in parts.into_iter().flat_map(in_rows) {
            let (mut i, mut j) = ([NOWHERE; LANES], [0; LANES]);
            let (mut coefficients, mut memory) = (Vec::with_capacity(LANES), Vec::with_capacity(LANES));
            let (r, m) = (&places.particles.radius, &places.particles.mass);
            let of = |Placed { p, q, .. }| model.coefficients(r[p], r[q], m[p], m[q]);
            for (lane, pair) in row.iter().map(|pair| places.of(pair)).enumerate() {
                (i[lane], j[lane]) = (pair.i, pair.j);
                let constants = of(pair);
                let joined = necks.binary_search(&(pair.bond.0, pair.bond.1)).is_ok();
                coefficients.push(if joined { model.joined(constants) } else { constants });
                memory.push(springs.of(pair.bond));
            }
            laid.i.push(i);
            laid.j.push(j);
            // Lanes without a pair have the constants of the first, but no neck, which would act at any distance: their partner is nowhere.
            coefficients.resize(LANES, of(places.of(&row[0])));
            let constants: M::Coefficients<Lanes<LANES>> =
                Flat::from_fn(|k| Lanes(std::array::from_fn(|lane| *coefficients[lane].at(k))));
            let same =
                |last: &M::Coefficients<_>| (0..M::Coefficients::<f64>::LEN).all(|k| last.at(k) == constants.at(k));
            // What friction may stop is a matter of each pair, and changes.
            if M::FRICTION_STOPS || !laid.coefficients.last().is_some_and(same) {
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

impl FarPairs {
    /// Lays out far pairs.
    pub fn arrange(places: &Places, pairs: &[Neighbour]) -> Self {
        let mut laid = Self {
            i: Vec::new(),
            j: Vec::new(),
            kind: Vec::new(),
            radii: Vec::new(),
            len: pairs.len(),
            loads: (!pairs.is_empty()).then(no_loads),
            virial: [0.0; 3],
        };
        for row in in_rows(pairs) {
            let (mut i, mut j) = ([NOWHERE; LANES], [0; LANES]);
            let mut radii = [const { Vec::new() }; 2];
            for (lane, pair) in row.iter().map(|pair| places.of(pair)).enumerate() {
                (i[lane], j[lane]) = (pair.i, pair.j);
                radii[0].push(places.particles.radius[pair.p]);
                radii[1].push(places.particles.radius[pair.q]);
            }
            laid.i.push(i);
            laid.j.push(j);
            let radii = radii.map(|numbers| lanes(&numbers));
            if laid.radii.last() != Some(&radii) {
                laid.radii.push(radii);
            }
            laid.kind.push(laid.radii.len() as u32 - 1);
        }
        laid
    }

    /// The held loads on the first spheres, as numbers to be saved.
    pub fn held_loads(&self, spheres: usize) -> impl Iterator<Item = f64> + '_ {
        let loads = self
            .loads
            .iter()
            .flat_map(move |loads| loads[..spheres].iter().flat_map(|load| load.0[..3].iter().copied()));
        self.virial.into_iter().chain(loads)
    }

    /// Restores the held loads.
    pub fn restore_loads(&mut self, spheres: usize, numbers: &mut impl Iterator<Item = f64>) {
        let mut next = || numbers.next().unwrap_or(f64::NAN);
        self.virial = std::array::from_fn(|_| next());
        for load in self.loads.iter_mut().flat_map(|loads| loads[..spheres].iter_mut()) {
            load.0[..3].fill_with(&mut next);
        }
    }
}
