//! A run: the stages of a study, one after another, driven step by step, watched, recorded, and kept so that it can be resumed bit by bit.

mod driver;
mod job;
mod record;
mod recorder;
mod row;
mod sink;
mod study;
pub mod sweep;

pub use driver::{Course, Driver, Outcome, Stage, advance, advance_until};
pub use job::{Job, Reader, Runnable};
pub use recorder::Glance;
pub use row::{Row, columns};
pub use sink::{Each, Memory, Sink, Step};
pub use study::{Progress, Study};
