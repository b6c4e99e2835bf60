//! The first code of the page, and small: finds out what there is to draw with, and loads the one
//! bundle for that.

use super::address::mark_ui;
use super::dom::{document, set_attribute, set_flag, window};
use super::files::{self, in_bundles, is_held};
use crate::plants::OWN;
use js_sys::{JsString, Promise};
use wasm_bindgen::prelude::*;
use web_sys::{Element, HtmlCanvasElement, HtmlScriptElement};

/// Loads the bundle for WebGL2 where there is nothing better, else the small one for WebGPU: that
/// one can show the still picture just as well.
///
/// What there is to draw with takes longest to find out, so it is asked first, while the rest of the
/// page is still being read. Nothing here is a future, writes numbers or says
/// why it panics: what does is a kilobyte each.
pub fn boot() {
    mark_ui();
    let adapter = ask_for_adapter();
    let begin = move || {
        listen_for_languages();
        // What is told where nothing of this runs.
        if let Some(stuck) = element("stuck") {
            stuck.remove();
        }
        show_poster();
        tell_failed_bundles();
        match adapter {
            Some(adapter) => {
                let answered = Closure::once(|adapter: JsValue| choose(adapter.is_truthy()));
                let refused = Closure::once(|_: JsValue| choose(false));
                let _ = adapter.then2(&answered, &refused);
                answered.forget();
                refused.forget();
            }
            None => choose(false),
        }
    };
    if document().ready_state() == "loading" {
        let begin = Closure::once_into_js(begin);
        let _ =
            document().add_event_listener_with_callback("DOMContentLoaded", begin.unchecked_ref());
    } else {
        begin();
    }
}

/// Loads what says the page in another language where one may be wished, be it later.
fn listen_for_languages() {
    let wished = chosen_language().or_else(|| window().navigator().language());
    let address = JsString::from(window().location().href().unwrap_or_default());
    if wished.is_some_and(|wished| !wished.starts_with("en")) || address.includes("lang=", 0) {
        load_interpreter();
    }
    if let Some(choice) = element("language") {
        // The same script once more does nothing.
        let hear = Closure::<dyn FnMut()>::new(load_interpreter).into_js_value();
        let _ = choice.add_event_listener_with_callback("change", hear.unchecked_ref());
    }
}

fn load_interpreter() {
    load("interpreter", || {});
}

/// Where the language that was chosen is kept.
pub const CHOSEN: &str = "language";

/// The language that was chosen the last time.
pub fn chosen_language() -> Option<String> {
    window().local_storage().ok()??.get_item(CHOSEN).ok()?
}

fn choose(has_webgpu: bool) {
    load(if !has_webgpu && has_webgl2() { "page_gl" } else { "page" }, tell_failure);
}

/// A bundle may fail after its script came: its WebAssembly is refused, or too new for the browser.
fn tell_failed_bundles() {
    let hear = Closure::<dyn FnMut()>::new(|| {
        let state = document().document_element().and_then(|root| root.get_attribute("data-state"));
        if state.as_deref() == Some("loading") {
            tell_failure();
        }
    });
    let hear = hear.into_js_value();
    let _ = window().add_event_listener_with_callback("unhandledrejection", hear.unchecked_ref());
}

/// Says that nothing runs until the next bundle does.
#[cfg(feature = "draw")]
pub fn begin_again() {
    mark_state("loading");
}

fn mark_state(state: &str) {
    if let Some(root) = document().document_element() {
        set_attribute(&root, "data-state", state);
    }
}

fn tell_failure() {
    let text = "The playground could not be loaded. Please load the page again, or try it with a \
                newer browser.";
    if let Some((list, around)) = element("message-list").zip(element("messages")) {
        list.set_text_content(Some(text));
        set_flag(&around, "hidden", false);
    }
    mark_state("error");
}

/// Shows the still picture of the linked plant: it is there long before the bundle that knows the
/// plants, which mends what was not understood here.
fn show_poster() {
    let fragment = window().location().hash().unwrap_or_default();
    let name = fragment.strip_prefix('#').unwrap_or_default();
    let name = name.split_once('?').map_or(name, |(name, _)| name);
    let is_name = !matches!(name, "" | "figures")
        && !name.starts_with(OWN)
        && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
    let plant = if is_name { name } else { "croton" };
    if let Some(poster) = element("poster") {
        set_attribute(&poster, "src", files::address(&["posters/", plant, ".avif"].concat()));
    }
}

/// Loads a bundle and starts its page.
pub fn load(bundle: &str, on_failure: impl FnOnce() + 'static) {
    let address = in_bundles(&[bundle, ".js"].concat());
    if !is_held(&address) {
        // The script would ask for it only when it is there itself.
        preload_wasm(&in_bundles(&[bundle, "_bg.wasm"].concat()));
    }
    // Documents make every element.
    let Ok(script) = document().create_element("script") else { return };
    let script: HtmlScriptElement = script.unchecked_into();
    script.set_type("module");
    script.set_src(&address);
    script.set_onerror(Some(Closure::once_into_js(on_failure).unchecked_ref()));
    append_to_head(&script);
}

fn preload_wasm(address: &str) {
    let Ok(link) = document().create_element("link") else { return };
    set_attribute(&link, "rel", "preload");
    set_attribute(&link, "as", "fetch");
    set_attribute(&link, "crossorigin", "anonymous");
    set_attribute(&link, "href", address);
    append_to_head(&link);
}

fn element(id: &str) -> Option<Element> {
    document().get_element_by_id(id)
}

fn append_to_head(element: &Element) {
    if let Some(head) = document().head() {
        let _ = head.append_child(element);
    }
}

/// Asks the browser, if it has WebGPU, for something to run it on.
fn ask_for_adapter() -> Option<Promise> {
    let gpu = js_sys::Reflect::get(&window().navigator(), &"gpu".into()).ok()?;
    let ask = js_sys::Reflect::get(&gpu, &"requestAdapter".into()).ok()?;
    let asked = ask.dyn_ref::<js_sys::Function>()?.call0(&gpu).ok()?;
    asked.dyn_into().ok()
}

pub fn has_webgl2() -> bool {
    let canvas = document().create_element("canvas").ok();
    let canvas = canvas.and_then(|c| c.dyn_into::<HtmlCanvasElement>().ok());
    canvas.is_some_and(|c| matches!(c.get_context("webgl2"), Ok(Some(_))))
}
