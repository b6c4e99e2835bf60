//! The address of the page, whose fragment is the link of what is shown.

use super::dom::window;
use wasm_bindgen::JsValue;

/// The whole address with another fragment. Links within the page have such ones: one that begins with `#` is
/// taken for a way to an element by programs that check pages.
pub fn with_fragment(fragment: &str) -> String {
    let href = window().location().href().unwrap_or_default();
    format!("{}#{fragment}", href.split('#').next().unwrap_or_default())
}

/// The fragment with its `#`; empty without one.
pub fn fragment() -> String {
    window().location().hash().unwrap_or_default()
}

/// Makes a link the fragment, in the place of the one that is there.
pub fn write_link(link: &str) {
    if let Ok(history) = window().history() {
        // Fails only where a browser allows no more writing for a while; the next one will do.
        let address = format!("#{link}");
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

/// Makes a link the fragment; the browser's way back leads to the one that is there.
pub fn push_link(link: &str) {
    if let Ok(history) = window().history() {
        let address = format!("#{link}");
        let _ = history.push_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}
