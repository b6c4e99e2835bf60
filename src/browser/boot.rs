//! The first code of the page, and small: finds out what there is to draw with, and loads the one
//! bundle for that.

use super::dom::{document, find, set_attribute, set_flag, window};
use js_sys::Promise;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Element, HtmlCanvasElement, HtmlScriptElement};

/// Loads the bundle for WebGL2 where there is nothing better, else the small one for WebGPU: that
/// one can show the still picture just as well.
///
/// What there is to draw with takes longest to find out, so it is asked first, while the rest of the
/// page is still being read.
pub async fn boot() {
    let adapter = ask_for_adapter();
    page_is_read().await;
    show_poster();
    let bundle = if !is_there(adapter).await && has_webgl2() { "page_gl" } else { "page" };
    load(bundle, || {
        let text = "The playground could not be loaded. Please load the page again.";
        find::<Element>("message-list").set_text_content(Some(text));
        set_flag(&find::<Element>("messages"), "hidden", false);
        if let Some(root) = document().document_element() {
            set_attribute(&root, "data-state", "error");
        }
    });
}

/// Shows the still picture of the linked plant: it is there long before the bundle that knows the
/// plants, which mends what was not understood here.
fn show_poster() {
    let fragment = window().location().hash().unwrap_or_default();
    let name = fragment.trim_start_matches('#').split('?').next().unwrap_or_default();
    let is_name = !matches!(name, "" | "figures")
        && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
    let plant = if is_name { name } else { "croton" };
    set_attribute(&find::<Element>("poster"), "src", format!("posters/{plant}.avif"));
}

/// Loads a bundle and starts its page.
pub fn load(bundle: &str, on_failure: impl FnOnce() + 'static) {
    // The loader would ask for these one after the other.
    preload(&in_bundles(&format!("{bundle}.js")), "modulepreload", "script");
    preload(&in_bundles(&format!("{bundle}_bg.wasm")), "preload", "fetch");
    let script = document().create_element("script").expect("documents make scripts");
    let script: HtmlScriptElement = script.unchecked_into();
    script.set_type("module");
    script.set_src(&loader(bundle));
    script.set_onerror(Some(Closure::once_into_js(on_failure).unchecked_ref()));
    append_to_head(&script);
}

/// The address of the script that starts a bundle.
pub fn loader(bundle: &str) -> String {
    in_bundles(&format!("{bundle}_loader.js"))
}

/// The address of a file in the folder of bundles, whose name tells builds apart.
fn in_bundles(file: &str) -> String {
    let root = document().document_element();
    let folder = root.and_then(|root| root.get_attribute("data-bundles"));
    format!("./{}/{file}", folder.as_deref().unwrap_or("."))
}

fn preload(address: &str, how: &str, kind: &str) {
    let link = document().create_element("link").expect("documents make links");
    set_attribute(&link, "rel", how);
    set_attribute(&link, "as", kind);
    set_attribute(&link, "crossorigin", "anonymous");
    set_attribute(&link, "href", address);
    append_to_head(&link);
}

fn append_to_head(element: &Element) {
    let _ = document().head().expect("a page has a head").append_child(element);
}

/// Until the whole of the HTML stands in the document.
async fn page_is_read() {
    if document().ready_state() == "loading" {
        let read = Promise::new(&mut |resolve, _| {
            let _ = document().add_event_listener_with_callback("DOMContentLoaded", &resolve);
        });
        let _ = JsFuture::from(read).await;
    }
}

/// Asks the browser, if it has WebGPU, for something to run it on.
fn ask_for_adapter() -> Option<Promise> {
    let gpu = js_sys::Reflect::get(&window().navigator(), &"gpu".into()).ok()?;
    let ask = js_sys::Reflect::get(&gpu, &"requestAdapter".into()).ok()?;
    let asked = ask.dyn_ref::<js_sys::Function>()?.call0(&gpu).ok()?;
    asked.dyn_into().ok()
}

async fn is_there(adapter: Option<Promise>) -> bool {
    match adapter {
        Some(adapter) => JsFuture::from(adapter).await.is_ok_and(|adapter| adapter.is_truthy()),
        None => false,
    }
}

pub fn has_webgl2() -> bool {
    let canvas = document().create_element("canvas").ok();
    let canvas = canvas.and_then(|c| c.dyn_into::<HtmlCanvasElement>().ok());
    canvas.is_some_and(|c| matches!(c.get_context("webgl2"), Ok(Some(_))))
}
