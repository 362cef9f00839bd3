//! The numbers that [`Real`](crate::Real) can be, apart from `f64` and `f32` themselves.

mod lanes;

pub use lanes::{LaneMask, Lanes};
