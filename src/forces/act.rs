//! A row of eight pairs: the contact law in a loop over its lanes, which the compiler turns into vector instructions.

use super::{LANES, Totals};
use crate::spec::numbers::Lanes;
use crate::spec::{Contact, Flat, PairModel, Real, Vec3};
use num_traits::Zero;

/// One number of eight pairs.
pub(super) type Row = Lanes<LANES>;
/// The gathered input of a row of pairs: differences of position and velocity, the distance and its inverse, angular
/// velocity and radius of `i` and of `j`.
pub(super) type RowInput = [Row; 16];
/// The output of a row: force on `i`, torque on `i`, torque on `j`.
pub(super) type RowOutput = [Row; 9];

/// Evaluates a row, advances its springs by `dt`, and enters its losses. For rows of `JOINED` pairs the compiler omits the terms of contacts.
#[inline(always)]
pub(super) fn act<M: PairModel, const JOINED: bool>(
    model: &M,
    coefficients: &M::Coefficients<Row>,
    memory: &mut M::Memory<Row>,
    input: &RowInput,
    output: &mut RowOutput,
    sums: &mut Sums<M>,
    allowed: f64,
    dt: f64,
) {
    if M::MOSTLY_FAR && !JOINED {
        let mut near = false;
        for lane in 0..LANES {
            let constants = Flat::from_fn(|k| coefficients.at(k).0[lane]);
            near |= model.is_near(&contact(input, lane), &constants);
        }
        // The springs of a contact that has just ended release their energy: the law accounts for it.
        if !near && !holds::<M>(memory) {
            return apart(model, input, output, sums, allowed);
        }
    }
    for lane in 0..LANES {
        let contact = contact(input, lane);
        let constants = Flat::from_fn(|k| coefficients.at(k).0[lane]);
        let constants = if JOINED { model.joined(constants) } else { constants };
        let springs = Flat::from_fn(|k| memory.at(k).0[lane]);
        let outcome = model.pair(&contact, &constants, springs, dt);
        for k in 0..M::Memory::<f64>::LEN {
            memory.at_mut(k).0[lane] = *outcome.memory.at(k);
        }
        let wrench = outcome.wrench;
        let (a, b) = (wrench.torque_i.0, wrench.torque_j.0);
        for k in 0..3 {
            output[k + 3].0[lane] = a[k];
            output[k + 6].0[lane] = b[k];
        }
        for k in 0..M::Losses::<f64>::LEN {
            sums.losses.at_mut(k).0[lane] += *outcome.losses.at(k);
        }
        push(wrench.force, &contact, lane, input, output, sums, allowed);
    }
}

/// Enters the distances of a row and their inverses. In a pass of its own, in which the root and the division of one row need not wait for those of another.
#[inline(always)]
pub(super) fn measure(input: &mut RowInput) {
    for lane in 0..LANES {
        let distance = Vec3([input[0].0[lane], input[1].0[lane], input[2].0[lane]]).norm();
        input[6].0[lane] = distance;
        input[7].0[lane] = 1.0 / distance;
    }
}

/// Whether any pair of a row has a spring.
#[inline(always)]
fn holds<M: PairModel>(memory: &M::Memory<Row>) -> bool {
    (0..M::Memory::<f64>::LEN).any(|k| memory.at(k).0.iter().any(|&number| number != 0.0))
}

/// A row of near pairs none of which is in range of contact: only central forces act.
#[inline(always)]
fn apart<M: PairModel>(model: &M, input: &RowInput, output: &mut RowOutput, sums: &mut Sums<M>, allowed: f64) {
    output[3..].fill(Row::zero());
    for lane in 0..LANES {
        let contact = contact(input, lane);
        let force = model.far(&contact);
        push(force, &contact, lane, input, output, sums, allowed);
    }
}

/// Evaluates a row of far pairs.
#[inline(always)]
pub(super) fn far<M: PairModel>(
    model: &M,
    apart: &[Row; 3],
    [r_i, r_j]: &[Row; 2],
    force: &mut [Row; 3],
    virial: &mut [Row; 3],
) {
    for lane in 0..LANES {
        let x = Vec3([apart[0].0[lane], apart[1].0[lane], apart[2].0[lane]]);
        let still = Vec3::zero();
        let f = model.far(&Contact::new(x, still, still, still, r_i.0[lane], r_j.0[lane]));
        for k in 0..3 {
            force[k].0[lane] = f.0[k];
            virial[k].0[lane] -= x.0[k] * f.0[k];
        }
    }
}

/// The contact kinematics of the two spheres of a lane.
#[inline(always)]
fn contact(input: &RowInput, lane: usize) -> Contact<f64> {
    let number = |k: usize| input[k].0[lane];
    let vector = |k: usize| Vec3([number(k), number(k + 1), number(k + 2)]);
    Contact::at_distance(vector(0), number(6), number(7), vector(3), vector(8), vector(12), number(11), number(15))
}

/// Enters the force of a lane.
#[inline(always)]
fn push<M: PairModel>(
    force: Vec3<f64>,
    contact: &Contact<f64>,
    lane: usize,
    input: &RowInput,
    output: &mut RowOutput,
    sums: &mut Sums<M>,
    allowed: f64,
) {
    for k in 0..3 {
        output[k].0[lane] = force.0[k];
        sums.virial[k].0[lane] -= input[k].0[lane] * force.0[k];
    }
    let clearance = contact.gap + allowed * (contact.r_i + contact.r_j);
    let least = sums.clearance.0[lane];
    sums.clearance.0[lane] = if least < clearance { least } else { clearance };
}

/// Sums over pairs, lane by lane.
pub(super) struct Sums<M: PairModel> {
    losses: M::Losses<Row>,
    /// Diagonal of the sum of branch vector times force.
    pub virial: [Row; 3],
    clearance: Row,
}

impl<M: PairModel> Default for Sums<M> {
    fn default() -> Self {
        let zero = Row::zero();
        Self { losses: Flat::from_fn(|_| zero), virial: [zero; 3], clearance: Row::lit(f64::INFINITY) }
    }
}

impl<M: PairModel> Sums<M> {
    /// All lanes together, but for the power, which follows from the loads on the spheres.
    pub(super) fn total(&self) -> Totals<M::Losses<f64>> {
        let sum = |row: Row| row.0.iter().sum::<f64>();
        Totals {
            power: 0.0,
            losses: Flat::from_fn(|k| sum(*self.losses.at(k))),
            virial: self.virial.map(sum),
            clearance: self.clearance.0.into_iter().fold(f64::INFINITY, f64::min),
        }
    }
}
