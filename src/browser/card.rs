//! The card of the clone in hand: what it is in words, and how many cells it has by day; and the buttons
//! that take one.

use super::app;
use super::dom::{Listener, document, find, on, set_flag, set_text};
use crate::play::clone::Told;
use crate::play::page::{Event, Page};
use crate::play::words::grouped;
use web_sys::{Element, HtmlElement};

pub struct Card {
    card: Element,
    /// Title, story and size.
    texts: [Element; 3],
    days: Element,
    mother: Element,
    told: Option<Told>,
    _listeners: Vec<Listener>,
}

impl Card {
    pub fn new() -> Card {
        let click =
            |id: &str, act: fn()| on(&find::<Element>(id), "click", move |_: web_sys::Event| act());
        let listeners = vec![
            click("take", || app::take(None, false)),
            click("mother", || app::send(Event::TakeMother)),
            click("clan", || app::send(Event::TakeClan)),
            click("clan-before", || app::send(Event::StepClans(-1))),
            click("clan-next", || app::send(Event::StepClans(1))),
            click("put-down", || {
                app::send(Event::PutDown);
                // The button is gone.
                let _ = find::<HtmlElement>("stage").focus();
            }),
        ];
        Card {
            card: find("clone"),
            texts: ["clone-title", "clone-story", "clone-size"].map(find),
            days: find("clone-days"),
            mother: find("mother"),
            told: None,
            _listeners: listeners,
        }
    }

    pub fn show(&mut self, page: &Page) {
        let told = page.told_of_clone();
        if told == self.told {
            return;
        }
        set_flag(&self.card, "hidden", told.is_none());
        let Told { title, story, size, days, has_mother } = told.clone().unwrap_or_default();
        for (element, text) in self.texts.iter().zip([&title, &story, &size]) {
            set_text(element, text);
        }
        set_flag(&self.mother, "disabled", !has_mother);
        if self.told.as_ref().is_none_or(|before| before.days != days) {
            self.days.set_text_content(None);
            for (day, cells) in days {
                if let Ok(item) = document().create_element("li") {
                    item.set_text_content(Some(&format!("Day {day}: {}", grouped(cells))));
                    let _ = self.days.append_child(&item);
                }
            }
        }
        self.told = told;
    }
}
