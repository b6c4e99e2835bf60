//! The service worker: keeps the page for when there is no network.

/// Called by the line that the build appends: the name of the build, and the names of its files with
/// spaces between.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen::prelude::wasm_bindgen]
pub fn keep(build: &str, files: &str) {
    clonal_mosaic::browser::start_service_worker(build, files);
}

fn main() {}
