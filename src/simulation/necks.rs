//! Breaking of necks.

use super::{Integrator, Simulation};
use crate::error::Halt;
use crate::forces::bond;
use crate::spec::{Contact, Flat, PairModel};
use crate::system::Springs;

/// Removes some necks. The contacts that take their place begin with relaxed springs, and with what the model says is left of a neck.
pub fn remove_necks<M: PairModel>(
    necks: &mut Vec<(u32, u32)>,
    springs: &mut Springs,
    removed: impl Fn((u32, u32)) -> bool,
) {
    let is_removed = |pair| necks.binary_search(&pair).is_ok() && removed(pair);
    springs.replace(is_removed, |numbers| {
        let left = M::left_by_neck(Flat::from_fn(|k| numbers[k]));
        (0..M::Memory::<f64>::LEN).map(|k| *left.at(k)).collect()
    });
    necks.retain(|&neck| !removed(neck));
}

impl<M: PairModel> Simulation<M> {
    /// Breaks every neck of which `breaks` holds, given the ids of its spheres, the pair, its springs, and what it holds, as [`remove_necks`] does. Returns
    /// the ids.
    ///
    /// # Errors
    ///
    /// If neighbours cannot be listed anew.
    pub fn break_necks(
        &mut self,
        breaks: impl Fn((u32, u32), &Contact<f64>, &M::Memory<f64>, &M::Stored<f64>) -> bool,
    ) -> Result<Vec<(u32, u32)>, Halt> {
        let broken = self.necks_that(breaks);
        if broken.is_empty() {
            return Ok(broken);
        }
        let before: f64 = self.stored().iter().sum();
        let (mut springs, _) = self.springs();
        remove_necks::<M>(&mut self.system.necks, &mut springs, |neck| broken.binary_search(&neck).is_ok());
        self.relist(&springs)?;
        self.ledger.lost_to_breaking += before - self.stored().iter().sum::<f64>();
        if self.settings.integrator == Integrator::VelocityVerlet {
            self.hold()?;
        }
        Ok(broken)
    }

    fn necks_that(
        &self,
        breaks: impl Fn((u32, u32), &Contact<f64>, &M::Memory<f64>, &M::Stored<f64>) -> bool,
    ) -> Vec<(u32, u32)> {
        let mut found = Vec::new();
        for block in &self.blocks {
            for (i, j, row, lane) in block.each_pair() {
                let (p, q) = (block.member(i), block.member(j));
                let image = std::array::from_fn(|k| q.1[k] - p.1[k]);
                let (a, b, _) = bond(&self.system.particles, p.0, q.0, image);
                if self.system.necks.binary_search(&(a, b)).is_err() {
                    continue;
                }
                let contact = self.contact(p, q);
                let coefficients = Flat::from_fn(|k| block.pairs.constants(row).at(k).0[lane]);
                let memory = Flat::from_fn(|k| block.pairs.memory[row].at(k).0[lane]);
                if breaks((a, b), &contact, &memory, &self.model.stored(&contact, &coefficients, &memory)) {
                    found.push((a, b));
                }
            }
        }
        found.sort_unstable();
        found
    }
}
