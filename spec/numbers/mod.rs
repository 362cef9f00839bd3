//! The number types that implement [`Real`](crate::Real), apart from `f64` and `f32`.

mod bits;
pub(crate) mod exponential;
mod instructions;
mod lanes;
#[cfg(feature = "source")]
pub mod source;
#[cfg(feature = "source")]
pub mod written;

#[cfg(feature = "verify")]
pub mod dimension;
#[cfg(feature = "verify")]
mod dual;
#[cfg(feature = "verify")]
mod interval;
#[cfg(feature = "verify")]
mod reference;
#[cfg(feature = "verify")]
mod rounded;
#[cfg(feature = "verify")]
mod slope;

pub use bits::Bits;
pub use instructions::{Instructions, Set, Work};
pub use lanes::{LaneMask, Lanes};
#[cfg(feature = "source")]
pub use source::Source;

#[cfg(feature = "verify")]
pub use {
    dimension::Dimension,
    dual::Dual,
    interval::{Interval, Truth},
    reference::Reference,
    rounded::{Rounded, Trouble, Ulps, Verdict},
    slope::Slope,
};
