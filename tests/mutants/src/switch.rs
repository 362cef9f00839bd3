//! The switch of the mutated copy: which mutant is active, and which mutants a test reaches.
//!
//! This file is copied into the copy and is a module there.

use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// Nothing has been read from the environment yet.
const UNKNOWN: u32 = u32::MAX;
/// No mutant is active; those that are reached are written down.
const RECORDING: u32 = u32::MAX - 1;

static ACTIVE: AtomicU32 = AtomicU32::new(UNKNOWN);

/// Whether this mutant is active.
#[inline(always)]
pub(crate) fn on(mutant: u32) -> bool {
    let active = ACTIVE.load(Ordering::Relaxed);
    active == mutant || active >= RECORDING && look_up(mutant)
}

#[cold]
#[inline(never)]
fn look_up(mutant: u32) -> bool {
    if ACTIVE.load(Ordering::Relaxed) == UNKNOWN {
        let number = std::env::var("VERIDEM_MUTANT").ok().and_then(|text| text.parse().ok());
        ACTIVE.store(number.unwrap_or(RECORDING), Ordering::Relaxed);
        return on(mutant);
    }
    record(mutant);
    false
}

/// Appends the number of a mutant that is reached for the first time to the file that the environment names.
fn record(mutant: u32) {
    static SEEN: [AtomicBool; 1 << 14] = [const { AtomicBool::new(false) }; 1 << 14];
    static FILE: OnceLock<Option<std::fs::File>> = OnceLock::new();
    let seen = &SEEN[mutant as usize];
    if seen.load(Ordering::Relaxed) || seen.swap(true, Ordering::Relaxed) {
        return;
    }
    let open = || {
        let path = std::env::var("VERIDEM_REACHED").ok()?;
        // programs that a test starts write into the same file
        Some(std::fs::OpenOptions::new().create(true).append(true).open(path).expect("a file"))
    };
    if let Some(mut file) = FILE.get_or_init(open).as_ref() {
        // at once: laws may have several threads
        file.write_all(format!("{mutant}\n").as_bytes()).expect("a line");
    }
}
