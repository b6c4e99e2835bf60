//! Mouse, pen and fingers on the stage: one turns the plant, two (or Shift, or the right button) move
//! it, wheel and pinch zoom. What neither moves nor is joined by another is a click: it takes a clone in hand.

use super::app;
use super::dom::{Listener, on};
use crate::play::page::Event;
use glam::Vec2;
use std::cell::RefCell;
use std::rc::Rc;
use web_sys::{HtmlElement, MouseEvent, PointerEvent, WheelEvent};

/// Degrees that the plant turns when dragged across the shorter side of the stage.
const TURN_DEG: f32 = 180.0;
/// Zoom of one pixel of a wheel, as an exponent. Mice send about 100 pixels to a notch.
const WHEEL_ZOOM: f64 = 0.0015;
/// Zoom of one pixel of a trackpad's pinch, which browsers send as a wheel with Ctrl.
const PINCH_ZOOM: f64 = 0.01;
/// Pixels in a line, for wheels that count in lines.
const LINE_PX: f64 = 16.0;

/// Pixels that a hand may tremble in a click; a drag begins beyond them.
pub const TREMBLE_PX: f32 = 5.0;

/// The stage in a frame before somebody has clicked it; see also `touch-action` in the style sheet.
const OUT_OF_HAND: &str = "[data-framed] .stage:not(:focus)";

pub struct Pointer {
    _listeners: [Listener; 6],
}

/// A pointer that is down.
struct Down {
    id: i32,
    at: Vec2,
    moves: bool,
    /// Whether it may be a click still.
    clicks: bool,
}

impl Pointer {
    pub fn new(stage: &HtmlElement) -> Pointer {
        let down: Rc<RefCell<Vec<Down>>> = Rc::default();
        let (pressed, moved, lifted, cancelled) =
            (down.clone(), down.clone(), down.clone(), down.clone());
        let [catcher, dragged, wheeled, clicked] = std::array::from_fn(|_| stage.clone());
        let listeners = [
            on(stage, "pointerdown", move |event: PointerEvent| {
                let mut down = pressed.borrow_mut();
                if down.len() < 2 {
                    // Fails only for pointers that are gone already.
                    let _ = catcher.set_pointer_capture(event.pointer_id());
                    let moves = event.button() != 0 || event.shift_key();
                    let clicks = down.is_empty() && event.button() == 0;
                    down.iter_mut().for_each(|other| other.clicks = false);
                    down.push(Down { id: event.pointer_id(), at: place(&event), moves, clicks });
                }
            }),
            on(stage, "pointermove", move |event: PointerEvent| {
                drag(&mut moved.borrow_mut(), &event, &dragged);
            }),
            on(stage, "pointerup", move |event: PointerEvent| {
                let is_it = |d: &Down| d.id == event.pointer_id();
                let clicks = lifted.borrow().iter().any(|d| is_it(d) && d.clicks);
                lifted.borrow_mut().retain(|d| !is_it(d));
                if clicks {
                    app::take(Some(in_square(place(&event), &clicked)), event.shift_key());
                }
            }),
            on(stage, "pointercancel", move |event: PointerEvent| {
                cancelled.borrow_mut().retain(|d| d.id != event.pointer_id());
            }),
            on(stage, "wheel", move |event: WheelEvent| {
                // In a frame it scrolls the page around, until the plant is clicked.
                let is_stranger = matches!(wheeled.matches(OUT_OF_HAND), Ok(true));
                if is_stranger && !event.ctrl_key() && !event.meta_key() {
                    return;
                }
                event.prevent_default();
                let lines = event.delta_mode() == WheelEvent::DOM_DELTA_LINE;
                let pixels = event.delta_y() * if lines { LINE_PX } else { 1.0 };
                let rate = if event.ctrl_key() { PINCH_ZOOM } else { WHEEL_ZOOM };
                let factor = (-pixels * rate).exp() as f32;
                let at = in_square(place(&event), &wheeled);
                app::zoom(factor, at);
            }),
            on(stage, "contextmenu", |event: MouseEvent| event.prevent_default()),
        ];
        Pointer { _listeners: listeners }
    }
}

fn drag(down: &mut [Down], event: &PointerEvent, stage: &HtmlElement) {
    let Some(moved) = down.iter().position(|d| d.id == event.pointer_id()) else { return };
    let (from, to) = (down[moved].at, place(event));
    if down[moved].clicks && from.distance(to) < TREMBLE_PX {
        return;
    }
    down[moved].clicks = false;
    down[moved].at = to;
    let half = half_square(stage);
    let by = (to - from) / half;
    match down {
        [only] if !only.moves => {
            // The surface follows the hand.
            let turn = by * (TURN_DEG / 2.0);
            app::send(Event::Turn { right_deg: -turn.x, up_deg: turn.y });
        }
        [_] => app::send(Event::Pan(Vec2::new(by.x, -by.y))),
        [..] => {
            let other = down[1 - moved].at;
            let factor = (to.distance(other).max(1.0)) / (from.distance(other).max(1.0));
            app::zoom(factor, in_square((to + other) * 0.5, stage));
            app::send(Event::Pan(Vec2::new(by.x, -by.y) * 0.5));
        }
    }
}

fn place(event: &MouseEvent) -> Vec2 {
    Vec2::new(event.client_x() as f32, event.client_y() as f32)
}

fn half_square(stage: &HtmlElement) -> f32 {
    (stage.client_width().min(stage.client_height()).max(2) as f32) * 0.5
}

/// A place in the window as -1 to 1 over the centred square of the stage, `y` upwards.
fn in_square(place: Vec2, stage: &HtmlElement) -> Vec2 {
    let stage_box = stage.get_bounding_client_rect();
    let middle = Vec2::new(
        (stage_box.left() + stage_box.width() / 2.0) as f32,
        (stage_box.top() + stage_box.height() / 2.0) as f32,
    );
    let from_middle = (place - middle) / half_square(stage);
    Vec2::new(from_middle.x, -from_middle.y)
}
