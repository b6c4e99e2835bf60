//! The page, drawn with WebGL2: a bundle of its own, loaded only where there is no WebGPU.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_page();
}
