//! The studio, which the page loads when something of it is first wanted.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_studio();
}
