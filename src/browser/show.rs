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
    plant: Option<&'static str>,
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
        ShowChooser { element, select, meaning, plant: None, _listener: listener }
    }

    /// Offers what the plant has. A plant that has nothing but its cells leaves no choice.
    pub fn show(&mut self, page: &Page) {
        let (plant, show) = (page.scene().plant, page.scene().show);
        if self.plant.replace(plant.key) != Some(plant.key) {
            let shows = Show::offered(plant).map(|show| (show.key(), show.name()));
            set_flag(&self.element, "hidden", offer(&self.select, shows) < 2);
        }
        if self.select.value() != show.key() {
            self.select.set_value(show.key());
        }
        set_text(&self.meaning, &show.meaning(plant));
    }
}
