//! The rest of the page: caption, individual, link, undo, help, and the state that the `<html>`
//! element carries for tests and embedders.

use super::address::{UI, fragment, wanted};
use super::app;
use super::boot;
use super::dom::{
    Listener, document, find, member, on, set_attribute, set_flag, set_style, set_text, window,
};
use super::keyboard::{TURN_DEG, ZOOM};
use super::typing;
use crate::play::link::INDIVIDUAL;
use crate::play::page::{Event, Page, State};
use crate::play::strip::rgb;
use crate::play::words;
use crate::surface::rounded;
use glam::Vec2;
use js_sys::Reflect;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, HtmlDialogElement, HtmlElement, HtmlInputElement};

/// Individuals drawn by chance have numbers that can be said aloud.
const DRAWN_INDIVIDUALS: u32 = 9999;

pub struct Controls {
    root: Element,
    stage: Element,
    /// All of the picture in words.
    summary: Element,
    name: Element,
    latin: Element,
    source: Element,
    facts: [Element; 5],
    /// Bars of the shares of the cells and of the area.
    bars: [HtmlElement; 2],
    individual: HtmlInputElement,
    refusal: Element,
    undo: Element,
    redo: Element,
    _listeners: Vec<Listener>,
}

impl Controls {
    pub fn new() -> Controls {
        let individual: HtmlInputElement = find("individual");
        let take = |number| app::send(Event::Individual(number));
        let mut listeners = Vec::from(typing::watch(&individual, 1.0, take));
        listeners.push(click("another", another_individual));
        listeners.push(click("copy-link", copy_link));
        listeners.push(click("help", show_keys));
        for (id, event) in
            [("undo", Event::Undo), ("redo", Event::Redo), ("framing", Event::ResetView)]
        {
            listeners.push(click(id, move || app::send(event.clone())));
        }
        // What dragging does, for who cannot drag (WCAG 2.2, 2.5.7).
        for (id, right_deg, up_deg) in [
            ("turn-left", -TURN_DEG, 0.0),
            ("turn-right", TURN_DEG, 0.0),
            ("turn-up", 0.0, TURN_DEG),
            ("turn-down", 0.0, -TURN_DEG),
        ] {
            listeners.push(click(id, move || app::send(Event::Turn { right_deg, up_deg })));
        }
        for (id, factor) in [("nearer", ZOOM), ("farther", 1.0 / ZOOM)] {
            listeners.push(click(id, move || app::zoom(factor, Vec2::ZERO)));
        }
        listeners.push(click("tour", || load_studio("tour")));
        listeners.push(on(&find::<Element>("studio"), "click", |event: web_sys::Event| {
            if let Some(door) = event.target() {
                load_studio(&door.unchecked_into::<Element>().id());
            }
        }));
        for kind in ["dragover", "drop"] {
            // Or else the browser goes to the file, away from the plant.
            listeners.push(on(&document(), kind, |event: web_sys::Event| {
                event.prevent_default();
                // They are in the event for a moment alone, and the studio may not be there yet.
                let files = member(&member(&event, "dataTransfer"), "files");
                let _ = Reflect::set(&document(), &"files".into(), &files);
                load_studio("drop");
            }));
        }
        listeners.push(on(&find::<Element>("panel"), "submit", |event: web_sys::Event| {
            event.prevent_default();
        }));
        // A link within the page would be taken for one to a plant.
        listeners.push(on(&find::<Element>("skip"), "click", |event: web_sys::Event| {
            event.prevent_default();
            let _ = find::<HtmlElement>("day").focus();
        }));
        Controls {
            root: document().document_element().expect("a document has a root"),
            stage: find("stage"),
            summary: find("summary"),
            name: find("name"),
            latin: find("latin"),
            source: find("source"),
            facts: ["fact-day", "fact-cells", "fact-share", "fact-area", "fact-fingerprint"]
                .map(find),
            bars: ["share", "area"].map(find),
            individual,
            refusal: find("individual-refusal"),
            undo: find("undo"),
            redo: find("redo"),
            _listeners: listeners,
        }
    }

    /// Shows what is on the screen.
    pub fn show(&self, page: &Page) {
        let scene = page.scene();
        let plant = scene.plant;
        set_text(&self.name, plant.name);
        set_text(&self.latin, plant.latin);
        set_text(&self.source, page.source());
        let refusal = page.refusal(INDIVIDUAL);
        typing::show(&self.individual, &scene.individual.to_string(), &self.refusal, refusal);
        set_flag(&self.undo, "disabled", !page.history().can_undo());
        set_flag(&self.redo, "disabled", !page.history().can_redo());
        set_attribute(&self.stage, "aria-label", page.title());
        set_text(&self.summary, page.summary());
        let [day, cells, share, area, fingerprint] = &self.facts;
        match &page.shown().day {
            Some(shown) => {
                let count = shown.facts.count;
                set_text(day, &shown.day.to_string());
                set_text(cells, &words::grouped(count.cells));
                set_text(share, &words::shares(plant, count));
                set_text(area, &words::area_shares(plant, &shown.facts));
                set_text(fingerprint, &shown.facts.fingerprint);
                let colours = &scene.look.cells;
                for (element, parts) in self.bars.iter().zip([count.by_type, shown.facts.areas]) {
                    set_style(element, "background", &bar(parts, colours));
                }
            }
            None => self.facts.iter().for_each(|fact| set_text(fact, "–")),
        }
    }

    /// Tells tests and embedders what is on the screen, drawn by this backend.
    pub fn show_state(&self, state: State, page: &Page, backend: &str) {
        let drawn = page.drawn();
        let day = drawn.and_then(|d| d.day.as_ref());
        let (plant, individual) = match drawn {
            Some(drawn) => (drawn.plant, drawn.individual),
            None => (page.scene().plant.key, page.scene().individual),
        };
        let text = |x: Option<u32>| x.map(|x| x.to_string()).unwrap_or_default();
        for (name, value) in [
            ("data-plant", plant),
            ("data-individual", &individual.to_string()),
            ("data-day", &text(day.map(|d| d.day))),
            ("data-cells", &day.map_or(0, |d| d.facts.count.cells).to_string()),
            ("data-fingerprint", day.map_or("", |d| &d.facts.fingerprint)),
            ("data-backend", backend),
            // The state comes last: who waits for it finds the rest in place.
            ("data-state", state.word()),
        ] {
            set_attribute(&self.root, name, value);
        }
    }
}

/// The background of a bar in the colours of F, M and B, each as long as its share.
fn bar(parts: [u32; 3], colours: &[[f32; 3]; 3]) -> String {
    let whole = parts.iter().sum::<u32>().max(1);
    let percent = |part: u32| 100.0 * f64::from(part) / f64::from(whole);
    let [f, b, m] = colours.map(rgb);
    let [to_f, to_m] = [parts[0], parts[0] + parts[2]].map(|part| rounded(percent(part), 10.0));
    format!("linear-gradient(90deg, {f} {to_f}%, {m} 0 {to_m}%, {b} 0)")
}

fn click(id: &str, mut act: impl FnMut() + 'static) -> Listener {
    on(&find::<Element>(id), "click", move |_: web_sys::Event| act())
}

/// Draws an individual that is not the shown one.
pub fn another_individual() {
    let Ok(chance) = getrandom::u32() else { return };
    let number = 1 + chance % DRAWN_INDIVIDUALS;
    let other = if number == app::individual() { 1 + number % DRAWN_INDIVIDUALS } else { number };
    app::send(Event::Individual(f64::from(other)));
}

/// Copies the link of what is shown; where the browser does not allow it, shows it to be copied.
pub fn copy_link() {
    let mut address = app::address();
    // What a plant of the visitor's own is made of.
    if fragment().starts_with("#own-") {
        address += &wanted();
    }
    spawn_local(async move {
        let clipboard = window().navigator().clipboard();
        // Pages without https have no clipboard.
        let copied = !clipboard.is_undefined()
            && JsFuture::from(clipboard.write_text(&address)).await.is_ok();
        let link: HtmlElement = find("copied");
        if copied {
            app::say("Link copied");
            set_text(&link, "Link copied");
            // Taken away and read back in between, so that the animation starts again.
            set_flag(&link, "data-seen", false);
            let _ = link.offset_width();
            set_flag(&link, "data-seen", true);
        } else {
            app::tell(&format!("Copy this link: {address}"));
        }
    });
}

/// Loads the studio when it is first wanted; then it listens itself.
pub fn load_studio(wanted: &str) {
    let root = document().document_element().expect("a document has a root");
    // How much of the page there is, is no matter of the studio's.
    if wanted.is_empty() || wanted.starts_with(UI) || root.has_attribute("data-studio") {
        return;
    }
    set_attribute(&root, "data-studio", wanted);
    boot::load("studio", move || {
        set_flag(&root, "data-studio", false);
        app::tell("The studio could not be loaded. Please try again.");
    });
}

/// Shows which keys do what.
pub fn show_keys() {
    let dialog: HtmlDialogElement = find("keys");
    if !dialog.open() {
        let _ = dialog.show_modal();
    }
}
