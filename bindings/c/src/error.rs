//! How calls end: a number for the caller, and a message in words.

use std::cell::RefCell;
use std::ffi::{CString, c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Done.
const DONE: c_int = 0;

/// What went wrong.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// An argument is wrong.
    Input(String),
    /// A pair left the domain of the law.
    Domain(String),
}

/// The outcome of a call.
pub(crate) type Done<T = ()> = Result<T, Trouble>;

/// Shorthand for wrong input.
pub(crate) fn wrong<T>(what: impl Into<String>) -> Done<T> {
    Err(Trouble::Input(what.into()))
}

thread_local! {
    static LAST: RefCell<CString> = RefCell::default();
}

/// Does the work of a call. Nothing unwinds into the caller: a panic becomes a number and a message like any other failure.
pub(crate) fn border(work: impl FnOnce() -> Done) -> c_int {
    let (code, message) = match catch_unwind(AssertUnwindSafe(work)) {
        Ok(Ok(())) => return DONE,
        Ok(Err(Trouble::Input(what))) => (65, what),
        Ok(Err(Trouble::Domain(what))) => (5, what),
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
            (70, format!("broken invariant: {}", text.unwrap_or("without a message")))
        }
    };
    LAST.with_borrow_mut(|last| *last = CString::new(message.replace('\0', " ")).unwrap_or_default());
    code
}

/// The message of the last call of this thread that failed.
#[unsafe(no_mangle)]
extern "C" fn veridem_message() -> *const c_char {
    LAST.with_borrow(|last| last.as_ptr())
}
