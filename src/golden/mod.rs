//! Golden vectors: inputs and correctly rounded outputs of every equation, kept in `golden/`; and golden trajectories, motions with a known solution.
//!
//! The vectors are generated with 256-bit numbers and never edited by hand; those computed independently of this code keep
//! their values and state their source. `golden/README.md` is the format.

mod calls;
mod independent;
mod index;
mod rounding;
mod sample;
mod trajectories;
mod vectors;

pub use calls::{Call, Calls};
pub use independent::check_independent;
pub use index::{INDEX, index};
pub use rounding::{Rounding, error, measure};
pub use sample::{Sample, samples};
pub use trajectories::{Complaints, Run, Trajectory, check_trajectories, steps};
pub use vectors::{File, Vector, check, file_of, read, regenerate};

use veridem_spec::document::Document;
use veridem_spec::equation::Equation;

/// Every equation with its documentation.
///
/// # Errors
///
/// The first equation whose documentation cannot be read.
pub fn documented() -> Result<Vec<(Equation, Document)>, String> {
    veridem_spec::equations().into_iter().map(|equation| Document::of(&equation).map(|d| (equation, d))).collect()
}
