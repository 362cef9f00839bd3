//! Contact history, carried from one neighbour list to the next.

use super::Image;
use serde::{Deserialize, Serialize};

/// The persistent key of a pair: the ids of the spheres, the lower first, and the periodic image of the second relative to the first.
pub type Bond = (u32, u32, Image);

/// The contact history of all pairs that have one, looked up by the keys of the pairs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Springs {
    /// Sorted; each with the place of its springs.
    pub(super) bonds: Vec<(Bond, u32)>,
    pub(super) numbers: Vec<f64>,
    pub(super) width: usize,
}

impl Springs {
    /// No springs yet, of `width` numbers each.
    pub fn new(width: usize) -> Self {
        Self { width, ..Self::default() }
    }

    /// Adds the springs of a pair; those that are all zero need no entry.
    pub fn add(&mut self, bond: Bond, springs: impl Iterator<Item = f64> + Clone) {
        if springs.clone().any(|s| s != 0.0) {
            self.bonds.push((bond, self.numbers.len() as u32));
            self.numbers.extend(springs);
        }
    }

    /// Makes the springs ready to be found.
    pub fn sorted(mut self) -> Self {
        self.bonds.sort_unstable();
        self
    }

    /// Replaces the springs of some pairs of spheres; those that are all zero then need no entry.
    pub fn replace(&mut self, pair: impl Fn((u32, u32)) -> bool, new: impl Fn(&[f64]) -> Vec<f64>) {
        let Self { bonds, numbers, width } = self;
        bonds.retain(|&((i, j, _), place)| {
            if !pair((i, j)) {
                return true;
            }
            let springs = &mut numbers[place as usize..][..*width];
            springs.copy_from_slice(&new(springs));
            springs.iter().any(|&s| s != 0.0)
        });
    }

    /// The pairs that have springs.
    pub fn bonds(&self) -> impl ExactSizeIterator<Item = Bond> + '_ {
        self.bonds.iter().map(|&(bond, _)| bond)
    }

    /// The springs of a pair, if it has any.
    pub fn of(&self, bond: Bond) -> Option<&[f64]> {
        let place = self.bonds.binary_search_by_key(&bond, |&(bond, _)| bond).ok()?;
        let start = self.bonds[place].1 as usize;
        Some(&self.numbers[start..start + self.width])
    }
}
