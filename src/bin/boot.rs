//! Chooses the bundle that this browser can draw with.

#[cfg(target_arch = "wasm32")]
use lol_alloc::{AssumeSingleThreaded, LeakingAllocator};

// It asks for a few strings and ends: nothing is worth being given back, and what could is a quarter of the bundle.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: AssumeSingleThreaded<LeakingAllocator> =
    // A page has one thread, and workers have memories of their own.
    unsafe { AssumeSingleThreaded::new(LeakingAllocator::new()) };

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_boot();
}
