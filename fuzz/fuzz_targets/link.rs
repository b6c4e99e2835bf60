//! Any text is a link, and the scene that was read is the one that is written.
#![no_main]

use clonal_mosaic::play::link;
use clonal_mosaic::plants;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let opened = link::read(text, plants::all());
    let told = opened.left_out.join("");
    assert!(told.len() < 20_000 && !told.contains(char::is_control), "{told}");
    let again = link::read(&link::write(&opened.scene), plants::all());
    assert_eq!(again.left_out, [""; 0]);
    assert_eq!(again.scene.recipe, opened.scene.recipe);
});
