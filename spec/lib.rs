//! The equations of three contact models, executable.
//!
//! Every equation of a paper is one small function over an abstract number, [`Real`]. Read a room, for instance
//! [`wear::eq03_normal_force`], from top to bottom: the formula as printed, how it was read, its units and domain, its laws.

#[cfg(test)]
extern crate self as veridem_spec;

#[cfg(feature = "columns")]
pub mod columns;
pub mod contact;
pub mod document;
pub mod equation;
pub mod finding;
#[cfg(feature = "source")]
pub mod languages;
pub mod mechanics;
pub mod model;
pub mod numbers;
pub mod real;
pub mod soot;
pub mod titania;
pub mod unit;
pub mod vec3;
pub mod wear;

pub use contact::Contact;
use equation::{Equation, Paper};
pub use mechanics::carried::{Carried, Turns};
pub use mechanics::necked::{self, Necked};
pub use model::{Flat, Named, Outcome, PairModel, Touch, Wrench};
pub use real::{Real, piecewise};
pub use vec3::{Tensor, Vec3};

/// The papers, and the mechanics that they share.
pub fn papers() -> Vec<Paper> {
    vec![mechanics::paper(), titania::paper(), wear::paper(), soot::paper()]
}

/// Every equation of every paper.
pub fn equations() -> Vec<Equation> {
    papers().into_iter().flat_map(|paper| (paper.equations)()).collect()
}
