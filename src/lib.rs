//! The f64 engine built on the equations of [`veridem_spec`], and the command line that runs the papers' cases.

pub mod case;
pub mod forces;
pub mod motion;
pub mod simulation;
pub mod system;

pub use veridem_spec as spec;
