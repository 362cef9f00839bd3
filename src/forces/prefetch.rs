//! Prefetches memory ahead of its use.

/// Begins to load what the reference points to into the cache, where the processor has an instruction for it. Changes no result.
#[inline(always)]
#[cfg_attr(
    not(target_arch = "x86_64"),
    expect(unused_variables, reason = "there is no such instruction in stable Rust")
)]
pub fn prefetch<T>(ahead: &T) {
    #[cfg(target_arch = "x86_64")]
    for line in (0..size_of::<T>()).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        #[expect(unsafe_code, reason = "a prefetch reads nothing that the program sees")]
        // SAFETY: the instruction never faults, whatever the address.
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(ahead).cast::<i8>().wrapping_add(line));
        }
    }
}
