//! The workshop, or the darkroom, at its one piece of work; dropping it ends it.

use crate::browser::dom::{Listener, on};
use crate::browser::files;
use js_sys::Array;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{ErrorEvent, MessageEvent, Worker};

pub struct Work {
    worker: Worker,
    _listeners: [Listener; 2],
}

/// What a worker says.
pub enum Said {
    /// So many days have grown, or steps are done.
    Day(u32),
    /// In plain words, why it cannot be.
    Refused(String),
    /// What was wanted, or a part of it: see `wish`.
    Done(Array),
}

impl Work {
    /// Starts the workshop and tells it its wish: see `wish`.
    pub fn start(
        wish: [&str; 3],
        more: impl Into<JsValue>,
        hear: impl Fn(Said) + Clone + 'static,
    ) -> Result<Work, String> {
        Work::start_in("workshop", wish, more, hear)
    }

    /// The same in a bundle of another name.
    pub fn start_in(
        bundle: &str,
        wish: [&str; 3],
        more: impl Into<JsValue>,
        hear: impl Fn(Said) + Clone + 'static,
    ) -> Result<Work, String> {
        let worker = files::start_worker(bundle).ok_or_else(|| {
            "This browser starts no worker, so nothing can be made here.".to_string()
        })?;
        let wish = said(wish, more);
        let (listens, hear_end) = (worker.clone(), hear.clone());
        let listeners = [
            on(&worker, "message", move |message: MessageEvent| {
                let said = message.data();
                if said.is_null() {
                    // It listens now; words can always be sent.
                    let _ = listens.post_message(&wish);
                } else if let Some(day) = said.as_f64() {
                    hear(Said::Day(day as u32));
                } else if let Some(why) = said.as_string() {
                    hear(Said::Refused(why));
                } else {
                    hear(Said::Done(said.unchecked_into()));
                }
            }),
            on(&worker, "error", move |_: ErrorEvent| {
                let why = "It ended before it was done, most likely for want of memory.";
                hear_end(Said::Refused(why.to_string()));
            }),
        ];
        Ok(Work { worker, _listeners: listeners })
    }

    /// Tells a workshop that has answered another wish: it stays, and so answers at once.
    pub fn wish(&self, wish: [&str; 3], more: impl Into<JsValue>) {
        // Words and numbers can always be sent.
        let _ = self.worker.post_message(&said(wish, more));
    }
}

fn said([word, link, mesh]: [&str; 3], more: impl Into<JsValue>) -> Array {
    Array::of4(&word.into(), &link.into(), &mesh.into(), &more.into())
}

impl Drop for Work {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

/// Tells why something cannot be by a sentence with `why` in it, but for a `why` that is a sentence itself.
pub fn refusal(why: &str, sentence: String) -> String {
    if why.ends_with('.') { why.to_string() } else { sentence }
}
