//! Requests to stop before the end: a signal, a limit of time or of steps.

use crate::error::Error;
#[cfg(unix)]
use signal_hook::consts::{SIGHUP, SIGXCPU, SIGXFSZ};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Signals, and the remaining time and steps. Long computations poll it, and save their state before they stop.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    signal: Arc<AtomicBool>,
    deadline: Option<Instant>,
    steps: Option<u64>,
}

/// The signals of this process, once it handles them.
static OF_PROCESS: OnceLock<Interrupt> = OnceLock::new();

impl Interrupt {
    /// Stops on SIGINT, SIGTERM, SIGHUP and SIGXCPU, after `time` of the wall clock, and after a number of steps of this process.
    ///
    /// # Errors
    ///
    /// If the operating system refuses a signal handler.
    pub fn new(time: Option<Duration>, steps: Option<u64>) -> std::io::Result<Self> {
        let signal = Arc::new(AtomicBool::new(false));
        #[cfg(unix)]
        for number in [SIGHUP, SIGXCPU].into_iter().filter(|&number| number != SIGHUP || !hangup_is_ignored()) {
            // The system may repeat them at any time.
            flag::register(number, signal.clone())?;
        }
        for number in [SIGINT, SIGTERM] {
            // The same signal a second time ends the process at once: nothing that was written before is harmed.
            let first = Arc::new(AtomicBool::new(false));
            flag::register_conditional_shutdown(number, 75, first.clone())?;
            flag::register(number, first)?;
            flag::register(number, signal.clone())?;
        }
        OF_PROCESS.set(Self { signal: signal.clone(), ..Self::default() }).ok();
        Ok(Self { signal, deadline: time.and_then(|time| Instant::now().checked_add(time)), steps })
    }

    /// Stops on the signals that this process handles, if it handles any: where none is handed down.
    pub fn of_process() -> Self {
        OF_PROCESS.get().cloned().unwrap_or_default()
    }

    /// The same wish, and to stop after `time` of the wall clock.
    pub fn within(&self, time: Duration) -> Self {
        Self { deadline: Some(Instant::now() + time), ..self.clone() }
    }

    /// Asks to stop, from another thread: all copies hear it.
    pub fn request(&self) {
        self.signal.store(true, Ordering::Relaxed);
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
    /// [`Error::Interrupted`] if a signal has come or the time is over.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_due() { Err(Error::Interrupted) } else { Ok(()) }
    }
}

/// Whether the process was told to ignore the end of its terminal, as by `nohup`.
#[cfg(unix)]
fn hangup_is_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_some_and(|mask| mask >> (SIGHUP - 1) & 1 == 1)
}

/// Lets a write beyond the size that the system allows for a file fail instead of ending the process.
///
/// # Errors
///
/// If the operating system refuses a signal handler.
pub fn outlive_file_limits() -> std::io::Result<()> {
    #[cfg(unix)]
    flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
    Ok(())
}
