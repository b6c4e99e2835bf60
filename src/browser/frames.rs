//! Frames, asked for only when something changed.

use super::{app, dom};
use wasm_bindgen::prelude::*;

/// Seconds that the first frame after a rest counts.
const FIRST_S: f64 = 1.0 / 60.0;

/// Asks the browser for frames.
pub struct Frames {
    callback: Closure<dyn FnMut(f64)>,
    asked: Option<i32>,
    /// Nobody sees the page: whether a frame waits for somebody who does.
    held: Option<bool>,
    last_ms: Option<f64>,
}

impl Frames {
    pub fn new() -> Frames {
        Frames { callback: Closure::new(app::frame), asked: None, held: None, last_ms: None }
    }

    /// Asks for the next frame, once.
    pub fn ask(&mut self) {
        if let Some(waits) = &mut self.held {
            *waits = true;
        } else if self.asked.is_none() {
            let callback = self.callback.as_ref().unchecked_ref();
            self.asked = dom::window().request_animation_frame(callback).ok();
        }
    }

    /// Asks for none until somebody sees the page again.
    pub fn hold(&mut self, holds: bool) {
        match self.held.take() {
            before if holds => self.held = Some(before.unwrap_or(self.asked.is_some())),
            Some(true) => self.ask(),
            _ => {}
        }
    }

    /// A frame begins; seconds since the last one, or of a usual frame after a rest.
    pub fn begin(&mut self, now_ms: f64) -> f64 {
        self.asked = None;
        let seconds = self.last_ms.map_or(FIRST_S, |last| (now_ms - last) / 1000.0);
        self.last_ms = Some(now_ms);
        seconds.max(0.0)
    }

    /// Nothing moves any more.
    pub fn rest(&mut self) {
        self.last_ms = None;
    }
}

impl Drop for Frames {
    fn drop(&mut self) {
        if let Some(asked) = self.asked {
            let _ = dom::window().cancel_animation_frame(asked);
        }
    }
}
