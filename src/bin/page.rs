//! The page, drawn with WebGPU, and its worker.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start();
}
