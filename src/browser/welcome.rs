//! The first visit: who has never been here sees the plant grow once, with a sentence, until any input ends that.

use super::app;
use super::dom::{Listener, find, on_first, set_flag, window};
use crate::play::page::Event;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent};

/// Where it is kept that somebody has been here.
const STORED: &str = "mosaic-been";

pub struct Welcome {
    sentence: HtmlElement,
    _listeners: [Listener; 3],
}

/// Whether nobody has been here with this browser, as far as it tells. From now on somebody has.
pub fn is_first_visit() -> bool {
    let Ok(Some(storage)) = window().local_storage() else { return true };
    let has_been = matches!(storage.get_item(STORED), Ok(Some(_)));
    // A full storage forgets it, no more.
    let _ = storage.set_item(STORED, "1");
    !has_been
}

impl Welcome {
    pub fn new() -> Welcome {
        let sentence: HtmlElement = find("welcome");
        let listeners = ["pointerdown", "keydown", "wheel"].map(|kind| {
            let sentence = sentence.clone();
            on_first(&window(), kind, move |event: web_sys::Event| {
                if !sentence.hidden() {
                    end(&sentence, &event);
                }
            })
        });
        Welcome { sentence, _listeners: listeners }
    }

    pub fn show(&self) {
        set_flag(&self.sentence, "hidden", false);
    }
}

fn end(sentence: &Element, event: &web_sys::Event) {
    set_flag(sentence, "hidden", true);
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let on_play = target.is_some_and(|target| matches!(target.closest("#play"), Ok(Some(_))));
    let by_key = event.dyn_ref::<KeyboardEvent>().is_some_and(|event| event.key() == " ");
    // The button and the key that pause do so themselves.
    if !on_play && !by_key {
        app::send(Event::EndPremiere);
    }
}
