//! What the visitor asked of the browser: dark or light, less motion.

use super::app;
use super::dom::{Listener, document, find, on, set_attribute, window};
use crate::play::page::Event;
use web_sys::{HtmlElement, MediaQueryList};

/// Where a choice of dark or light is kept.
const STORED: &str = "mosaic-theme";
const PREFERS_DARK: &str = "(prefers-color-scheme: dark)";

pub struct Surroundings {
    less_motion: Option<MediaQueryList>,
    _listeners: Vec<Listener>,
}

impl Surroundings {
    pub fn new() -> Surroundings {
        let less_motion = query("(prefers-reduced-motion: reduce)");
        let button: HtmlElement = find("theme");
        if let Some(theme) = stored() {
            set_attribute(&root(), "data-theme", theme);
        }
        let mut listeners = vec![on(&button, "click", |_: web_sys::Event| {
            let theme = if is_dark() { "light" } else { "dark" };
            set_attribute(&root(), "data-theme", theme);
            if let Ok(Some(storage)) = window().local_storage() {
                // A full or forbidden storage forgets the choice, no more.
                let _ = storage.set_item(STORED, theme);
            }
            app::repaint();
        })];
        if let Some(query) = &query(PREFERS_DARK) {
            listeners.push(on(query, "change", |_: web_sys::Event| app::repaint()));
        }
        if let Some(query) = &less_motion {
            let asked = query.clone();
            listeners.push(on(query, "change", move |_: web_sys::Event| {
                app::send(Event::LessMotion(asked.matches()));
            }));
        }
        Surroundings { less_motion, _listeners: listeners }
    }

    pub fn less_motion(&self) -> bool {
        self.less_motion.as_ref().is_some_and(MediaQueryList::matches)
    }
}

/// Whether the page is dark: by the visitor's choice here, or else by the system's.
pub fn is_dark() -> bool {
    match root().get_attribute("data-theme") {
        Some(theme) => theme == "dark",
        None => query(PREFERS_DARK).is_some_and(|q| q.matches()),
    }
}

fn query(text: &str) -> Option<MediaQueryList> {
    window().match_media(text).ok().flatten()
}

fn stored() -> Option<String> {
    let storage = window().local_storage().ok().flatten()?;
    storage.get_item(STORED).ok().flatten().filter(|t| t == "dark" || t == "light")
}

fn root() -> web_sys::Element {
    document().document_element().expect("a document has a root")
}
