//! Equations and contact laws over columns of numbers: one slice for each number of the arguments, and one for each of the results.
//!
//! The loops are compiled for every equation and every instruction set from the one text of the equation. No operation is
//! fused or reordered, so all of them give the bits of `f64`.

use crate::equation::{Kernel, Laid, Shape, Taken};
use crate::numbers::{Instructions, Lanes, Work};
use crate::{Contact, Flat, PairModel, Real, Vec3};
use std::marker::PhantomData;

/// How many evaluations make a row. A row of all columns fits into the first cache, and is long enough for several vectors side by side.
const WIDTH: usize = 32;
/// Largest number of arguments, and of results.
const MOST: usize = 96;

/// The columns that receive the results.
pub type Results<'a, 'b> = &'a mut [&'b mut [f64]];

/// An equation over columns of equal length.
pub struct Many {
    /// One number after the other.
    pub f64: fn(&[&[f64]], Results),
    /// In rows, with the given instructions.
    pub rows: fn(Instructions, &[&[f64]], Results),
}

/// Evaluates a kernel with columns of arguments, one number after the other.
///
/// # Panics
///
/// If a column is missing or shorter than the first.
pub fn one_by_one<A>(kernel: impl Kernel<f64, A>, arguments: &[&[f64]], results: Results) {
    for place in 0..length(arguments) {
        let (mut taken, mut given) = (0, 0);
        let mut from = || {
            taken += 1;
            arguments[taken - 1][place]
        };
        let mut to = |number| {
            given += 1;
            results[given - 1][place] = number;
        };
        kernel.apply(&mut from, &mut to);
    }
}

/// Evaluates a kernel with columns of arguments, several numbers at a time.
///
/// # Panics
///
/// If a column is missing or shorter than the first, or there are more than 96 arguments or results.
pub fn in_rows<A>(kernel: impl Kernel<f64, A>, instructions: Instructions, arguments: &[&[f64]], results: Results) {
    instructions.run(Rows { kernel, arguments, results, of: PhantomData });
}

fn length(columns: &[&[f64]]) -> usize {
    columns.first().map_or(0, |column| column.len())
}

struct Rows<'a, 'b, A, K> {
    kernel: K,
    arguments: &'a [&'a [f64]],
    results: Results<'a, 'b>,
    of: PhantomData<A>,
}

impl<A, K: Kernel<f64, A>> Work for Rows<'_, '_, A, K> {
    type Outcome = ();

    #[inline(always)]
    fn run(self) {
        // Copies of the row, because the compiler cannot know that columns do not overlap.
        let (mut input, mut output) = ([Lanes([0.0; WIDTH]); MOST], [Lanes([0.0; WIDTH]); MOST]);
        let length = length(self.arguments);
        for begin in (0..length).step_by(WIDTH) {
            let row = begin..length.min(begin + WIDTH);
            for (place, column) in self.arguments.iter().enumerate() {
                input[place].0[..row.len()].copy_from_slice(&column[row.clone()]);
            }
            // Beyond the end of the columns it evaluates what the row before has left there.
            for lane in 0..WIDTH {
                let (mut taken, mut given) = (0, 0);
                let mut from = || {
                    taken += 1;
                    input[taken - 1].0[lane]
                };
                let mut to = |number| {
                    given += 1;
                    output[given - 1].0[lane] = number;
                };
                self.kernel.apply(&mut from, &mut to);
            }
            for (place, column) in self.results.iter_mut().enumerate() {
                column[row.clone()].copy_from_slice(&output[place].0[..row.len()]);
            }
        }
    }
}

/// A contact law as a kernel. Its arguments: difference of the positions, difference of the velocities, the two angular velocities, the two
/// radii, the constants of the pair, its springs. Its results: the force, the two torques, the springs, the losses.
pub struct PairKernel<'a, M> {
    /// The law.
    pub model: &'a M,
    /// The time step, s.
    pub dt: f64,
}

impl<R: Real, M: PairModel> Kernel<R, ()> for PairKernel<'_, M> {
    fn shape(&self) -> Shape {
        let vectors = |count| vec![3; count];
        let numbers = |count| vec![1; count];
        let (constants, springs) = (M::Coefficients::<R>::LEN, M::Memory::<R>::LEN);
        Shape {
            arguments: [vectors(4), numbers(2 + constants + springs)].concat(),
            results: [vectors(3), numbers(springs + M::Losses::<R>::LEN)].concat(),
        }
    }

    #[inline(always)]
    fn apply(&self, from: &mut impl FnMut() -> R, to: &mut impl FnMut(R)) {
        let (contact, constants, springs) = pair(from);
        let outcome = self.model.pair(&contact, &constants, springs, R::lit(self.dt));
        let wrench = outcome.wrench;
        (wrench.force, wrench.torque_i, wrench.torque_j).put(to);
        (0..M::Memory::<R>::LEN).for_each(|k| to(*outcome.memory.at(k)));
        (0..M::Losses::<R>::LEN).for_each(|k| to(*outcome.losses.at(k)));
    }
}

/// The constants of a pair as a kernel. Its arguments: the two radii, the two masses. Its results: the constants.
pub struct CoefficientsKernel<'a, M> {
    /// The law.
    pub model: &'a M,
    /// Whether a neck joins the pair.
    pub joined: bool,
}

impl<R: Real, M: PairModel> Kernel<R, ()> for CoefficientsKernel<'_, M> {
    fn shape(&self) -> Shape {
        Shape { arguments: vec![1; 4], results: vec![1; M::Coefficients::<R>::LEN] }
    }

    #[inline(always)]
    fn apply(&self, from: &mut impl FnMut() -> R, to: &mut impl FnMut(R)) {
        let constants = self.model.coefficients(from(), from(), from(), from());
        let constants = if self.joined { self.model.joined(constants) } else { constants };
        (0..M::Coefficients::<R>::LEN).for_each(|k| to(*constants.at(k)));
    }
}

/// The energy stored in a pair as a kernel. Its arguments are those of [`PairKernel`], its results the energies by cause.
pub struct StoredKernel<'a, M> {
    /// The law.
    pub model: &'a M,
}

impl<R: Real, M: PairModel> Kernel<R, ()> for StoredKernel<'_, M> {
    fn shape(&self) -> Shape {
        let arguments = Kernel::<R, ()>::shape(&PairKernel { model: self.model, dt: 0.0 }).arguments;
        Shape { arguments, results: vec![1; M::Stored::<R>::LEN] }
    }

    #[inline(always)]
    fn apply(&self, from: &mut impl FnMut() -> R, to: &mut impl FnMut(R)) {
        let (contact, constants, springs) = pair(from);
        let stored = self.model.stored(&contact, &constants, &springs);
        (0..M::Stored::<R>::LEN).for_each(|k| to(*stored.at(k)));
    }
}

/// The kinematics, the constants and the springs of a pair.
#[inline(always)]
fn pair<R: Real, C: Flat<R>, S: Flat<R>>(from: &mut impl FnMut() -> R) -> (Contact<R>, C, S) {
    let [x, v, omega_i, omega_j] = [Vec3::take(from), Vec3::take(from), Vec3::take(from), Vec3::take(from)];
    let contact = Contact::new(x, v, omega_i, omega_j, from(), from());
    (contact, Flat::from_fn(|_| from()), Flat::from_fn(|_| from()))
}
