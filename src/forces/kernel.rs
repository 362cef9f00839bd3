//! The pair loop: the contact model, eight pairs at a time.

use super::act::{Given, Row, Seen, Sums};
use super::blocks::Block;
use super::instructions::{Instructions, Set, SideBySide};
use super::layout::{CAPACITY, LANES};
use super::pairs::{FarPairs, Pairs};
use super::{Totals, transpose};
use crate::spec::numbers::Lanes;
use crate::spec::{PairModel, Vec3};
use crate::system::{Domain, Particles};
use num_traits::Zero;

/// Rows that are gathered before they are evaluated: what is stored number by number is then ready to be read row by row.
const BATCH: usize = 8;

/// Force (pN) and torque (pN nm) on a sphere, end to end; two numbers more make it one vector, and mean nothing.
pub type Load = Lanes<LANES>;

/// The spheres of a block, side by side; aligned, so that a sphere does not straddle more lines of the cache than it must.
#[repr(align(64))]
struct Bench {
    /// Position and velocity.
    motion: [[f64; LANES]; CAPACITY],
    /// Angular velocity and radius.
    spin: [[f64; 4]; CAPACITY],
    /// How many spheres there are.
    len: usize,
}

impl Default for Bench {
    fn default() -> Self {
        let (mut motion, mut spin) = ([[0.0; LANES]; CAPACITY], [[0.0; 4]; CAPACITY]);
        // The partner of lanes without a pair: far from everything, even across the squares of a distance.
        motion[CAPACITY - 1] = [1e9, 1e9, 1e9, 0.0, 0.0, 0.0, 0.0, 0.0];
        spin[CAPACITY - 1] = [0.0, 0.0, 0.0, 1.0];
        Self { motion, spin, len: 0 }
    }
}

impl Bench {
    fn lay_out<M: PairModel>(&mut self, block: &Block<M>, particles: &Particles, domain: &Domain) {
        self.len = block.own.len() + block.halo.len();
        let mut places = self.motion.iter_mut().zip(self.spin.iter_mut());
        let own = block.own.clone().map(|p| (p, Vec3::zero()));
        let halo = block.halo.iter().map(|&(q, image)| (q as usize, domain.shift(image)));
        for ((p, shift), (motion, spin)) in own.chain(halo).zip(&mut places) {
            let Vec3([x, y, z]) = particles.x[p] + shift;
            let (Vec3([a, b, c]), Vec3([d, e, f])) = (particles.v[p], particles.w[p]);
            *motion = [x, y, z, a, b, c, 0.0, 0.0];
            *spin = [d, e, f, particles.radius[p]];
        }
    }

    /// Power that forces deliver to the spheres.
    fn power(&self, loads: &[Load; CAPACITY]) -> f64 {
        let mut power = [0.0; 3];
        for (motion, load) in self.motion[..self.len].iter().zip(loads) {
            for k in 0..3 {
                power[k] += load.0[k] * motion[k + 3];
            }
        }
        power.iter().sum()
    }
}

/// Evaluates all pairs of a block, advances their springs by `dt`, and leaves the loads on its spheres (own, then halo) in it. Far pairs
/// go on doing what they did, unless they are to be evaluated anew.
pub fn evaluate<M: PairModel>(
    model: &M,
    instructions: Instructions,
    block: &mut Block<M>,
    (particles, domain): (&Particles, &Domain),
    far_anew: bool,
    (max_overlap, dt): (f64, f64),
) -> Totals<M::Losses<f64>> {
    thread_local! {
        static BENCH: std::cell::RefCell<Box<Bench>> = std::cell::RefCell::default();
    }
    BENCH.with_borrow_mut(|bench| {
        bench.lay_out(block, particles, domain);
        let Block { pairs, far, loads, .. } = block;
        if far_anew {
            dispatch_far(model, instructions, far, bench);
        }
        let spheres = ..bench.len;
        let mut totals = Totals { virial: far.virial, ..Totals::default() };
        match &far.loads {
            Some(held) => {
                loads[spheres].copy_from_slice(&held[spheres]);
                totals.power = bench.power(held);
            }
            None => loads[spheres].fill(Load::zero()),
        }
        totals.and(dispatch(model, instructions, pairs, bench, loads, max_overlap, dt))
    })
}

fn dispatch<M: PairModel>(
    model: &M,
    instructions: Instructions,
    pairs: &mut Pairs<M>,
    bench: &Bench,
    loads: &mut [Load; CAPACITY],
    max_overlap: f64,
    dt: f64,
) -> Totals<M::Losses<f64>> {
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "`Instructions` exist only where the processor has them")]
    match instructions.set() {
        Set::Baseline => {}
        Set::Avx2 => return unsafe { avx2::rows(model, pairs, bench, loads, max_overlap, dt) },
        Set::Avx512 => return unsafe { avx512::rows(model, pairs, bench, loads, max_overlap, dt) },
    }
    baseline::rows(model, pairs, bench, loads, max_overlap, dt)
}

fn dispatch_far<M: PairModel>(model: &M, instructions: Instructions, pairs: &mut FarPairs, bench: &Bench) {
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "`Instructions` exist only where the processor has them")]
    match instructions.set() {
        Set::Baseline => {}
        Set::Avx2 => return unsafe { avx2::far(model, pairs, bench) },
        Set::Avx512 => return unsafe { avx512::far(model, pairs, bench) },
    }
    baseline::far(model, pairs, bench);
}

/// Does work side by side with the given instructions.
pub fn side_by_side<W: SideBySide>(instructions: Instructions, work: W) -> W::Outcome {
    #[cfg(target_arch = "x86_64")]
    #[expect(unsafe_code, reason = "`Instructions` exist only where the processor has them")]
    match instructions.set() {
        Set::Baseline => {}
        Set::Avx2 => return unsafe { avx2::side_by_side(work) },
        Set::Avx512 => return unsafe { avx512::side_by_side(work) },
    }
    baseline::side_by_side(work)
}

/// The pair loop for one instruction set. Its three parts are kept apart, or the compiler mixes the narrow moves of the first and the
/// last into the wide arithmetic of the second.
macro_rules! pair_loop {
    ($name:ident $(, $features:literal)?) => {
        mod $name {
            use super::*;

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn gather(bench: &Bench, i: &[u16; LANES], j: &[u16; LANES], seen: &mut Seen) {
                let mut motion = [[0.0; LANES]; LANES];
                let mut spin = [[0.0; LANES]; LANES];
                for lane in 0..LANES {
                    let (i, j) = (usize::from(i[lane]) % CAPACITY, usize::from(j[lane]) % CAPACITY);
                    for k in 0..LANES {
                        motion[lane][k] = bench.motion[i][k] - bench.motion[j][k];
                    }
                    spin[lane][..4].copy_from_slice(&bench.spin[i]);
                    spin[lane][4..].copy_from_slice(&bench.spin[j]);
                }
                let (motion, spin) = (transpose::$name(motion), transpose::$name(spin));
                for k in 0..LANES {
                    seen[k] = Lanes(motion[k]);
                    seen[k + LANES] = Lanes(spin[k]);
                }
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn act<M: PairModel, const JOINED: bool>(
                model: &M,
                coefficients: &M::Coefficients<Row>,
                memory: &mut M::Memory<Row>,
                seen: &Seen,
                given: &mut Given,
                sums: &mut Sums<M>,
                allowed: f64,
                dt: f64,
            ) {
                super::super::act::act::<M, JOINED>(model, coefficients, memory, seen, given, sums, allowed, dt);
            }

            /// Adds forces and torques to the loads on the spheres, one after the other.
            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn scatter(loads: &mut [Load; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], given: &Given) {
                let (mut on_i, mut on_j) = ([[0.0; LANES]; LANES], [[0.0; LANES]; LANES]);
                for k in 0..3 {
                    on_i[k] = given[k].0;
                    on_i[k + 3] = given[k + 3].0;
                    on_j[k] = (-given[k]).0;
                    on_j[k + 3] = given[k + 6].0;
                }
                let (on_i, on_j) = (transpose::$name(on_i), transpose::$name(on_j));
                for lane in 0..LANES {
                    for (places, part) in [(i, &on_i), (j, &on_j)] {
                        let load = &mut loads[usize::from(places[lane]) % CAPACITY];
                        for k in 0..LANES {
                            load.0[k] += part[lane][k];
                        }
                    }
                }
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn gather_far(bench: &Bench, i: &[u16; LANES], j: &[u16; LANES], apart: &mut [Row; 3]) {
                let mut motion = [[0.0; 4]; LANES];
                for lane in 0..LANES {
                    let (i, j) = (usize::from(i[lane]) % CAPACITY, usize::from(j[lane]) % CAPACITY);
                    for k in 0..4 {
                        motion[lane][k] = bench.motion[i][k] - bench.motion[j][k];
                    }
                }
                let motion = transpose::narrow::$name(motion);
                for k in 0..3 {
                    apart[k] = Lanes(motion[k]);
                }
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn act_far<M: PairModel>(
                model: &M,
                apart: &[Row; 3],
                radii: &[Row; 2],
                force: &mut [Row; 3],
                virial: &mut [Row; 3],
            ) {
                super::super::act::far(model, apart, radii, force, virial);
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn scatter_far(loads: &mut [Load; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], force: &[Row; 3]) {
                let [x, y, z] = force.map(|component| component.0);
                let on_i = transpose::back::$name([x, y, z, [0.0; LANES]]);
                for lane in 0..LANES {
                    let (i, j) = (usize::from(i[lane]) % CAPACITY, usize::from(j[lane]) % CAPACITY);
                    for k in 0..4 {
                        loads[i].0[k] += on_i[lane][k];
                    }
                    for k in 0..4 {
                        loads[j].0[k] -= on_i[lane][k];
                    }
                }
            }

            $(#[target_feature(enable = $features)])?
            pub fn far<M: PairModel>(model: &M, pairs: &mut FarPairs, bench: &Bench) {
                let Some(loads) = &mut pairs.loads else { return };
                loads[..bench.len].fill(Load::zero());
                let mut virial = [Row::zero(); 3];
                let mut apart = [[Row::zero(); 3]; BATCH];
                let mut force = [[Row::zero(); 3]; BATCH];
                for start in (0..pairs.i.len()).step_by(BATCH) {
                    let rows = start..(start + BATCH).min(pairs.i.len());
                    for (row, apart) in rows.clone().zip(&mut apart) {
                        gather_far(bench, &pairs.i[row], &pairs.j[row], apart);
                    }
                    for ((row, apart), force) in rows.clone().zip(&apart).zip(&mut force) {
                        act_far(model, apart, &pairs.radii[pairs.kind[row] as usize], force, &mut virial);
                    }
                    for (row, force) in rows.zip(&force) {
                        scatter_far(loads, &pairs.i[row], &pairs.j[row], force);
                    }
                }
                pairs.virial = virial.map(|row| row.0.iter().sum());
            }

            $(#[target_feature(enable = $features)])?
            pub fn rows<M: PairModel>(
                model: &M,
                pairs: &mut Pairs<M>,
                bench: &Bench,
                loads: &mut [Load; CAPACITY],
                allowed: f64,
                dt: f64,
            ) -> Totals<M::Losses<f64>> {
                let mut sums = Sums::default();
                let joined = pairs.joined();
                let mut seen = [[Row::zero(); 16]; BATCH];
                let mut given = [[Row::zero(); 9]; BATCH];
                for start in (0..pairs.i.len()).step_by(BATCH) {
                    let rows = start..(start + BATCH).min(pairs.i.len());
                    for (row, seen) in rows.clone().zip(&mut seen) {
                        gather(bench, &pairs.i[row], &pairs.j[row], seen);
                    }
                    for ((row, seen), given) in rows.clone().zip(&seen).zip(&mut given) {
                        let constants = &pairs.coefficients[pairs.kind[row] as usize];
                        let act = if row < joined { act::<M, true> } else { act::<M, false> };
                        act(model, constants, &mut pairs.memory[row], seen, given, &mut sums, allowed, dt);
                    }
                    for (row, given) in rows.zip(&given) {
                        scatter(loads, &pairs.i[row], &pairs.j[row], given);
                    }
                }
                sums.total()
            }

            $(#[target_feature(enable = $features)])?
            pub fn side_by_side<W: SideBySide>(work: W) -> W::Outcome {
                work.run(|rows| transpose::$name(rows))
            }
        }
    };
}

pair_loop!(baseline);
#[cfg(target_arch = "x86_64")]
pair_loop!(avx2, "avx2");
#[cfg(target_arch = "x86_64")]
pair_loop!(avx512, "avx512f,avx512dq,avx512vl");
