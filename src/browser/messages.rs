//! Messages for the visitor: seen until dismissed, and the live region for those who hear the page.

use super::dom::{Listener, document, find, on, set_flag, set_text};
use crate::surface::holds;
use web_sys::{Element, Event, HtmlElement};

pub struct Messages {
    region: HtmlElement,
    list: Element,
    live: Element,
    _dismiss: Listener,
}

impl Messages {
    pub fn new() -> Messages {
        let (region, list): (HtmlElement, Element) = (find("messages"), find("message-list"));
        let (hidden, cleared) = (region.clone(), list.clone());
        let dismiss = on(&find::<Element>("dismiss"), "click", move |_: Event| {
            cleared.set_text_content(None);
            set_flag(&hidden, "hidden", true);
        });
        Messages { region, list, live: find("live"), _dismiss: dismiss }
    }

    /// Shows these messages in the place of older ones, but for those that last.
    pub fn tell(&self, texts: &[String]) {
        while let Ok(Some(item)) = self.list.query_selector("li:not([data-lasts])") {
            item.remove();
        }
        for text in texts {
            self.add(text, false);
        }
        set_flag(&self.region, "hidden", self.list.child_element_count() == 0);
    }

    /// Shows one message more, until others come.
    pub fn also(&self, text: &str) {
        self.add(text, false);
        set_flag(&self.region, "hidden", false);
    }

    /// Shows one message more, until it is dismissed.
    pub fn keep(&self, text: &str) {
        self.add(text, true);
        set_flag(&self.region, "hidden", false);
    }

    fn add(&self, text: &str, lasts: bool) {
        // With what was said in another language.
        if holds(&self.list.inner_html(), text) {
            return;
        }
        if let Ok(item) = document().create_element("li") {
            item.set_text_content(Some(text));
            set_flag(&item, "data-lasts", lasts);
            let _ = self.list.append_child(&item);
        }
    }

    /// Says it in the live region.
    pub fn say(&self, text: &str) {
        set_text(&self.live, text);
    }
}
