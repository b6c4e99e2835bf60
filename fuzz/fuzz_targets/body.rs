//! Any bytes are a sound body or an error.
#![no_main]

use clonal_mosaic::surface::Brought;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| match Brought::read(bytes) {
    Ok(brought) => brought.body.surface.check().expect("a sound mesh"),
    Err(error) => assert!(error.to_string().len() < 1000),
});
