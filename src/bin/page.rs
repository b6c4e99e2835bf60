//! The page, drawn with WebGPU.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_page();
}
