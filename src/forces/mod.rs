//! From positions to forces: the neighbour list, its blocks, the pair loop on lanes, and the sum per particle.

mod act;
mod blocks;
mod causes;
mod kernel;
mod layout;
mod merged;
mod order;
mod pairs;
mod prefetch;
mod surfaces;
mod totals;
mod transpose;
mod vectorised;

pub use crate::spec::numbers::Instructions;
pub use blocks::{Block, Touchable, partition, places};
pub use kernel::{Load, evaluate, vectorised};
pub use layout::{CAPACITY, LANES, bond};
pub use merged::{AHEAD, MergedLoads, StoredLoads, stored_loads};
pub use order::spatial_order;
pub use pairs::{FarPairs, Pairs};
pub use prefetch::prefetch;
pub use surfaces::{SurfaceTotals, each_touch, surface_forces};
pub use totals::Totals;
pub use transpose::Square;
pub use vectorised::Vectorised;
