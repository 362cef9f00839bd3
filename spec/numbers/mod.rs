//! The number types that implement [`Real`](crate::Real), apart from `f64` and `f32`.

pub(crate) mod exponential;
mod instructions;
mod lanes;

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

pub use instructions::{Instructions, Set, Work};
pub use lanes::{LaneMask, Lanes};

#[cfg(feature = "verify")]
pub use {
    dimension::Dimension,
    dual::Dual,
    interval::{Interval, Truth},
    reference::Reference,
    rounded::{Rounded, Trouble, Ulps, Verdict},
    slope::Slope,
};
