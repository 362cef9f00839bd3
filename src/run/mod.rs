//! A run: the stages of a study in succession, advanced step by step, observed, recorded, and checkpointed so that a resumed run has the same bits.

mod driver;
mod export;
mod job;
mod paths;
mod places;
mod plan;
mod progress;
mod record;
mod recorder;
mod row;
mod saved;
mod sink;
mod study;
pub mod sweep;

pub use driver::{Driver, Outcome, RunState, RunningStage, advance, advance_until};
pub use job::{Job, Reader, Runnable};
pub use paths::{CasePath, Paths};
pub use progress::{Message, RunProgress};
pub use row::{Row, columns};
pub use sink::{Each, Memory, Sink, Step};
pub use study::{Progress, Study};
