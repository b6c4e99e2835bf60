//! The worker, in which plants grow.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_worker();
}
