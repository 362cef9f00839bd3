//! Messages to the user: all of them go through here to standard error.

use std::collections::BTreeSet;
use std::io::Write;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

static SILENT: AtomicBool = AtomicBool::new(false);
static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Writes a line to standard error; nobody need read it, so that a closed or full one is no failure.
pub fn message(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

/// Remarks, once, on input that is accepted but may not mean what its author thinks, unless notices are silenced.
pub fn notice(text: impl Into<String>) {
    let text = text.into();
    let mut said = SAID.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    if !SILENT.load(Ordering::Relaxed) && !said.contains(&text) {
        message(&format!("notice: {text}"));
        said.insert(text);
    }
}

/// Whether this process has made a remark.
#[cfg(test)]
pub(crate) fn was_said(text: &str) -> bool {
    SAID.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).contains(text)
}

/// Silences all notices of the process.
pub fn silence() {
    SILENT.store(true, Ordering::Relaxed);
}
