//! Any text is a recipe or refused on a line, and a recipe that was read comes back.
#![no_main]

use clonal_mosaic::tissue::Recipe;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| match Recipe::from_json(text) {
    Ok(recipe) => assert_eq!(Recipe::from_json(&recipe.to_json()), Ok(recipe)),
    Err(error) => {
        let told = error.to_string();
        assert!(told.len() < 1000 && !told.contains(char::is_control), "{told}");
    }
});
