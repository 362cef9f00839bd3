//! Long computations: on threads of their own, with their messages told to Python, ended by Ctrl-C.

use crate::errors::{caught, exception, wrong};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;
use veridem::error::Error;
use veridem::interrupt::Interrupt;

/// Interval at which Python is asked whether a signal has come.
const PAUSE: Duration = Duration::from_millis(50);
/// Most threads, as on the command line.
const MOST: usize = 1024;

/// Threads for a computation: all cores, unless told otherwise.
pub(crate) fn pool(threads: Option<usize>) -> PyResult<ThreadPool> {
    let count = threads.unwrap_or(0);
    if threads == Some(0) || count > MOST {
        return Err(wrong(format!("`threads` = {count}: expected 1 to {MOST}")));
    }
    ThreadPoolBuilder::new().num_threads(count).build().map_err(|error| wrong(error.to_string()))
}

/// The limit of time of a computation.
pub(crate) fn limit(max_time: Option<f64>) -> PyResult<Interrupt> {
    let interrupt = Interrupt::default();
    let Some(seconds) = max_time else { return Ok(interrupt) };
    let time = Duration::try_from_secs_f64(seconds).map_err(|error| wrong(format!("`max_time`: {error}")))?;
    Ok(interrupt.within(time))
}

/// Does some work on these threads while Python runs; hands its messages to `tell`. A signal, or an exception that `tell` raises, asks it to
/// stop, and is raised when it has ended.
pub(crate) fn interruptible<T: Send, M: Send>(
    py: Python<'_>,
    pool: &ThreadPool,
    interrupt: &Interrupt,
    work: impl FnOnce(&Interrupt, &Sender<M>) -> Result<T, Error> + Send,
    mut tell: impl FnMut(M) -> PyResult<()>,
) -> PyResult<T> {
    let (sender, mut receiver) = channel();
    let (ended, raised) = std::thread::scope(|scope| {
        let worker = scope.spawn(move || caught(|| pool.install(|| work(interrupt, &sender)).map_err(exception)));
        let mut raised = None;
        loop {
            let receiver = &mut receiver;
            let told = match py.detach(move || receiver.recv_timeout(PAUSE)) {
                Ok(_) if raised.is_some() => Ok(()),
                Ok(message) => tell(message),
                Err(RecvTimeoutError::Timeout) => Ok(()),
                Err(RecvTimeoutError::Disconnected) => break,
            };
            if let Err(error) = told.and_then(|()| py.check_signals()) {
                interrupt.request();
                raised.get_or_insert(error);
            }
        }
        (py.detach(|| worker.join()), raised)
    });
    let ended = ended.expect("panics of the worker are caught");
    match (raised, ended) {
        (None, ended) => ended,
        (Some(error), Err(stopped)) if error.is_instance_of::<PyKeyboardInterrupt>(py) => {
            // Says how to go on.
            let stopped = stopped.value(py).to_string();
            Err(PyKeyboardInterrupt::new_err(stopped))
        }
        (Some(error), _) => Err(error),
    }
}
