//! Requests to stop before the end: a signal, a limit of time or of steps.

use crate::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Signals, and the remaining time and steps. Long computations poll it, and save their state before they stop.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    signal: Arc<AtomicBool>,
    deadline: Option<Instant>,
    steps: Option<u64>,
}

impl Interrupt {
    /// Stops on SIGINT and SIGTERM, after `time` of the wall clock, and after a number of steps of this process.
    ///
    /// # Errors
    ///
    /// If the operating system refuses a signal handler.
    pub fn new(time: Option<Duration>, steps: Option<u64>) -> std::io::Result<Self> {
        let signal = Arc::new(AtomicBool::new(false));
        for number in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
            // The second signal ends the process at once: nothing that was written before is harmed.
            signal_hook::flag::register_conditional_shutdown(number, 75, signal.clone())?;
            signal_hook::flag::register(number, signal.clone())?;
        }
        Ok(Self { signal, deadline: time.map(|time| Instant::now() + time), steps })
    }

    /// The same wish, and to stop after `time` of the wall clock.
    pub fn within(&self, time: Duration) -> Self {
        Self { deadline: Some(Instant::now() + time), ..self.clone() }
    }

    /// Whether to stop now, after this many steps of this process.
    pub fn stops(&self, steps: u64) -> bool {
        self.steps.is_some_and(|most| steps >= most) || self.is_due()
    }

    /// Whether a signal has come or the time is over.
    pub fn is_due(&self) -> bool {
        self.signal.load(Ordering::Relaxed) || self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Ends work that keeps nothing.
    ///
    /// # Errors
    ///
    /// [`Error::Stopped`] if a signal has come or the time is over.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_due() { Err(Error::Stopped(None)) } else { Ok(()) }
    }
}
