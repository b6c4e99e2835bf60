//! Hands and keys on the pictures of a series, which have one camera: what turns one of them turns all.

use super::app;
use super::dom::{Listener, on, on_first};
use super::keyboard::{TURN_DEG, ZOOM};
use super::pointer::TREMBLE_PX;
use crate::play::gallery::Event;
use glam::Vec2;
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent, MouseEvent, PointerEvent};

/// Degrees that the plants turn when one is dragged across its picture.
const ACROSS_DEG: f32 = 180.0;

/// A pointer that is down on a picture, or was until the click that follows.
#[derive(Clone, Copy)]
struct Hand {
    id: i32,
    at: Vec2,
    /// The width of its picture, in pixels.
    width_px: f32,
    turns: bool,
}

/// Listens to the pictures of a row.
pub fn listen(pictures: &HtmlElement) -> Vec<Listener> {
    let hand: Rc<Cell<Option<Hand>>> = Rc::default();
    let [pressed, moved, clicked, cancelled] = std::array::from_fn(|_| hand.clone());
    let catcher = pictures.clone();
    vec![
        on(pictures, "pointerdown", move |event: PointerEvent| {
            let picture = picture_of(&event).filter(|_| event.is_primary() && event.button() == 0);
            pressed.set(picture.map(|picture| {
                let width_px = picture.client_width().max(1) as f32;
                Hand { id: event.pointer_id(), at: place(&event), width_px, turns: false }
            }));
        }),
        on(pictures, "pointermove", move |event: PointerEvent| {
            let Some(hand) = moved.get().filter(|hand| hand.id == event.pointer_id()) else {
                return;
            };
            let (at, by) = (place(&event), place(&event) - hand.at);
            if event.buttons() == 0 || !hand.turns && by.length() < TREMBLE_PX {
                return;
            }
            // Fails only for pointers that are gone already.
            let _ = catcher.set_pointer_capture(hand.id);
            moved.set(Some(Hand { at, turns: true, ..hand }));
            let by = by / hand.width_px * ACROSS_DEG;
            look(-by.x, by.y, 1.0);
        }),
        on(pictures, "pointercancel", move |_: PointerEvent| cancelled.set(None)),
        // A click that ends a drag leads nowhere.
        on_first(pictures, "click", move |event: MouseEvent| {
            if clicked.take().is_some_and(|hand| hand.turns) {
                event.prevent_default();
                event.stop_propagation();
            }
        }),
        // Browsers would drag the link of the picture.
        on(pictures, "dragstart", |event: web_sys::Event| event.prevent_default()),
        on(pictures, "keydown", |event: KeyboardEvent| {
            let plain = !(event.ctrl_key() || event.meta_key() || event.alt_key());
            if plain && turn_by_key(&event.key()) {
                event.prevent_default();
            }
        }),
    ]
}

fn turn_by_key(key: &str) -> bool {
    match key {
        "ArrowLeft" => look(-TURN_DEG, 0.0, 1.0),
        "ArrowRight" => look(TURN_DEG, 0.0, 1.0),
        "ArrowUp" => look(0.0, TURN_DEG, 1.0),
        "ArrowDown" => look(0.0, -TURN_DEG, 1.0),
        "+" | "=" => look(0.0, 0.0, ZOOM),
        "-" => look(0.0, 0.0, 1.0 / ZOOM),
        _ => return false,
    }
    true
}

fn look(right_deg: f32, up_deg: f32, zoom: f32) {
    app::send_to_figures(Event::Look { right_deg, up_deg, zoom });
}

fn picture_of(event: &PointerEvent) -> Option<Element> {
    let target = event.target()?.dyn_into::<Element>().ok()?;
    target.closest(".picture").ok().flatten()
}

fn place(event: &MouseEvent) -> Vec2 {
    Vec2::new(event.client_x() as f32, event.client_y() as f32)
}
