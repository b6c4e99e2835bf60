//! Memory: what surely needs more than there is does not begin, and if it runs out all the same the program
//! ends as on wrong input, with one line and status 2.

use super::{REFUSED, Refusal};
use clonal_mosaic::tissue::{Recipe, least_memory_bytes};
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::process;

/// Refuses a recipe whose cells alone need more memory than the system has to give, where it says how much
/// that is (Linux).
pub fn check(recipe: &Recipe) -> Result<(), Refusal> {
    let told = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
    let kilobytes = |line: &str| {
        line.strip_prefix("MemAvailable:")?.trim().strip_suffix(" kB")?.parse::<f64>().ok()
    };
    let free_bytes: f64 = match told.lines().find_map(kilobytes) {
        Some(kilobytes) => 1024.0 * kilobytes,
        None => return Ok(()),
    };
    let bytes = least_memory_bytes(recipe);
    if bytes <= free_bytes {
        return Ok(());
    }
    Err(format!(
        "this recipe's cells need at least {:.0} GB of memory, and {:.0} GB are free: fewer days, fewer \
         initial_cells, or a lower max_cells make it smaller",
        bytes / 1e9,
        free_bytes / 1e9
    ))
}

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
