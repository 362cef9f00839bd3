//! From positions to forces: the neighbour list, its blocks, the pair loop on lanes, and the sum per particle.

mod blocks;
mod grid;
mod instructions;
mod kernel;
mod memory;
mod order;
mod transpose;

pub use blocks::{Block, CAPACITY, LANES, Pairs, bond, partition};
pub use grid::{Neighbour, neighbours};
pub use instructions::Instructions;
pub use kernel::{Load, Totals, evaluate};
pub use memory::{Bond, Springs};
pub use order::spatial_order;
