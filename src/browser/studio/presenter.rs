//! The presenter: the plant fills the window, with its day, its numbers and its link in type that the back row of
//! a classroom reads. Days are the page's own: its buttons are pressed for the visitor.

use super::with;
use super::{picture, subject};
use crate::browser::address::fragment;
use crate::browser::dom::{
    Listener, document, find, on, on_first, set_flag, set_text, window, within,
};
use crate::plants;
use crate::play::link;
use crate::play::words::grouped;
use std::cell::Cell;
use wasm_bindgen::prelude::*;
use web_sys::{Element, Event, HtmlElement, KeyboardEvent};

/// What stands in the address while it is open.
pub const VIEW: &str = "present";
/// Milliseconds after which its buttons fade.
const REST_MS: i32 = 4000;
/// Milliseconds after which a hand that turned the plant is taken to be done.
const TURNED_MS: i32 = 400;

thread_local! {
    /// Whether the key H counts: a single character may be turned off (WCAG 2.2, 2.1.4).
    static HAS_KEY: Cell<bool> = const { Cell::new(true) };
}

pub struct Presenter {
    view: HtmlElement,
    /// Whether it was opened beside something else that the address says.
    is_guest: bool,
    /// When a hand or a key was last there, and whether somebody waits for its rest.
    woken_ms: f64,
    waits: bool,
    _listeners: Vec<Listener>,
}

impl Presenter {
    pub fn new() -> Presenter {
        let body = document().body().expect("a page has a body");
        let _ = body.insert_adjacent_html("beforeend", include_str!("presenter.html"));
        let view: HtmlElement = find("presenter");
        let mut listeners = vec![
            on(&view, "click", |event: Event| {
                let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
                let button = target.and_then(|target| target.closest("[data-do]").ok().flatten());
                if let Some(what) = button.and_then(|button| button.get_attribute("data-do")) {
                    act(&what);
                }
            }),
            // Before the stage, where arrows turn the plant.
            on_first(&window(), "keydown", |event: KeyboardEvent| {
                if hear_key(&event) {
                    event.prevent_default();
                    event.stop_propagation();
                }
            }),
            on(&document(), "fullscreenchange", |_: Event| {
                let word = if is_full() { "Leave full screen" } else { "Full screen" };
                set_text(&within(&find("presenter"), "[data-do=full]"), word);
            }),
        ];
        for kind in ["pointermove", "pointerdown"] {
            listeners.push(on(&window(), kind, |_: Event| with(|studio| studio.presenter.wake())));
        }
        for kind in ["pointerup", "wheel", "keyup"] {
            listeners.push(on(&window(), kind, |_: Event| {
                // The page is told first, and its link is another one then.
                after(TURNED_MS, || with(|studio| studio.presenter.show()));
            }));
        }
        subject::on_change(|| with(|studio| studio.presenter.show()));
        Presenter { view, is_guest: false, woken_ms: 0.0, waits: false, _listeners: listeners }
    }

    pub fn is_open(&self) -> bool {
        !self.view.hidden()
    }

    /// Agrees with the address.
    pub fn follow(&mut self, is_wanted: bool, view: &str) {
        // What the class gets stays in the address while its plant is presented.
        let stays = self.is_guest && !view.is_empty() && view != VIEW;
        match is_wanted || stays {
            true if !self.is_open() => self.open(),
            false if self.is_open() => self.close(),
            _ => {}
        }
    }

    fn open(&mut self) {
        self.view.set_hidden(false);
        let _ = self.view.focus();
        self.show();
        self.wake();
    }

    fn close(&mut self) {
        self.view.set_hidden(true);
        self.is_guest = false;
        let _ = find::<HtmlElement>("stage").focus();
        if is_full() {
            document().exit_fullscreen();
        }
    }

    /// Shows what the page says of itself, and the link once nothing moves.
    fn show(&self) {
        if !self.is_open() {
            return;
        }
        for (part, id) in [("h2", "name"), (".number", "fact-day"), (".part", "fact-share")] {
            let told = find::<Element>(id).text_content().unwrap_or_default();
            set_text(&within(&self.view, part), &told);
        }
        let root = document().document_element().expect("a document has a root");
        let cells = root.get_attribute("data-cells").and_then(|cells| cells.parse().ok());
        let cells: u32 = cells.unwrap_or_default();
        let word = if cells == 1 { "cell" } else { "cells" };
        set_text(&within(&self.view, ".cells"), &format!("{} {word}", grouped(cells)));
        let plays = find::<Element>("play").has_attribute("data-playing");
        let code: Element = within(&self.view, ".code");
        set_flag(&code, "data-moves", plays);
        if !plays {
            picture::show_qr(&within(&self.view, ".qr"), &shared_address());
        }
    }

    /// Shows the buttons for a while.
    fn wake(&mut self) {
        if self.is_open() {
            self.woken_ms = now_ms();
            set_flag(&self.view, "data-rests", false);
            self.wait(REST_MS);
        }
    }

    fn wait(&mut self, ms: i32) {
        if !self.waits {
            self.waits = true;
            after(ms, || with(|studio| studio.presenter.rest()));
        }
    }

    fn rest(&mut self) {
        self.waits = false;
        match REST_MS - (now_ms() - self.woken_ms) as i32 {
            left if left > 0 => self.wait(left),
            _ => set_flag(&self.view, "data-rests", true),
        }
    }
}

/// The address that others get: without the presenter, but with what a class is to see.
fn shared_address() -> String {
    let mut scene = link::read(&fragment(), plants::all()).scene;
    let day = document().document_element().and_then(|root| root.get_attribute("data-day"));
    if let Some(day) = day.and_then(|day| day.parse().ok()) {
        scene.day = day;
    }
    let class = super::pupils::beside();
    subject::address_of(&format!("{}{class}", link::write(&scene)))
}

/// Opens it: by the address, or beside what stands there for a class.
pub fn open() {
    if super::pupils::beside().is_empty() {
        return subject::want(VIEW);
    }
    with(|studio| {
        studio.presenter.is_guest = true;
        studio.presenter.open();
    });
    super::name_view();
}

fn leave() {
    let mut was_guest = false;
    with(|studio| {
        was_guest = studio.presenter.is_guest;
        if was_guest {
            studio.presenter.close();
        }
    });
    if was_guest { super::name_view() } else { subject::want("") }
}

/// Says whether the key H opens and leaves it.
pub fn has_key(counts: bool) {
    HAS_KEY.set(counts);
}

/// Does what a button or a key is for.
fn act(what: &str) {
    match what {
        "leave" => leave(),
        "full" if is_full() => document().exit_fullscreen(),
        "full" => {
            // A browser may refuse.
            let _ = document().document_element().map(|root| root.request_fullscreen());
        }
        id => find::<HtmlElement>(id).click(),
    }
}

/// True if the key means something here.
fn hear_key(event: &KeyboardEvent) -> bool {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let is_on = |what: &str| target.as_ref().is_some_and(|t| t.matches(what).unwrap_or(false));
    if event.ctrl_key() || event.meta_key() || event.alt_key() || event.shift_key() {
        return false;
    }
    if is_on("input:not([type=range]), textarea, select, dialog, dialog *") {
        return false;
    }
    let key = event.key();
    let is_open = !find::<HtmlElement>("presenter").hidden();
    let figures = find::<Element>("playground").has_attribute("inert");
    match key.as_str() {
        "h" if HAS_KEY.get() && !figures => {
            if is_open {
                leave()
            } else {
                open()
            }
            return true;
        }
        _ if !is_open => return false,
        _ => with(|studio| studio.presenter.wake()),
    }
    let what = match key.as_str() {
        "Escape" => "leave",
        // A button that has the focus is pressed by it.
        " " if is_on("button") => return false,
        " " => "play",
        "ArrowLeft" | "PageUp" => "back",
        "ArrowRight" | "PageDown" => "on",
        "Home" => "first",
        "End" => "last",
        _ => return false,
    };
    act(what);
    true
}

fn is_full() -> bool {
    document().fullscreen_element().is_some()
}

fn now_ms() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}

/// Does something later.
pub fn after(ms: i32, act: impl FnOnce() + 'static) {
    let act = Closure::once_into_js(act);
    let act = act.unchecked_ref();
    let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(act, ms);
}
