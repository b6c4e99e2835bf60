//! The first code of the page, and small: finds out what there is to draw with, and loads the one
//! bundle for that.

use super::address::mark_ui;
use super::dom::{document, find, set_attribute, set_flag, window};
use super::files::{self, in_bundles, is_held};
use crate::plants::OWN;
use js_sys::Promise;
use wasm_bindgen::prelude::*;
use web_sys::{Element, HtmlCanvasElement, HtmlScriptElement};

/// Loads the bundle for WebGL2 where there is nothing better, else the small one for WebGPU: that
/// one can show the still picture just as well.
///
/// What there is to draw with takes longest to find out, so it is asked first, while the rest of the
/// page is still being read. Nothing here is a future: what runs those is a kilobyte.
pub fn boot() {
    mark_ui();
    let adapter = ask_for_adapter();
    let begin = move || {
        // What is told where nothing of this runs.
        find::<Element>("stuck").remove();
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

fn choose(has_webgpu: bool) {
    load(if !has_webgpu && has_webgl2() { "page_gl" } else { "page" }, tell_failure);
}

/// A bundle may fail after its script came: its WebAssembly is refused, or too new for the browser.
fn tell_failed_bundles() {
    let hear = Closure::<dyn FnMut()>::new(|| {
        if root().get_attribute("data-state").as_deref() == Some("loading") {
            tell_failure();
        }
    });
    let hear = hear.into_js_value();
    let _ = window().add_event_listener_with_callback("unhandledrejection", hear.unchecked_ref());
}

/// Says that nothing runs until the next bundle does.
#[cfg(feature = "draw")]
pub fn begin_again() {
    set_attribute(&root(), "data-state", "loading");
}

fn tell_failure() {
    let text = "The playground could not be loaded. Please load the page again, or try it with a \
                newer browser.";
    find::<Element>("message-list").set_text_content(Some(text));
    set_flag(&find::<Element>("messages"), "hidden", false);
    set_attribute(&root(), "data-state", "error");
}

/// Shows the still picture of the linked plant: it is there long before the bundle that knows the
/// plants, which mends what was not understood here.
fn show_poster() {
    let fragment = window().location().hash().unwrap_or_default();
    let name = fragment.trim_start_matches('#').split('?').next().unwrap_or_default();
    let is_name = !matches!(name, "" | "figures")
        && !name.starts_with(OWN)
        && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
    let plant = if is_name { name } else { "croton" };
    let address = files::address(&format!("posters/{plant}.avif"));
    set_attribute(&find::<Element>("poster"), "src", address);
}

/// Loads a bundle and starts its page.
pub fn load(bundle: &str, on_failure: impl FnOnce() + 'static) {
    let address = in_bundles(&format!("{bundle}.js"));
    if !is_held(&address) {
        // The script would ask for it only when it is there itself.
        preload_wasm(&in_bundles(&format!("{bundle}_bg.wasm")));
    }
    let script = document().create_element("script").expect("documents make scripts");
    let script: HtmlScriptElement = script.unchecked_into();
    script.set_type("module");
    script.set_src(&address);
    script.set_onerror(Some(Closure::once_into_js(on_failure).unchecked_ref()));
    append_to_head(&script);
}

fn preload_wasm(address: &str) {
    let link = document().create_element("link").expect("documents make links");
    set_attribute(&link, "rel", "preload");
    set_attribute(&link, "as", "fetch");
    set_attribute(&link, "crossorigin", "anonymous");
    set_attribute(&link, "href", address);
    append_to_head(&link);
}

fn root() -> Element {
    document().document_element().expect("a document has a root")
}

fn append_to_head(element: &Element) {
    let _ = document().head().expect("a page has a head").append_child(element);
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
