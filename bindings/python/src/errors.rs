//! Errors and panics as exceptions.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::sync::Mutex;

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
        Err(made("BrokenInvariant", &format!("broken invariant, a defect of veridem: {message}")))
    })
}

/// An exception of a class of the package.
fn made(class: &str, message: &str) -> PyErr {
    Python::attach(|py| {
        let class = py.import("veridem.errors").and_then(|errors| errors.getattr(class));
        class.and_then(|class| class.call1((message,))).map_or_else(|error| error, PyErr::from_value)
    })
}

/// The exception of wrong input that belongs to no file.
pub(crate) fn wrong(what: impl Into<String>) -> PyErr {
    PyValueError::new_err(what.into())
}
