//! Proofs of what the specification claims, over whole boxes of arguments instead of samples.

mod bisection;
mod boxes;
mod claims;
mod page;
mod verdicts;

pub use bisection::{Proof, Ranges};
pub use boxes::{Scale, range, whole};
pub use claims::{Claim, Sign, attempt, claims, described, enclosure};
pub use page::{PAGE, page, row};
pub use verdicts::{Status, Verdict, box_text, verdicts};
