//! Messages for the visitor: seen until dismissed, and the live region for those who hear the page.

use super::dom::{Listener, document, find, on, set_flag, set_text};
use web_sys::{Element, Event, HtmlElement};

pub struct Messages {
    region: HtmlElement,
    list: Element,
    live: Element,
    _dismiss: Listener,
}

impl Messages {
    pub fn new() -> Messages {
        let region: HtmlElement = find("messages");
        let hidden = region.clone();
        let dismiss = on(&find::<Element>("dismiss"), "click", move |_: Event| {
            set_flag(&hidden, "hidden", true);
        });
        Messages { region, list: find("message-list"), live: find("live"), _dismiss: dismiss }
    }

    /// Shows these messages in the place of older ones; none at all clears the region.
    pub fn tell(&self, texts: &[String]) {
        self.list.set_text_content(None);
        for text in texts {
            self.add(text);
        }
        set_flag(&self.region, "hidden", texts.is_empty());
    }

    /// Shows one message more.
    pub fn add(&self, text: &str) {
        if let Ok(item) = document().create_element("li") {
            item.set_text_content(Some(text));
            let _ = self.list.append_child(&item);
            set_flag(&self.region, "hidden", false);
        }
    }

    /// Says it in the live region.
    pub fn say(&self, text: &str) {
        set_text(&self.live, text);
    }
}
