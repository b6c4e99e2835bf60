//! The ladder of graphics: WebGPU, then the WebGL2 bundle of this page, then a still picture.

use super::app;
use super::dom::{document, window};
use crate::draw::Renderer;
use crate::play::protocol::BUILD;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::spawn_local;
use web_sys::{HtmlCanvasElement, HtmlScriptElement};

const STILL: &str = "This browser offers neither WebGPU nor WebGL2, so here is a still picture of \
                     the plant. Its cells grow all the same: the numbers are live.";

/// Whether this bundle is the one for WebGL2.
const IS_WEBGL_BUNDLE: bool = cfg!(feature = "webgl");

/// Starts the page of this bundle.
pub fn start_page() {
    console_error_panic_hook::set_once();
    app::start();
    if let Some(canvas) = app::canvas() {
        spawn_local(start_renderer(canvas));
    }
}

/// Starts the graphics on a canvas, or goes one step down the ladder.
pub async fn start_renderer(canvas: HtmlCanvasElement) {
    match Renderer::new(canvas, Box::new(trouble)).await {
        Ok(renderer) => app::run(renderer),
        Err(_) if !IS_WEBGL_BUNDLE && has_webgl2() => start_webgl_bundle(),
        Err(_) => app::stay_still(STILL),
    }
}

fn trouble(what: String) {
    web_sys::console::warn_1(&what.into());
    app::lost();
}

fn has_webgl2() -> bool {
    let canvas = document().create_element("canvas").ok();
    let canvas = canvas.and_then(|c| c.dyn_into::<HtmlCanvasElement>().ok());
    canvas.is_some_and(|c| matches!(c.get_context("webgl2"), Ok(Some(_))))
}

/// Hands the page over to its WebGL2 bundle. That is several times as large, and so it is loaded only
/// here.
fn start_webgl_bundle() {
    let script = document().create_element("script").ok();
    let Some(script) = script.and_then(|s| s.dyn_into::<HtmlScriptElement>().ok()) else {
        return app::stay_still(STILL);
    };
    script.set_type("module");
    script.set_src(&format!("./page_gl_loader.js?build={BUILD}"));
    let failed = Closure::once_into_js(|| {
        app::start();
        app::stay_still("The part of this page that draws with WebGL2 could not be loaded.");
    });
    script.set_onerror(Some(failed.unchecked_ref()));
    // A canvas that was asked for WebGPU never gives WebGL2.
    app::renew_canvas();
    app::end();
    if let Some(head) = window().document().and_then(|d| d.head()) {
        let _ = head.append_child(&script);
    }
}
