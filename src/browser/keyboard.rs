//! Keys. Single characters count only on the stage and on sliders, so that they never fight a screen reader or
//! a field (WCAG 2.2, 2.1.4); undo and redo count everywhere but where something is being typed.

use super::dom::{Listener, find, on, window};
use super::{app, controls};
use crate::play::page::Event;
use glam::Vec2;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent};

/// Degrees that an arrow key or a button turns the plant.
pub const TURN_DEG: f32 = 10.0;
/// Half sides of the stage that an arrow key with Shift moves it.
const MOVE: f32 = 0.1;
/// Zoom of one key or button.
pub const ZOOM: f32 = 1.2;

/// Listens on the stage and on the whole window.
pub fn listen(stage: &HtmlElement) -> [Listener; 2] {
    [
        on(stage, "keydown", |event: KeyboardEvent| {
            if is_plain(&event) && (on_stage(&event) || on_plant(&event)) {
                event.prevent_default();
                event.stop_propagation();
            }
        }),
        on(&window(), "keydown", |event: KeyboardEvent| {
            let on_slider = is_plain(&event) && is_on(&event, "#playground input[type=range]");
            if on_slider && on_plant(&event) || anywhere(&event) {
                event.prevent_default();
            }
        }),
    ]
}

fn is_plain(event: &KeyboardEvent) -> bool {
    !(event.ctrl_key() || event.meta_key() || event.alt_key())
}

/// True if the key means something on the stage alone.
fn on_stage(event: &KeyboardEvent) -> bool {
    let turn = |right_deg, up_deg| Event::Turn { right_deg, up_deg };
    let pan = |x, y| Event::Pan(Vec2::new(x, y));
    let event = match (event.key().as_str(), event.shift_key()) {
        ("ArrowLeft", false) => turn(-TURN_DEG, 0.0),
        ("ArrowRight", false) => turn(TURN_DEG, 0.0),
        ("ArrowUp", false) => turn(0.0, TURN_DEG),
        ("ArrowDown", false) => turn(0.0, -TURN_DEG),
        ("ArrowLeft", true) => pan(-MOVE, 0.0),
        ("ArrowRight", true) => pan(MOVE, 0.0),
        ("ArrowUp", true) => pan(0.0, MOVE),
        ("ArrowDown", true) => pan(0.0, -MOVE),
        ("Home", _) => Event::Seek(0),
        ("End", _) => Event::Seek(u32::MAX),
        ("PageUp", _) => Event::StepClans(-1),
        ("PageDown", _) => Event::StepClans(1),
        ("Enter", clan) => {
            app::take(None, clan);
            return true;
        }
        _ => return false,
    };
    app::send(event);
    true
}

/// True if the key means something on the stage and on sliders, which are let go of with the focus on them.
fn on_plant(event: &KeyboardEvent) -> bool {
    match event.key().as_str() {
        "+" | "=" => app::zoom(ZOOM, Vec2::ZERO),
        "-" => app::zoom(1.0 / ZOOM, Vec2::ZERO),
        "0" => app::send(Event::ResetView),
        " " => app::send(Event::PlayOrPause),
        "." => app::send(Event::StepDays(1)),
        "," => app::send(Event::StepDays(-1)),
        "n" => controls::another_individual(),
        "c" => controls::copy_link(),
        "m" => app::send(Event::TakeMother),
        "s" => find::<HtmlElement>("in-words").click(),
        "?" => controls::show_keys(),
        _ => return false,
    }
    true
}

/// True if the key means something everywhere.
fn anywhere(event: &KeyboardEvent) -> bool {
    let command = event.ctrl_key() || event.meta_key();
    // What was typed and does not count yet is undone by the browser; what counts, by us: else the field
    // would show the number of before beside the plant of now.
    if is_on(event, "input[inputmode]") && (!command || is_on(event, "[data-typing]")) {
        return false;
    }
    match (event.key().to_ascii_lowercase().as_str(), command, event.shift_key()) {
        ("escape", false, _) if !is_on(event, "dialog *") => app::send(Event::PutDown),
        // Nobody would see what is undone.
        ("z" | "y", true, _) if app::shows_figures() => return false,
        ("z", true, false) => app::send(Event::Undo),
        ("z", true, true) | ("y", true, false) => app::send(Event::Redo),
        _ => return false,
    }
    true
}

/// Whether the focus is on what a selector finds.
fn is_on(event: &KeyboardEvent, selector: &str) -> bool {
    let target = event.target().and_then(|t| t.dyn_into::<Element>().ok());
    target.is_some_and(|t| t.matches(selector).unwrap_or(false))
}
