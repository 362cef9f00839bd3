//! The f64 engine built on the equations of [`veridem_spec`], and the command line that runs the cases of the papers.

pub mod case;
#[cfg(feature = "cli")]
pub mod cli;
pub mod error;
pub mod figures;
pub mod forces;
pub mod geometry;
#[cfg(feature = "verify")]
pub mod golden;
pub mod initial;
pub mod interrupt;
pub mod motion;
pub mod observe;
pub mod output;
pub mod papers;
pub mod random;
#[cfg(feature = "cli")]
pub mod reproduce;
pub mod run;
pub mod simulation;
pub mod system;

pub use veridem_spec as spec;
