//! The mail between the page and its worker, and files that are read.

use super::backend::IS_WEBGL_BUNDLE;
use super::dom::{self, Listener, on};
use super::files;
use crate::play::protocol::{BUILD, ToPage, ToWorker};
use js_sys::Uint32Array;
use wasm_bindgen::JsCast;
use web_sys::{ErrorEvent, MessageEvent, Worker};

/// Remembers, for this tab, that the page was loaded again because of a worker of another build.
const RELOADED: &str = "mosaic-reloaded-for";

/// A running worker; it ends when this is dropped.
pub struct Mail {
    worker: Worker,
    _listeners: [Listener; 2],
}

impl Mail {
    /// Starts a worker: the bundle of this page once more, which the browser has at hand. `hear`
    /// takes what it says, or why it has stopped.
    pub fn start(hear: impl Fn(Result<ToPage, String>) + Clone + 'static) -> Result<Mail, String> {
        let bundle = if IS_WEBGL_BUNDLE { "page_gl" } else { "page" };
        let worker = files::start_worker(bundle)
            .ok_or_else(|| "This browser starts no worker: the plant cannot grow.".to_string())?;
        let hear_end = hear.clone();
        let listeners = [
            on(&worker, "message", move |message: MessageEvent| {
                let words = message.data().dyn_into::<Uint32Array>().map(|w| w.to_vec());
                if let Some(answer) = words.ok().and_then(|w| ToPage::from_words(&w).ok()) {
                    hear(Ok(answer));
                }
            }),
            on(&worker, "error", move |error: ErrorEvent| {
                let why = error.message();
                hear_end(Err(format!(
                    "The worker that grows the plant has stopped ({why}). Please load the page again."
                )));
            }),
        ];
        Ok(Mail { worker, _listeners: listeners })
    }

    pub fn post(&self, wish: &ToWorker) {
        // Words can always be sent.
        let _ = self.worker.post_message(&Uint32Array::from(wish.to_words().as_slice()));
    }
}

impl Drop for Mail {
    fn drop(&mut self) {
        self.worker.terminate();
    }
}

/// Loads the page again because page and worker are of different builds; false if that was tried
/// already.
pub fn reload_once() -> bool {
    let Ok(Some(storage)) = dom::window().session_storage() else { return false };
    if storage.get_item(RELOADED).ok().flatten().as_deref() == Some(BUILD) {
        return false;
    }
    storage.set_item(RELOADED, BUILD).is_ok() && dom::window().location().reload().is_ok()
}
