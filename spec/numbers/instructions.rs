//! The vector instructions in use. The bits of the results do not depend on them.

use std::sync::OnceLock;

/// An instruction set that this processor has: there is no other way to come by one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions(Set);

/// From the plainest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// What every processor of the target has.
    Baseline,
    /// Four numbers at once.
    Avx2,
    /// Eight numbers at once.
    Avx512,
}

static CHOSEN: OnceLock<Instructions> = OnceLock::new();

impl Instructions {
    /// What every processor of the target has.
    pub const BASELINE: Self = Self(Set::Baseline);

    /// Those that this processor has.
    pub fn available() -> Vec<Self> {
        let mut sets = vec![Self::BASELINE];
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx2") {
                sets.push(Self(Set::Avx2));
            }
            if std::arch::is_x86_feature_detected!("avx512f")
                && std::arch::is_x86_feature_detected!("avx512dq")
                && std::arch::is_x86_feature_detected!("avx512vl")
            {
                sets.push(Self(Set::Avx512));
            }
        }
        sets
    }

    /// Those that were chosen for this process, otherwise the widest that this processor has.
    pub fn best() -> Self {
        *CHOSEN.get_or_init(|| Self::available().pop().unwrap_or(Self::BASELINE))
    }

    /// Chooses these for all that this process computes from now on, unless something was computed already. Results do not depend on
    /// them.
    pub fn choose(self) {
        CHOSEN.get_or_init(|| self);
    }

    /// Those with this name, if this processor has them.
    pub fn named(name: &str) -> Option<Self> {
        Self::available().into_iter().find(|set| set.name() == name)
    }

    /// The name.
    pub fn name(self) -> &'static str {
        match self.0 {
            Set::Baseline => "baseline",
            Set::Avx2 => "avx2",
            Set::Avx512 => "avx512",
        }
    }

    /// Which one it is.
    pub fn set(self) -> Set {
        self.0
    }

    /// Does work with these instructions.
    pub fn run<W: Work>(self, work: W) -> W::Outcome {
        #[cfg(target_arch = "x86_64")]
        #[expect(unsafe_code, reason = "`Instructions` exist only where the processor has them")]
        match self.0 {
            Set::Baseline => {}
            // SAFETY: the processor has these instructions, or there were no such `Instructions`.
            Set::Avx2 => return unsafe { avx2(work) },
            // SAFETY: the processor has these instructions, or there were no such `Instructions`.
            Set::Avx512 => return unsafe { avx512(work) },
        }
        work.run()
    }
}

/// Work that is compiled for every instruction set.
pub trait Work {
    /// The result.
    type Outcome;
    /// Does the work. To be inlined, or it is compiled for the baseline alone.
    fn run(self) -> Self::Outcome;
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<W: Work>(work: W) -> W::Outcome {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl")]
fn avx512<W: Work>(work: W) -> W::Outcome {
    work.run()
}

#[cfg(test)]
mod laws {
    use super::*;

    #[test]
    fn sets_are_found_by_their_names() {
        for set in Instructions::available() {
            assert_eq!(Instructions::named(set.name()), Some(set));
        }
        assert_eq!(Instructions::named("none"), None);
    }
}
