//! The interpreter, which is loaded where another language than English is wished.

fn main() {
    #[cfg(target_arch = "wasm32")]
    clonal_mosaic::browser::start_interpreter();
}
