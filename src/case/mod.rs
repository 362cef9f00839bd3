//! The case file: what the user asks for, read, checked and expressed in engine units.

mod derived;
mod film;
pub mod quantity;
mod read;
pub mod schema;
pub mod section;
mod soot;
mod titania;
pub mod units;
pub(crate) mod validation;

pub use derived::{Critical, OF_WEAR, Scales};
pub use film::*;
pub use read::{located, unmarked};
pub use schema::*;
pub use soot::*;
pub use titania::*;
