//! Springs at a rebuild of the neighbour list: the springs that a pair keeps, and the energy of those that it loses.

use super::Simulation;
use crate::error::Halt;
use crate::forces;
use crate::interrupt::Interrupt;
use crate::spec::{Flat, PairModel};
use crate::system::{Bond, Image, Springs};
use std::collections::BTreeSet;

impl<M: PairModel> Simulation<M> {
    /// Rebuilds the neighbour list. The energy of springs that are dropped is entered as lost.
    pub(super) fn list_anew(&mut self) -> Result<(), Halt> {
        let (springs, forgotten) = self.springs();
        self.enter_lost(&forgotten);
        // Their memory is needed for the next ones.
        self.blocks = Vec::new();
        self.list_neighbours(&springs, &Interrupt::default())?;
        self.let_go(&springs);
        Ok(())
    }

    /// The contact history of all pairs, and the energy of the springs that the model resets.
    pub(super) fn springs(&self) -> (Springs, M::Losses<f64>) {
        let mut springs = Springs::new(M::Memory::<f64>::LEN);
        let mut forgotten: M::Losses<f64> = Flat::from_fn(|_| 0.0);
        for block in &self.blocks {
            for (i, j, row, lane) in block.each_pair() {
                let (i, j) = (block.member(i), block.member(j));
                let constants = Flat::from_fn(|k| block.pairs.constants(row).at(k).0[lane]);
                let memory = block.pairs.memory_of(row, lane);
                let (kept, lost) = self.model.relisted(&self.contact(i, j), &constants, memory);
                springs.add(self.bond(i, j), (0..M::Memory::<f64>::LEN).map(|k| *kept.at(k)));
                forgotten = Flat::from_fn(|k| forgotten.at(k) + lost.at(k));
            }
        }
        (springs.sorted(), forgotten)
    }

    /// Enters the energy of springs of pairs that are no longer listed among those that can touch. They are out of contact: the law accounts for the loss.
    fn let_go(&mut self, springs: &Springs) {
        let held = |memory: &M::Memory<f64>| (0..M::Memory::<f64>::LEN).any(|k| *memory.at(k) != 0.0);
        let pairs_with_springs = || {
            let pairs = self.blocks.iter().flat_map(|block| block.each_pair().map(move |pair| (block, pair)));
            pairs.filter(|(block, (_, _, row, lane))| held(&block.pairs.memory_of(*row, *lane)))
        };
        if pairs_with_springs().count() == springs.bonds().len() {
            return;
        }
        let found: BTreeSet<Bond> =
            pairs_with_springs().map(|(block, (i, j, ..))| self.bond(block.member(i), block.member(j))).collect();
        let particles = &self.system.particles;
        let place = self.system.places();
        let mut lost: M::Losses<f64> = Flat::from_fn(|_| 0.0);
        for bond in springs.bonds().filter(|bond| !found.contains(bond)) {
            let (i, j) = (place[&bond.0], place[&bond.1]);
            let contact = self.contact((i, [0; 3]), (j, bond.2));
            let (r, m) = (&particles.radius, &particles.mass);
            let constants = self.model.coefficients(r[i], r[j], m[i], m[j]);
            let numbers = springs.of(bond).expect("springs of a pair that has some");
            let losses = self.model.pair(&contact, &constants, Flat::from_fn(|k| numbers[k]), self.settings.dt).losses;
            lost = Flat::from_fn(|k| lost.at(k) + losses.at(k));
        }
        self.enter_lost(&lost);
    }

    fn enter_lost(&mut self, lost: &M::Losses<f64>) {
        for (k, sum) in self.ledger.lost_by_pairs.iter_mut().enumerate() {
            *sum += lost.at(k);
        }
    }

    /// The persistent key of two spheres, each given by index and copy.
    pub(super) fn bond(&self, (p, a): (usize, Image), (q, b): (usize, Image)) -> Bond {
        forces::bond(&self.system.particles, p, q, std::array::from_fn(|k| b[k] - a[k]))
    }
}
