//! The case file: what the user asks for, read, checked and expressed in engine units.

pub mod quantity;
pub mod schema;
pub mod section;
pub mod units;

pub use schema::*;
