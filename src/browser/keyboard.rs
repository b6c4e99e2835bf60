//! Keys. Single letters count only on the stage, so that they never fight a screen reader or a field;
//! `?`, undo and redo count everywhere but in fields.

use super::dom::{Listener, on, window};
use super::{app, controls};
use crate::play::page::Event;
use glam::Vec2;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent};

/// Degrees that an arrow key turns the plant.
const TURN_DEG: f32 = 10.0;
/// Half sides of the stage that an arrow key with Shift moves it.
const MOVE: f32 = 0.1;
/// Zoom of one key.
const ZOOM: f32 = 1.2;

/// Listens on the stage and on the whole window.
pub fn listen(stage: &HtmlElement) -> [Listener; 2] {
    [
        on(stage, "keydown", |event: KeyboardEvent| {
            if !(event.ctrl_key() || event.meta_key() || event.alt_key()) && on_stage(&event) {
                event.prevent_default();
                event.stop_propagation();
            }
        }),
        on(&window(), "keydown", |event: KeyboardEvent| {
            if !is_typed(&event) && anywhere(&event) {
                event.prevent_default();
            }
        }),
    ]
}

/// True if the key means something on the stage.
fn on_stage(event: &KeyboardEvent) -> bool {
    let turn = |right_deg, up_deg| Event::Turn { right_deg, up_deg };
    let pan = |x, y| Event::Pan(Vec2::new(x, y));
    let zoom = |factor| Event::Zoom { factor, at: Vec2::ZERO };
    let event = match (event.key().as_str(), event.shift_key()) {
        ("ArrowLeft", false) => turn(-TURN_DEG, 0.0),
        ("ArrowRight", false) => turn(TURN_DEG, 0.0),
        ("ArrowUp", false) => turn(0.0, TURN_DEG),
        ("ArrowDown", false) => turn(0.0, -TURN_DEG),
        ("ArrowLeft", true) => pan(-MOVE, 0.0),
        ("ArrowRight", true) => pan(MOVE, 0.0),
        ("ArrowUp", true) => pan(0.0, MOVE),
        ("ArrowDown", true) => pan(0.0, -MOVE),
        ("+" | "=", _) => zoom(ZOOM),
        ("-", _) => zoom(1.0 / ZOOM),
        ("0", _) => Event::ResetView,
        (" ", _) => Event::PlayOrPause,
        (".", _) => Event::StepDays(1),
        (",", _) => Event::StepDays(-1),
        ("Home", _) => Event::Seek(0),
        ("End", _) => Event::Seek(u32::MAX),
        ("n", _) => {
            controls::another_individual();
            return true;
        }
        ("c", _) => {
            controls::copy_link();
            return true;
        }
        _ => return false,
    };
    app::send(event);
    true
}

/// True if the key means something everywhere.
fn anywhere(event: &KeyboardEvent) -> bool {
    let command = event.ctrl_key() || event.meta_key();
    match (event.key().to_ascii_lowercase().as_str(), command, event.shift_key()) {
        ("?", false, _) => controls::show_keys(),
        // Nobody would see what is undone.
        ("z" | "y", true, _) if app::shows_figures() => return false,
        ("z", true, false) => app::send(Event::Undo),
        ("z", true, true) | ("y", true, false) => app::send(Event::Redo),
        _ => return false,
    }
    true
}

/// Whether the key goes into a field in which one types.
fn is_typed(event: &KeyboardEvent) -> bool {
    let target = event.target().and_then(|t| t.dyn_into::<Element>().ok());
    target.is_some_and(|t| t.matches("input[type=number], input[type=text]").unwrap_or(false))
}
