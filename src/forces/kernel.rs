//! The pair loop: the contact model, eight pairs at a time.

use super::act::{Row, RowInput, RowOutput, Sums};
use super::blocks::Block;
use super::layout::{CAPACITY, LANES};
use super::pairs::{FarPairs, Pairs};
use super::prefetch::prefetch;
use super::vectorised::Vectorised;
use super::{Totals, transpose};
use crate::spec::numbers::{Instructions, Lanes, Set};
use crate::spec::{PairModel, Vec3};
use crate::system::{Domain, Particles};
use num_traits::Zero;

/// Number of rows that are gathered before they are evaluated, so that stores of single numbers have completed before rows are loaded.
const BATCH: usize = 8;
/// Number of spheres of the halo, which lie scattered in memory, from the request for a sphere to its use.
const HALO_AHEAD: usize = 8;

/// Force (pN) and torque (pN nm) on a sphere, padded by two unused numbers to one vector.
pub type Load = Lanes<LANES>;

/// The gathered spheres of a block, contiguous and aligned to cache lines.
#[repr(align(64))]
struct GatheredSpheres {
    /// Position and velocity.
    motion: [[f64; LANES]; CAPACITY],
    /// Angular velocity and radius.
    spin: [[f64; 4]; CAPACITY],
    /// Number of spheres.
    len: usize,
}

impl Default for GatheredSpheres {
    fn default() -> Self {
        let (mut motion, mut spin) = ([[0.0; LANES]; CAPACITY], [[0.0; 4]; CAPACITY]);
        // The partner of lanes without a pair: far from everything, even across the squares of a distance.
        motion[CAPACITY - 1] = [1e9, 1e9, 1e9, 0.0, 0.0, 0.0, 0.0, 0.0];
        spin[CAPACITY - 1] = [0.0, 0.0, 0.0, 1.0];
        Self { motion, spin, len: 0 }
    }
}

impl GatheredSpheres {
    fn load<M: PairModel>(&mut self, block: &Block<M>, particles: &Particles, domain: &Domain) {
        self.len = block.own.len() + block.halo.len();
        let mut places = self.motion.iter_mut().zip(self.spin.iter_mut());
        let own = block.own.clone().map(|p| (p, Vec3::zero()));
        let halo = block.halo.iter().enumerate().map(|(k, &(q, image))| {
            if let Some(&(ahead, _)) = block.halo.get(k + HALO_AHEAD) {
                let ahead = ahead as usize;
                [&particles.x, &particles.v, &particles.w].into_iter().for_each(|of| prefetch(&of[ahead]));
                prefetch(&particles.radius[ahead]);
            }
            (q as usize, domain.shift(image))
        });
        for ((p, shift), (motion, spin)) in own.chain(halo).zip(&mut places) {
            let Vec3([x, y, z]) = particles.x[p] + shift;
            let (Vec3([a, b, c]), Vec3([d, e, f])) = (particles.v[p], particles.w[p]);
            *motion = [x, y, z, a, b, c, 0.0, 0.0];
            *spin = [d, e, f, particles.radius[p]];
        }
    }

    /// Power of the loads on the spheres.
    fn power(&self, loads: &[Load; CAPACITY]) -> f64 {
        // Four lanes each: the fourth multiplies a padding zero.
        let mut power = [[0.0; 4]; 2];
        for ((motion, spin), load) in self.motion[..self.len].iter().zip(&self.spin).zip(loads) {
            for k in 0..4 {
                power[0][k] += load.0[k] * motion[k + 3];
                power[1][k] += load.0[k + 3] * spin[k];
            }
        }
        power.iter().flatten().sum()
    }
}

/// Evaluates all pairs of a block, advances their springs by `dt`, and stores the loads on its spheres (own, then halo) in it. The forces of far pairs
/// are held constant unless they are to be evaluated anew.
pub fn evaluate<M: PairModel>(
    model: &M,
    instructions: Instructions,
    block: &mut Block<M>,
    (particles, domain): (&Particles, &Domain),
    far_anew: bool,
    (max_overlap, dt): (f64, f64),
) -> Totals<M::Losses<f64>> {
    thread_local! {
        static GATHERED: std::cell::RefCell<Box<GatheredSpheres>> = std::cell::RefCell::default();
    }
    GATHERED.with_borrow_mut(|spheres_of_block| {
        spheres_of_block.load(block, particles, domain);
        let Block { pairs, far, loads, .. } = block;
        if M::MOSTLY_FAR && far_anew {
            dispatch_far(model, instructions, far, spheres_of_block);
        }
        let spheres = ..spheres_of_block.len;
        match &far.loads {
            Some(held) => loads[spheres].copy_from_slice(&held[spheres]),
            None => loads[spheres].fill(Load::zero()),
        }
        let of_far = Totals { virial: far.virial, ..Totals::default() };
        let totals = of_far.and(dispatch(model, instructions, pairs, spheres_of_block, loads, max_overlap, dt));
        Totals { power: spheres_of_block.power(loads), ..totals }
    })
}

/// Calls a function of the pair loop that is compiled for these instructions, and returns its result.
macro_rules! return_with {
    ($instructions:expr, $function:ident($($argument:expr),*)) => {{
        #[cfg(target_arch = "x86_64")]
        #[expect(unsafe_code, reason = "`Instructions` exist only where the processor has them")]
        match $instructions.set() {
            Set::Baseline => {}
            // SAFETY: the processor has these instructions, or there were no such `Instructions`.
            Set::Avx2 => return unsafe { avx2::$function($($argument),*) },
            // SAFETY: the processor has these instructions, or there were no such `Instructions`.
            Set::Avx512 => return unsafe { avx512::$function($($argument),*) },
        }
        baseline::$function($($argument),*)
    }};
}

fn dispatch<M: PairModel>(
    model: &M,
    instructions: Instructions,
    pairs: &mut Pairs<M>,
    spheres_of_block: &GatheredSpheres,
    loads: &mut [Load; CAPACITY],
    max_overlap: f64,
    dt: f64,
) -> Totals<M::Losses<f64>> {
    return_with!(instructions, rows(model, pairs, spheres_of_block, loads, max_overlap, dt))
}

fn dispatch_far<M: PairModel>(
    model: &M,
    instructions: Instructions,
    pairs: &mut FarPairs,
    spheres_of_block: &GatheredSpheres,
) {
    return_with!(instructions, far(model, pairs, spheres_of_block))
}

/// Does vectorised work with the given instructions.
pub fn vectorised<W: Vectorised>(instructions: Instructions, work: W) -> W::Outcome {
    return_with!(instructions, vectorised(work))
}

/// Aligns the stack of the function that calls it to whole vectors. The compiler does not, and a row then takes up to a quarter longer in one process
/// than in the next, as the place of the stack is random and spilled vectors may lie across two pages.
#[inline(always)]
fn align_stack() {
    std::hint::black_box(&mut Row::zero());
}

/// The pair loop for one instruction set. Its three parts are kept apart, or the compiler mixes the narrow moves of the first and the
/// last into the wide arithmetic of the second.
macro_rules! pair_loop {
    ($name:ident $(, $features:literal)?) => {
        mod $name {
            use super::*;

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn gather(spheres_of_block: &GatheredSpheres, i: &[u16; LANES], j: &[u16; LANES], input: &mut RowInput) {
                let mut motion = [[0.0; LANES]; LANES];
                let mut spin = [[0.0; LANES]; LANES];
                for lane in 0..LANES {
                    let (i, j) = (usize::from(i[lane]) % CAPACITY, usize::from(j[lane]) % CAPACITY);
                    for k in 0..LANES {
                        motion[lane][k] = spheres_of_block.motion[i][k] - spheres_of_block.motion[j][k];
                    }
                    spin[lane][..4].copy_from_slice(&spheres_of_block.spin[i]);
                    spin[lane][4..].copy_from_slice(&spheres_of_block.spin[j]);
                }
                let (motion, spin) = (transpose::$name(motion), transpose::$name(spin));
                for k in 0..LANES {
                    input[k] = Lanes(motion[k]);
                    input[k + LANES] = Lanes(spin[k]);
                }
                super::super::act::measure(input);
            }

            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn act<M: PairModel, const JOINED: bool>(
                model: &M,
                coefficients: &M::Coefficients<Row>,
                memory: &mut M::Memory<Row>,
                input: &RowInput,
                output: &mut RowOutput,
                sums: &mut Sums<M>,
                allowed: f64,
                dt: f64,
            ) {
                align_stack();
                super::super::act::act::<M, JOINED>(model, coefficients, memory, input, output, sums, allowed, dt);
            }

            /// Adds forces and torques to the loads on the spheres, one after the other.
            $(#[target_feature(enable = $features)])?
            #[inline(never)]
            fn scatter(loads: &mut [Load; CAPACITY], i: &[u16; LANES], j: &[u16; LANES], output: &RowOutput) {
                let (mut on_i, mut on_j) = ([[0.0; LANES]; LANES], [[0.0; LANES]; LANES]);
                for k in 0..3 {
                    on_i[k] = output[k].0;
                    on_i[k + 3] = output[k + 3].0;
                    on_j[k] = (-output[k]).0;
                    on_j[k + 3] = output[k + 6].0;
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
            fn gather_far(spheres_of_block: &GatheredSpheres, i: &[u16; LANES], j: &[u16; LANES], apart: &mut [Row; 3]) {
                let mut motion = [[0.0; 4]; LANES];
                for lane in 0..LANES {
                    let (i, j) = (usize::from(i[lane]) % CAPACITY, usize::from(j[lane]) % CAPACITY);
                    for k in 0..4 {
                        motion[lane][k] = spheres_of_block.motion[i][k] - spheres_of_block.motion[j][k];
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
                align_stack();
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
            pub(crate) fn far<M: PairModel>(model: &M, pairs: &mut FarPairs, spheres_of_block: &GatheredSpheres) {
                let Some(loads) = &mut pairs.loads else { return };
                loads[..spheres_of_block.len].fill(Load::zero());
                let mut virial = [Row::zero(); 3];
                let mut apart = [[Row::zero(); 3]; BATCH];
                let mut force = [[Row::zero(); 3]; BATCH];
                for start in (0..pairs.i.len()).step_by(BATCH) {
                    let rows = start..(start + BATCH).min(pairs.i.len());
                    for (row, apart) in rows.clone().zip(&mut apart) {
                        gather_far(spheres_of_block, &pairs.i[row], &pairs.j[row], apart);
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
            pub(crate) fn rows<M: PairModel>(
                model: &M,
                pairs: &mut Pairs<M>,
                spheres_of_block: &GatheredSpheres,
                loads: &mut [Load; CAPACITY],
                allowed: f64,
                dt: f64,
            ) -> Totals<M::Losses<f64>> {
                let mut sums = Sums::default();
                let joined = pairs.joined();
                let mut input = [[Row::zero(); 16]; BATCH];
                let mut output = [[Row::zero(); 9]; BATCH];
                for start in (0..pairs.i.len()).step_by(BATCH) {
                    let rows = start..(start + BATCH).min(pairs.i.len());
                    for (row, input) in rows.clone().zip(&mut input) {
                        if let Some(ahead) = pairs.memory.get(row + BATCH) {
                            prefetch(ahead);
                            if M::FRICTION_STOPS {
                                prefetch(pairs.constants(row + BATCH));
                            }
                        }
                        gather(spheres_of_block, &pairs.i[row], &pairs.j[row], input);
                    }
                    for ((row, input), output) in rows.clone().zip(&input).zip(&mut output) {
                        let constants = &pairs.coefficients[pairs.kind[row] as usize];
                        let memory = &mut pairs.memory[row];
                        if row < joined {
                            act::<M, true>(model, constants, memory, input, output, &mut sums, allowed, dt);
                        } else {
                            act::<M, false>(model, constants, memory, input, output, &mut sums, allowed, dt);
                        }
                    }
                    for (row, output) in rows.zip(&output) {
                        scatter(loads, &pairs.i[row], &pairs.j[row], output);
                    }
                }
                sums.total()
            }

            $(#[target_feature(enable = $features)])?
            pub(crate) fn vectorised<W: Vectorised>(work: W) -> W::Outcome {
                align_stack();
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
