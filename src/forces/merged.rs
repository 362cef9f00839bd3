//! The loads on the spheres of a block, from its own pairs and from those of other blocks.

use super::blocks::Block;
use super::{CAPACITY, Load, prefetch};
use crate::spec::PairModel;

/// Number of spheres from the request for numbers that are read in order to their use.
pub const AHEAD: usize = 32;

/// The loads that each block has stored.
pub type StoredLoads<'a> = Vec<&'a [Load; CAPACITY]>;

/// The loads of all blocks.
pub fn stored_loads<M: PairModel>(blocks: &[Block<M>]) -> StoredLoads<'_> {
    blocks.iter().map(|block| &*block.loads).collect()
}

/// The loads on the spheres of a block, in order.
pub struct MergedLoads<'a> {
    own: std::slice::Iter<'a, Load>,
    /// Number of the next sphere.
    next: u32,
    incoming: &'a [(u32, u32, u32)],
    stored: &'a [&'a [Load; CAPACITY]],
}

impl<'a> MergedLoads<'a> {
    /// On the first `count` spheres of a block.
    pub fn new<M: PairModel>(block: &'a Block<M>, count: usize, stored: &'a StoredLoads<'a>) -> Self {
        Self { own: block.loads[..count].iter(), next: 0, incoming: &block.incoming, stored }
    }
}

impl Iterator for MergedLoads<'_> {
    type Item = Load;

    #[inline(always)]
    fn next(&mut self) -> Option<Load> {
        let mut sum = *self.own.next()?;
        while let Some((&(to, from, place), rest)) = self.incoming.split_first() {
            if to != self.next {
                break;
            }
            sum = sum + self.stored[from as usize][place as usize];
            self.incoming = rest;
        }
        if let Some(ahead) = self.own.as_slice().get(AHEAD) {
            prefetch(ahead);
        }
        self.next += 1;
        Some(sum)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.own.size_hint()
    }
}

impl ExactSizeIterator for MergedLoads<'_> {}
