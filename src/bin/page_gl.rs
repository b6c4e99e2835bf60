//! The page, drawn with WebGL2, and its worker: loaded only where there is no WebGPU.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start();
}
