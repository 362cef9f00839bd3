//! The pair loop: the contact model, eight pairs at a time.

use super::blocks::{Block, CAPACITY, LANES, Pairs};
use super::instructions::Instructions;
use crate::spec::numbers::Lanes;
use crate::spec::{Contact, PairModel, Real, Vec3};
use crate::system::{Domain, Particles};
use num_traits::Zero;

type Row = Lanes<LANES>;

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
    loads: Box<[Load; CAPACITY]>,
}

impl Default for Bench {
    fn default() -> Self {
        let mut spheres = Box::new([[0.0; 10]; CAPACITY]);
        // The partner of lanes without a pair: far from everything, even across the squares of a distance.
        spheres[CAPACITY - 1] = [1e9, 1e9, 1e9, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        Self { spheres, loads: Box::new([[0.0; 6]; CAPACITY]) }
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
        self.loads[..block.own.len() + block.halo.len()].fill([0.0; 6]);
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
        loads.extend_from_slice(&bench.loads[..block.own.len() + block.halo.len()]);
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
    {
        #[target_feature(enable = "avx2")]
        fn avx2<M: PairModel>(model: &M, pairs: &mut Pairs<M>, bench: &mut Bench, max_overlap: f64, dt: f64) -> Totals {
            rows(model, pairs, bench, max_overlap, dt)
        }
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        fn avx512<M: PairModel>(
            model: &M,
            pairs: &mut Pairs<M>,
            bench: &mut Bench,
            max_overlap: f64,
            dt: f64,
        ) -> Totals {
            rows(model, pairs, bench, max_overlap, dt)
        }
        #[expect(unsafe_code, reason = "`Instructions` above the baseline exist only where the processor has them")]
        match instructions {
            Instructions::Baseline => {}
            Instructions::Avx2 => return unsafe { avx2(model, pairs, bench, max_overlap, dt) },
            Instructions::Avx512 => return unsafe { avx512(model, pairs, bench, max_overlap, dt) },
        }
    }
    rows(model, pairs, bench, max_overlap, dt)
}

/// Position, velocity, angular velocity and radius of the spheres at eight places.
#[inline(always)]
fn gather(spheres: &[[f64; 10]; CAPACITY], places: &[u16; LANES]) -> ([Vec3<Row>; 3], Row) {
    let mut rows = [Row::zero(); 10];
    for lane in 0..LANES {
        let sphere = &spheres[usize::from(places[lane]) % CAPACITY];
        for k in 0..10 {
            rows[k].0[lane] = sphere[k];
        }
    }
    let [x, y, z, a, b, c, d, e, f, r] = rows;
    ([Vec3([x, y, z]), Vec3([a, b, c]), Vec3([d, e, f])], r)
}

#[inline(always)]
fn rows<M: PairModel>(model: &M, pairs: &mut Pairs<M>, bench: &mut Bench, max_overlap: f64, dt: f64) -> Totals {
    let Bench { spheres, loads } = bench;
    let (allowed, dt) = (Row::lit(max_overlap), Row::lit(dt));
    let mut power = Row::zero();
    let mut losses = [Row::zero(); 3];
    let mut virial = [Row::zero(); 3];
    let mut clearance = Row::lit(f64::INFINITY);

    let rows = pairs.i.iter().zip(&pairs.j).zip(&pairs.coefficients).zip(&mut pairs.memory);
    for (((i, j), coefficients), memory) in rows {
        let ([x_i, v_i, w_i], r_i) = gather(spheres, i);
        let ([x_j, v_j, w_j], r_j) = gather(spheres, j);
        let branch = x_i - x_j;
        let contact = Contact::new(branch, v_i - v_j, w_i, w_j, r_i, r_j);

        let outcome = model.pair(&contact, coefficients, *memory, dt);
        *memory = outcome.memory;

        let wrench = outcome.wrench;
        power = power + wrench.power(&contact);
        let lost = [outcome.losses.normal, outcome.losses.tangential, outcome.losses.slip];
        for k in 0..3 {
            losses[k] = losses[k] + lost[k];
            virial[k] = virial[k] - branch.0[k] * wrench.force.0[k];
        }
        clearance = clearance.min(contact.gap + allowed * (contact.r_i + contact.r_j));

        for lane in 0..LANES {
            let on_i = &mut loads[usize::from(i[lane]) % CAPACITY];
            for k in 0..3 {
                on_i[k] += wrench.force.0[k].0[lane];
                on_i[k + 3] += wrench.torque_i.0[k].0[lane];
            }
            let on_j = &mut loads[usize::from(j[lane]) % CAPACITY];
            for k in 0..3 {
                on_j[k] -= wrench.force.0[k].0[lane];
                on_j[k + 3] += wrench.torque_j.0[k].0[lane];
            }
        }
    }

    let sum = |row: Row| row.0.iter().sum::<f64>();
    Totals {
        power: sum(power),
        losses: losses.map(sum),
        virial: virial.map(sum),
        clearance: clearance.0.into_iter().fold(f64::INFINITY, f64::min),
    }
}
