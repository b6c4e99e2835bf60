//! The ladder of graphics: WebGPU, then WebGL2, then a still picture. Its first step is taken in
//! `boot`.

use super::app;
use super::boot::{self, has_webgl2};
use crate::draw::Renderer;
use wasm_bindgen_futures::spawn_local;
use web_sys::HtmlCanvasElement;

const STILL: &str = "This browser offers neither WebGPU nor WebGL2, so here is a still picture of \
                     the plant: its individual 1, on the day on which the plant is shown first. \
                     The cells of your own choice grow all the same, and their numbers are live.";

/// Told when cells do not fit on the graphics card, and when that is lost again and again.
pub const TOO_LARGE: &str = "This graphics card cannot hold so many cells: a still picture stands in \
                             for them. An earlier day or another plant will be drawn again.";
pub const GIVEN_UP: &str = "The graphics card failed several times: here is a still picture. Load the \
                            page again to try once more.";

/// Whether this bundle is the one for WebGL2.
pub const IS_WEBGL_BUNDLE: bool = cfg!(feature = "webgl");

/// Starts the page of this bundle.
pub fn start_page() {
    app::start();
    if let Some((canvas, number)) = app::canvas() {
        spawn_local(start_renderer(canvas, number));
    }
}

/// Starts the graphics on the canvas of a number, or goes one step down the ladder.
pub async fn start_renderer(canvas: HtmlCanvasElement, number: u32) {
    let started = Renderer::new(canvas, move |what| trouble(number, what)).await;
    if !app::is_current(number) {
        // The canvas was lost meanwhile, and another one is on its way.
        return;
    }
    match started {
        Ok(renderer) => app::run(renderer),
        Err(_) if !IS_WEBGL_BUNDLE && has_webgl2() => start_webgl_bundle(),
        Err(_) => app::stay_still(STILL),
    }
}

fn trouble(number: u32, what: String) {
    web_sys::console::warn_1(&what.into());
    app::lost(number);
}

/// Hands the page over to its WebGL2 bundle: WebGPU was there, but not for this canvas.
fn start_webgl_bundle() {
    // A canvas that was asked for WebGPU never gives WebGL2.
    app::renew_canvas();
    app::end();
    boot::begin_again();
    boot::load("page_gl", || {
        app::start();
        app::stay_still("The part of this page that draws with WebGL2 could not be loaded.");
    });
}
