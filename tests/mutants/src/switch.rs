//! The switch of the mutated copy: which mutant is active, and which mutants a test reaches.
//!
//! This file is copied into the copy of the specification and is a module there.

use crate::{Real, Vec3};
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
    if SEEN[mutant as usize].swap(true, Ordering::Relaxed) {
        return;
    }
    let open = || std::env::var("VERIDEM_REACHED").ok().map(|path| std::fs::File::create(path).expect("a file"));
    if let Some(mut file) = FILE.get_or_init(open).as_ref() {
        // at once: laws may have several threads
        file.write_all(format!("{mutant}\n").as_bytes()).expect("a line");
    }
}

/// What an equation returns.
pub(crate) trait Scaled<R> {
    /// All of its numbers times a factor.
    fn scaled(self, factor: R) -> Self;
}

impl<R: Real> Scaled<R> for R {
    fn scaled(self, factor: R) -> Self {
        self * factor
    }
}
impl<R: Real> Scaled<R> for Vec3<R> {
    fn scaled(self, factor: R) -> Self {
        self * factor
    }
}
impl<R: Real> Scaled<R> for [Vec3<R>; 3] {
    fn scaled(self, factor: R) -> Self {
        self.map(|row| row * factor)
    }
}
macro_rules! scaled_tuple {
    ($($part:ident)+) => {
        #[allow(non_snake_case)]
        impl<R: Real, $($part: Scaled<R>),+> Scaled<R> for ($($part,)+) {
            fn scaled(self, factor: R) -> Self {
                let ($($part,)+) = self;
                ($($part.scaled(factor),)+)
            }
        }
    };
}
scaled_tuple!(A B);
scaled_tuple!(A B C);
scaled_tuple!(A B C D);
scaled_tuple!(A B C D E);
scaled_tuple!(A B C D E F);
scaled_tuple!(A B C D E F G);

/// The result of an equation, or 1.01, 0 or -1 times it if one of its three mutants is active.
#[inline(always)]
pub(crate) fn result<R: Real, S: Scaled<R>>(first: u32, result: S) -> S {
    if on(first) {
        result.scaled(R::lit(1.01))
    } else if on(first + 1) {
        result.scaled(R::zero())
    } else if on(first + 2) {
        result.scaled(-R::one())
    } else {
        result
    }
}
