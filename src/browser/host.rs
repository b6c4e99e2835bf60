//! The page in a frame of another page: what it tells that page and hears of it, and that it rests while nobody sees
//! it. See `docs/embedding.md`.

use super::app;
use super::dom::{Listener, document, member, on, set_flag, window};
use crate::play::page::Event;
use js_sys::{Array, JSON};
use wasm_bindgen::prelude::*;
use web_sys::{Element, IntersectionObserver, IntersectionObserverEntry, MessageEvent, Window};

/// The version of the messages, in both directions.
const VERSION: u32 = 1;

pub struct Host {
    page: Window,
    /// What was told last.
    told: String,
    sight: Option<IntersectionObserver>,
    _seen: Closure<dyn FnMut(Array)>,
    _listener: Listener,
}

impl Host {
    /// The page around this one, if there is one.
    pub fn find(stage: &Element) -> Option<Host> {
        let own = window();
        let page = own.parent().ok().flatten().filter(|parent| *parent != own)?;
        set_flag(&document().document_element()?, "data-framed", true);
        let parent = page.clone();
        let listener = on(&own, "message", move |message: MessageEvent| {
            if message.source().is_some_and(|source| source == *parent.unchecked_ref()) {
                hear(&message.data());
            }
        });
        let seen = Closure::<dyn FnMut(Array)>::new(|entries: Array| {
            let newest: IntersectionObserverEntry = entries.pop().unchecked_into();
            app::seen(newest.is_intersecting());
        });
        let sight = IntersectionObserver::new(seen.as_ref().unchecked_ref()).ok();
        if let Some(sight) = &sight {
            sight.observe(stage);
        }
        Some(Host { page, told: String::new(), sight, _seen: seen, _listener: listener })
    }

    /// Tells it what the page shows, by the members of a JSON object, unless that was told last.
    pub fn tell(&mut self, members: String) {
        if self.told == members {
            return;
        }
        if let Ok(message) = JSON::parse(&format!("{{\"mosaic\":{VERSION},{members}}}")) {
            // It is no secret: whoever frames the page may know what it shows.
            let _ = self.page.post_message(&message, "*");
        }
        self.told = members;
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        if let Some(sight) = &self.sight {
            sight.disconnect();
        }
    }
}

/// Does what the page around wishes: `{mosaic: 1, link: "croton?v=1&d=9"}` or `{mosaic: 1, day: 9}`.
fn hear(said: &JsValue) {
    let member = |name: &str| member(said, name);
    if member("mosaic").as_f64() != Some(f64::from(VERSION)) {
        return;
    }
    if let Some(link) = member("link").as_string() {
        app::open_link(&link);
    }
    if let Some(day) = member("day").as_f64() {
        app::send(Event::Day(day));
    }
}
