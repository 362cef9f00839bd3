//! A law over columns: one for each number of the arguments, one for each of the results.

use crate::error::{Done, wrong};
use crate::law::constants;
use veridem_spec::columns::{PairKernel, in_rows};
use veridem_spec::numbers::Instructions;
use veridem_spec::{Flat, PairModel};

/// Numbers of the kinematics of a pair: branch vector, velocity, two angular velocities, two radii.
pub(crate) const KINEMATICS: usize = 14;

/// Columns of arguments and of results, of equal length.
pub(crate) struct Columns<'a, 'b> {
    /// Kinematics, the two masses, one or zero for a neck, the springs.
    pub arguments: &'a [&'a [f64]],
    /// Force, two torques, the springs, the losses.
    pub results: &'a mut [&'b mut [f64]],
}

impl Columns<'_, '_> {
    /// Evaluates a law.
    pub(crate) fn evaluate<M: PairModel>(&mut self, model: &M, dt: f64) -> Done {
        let (springs, losses) = (M::Memory::<f64>::LEN, M::Losses::<f64>::LEN);
        let (needed, given) = (KINEMATICS + 3 + springs, 9 + springs + losses);
        if self.arguments.len() != needed || self.results.len() != given {
            let found = format!("found {} columns of arguments and {}", self.arguments.len(), self.results.len());
            return wrong(format!("{found} of results, expected {needed} and {given}"));
        }
        let length = self.arguments[0].len();
        let mut of_pairs = vec![vec![0.0; length]; M::Coefficients::<f64>::LEN];
        for place in 0..length {
            let number = |column: usize| self.arguments[column][place];
            let of = [number(12), number(13), number(14), number(15)];
            let k = constants(model, of, number(16) > 0.5);
            for (n, column) in of_pairs.iter_mut().enumerate() {
                column[place] = *k.at(n);
            }
        }
        let of_pairs = of_pairs.iter().map(Vec::as_slice);
        let kinematics = self.arguments[..KINEMATICS].iter().copied();
        let arguments: Vec<&[f64]> =
            kinematics.chain(of_pairs).chain(self.arguments[KINEMATICS + 3..].iter().copied()).collect();
        in_rows(PairKernel { model, dt }, Instructions::best(), &arguments, self.results);
        Ok(())
    }
}
