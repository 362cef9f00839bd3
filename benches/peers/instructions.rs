//! The vector instructions that a measurement uses.

use veridem::forces::Instructions;

/// Chooses the instructions with this name for the process; without a name it uses the widest of the processor.
pub(crate) fn choose(name: Option<&String>) {
    if let Some(name) = name {
        let set = Instructions::available().into_iter().find(|set| set.name() == name);
        set.expect("instructions that this processor has: baseline, avx2, avx512").choose();
    }
}
