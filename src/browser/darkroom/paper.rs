//! What a picture is laid on: nothing, or the page's stage.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::{ImageData, OffscreenCanvas, OffscreenCanvasRenderingContext2d};

pub struct Paper {
    pub canvas: OffscreenCanvas,
    pub pen: OffscreenCanvasRenderingContext2d,
}

const TOO_LARGE: &str = "This browser holds no picture that large: choose a smaller one.";

impl Paper {
    pub fn new(width_px: u32, height_px: u32, is_read: bool) -> Result<Paper, String> {
        let canvas = OffscreenCanvas::new(width_px, height_px).map_err(|_| TOO_LARGE)?;
        let options = js_sys::Object::new();
        let _ = js_sys::Reflect::set(&options, &"willReadFrequently".into(), &is_read.into());
        let pen = canvas.get_context_with_context_options("2d", &options).ok().flatten();
        let pen = pen.ok_or(TOO_LARGE)?.unchecked_into();
        Ok(Paper { canvas, pen })
    }

    /// Paints a few pixels, stretched over a part of the paper.
    pub fn paint(&self, light: &ImageData, width_px: f64, height_px: f64) -> Result<(), String> {
        let small = Paper::new(light.width(), light.height(), false)?;
        let failed = |_: JsValue| "The stage cannot be painted.".to_string();
        small.pen.put_image_data(light, 0.0, 0.0).map_err(failed)?;
        // Cubic: between straight ramps the eye sees edges.
        let _ = js_sys::Reflect::set(&self.pen, &"imageSmoothingQuality".into(), &"high".into());
        self.pen
            .draw_image_with_offscreen_canvas_and_dw_and_dh(
                &small.canvas,
                0.0,
                0.0,
                width_px,
                height_px,
            )
            .map_err(failed)
    }

    /// Lays what another canvas holds on it, so many pixels from the left top.
    pub fn lay(&self, canvas: &OffscreenCanvas, x_px: f64, y_px: f64) -> Result<(), String> {
        self.pen
            .draw_image_with_offscreen_canvas(canvas, x_px, y_px)
            .map_err(|_| TOO_LARGE.to_string())
    }
}
