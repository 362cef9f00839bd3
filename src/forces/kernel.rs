//! The pair loop: the contact model, eight pairs at a time.

use super::blocks::{Block, CAPACITY, LANES, Pairs};
use super::instructions::Instructions;
use crate::spec::numbers::Lanes;
use crate::spec::{Contact, Flat, PairModel, Real, Vec3};
use crate::system::{Domain, Particles};
use num_traits::Zero;

type Row = Lanes<LANES>;
/// Rows that are gathered before they are evaluated: what is stored number by number is then ready to be read row by row.
const BATCH: usize = 8;

/// Force (pN) and torque (pN nm) on a sphere, end to end.
pub type Load = [f64; 6];

/// Sums over pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Totals {
    /// Power that the pairs deliver to the spheres.
    pub power: f64,
    /// Energy lost in this step: normal dashpots, tangential dashpots, slip.
    pub losses: [f64; 3],
    /// Diagonal of the sum of branch vector times force, positive in tension.
    pub virial: [f64; 3],
    /// The least `gap + max_overlap (r_i + r_j)`: negative where two spheres overlap too much.
    pub clearance: f64,
}

impl Default for Totals {
    fn default() -> Self {
        Self { power: 0.0, losses: [0.0; 3], virial: [0.0; 3], clearance: f64::INFINITY }
    }
}

impl Totals {
    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            power: self.power + other.power,
            losses: std::array::from_fn(|k| self.losses[k] + other.losses[k]),
            virial: std::array::from_fn(|k| self.virial[k] + other.virial[k]),
            clearance: self.clearance.min(other.clearance),
        }
    }
}

/// What a core needs to work on a block: the spheres (position, velocity, angular velocity, radius) and their loads.
pub struct Bench {
    spheres: Box<[[f64; 10]; CAPACITY]>,
    /// Padded with two zeros, so that a load is one vector.
    loads: Box<[[f64; LANES]; CAPACITY]>,
}

impl Default for Bench {
    fn default() -> Self {
        let mut spheres = Box::new([[0.0; 10]; CAPACITY]);
        // The partner of lanes without a pair: far from everything, even across the squares of a distance.
        spheres[CAPACITY - 1] = [1e9, 1e9, 1e9, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        Self { spheres, loads: Box::new([[0.0; LANES]; CAPACITY]) }
    }
}

impl Bench {
    fn lay_out<M: PairModel>(&mut self, block: &Block<M>, particles: &Particles, domain: &Domain) {
        let entry = |p: usize, shift: Vec3<f64>| {
            let Vec3([x, y, z]) = particles.x[p] + shift;
            let (Vec3([a, b, c]), Vec3([d, e, f])) = (particles.v[p], particles.w[p]);
            [x, y, z, a, b, c, d, e, f, particles.radius[p]]
        };
        let mut places = self.spheres.iter_mut();
        for (p, place) in block.own.clone().zip(&mut places) {
            *place = entry(p, Vec3::zero());
        }
        for (&(q, image), place) in block.halo.iter().zip(&mut places) {
            *place = entry(q as usize, domain.shift(image));
        }
        self.loads[..block.own.len() + block.halo.len()].fill([0.0; LANES]);
    }
}

/// Evaluates all pairs of a block, advances their springs by `dt`, and writes the load on its spheres (own, then halo).
pub fn evaluate<M: PairModel>(
    model: &M,
    instructions: Instructions,
    block: &mut Block<M>,
    (particles, domain): (&Particles, &Domain),
    max_overlap: f64,
    dt: f64,
    loads: &mut Vec<Load>,
) -> Totals {
    thread_local! {
        static BENCH: std::cell::RefCell<Bench> = std::cell::RefCell::default();
    }
    BENCH.with_borrow_mut(|bench| {
        bench.lay_out(block, particles, domain);
        let totals = dispatch(model, instructions, &mut block.pairs, bench, max_overlap, dt);
        loads.clear();
        let members = &bench.loads[..block.own.len() + block.halo.len()];
        loads.extend(members.iter().map(|&[x, y, z, a, b, c, ..]| [x, y, z, a, b, c]));
        totals
    })
}

fn dispatch<M: PairModel>(
    model: &M,
    instructions: Instructions,
    pairs: &mut Pairs<M>,
    bench: &mut Bench,
    max_overlap: f64,
    dt: f64,
) -> Totals {
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "`Instructions` above the baseline exist only where the processor has them")]
    match instructions {
        Instructions::Baseline => {}
        Instructions::Avx2 => return unsafe { avx2::rows(model, pairs, bench, max_overlap, dt) },
        Instructions::Avx512 => return unsafe { avx512::rows(model, pairs, bench, max_overlap, dt) },
    }
    baseline::rows(model, pairs, bench, max_overlap, dt)
}

/// What a row of pairs takes from its spheres: differences of position and velocity, angular velocity and radius of `i` and of `j`.
type Seen = [Row; 14];
/// What it gives back: force on `i`, torque on `i`, torque on `j`.
type Given = [Row; 9];

/// The pair loop for one instruction set. Its three parts are kept apart, or the compiler mixes the narrow moves of the first and the
/// last into the wide arithmetic of the second.
macro_rules! pair_loop {
    ($name:ident $(, $features:literal)?) => {
        mod $name {
            use super::*;

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn gather(spheres: &[[f64; 10]; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], seen: &mut Seen) {
                super::gather(spheres, i, j, seen);
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn act<M: PairModel>(
                model: &M,
                coefficients: &M::Coefficients<Row>,
                memory: &mut M::Memory<Row>,
                seen: &Seen,
                given: &mut Given,
                sums: &mut Sums,
                allowed: f64,
                dt: f64,
            ) {
                super::act(model, coefficients, memory, seen, given, sums, allowed, dt);
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn scatter(loads: &mut [[f64; LANES]; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], given: &Given) {
                super::scatter(loads, i, j, given);
            }

            $(#[target_feature(enable = $features)])?
            pub fn rows<M: PairModel>(model: &M, pairs: &mut Pairs<M>, bench: &mut Bench, allowed: f64, dt: f64) -> Totals {
                let mut sums = Sums::default();
                let mut seen = [[Row::zero(); 14]; BATCH];
                let mut given = [[Row::zero(); 9]; BATCH];
                for start in (0..pairs.i.len()).step_by(BATCH) {
                    let rows = start..(start + BATCH).min(pairs.i.len());
                    for (row, seen) in rows.clone().zip(&mut seen) {
                        gather(&bench.spheres, &pairs.i[row], &pairs.j[row], seen);
                    }
                    for ((row, seen), given) in rows.clone().zip(&seen).zip(&mut given) {
                        act(model, &pairs.coefficients[row], &mut pairs.memory[row], seen, given, &mut sums, allowed, dt);
                    }
                    for (row, given) in rows.zip(&given) {
                        scatter(&mut bench.loads, &pairs.i[row], &pairs.j[row], given);
                    }
                }
                sums.total()
            }
        }
    };
}

pair_loop!(baseline);
#[cfg(target_arch = "x86_64")]
pair_loop!(avx2, "avx2");
#[cfg(target_arch = "x86_64")]
pair_loop!(avx512, "avx512f,avx512dq,avx512vl");

#[inline(always)]
fn gather(spheres: &[[f64; 10]; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], seen: &mut Seen) {
    let at = |place: u16| &spheres[usize::from(place) % CAPACITY];
    let (i, j) = (i.map(at), j.map(at));
    let column = |spheres: &[&[f64; 10]; LANES], k: usize| {
        let [a, b, c, d, e, f, g, h] = spheres;
        Lanes([a[k], b[k], c[k], d[k], e[k], f[k], g[k], h[k]])
    };
    for k in 0..6 {
        seen[k] = column(&i, k) - column(&j, k);
    }
    for k in 0..4 {
        seen[k + 6] = column(&i, k + 6);
        seen[k + 10] = column(&j, k + 6);
    }
}

#[inline(always)]
fn act<M: PairModel>(
    model: &M,
    coefficients: &M::Coefficients<Row>,
    memory: &mut M::Memory<Row>,
    seen: &Seen,
    given: &mut Given,
    sums: &mut Sums,
    allowed: f64,
    dt: f64,
) {
    for lane in 0..LANES {
        let number = |k: usize| seen[k].0[lane];
        let vector = |k: usize| Vec3([number(k), number(k + 1), number(k + 2)]);
        let branch = vector(0);
        let contact = Contact::new(branch, vector(3), vector(6), vector(10), number(9), number(13));
        let constants = Flat::from_fn(|k| coefficients.at(k).0[lane]);
        let springs = Flat::from_fn(|k| memory.at(k).0[lane]);
        let outcome = model.pair(&contact, &constants, springs, dt);
        for k in 0..M::Memory::<f64>::LEN {
            memory.at_mut(k).0[lane] = *outcome.memory.at(k);
        }
        let wrench = outcome.wrench;
        let (f, a, b) = (wrench.force.0, wrench.torque_i.0, wrench.torque_j.0);
        for k in 0..3 {
            given[k].0[lane] = f[k];
            given[k + 3].0[lane] = a[k];
            given[k + 6].0[lane] = b[k];
        }
        sums.power.0[lane] += wrench.power(&contact);
        sums.losses[0].0[lane] += outcome.losses.normal;
        sums.losses[1].0[lane] += outcome.losses.tangential;
        sums.losses[2].0[lane] += outcome.losses.slip;
        for k in 0..3 {
            sums.virial[k].0[lane] -= branch.0[k] * f[k];
        }
        let clearance = contact.gap + allowed * (contact.r_i + contact.r_j);
        let least = sums.clearance.0[lane];
        sums.clearance.0[lane] = if least < clearance { least } else { clearance };
    }
}

/// Adds forces and torques to the loads on the spheres, one after the other.
#[inline(always)]
fn scatter(loads: &mut [[f64; LANES]; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], given: &Given) {
    let [x, y, z, a, b, c, d, e, f] = given.map(|row| row.0);
    let zero = [0.0; LANES];
    let on_i = transposed([x, y, z, a, b, c, zero, zero]);
    let on_j = transposed([(-Lanes(x)).0, (-Lanes(y)).0, (-Lanes(z)).0, d, e, f, zero, zero]);
    for lane in 0..LANES {
        for (places, part) in [(i, &on_i), (j, &on_j)] {
            let load = &mut loads[usize::from(places[lane]) % CAPACITY];
            for k in 0..LANES {
                load[k] += part[lane][k];
            }
        }
    }
}

/// Rows to columns.
#[inline(always)]
fn transposed(rows: [[f64; LANES]; LANES]) -> [[f64; LANES]; LANES] {
    let mut columns = rows;
    for row in 0..LANES {
        for k in 0..LANES {
            columns[k][row] = rows[row][k];
        }
    }
    columns
}

/// Sums over pairs, lane by lane.
struct Sums {
    power: Row,
    losses: [Row; 3],
    virial: [Row; 3],
    clearance: Row,
}

impl Default for Sums {
    fn default() -> Self {
        let zero = Row::zero();
        Self { power: zero, losses: [zero; 3], virial: [zero; 3], clearance: Row::lit(f64::INFINITY) }
    }
}

impl Sums {
    fn total(&self) -> Totals {
        let sum = |row: Row| row.0.iter().sum::<f64>();
        Totals {
            power: sum(self.power),
            losses: self.losses.map(sum),
            virial: self.virial.map(sum),
            clearance: self.clearance.0.into_iter().fold(f64::INFINITY, f64::min),
        }
    }
}
