//! The choice of what is seen on the body: the cells, or a drawing of what leads them.

use super::app;
use super::dom::{Listener, find, offer, on, set_flag, set_text};
use crate::plants::Show;
use crate::play::page::{Event, Page};
use web_sys::{Element, HtmlSelectElement};

pub struct ShowChooser {
    element: Element,
    select: HtmlSelectElement,
    meaning: Element,
    /// The plant and what is chosen for it.
    chosen: Option<(&'static str, Show)>,
    _listener: Listener,
}

impl ShowChooser {
    pub fn new() -> ShowChooser {
        let select: HtmlSelectElement = find("show");
        let chosen = select.clone();
        let listener = on(&select, "change", move |_: web_sys::Event| {
            if let Some(show) = Show::of_key(&chosen.value()) {
                app::send(Event::Show(show));
            }
        });
        let (element, meaning) = (find("shows"), find("show-meaning"));
        ShowChooser { element, select, meaning, chosen: None, _listener: listener }
    }

    /// Offers what the plant has. A plant that has nothing but its cells leaves no choice.
    pub fn show(&mut self, page: &Page) {
        let (plant, show) = (page.scene().plant, page.scene().show);
        let before = self.chosen.replace((plant.key, show));
        if before == self.chosen {
            return;
        }
        if before.is_none_or(|(key, _)| key != plant.key) {
            self.select.set_text_content(None);
            Show::offered(plant).for_each(|show| offer(&self.select, show.key(), show.name()));
            set_flag(&self.element, "hidden", self.select.length() < 2);
        }
        self.select.set_value(show.key());
        set_text(&self.meaning, &show.meaning(plant));
    }
}
