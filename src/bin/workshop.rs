//! The studio's workshop: a worker that grows plants and writes and reads files for it.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_workshop();
}
