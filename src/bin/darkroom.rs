//! The studio's darkroom: a worker that draws films and large pictures, with WebGL2.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_darkroom();
}
