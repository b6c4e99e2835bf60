//! Memory that runs out ends the program as wrong input does: with one line and status 2.

use super::REFUSED;
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::process;

#[global_allocator]
static MEMORY: OrRefused = OrRefused;

/// The system's memory, or the end.
struct OrRefused;

// SAFETY: every call is the system allocator's; what it returns is handed on unless it is null.
unsafe impl GlobalAlloc for OrRefused {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        or_end(unsafe { System.alloc(layout) })
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        or_end(unsafe { System.alloc_zeroed(layout) })
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        or_end(unsafe { System.realloc(old, layout, size) })
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        unsafe { System.dealloc(old, layout) }
    }
}

#[inline]
fn or_end(memory: *mut u8) -> *mut u8 {
    if memory.is_null() { end() } else { memory }
}

/// Nothing here may ask for memory. The standard error has no buffer.
#[cold]
fn end() -> ! {
    let _ = io::stderr().write_all(b"mosaic: there is not enough memory for this\n");
    process::exit(i32::from(REFUSED))
}
