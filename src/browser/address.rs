//! The address of the page, whose fragment is the link of what is shown, and behind a `~` what the studio does
//! with it: `croton?v=1&d=20~lesson/chance/2`.

use super::dom::{document, set_attribute, window};
#[cfg(feature = "draw")]
use wasm_bindgen::JsValue;

/// What stands before how much of the page is to be there.
pub const UI: &str = "~ui=";

/// The whole address with another fragment. Links within the page have such ones: one that begins with `#` is
/// taken for a way to an element by programs that check pages.
#[cfg(feature = "draw")]
pub fn with_fragment(fragment: &str) -> String {
    let href = window().location().href().unwrap_or_default();
    format!("{}#{fragment}", href.split('#').next().unwrap_or_default())
}

/// The fragment with its `#`, up to what is the studio's; empty without one.
pub fn fragment() -> String {
    let mut hash = hash();
    hash.truncate(hash.len() - beside(&hash).len());
    hash
}

/// What is the studio's, with its `~`; empty without it.
pub fn wanted() -> String {
    beside(&hash()).to_string()
}

/// Marks how much of the page there is, by `~ui=play` or `~ui=none` at the end of its address; without it, all.
/// The boot bundle does that, too: to search the address would be more bytes than the rest of this.
pub fn mark_ui() {
    let hash = hash();
    let ui = match () {
        () if hash.ends_with("~ui=play") => "play",
        () if hash.ends_with("~ui=none") => "none",
        () => "full",
    };
    if let Some(root) = document().document_element() {
        set_attribute(&root, "data-ui", ui);
    }
}

fn hash() -> String {
    window().location().hash().unwrap_or_default()
}

fn beside(hash: &str) -> &str {
    hash.find('~').and_then(|at| hash.get(at..)).unwrap_or_default()
}

/// Makes a link the fragment, in the place of the one that is there; what is the studio's stays.
#[cfg(feature = "draw")]
pub fn write_link(link: &str) {
    if let Ok(history) = window().history() {
        // Fails only where a browser allows no more writing for a while; the next one will do.
        let address = format!("#{link}{}", wanted());
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

/// Makes a link the fragment; the browser's way back leads to the one that is there.
#[cfg(feature = "draw")]
pub fn push_link(link: &str) {
    if let Ok(history) = window().history() {
        let address = format!("#{link}{}", wanted());
        let _ = history.push_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}
