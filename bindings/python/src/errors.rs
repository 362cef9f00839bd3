//! Errors and panics as exceptions.

use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::path::Path;
use std::sync::Mutex;
use veridem::error::{Error, Problem};

/// The message of the latest panic.
static BROKEN: Mutex<String> = Mutex::new(String::new());

/// Lets panics be told by exceptions alone.
pub(crate) fn keep_quiet() {
    set_hook(Box::new(|panic| {
        if let Ok(mut message) = BROKEN.lock() {
            *message = panic.to_string();
        }
    }));
}

/// Does some work; a panic in it becomes an exception.
pub(crate) fn caught<T>(work: impl FnOnce() -> PyResult<T>) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        let message = BROKEN.lock().map(|message| message.clone()).unwrap_or_default();
        Err(broken(&message))
    })
}

/// The exception of a broken invariant.
pub(crate) fn broken(message: &str) -> PyErr {
    made("BrokenInvariant", &format!("broken invariant, a defect of veridem: {message}"), |_| Ok(()))
}

/// An exception of a class of the package.
fn made(class: &str, message: &str, complete: impl FnOnce(&Bound<'_, PyAny>) -> PyResult<()>) -> PyErr {
    Python::attach(|py| {
        let class = py.import("veridem.errors").and_then(|errors| errors.getattr(class));
        let value = class.and_then(|class| class.call1((message,)));
        value.and_then(|value| complete(&value).map(|()| PyErr::from_value(value))).unwrap_or_else(|error| error)
    })
}

/// The exception of wrong input that belongs to no file.
pub(crate) fn wrong(what: impl Into<String>) -> PyErr {
    PyValueError::new_err(what.into())
}

/// The exception of an error.
pub(crate) fn exception(error: Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Input(problems) => made("InputError", &message, |value| {
            let list = PyList::empty(value.py());
            problems.iter().try_for_each(|problem| list.append(problem_of(value.py(), problem)?))?;
            value.setattr("problems", list)
        }),
        Error::Usage(_) => wrong(message),
        Error::NoInput(path, cause) | Error::Io(path, cause) => failed(&path, &cause),
        Error::Halted(halt, state) => made("Halted", &message, |value| {
            value.setattr("step", halt.step)?;
            value.setattr("time", halt.time)?;
            value.setattr("state", state)
        }),
        Error::Verification(_) => made("VerificationFailed", &message, |_| Ok(())),
        Error::Runs(..) => made("RunsFailed", &message, |_| Ok(())),
        Error::Stopped(run) => {
            let again = run.as_ref().map_or("the same call resumes it".into(), |run| {
                format!("veridem.resume({:?}) resumes it", run.display().to_string())
            });
            made("Stopped", &format!("stopped; {again}"), |value| value.setattr("run", run))
        }
        Error::Interrupted => PyKeyboardInterrupt::new_err(message),
    }
}

/// A problem of the input, as Python has it.
fn problem_of<'py>(py: Python<'py>, problem: &Problem) -> PyResult<Bound<'py, PyAny>> {
    let known = |text: String| (!text.is_empty()).then_some(text);
    let (file, key) = (known(problem.file.display().to_string()), known(problem.key.clone()));
    py.import("veridem.errors")?.getattr("Problem")?.call1((file, problem.line, key, &problem.what))
}

/// The exception of a file, of the class that Python has for its cause.
fn failed(path: &Path, cause: &io::Error) -> PyErr {
    let (text, path) = (cause.to_string(), path.display().to_string());
    match cause.raw_os_error() {
        Some(number) => {
            let text = text.trim_end_matches(&format!(" (os error {number})")).to_string();
            PyOSError::new_err((number, text, path))
        }
        None => PyOSError::new_err(format!("{path}: {text}")),
    }
}
