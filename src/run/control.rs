//! When a run is asked to stop before its end.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Signals, time and steps that a run has left.
#[derive(Clone, Debug, Default)]
pub struct Control {
    signal: Arc<AtomicBool>,
    deadline: Option<Instant>,
    steps: Option<u64>,
}

impl Control {
    /// Stops on SIGINT and SIGTERM, after `time` of the wall clock, and after so many steps of this process.
    pub fn new(time: Option<Duration>, steps: Option<u64>) -> std::io::Result<Self> {
        let signal = Arc::new(AtomicBool::new(false));
        for number in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
            // The second signal ends the process at once: nothing that was written before is harmed.
            signal_hook::flag::register_conditional_shutdown(number, 75, signal.clone())?;
            signal_hook::flag::register(number, signal.clone())?;
        }
        Ok(Self { signal, deadline: time.map(|time| Instant::now() + time), steps })
    }

    /// Stops after `time` of the wall clock, and leaves signals alone.
    pub fn lasting(time: Duration) -> Self {
        Self { deadline: Some(Instant::now() + time), ..Self::default() }
    }

    /// Whether to stop now, after so many steps of this process.
    pub fn stops(&self, steps: u64) -> bool {
        self.signal.load(Ordering::Relaxed)
            || self.steps.is_some_and(|most| steps >= most)
            || self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }
}
