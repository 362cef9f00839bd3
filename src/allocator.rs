//! An allocator for large systems.
//!
//! A program declares it:
//!
//! ```
//! #[global_allocator]
//! static ALLOCATOR: veridem::allocator::LargePages = veridem::allocator::LargePages;
//! ```

use std::alloc::{GlobalAlloc, Layout, System};

/// The allocator of the operating system, which is asked to put large arrays into large pages where it does so on request (Linux): the processor remembers
/// the addresses of few pages, and in each step the pair loop reads and writes arrays of hundreds of megabytes where there are a million spheres.
#[derive(Clone, Copy, Debug, Default)]
pub struct LargePages;

/// Size of a large page on most processors, bytes. Smaller arrays stay as they are.
const LARGE: usize = 2 << 20;

#[expect(unsafe_code, reason = "an allocator hands out memory")]
// SAFETY: memory comes from the system's allocator and goes back to it; the request changes neither its place nor its contents.
unsafe impl GlobalAlloc for LargePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise is what the system's allocator asks for.
        in_large_pages(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        in_large_pages(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above; what this allocator handed out is the system's.
        in_large_pages(unsafe { System.realloc(place, layout, size) }, size)
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(place, layout) }
    }
}

#[cfg(not(target_os = "linux"))]
fn in_large_pages(place: *mut u8, _size: usize) -> *mut u8 {
    place
}

/// Requests large pages for an array before it is written to. A refusal costs speed and nothing else.
#[cfg(target_os = "linux")]
fn in_large_pages(place: *mut u8, size: usize) -> *mut u8 {
    use rustix::mm::{Advice, madvise};
    /// Pages are at most as large as this: 4 to 64 KiB.
    const PAGE: usize = 64 << 10;
    if size >= LARGE && !place.is_null() {
        let before = place.addr().next_multiple_of(PAGE) - place.addr();
        #[expect(unsafe_code, reason = "the kernel is told a place in memory")]
        // SAFETY: the range is within the array, and the advice changes no contents.
        let _ = unsafe { madvise(place.wrapping_add(before).cast(), size - before, Advice::LinuxHugepage) };
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(unsafe_code, reason = "an allocator is called")]
    fn arrays_keep_their_contents_when_they_grow_and_begin_with_zeros_on_request() {
        let layout = |size| Layout::from_size_align(size, 64).expect("a size");
        for size in [100, LARGE - 1, LARGE, 3 * LARGE + 5] {
            // SAFETY: what is written and read is within the arrays, which are freed with the layout that they have.
            unsafe {
                let zeros = LargePages.alloc_zeroed(layout(size));
                assert!((0..size).all(|k| zeros.add(k).read() == 0) && zeros.addr().is_multiple_of(64));
                zeros.add(size - 1).write(7);
                let grown = LargePages.realloc(zeros, layout(size), 4 * size);
                grown.add(4 * size - 1).write(8);
                assert_eq!((grown.read(), grown.add(size - 1).read(), grown.add(4 * size - 1).read()), (0, 7, 8));
                LargePages.dealloc(grown, layout(4 * size));
                let new = LargePages.alloc(layout(size));
                new.add(size - 1).write(9);
                assert_eq!(new.add(size - 1).read(), 9);
                LargePages.dealloc(new, layout(size));
            }
        }
    }
}
