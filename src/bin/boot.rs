//! Chooses the bundle that this browser can draw with.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_boot();
}
