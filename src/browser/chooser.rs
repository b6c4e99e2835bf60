//! The plant chooser: one radio button with a picture for each plant, kind by kind.

use super::app;
use super::dom::{
    Listener, copy_of_template, document, find, mark_when_missing, on, set_attribute, set_flag,
    set_text, within,
};
use super::files;
use crate::plants;
use crate::play::page::{Event, Page, State};
use crate::surface::holds;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlInputElement};

/// By what a plant is found: its names and its kind, in small letters.
const WORDS: &str = "data-words";

pub struct Chooser {
    list: Element,
    radios: Vec<HtmlInputElement>,
    /// The pictures that are not yet asked for, and their files.
    pictures: Vec<(Element, String)>,
    /// Whether the chosen plant was on the screen when this was last shown.
    is_seen: bool,
    _listeners: Vec<Listener>,
}

impl Chooser {
    pub fn new() -> Chooser {
        let list: Element = find("plants");
        list.set_text_content(None);
        let mut listeners = Vec::new();
        let mut pictures = Vec::new();
        let mut radios = Vec::new();
        for (name, plants) in plants::kinds() {
            if let Ok(kind) = document().create_element("p") {
                kind.set_text_content(Some(name));
                let _ = list.append_child(&kind);
            }
            for plant in plants {
                let label = copy_of_template("plant-template");
                let radio: HtmlInputElement = within(&label, "input");
                radio.set_value(plant.key);
                set_text(&within(&label, ".name"), plant.name);
                let words = format!("{} {} {name}", plant.name, plant.latin).to_ascii_lowercase();
                set_attribute(&label, WORDS, words);
                let picture: Element = within(&label, "img");
                listeners.push(mark_when_missing(&picture));
                pictures.push((picture, format!("posters/{}-small.avif", plant.key)));
                let _ = list.append_child(&label);
                radios.push(radio);
            }
        }
        listeners.push(on(&list, "change", |event: web_sys::Event| {
            let radio = event.target().and_then(|t| t.dyn_into::<HtmlInputElement>().ok());
            if let Some(radio) = radio {
                app::send(Event::ChoosePlant(radio.value()));
            }
        }));
        let (search, among) = (find::<HtmlInputElement>("find"), list.clone());
        listeners.push(on(&search.clone(), "input", move |_: web_sys::Event| {
            let found = show_found(&among, &search.value().trim().to_ascii_lowercase());
            let told = if found { "" } else { "No plant is called that." };
            set_text(&find::<Element>("not-found"), told);
        }));
        Chooser { list, radios, pictures, is_seen: false, _listeners: listeners }
    }

    pub fn show(&mut self, page: &Page) {
        // The chosen plant comes first: the pictures of all wait until it has been seen for a while.
        if page.state() != State::Loading {
            if self.is_seen {
                for (picture, path) in self.pictures.drain(..) {
                    set_attribute(&picture, "src", files::address(&path));
                }
            }
            self.is_seen = true;
        }
        for radio in &self.radios {
            let chosen = radio.value() == page.scene().plant.key;
            if radio.checked() != chosen {
                radio.set_checked(chosen);
                if chosen {
                    self.bring_into_sight(radio);
                }
            }
        }
    }

    /// The plants stand in a list that is longer than its frame, on a phone in a row.
    fn bring_into_sight(&self, radio: &HtmlInputElement) {
        let (row, plant) = (self.list.get_bounding_client_rect(), radio.get_bounding_client_rect());
        let right = plant.left() + 0.5 * plant.width() - row.left() - 0.5 * row.width();
        let down = plant.top() + 0.5 * plant.height() - row.top() - 0.5 * row.height();
        self.list.set_scroll_left(self.list.scroll_left() + right as i32);
        self.list.set_scroll_top(self.list.scroll_top() + down as i32);
    }
}

/// Shows the plants whose words hold a text, and the kinds that have some of them. Whether there are any.
fn show_found(list: &Element, text: &str) -> bool {
    let (mut kind, mut found): (Option<Element>, bool) = (None, false);
    for item in (0..).map_while(|k| list.children().item(k)) {
        let words = item.get_attribute(WORDS);
        let is_found = words.as_ref().is_some_and(|words| holds(words, text));
        set_flag(&item, "hidden", !is_found);
        if words.is_none() {
            kind = Some(item);
        } else if is_found {
            found = true;
            if let Some(kind) = kind.take() {
                set_flag(&kind, "hidden", false);
            }
        }
    }
    found
}
