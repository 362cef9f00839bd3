//! The language of case files: sections, quantities with units, and the locations of errors. It depends on no paper.

pub mod check;
pub mod json_schema;
mod key;
mod moments;
mod outline;
pub mod quantity;
mod read;
mod schema;
pub mod section;
pub mod springs;
pub mod units;

pub use moments::Moments;
pub use outline::{Outline, Words};
pub use read::{document, located, parse, problems, read_text, unmarked};
pub use schema::{Case, Digits, Extra, Format, InSteps, Limits, Output, keys};
