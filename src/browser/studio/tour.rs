//! A tour of the page in five steps, for who wants it: a card that stands beside the page, which can be used meanwhile.

use super::with;
use crate::browser::dom::{Listener, document, find, on, on_first, set_flag, set_text, within};
use wasm_bindgen::JsCast;
use web_sys::{
    Element, Event, HtmlElement, KeyboardEvent, ScrollIntoViewOptions, ScrollLogicalPosition,
};

/// A stop: what is shown there, and what is said of it.
struct Stop {
    /// Selects it.
    on: &'static str,
    title: &'static str,
    text: &'static str,
}

const STOPS: [Stop; 5] = [
    Stop {
        on: "#stage",
        title: "The plant",
        text: "Drag it to turn it; wheel or two fingers bring it nearer, down to single cells. Click a cell: all that \
               descend from it light up, on every day.",
    },
    Stop {
        on: ".timeline",
        title: "Its days",
        text: "Play, or pull the slider back and forth. The strip below it shows of which colours the plant is on each \
               day: filled by the number of cells, dashed by area.",
    },
    Stop {
        on: ".individuals:has(#individual)",
        title: "Individuals",
        text: "One recipe, many plants. Press “Another individual” a few times: what stays the same, and what never \
               does?",
    },
    Stop {
        on: ".recipe",
        title: "The recipe",
        text: "Open it and change a number: the plant grows again. What does it do to the pattern? Undo, at the top, \
               takes it back.",
    },
    Stop {
        on: "#copy-link",
        title: "Its link",
        text: "What you see has an address. Whoever opens the link sees the same cells, one by one. The Studio beside \
               the plant takes it away, compares it and has lessons.",
    },
];

pub struct Tour {
    card: HtmlElement,
    step: usize,
    /// What had the focus before.
    from: Option<HtmlElement>,
    _listeners: [Listener; 3],
}

impl Tour {
    pub fn new() -> Tour {
        let body = document().body().expect("a page has a body");
        let _ = body.insert_adjacent_html("beforeend", include_str!("tour.html"));
        let card: HtmlElement = find("tour-card");
        let listeners = [
            on(&find::<Element>("tour"), "click", |_: Event| {
                // The dialog of the keys closes after this, and gives the focus back.
                super::presenter::after(0, open);
            }),
            on(&card, "click", |event: Event| {
                let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
                let by = target.and_then(|target| target.get_attribute("data-by"));
                if let Some(by) = by.and_then(|by| by.parse().ok()) {
                    with(|studio| studio.tour.go(by));
                }
            }),
            on_first(&document(), "keydown", |event: KeyboardEvent| {
                let is_open = !find::<HtmlElement>("tour-card").hidden();
                let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
                let in_dialog =
                    target.is_some_and(|t| t.matches("dialog, dialog *").unwrap_or(false));
                if is_open && event.key() == "Escape" && !in_dialog {
                    event.stop_propagation();
                    with(|studio| studio.tour.go(0));
                }
            }),
        ];
        Tour { card, step: 0, from: None, _listeners: listeners }
    }

    fn open(&mut self) {
        if self.card.hidden() {
            self.from = document().active_element().and_then(|e| e.dyn_into().ok());
            self.card.set_hidden(false);
        }
        self.step = 0;
        self.show();
    }

    /// Goes on or back by a step; by none, it leaves.
    fn go(&mut self, by: isize) {
        match self.step.checked_add_signed(by) {
            Some(step) if by != 0 && step < self.stops().len() => {
                self.step = step;
                self.show();
            }
            _ => self.leave(),
        }
    }

    /// The stops that the page has: a class may not get all.
    fn stops(&self) -> Vec<(&'static Stop, HtmlElement)> {
        let found = STOPS.iter().filter_map(|stop| {
            let element = document().query_selector(stop.on).ok().flatten()?;
            let element: HtmlElement = element.dyn_into().ok()?;
            // On a phone the panel is drawn up when its turn comes.
            let is_there = element.offset_width() > 0 || is_below(&element);
            is_there.then_some((stop, element))
        });
        found.collect()
    }

    fn show(&self) {
        self.unmark();
        let stops = self.stops();
        let Some((stop, element)) = stops.get(self.step) else { return };
        if is_below(element) {
            find::<HtmlElement>("sheet").click();
        }
        set_flag(element, "data-toured", true);
        let way = ScrollIntoViewOptions::new();
        way.set_block(ScrollLogicalPosition::Nearest);
        element.scroll_into_view_with_scroll_into_view_options(&way);
        set_text(
            &within(&self.card, ".where"),
            &format!("A tour, step {} of {}", self.step + 1, stops.len()),
        );
        set_text(&within(&self.card, "h2"), stop.title);
        set_text(&within(&self.card, ".text"), stop.text);
        set_flag(&within(&self.card, "[data-by='-1']"), "disabled", self.step == 0);
        let is_last = self.step + 1 == stops.len();
        set_text(&within(&self.card, "[data-by='1']"), if is_last { "Done" } else { "Next" });
        set_flag(&within(&self.card, "[data-by='0']"), "hidden", is_last);
        let _ = self.card.focus();
    }

    fn leave(&mut self) {
        self.unmark();
        self.card.set_hidden(true);
        // What it began from may be gone.
        let from = self.from.take().filter(|from| from.offset_width() > 0);
        let _ = from.unwrap_or_else(|| find("stage")).focus();
    }

    fn unmark(&self) {
        if let Ok(Some(marked)) = document().query_selector("[data-toured]") {
            set_flag(&marked, "data-toured", false);
        }
    }
}

pub fn open() {
    with(|studio| studio.tour.open());
}

/// Whether something lies on the sheet of a phone that is not drawn up.
fn is_below(element: &Element) -> bool {
    let handle: HtmlElement = find("sheet");
    let panel: HtmlElement = find("panel");
    let is_down = handle.offset_width() > 0 && !panel.has_attribute("data-open");
    is_down && panel.contains(Some(element))
}
