//! Fingers on sliders. Browsers set a slider as soon as a finger comes down on it, even if the finger then
//! scrolls. Here a value counts when the finger has gone along the slider, or is lifted where it came down.

use super::dom::{Listener, on_first, window};
use super::typing::hold;
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::{Event, EventInit, HtmlInputElement, PointerEvent};

/// Pixels along the slider that are no tremor.
const ALONG_PX: i32 = 6;

pub struct Fingers {
    _listeners: [Listener; 8],
}

/// A slider with a finger on it.
struct Touched {
    slider: HtmlInputElement,
    before: String,
    from: [i32; 2],
    intent: Intent,
}

#[derive(Clone, Copy, PartialEq)]
enum Intent {
    Unknown,
    Slide,
    Scroll,
}

/// What is heard of them.
const KINDS: [&str; 8] = [
    "pointerdown",
    "pointermove",
    "pointerup",
    "pointercancel",
    "input",
    "change",
    "touchend",
    "touchcancel",
];

impl Fingers {
    pub fn new() -> Fingers {
        let touched: Rc<RefCell<Option<Touched>>> = Rc::default();
        let listeners = KINDS.map(|kind| {
            let touched = touched.clone();
            on_first(&window(), kind, move |event: Event| hear(&touched, kind, &event))
        });
        Fingers { _listeners: listeners }
    }
}

fn hear(touched: &RefCell<Option<Touched>>, kind: &str, event: &Event) {
    let pointer: &PointerEvent = event.unchecked_ref();
    match kind {
        // A second finger changes nothing.
        "pointerdown" if pointer.is_primary() => *touched.borrow_mut() = Touched::by(pointer),
        "touchend" | "touchcancel" => *touched.borrow_mut() = None,
        _ => {}
    }
    let tells = match touched.borrow_mut().as_mut() {
        Some(touched) => touched.hear(kind, event).then(|| touched.slider.clone()),
        None => None,
    };
    // Told after the borrow: what is told is heard here, too.
    let Some(slider) = tells else { return };
    tell(&slider, "input");
    if let Some(touched) = touched.borrow_mut().as_mut().filter(|_| kind == "pointercancel") {
        touched.intent = Intent::Scroll;
    }
}

impl Touched {
    fn by(event: &PointerEvent) -> Option<Touched> {
        let slider: HtmlInputElement = event.target()?.dyn_into().ok()?;
        (event.pointer_type() == "touch" && slider.type_() == "range").then(|| {
            hold(&slider, true);
            let (before, from) = (slider.value(), [event.client_x(), event.client_y()]);
            Touched { slider, before, from, intent: Intent::Unknown }
        })
    }

    /// True if a value is to be told: that counts from now on, or the one of before.
    fn hear(&mut self, kind: &str, event: &Event) -> bool {
        match kind {
            "pointermove" => {
                let pointer: &PointerEvent = event.unchecked_ref();
                let along = (pointer.client_x() - self.from[0]).abs();
                let across = (pointer.client_y() - self.from[1]).abs();
                self.intent == Intent::Unknown && along > ALONG_PX && along > across && self.slide()
            }
            "pointerup" => self.intent == Intent::Unknown && self.slide(),
            "pointercancel" => {
                // The browser takes the finger to scroll.
                hold(&self.slider, false);
                self.slider.set_value(&self.before);
                if self.intent == Intent::Unknown {
                    self.intent = Intent::Scroll;
                }
                self.intent == Intent::Slide
            }
            "input" | "change" => {
                self.filter(event);
                false
            }
            _ => false,
        }
    }

    /// From now on its values count.
    fn slide(&mut self) -> bool {
        hold(&self.slider, false);
        self.intent = Intent::Slide;
        true
    }

    /// Keeps from everybody what does not count.
    fn filter(&self, event: &Event) {
        let is_of_it = event.target().is_some_and(|target| target == *self.slider.unchecked_ref());
        if is_of_it && self.intent != Intent::Slide {
            event.stop_immediate_propagation();
            if self.intent == Intent::Scroll {
                // The slider goes on to follow the finger.
                self.slider.set_value(&self.before);
            }
        }
    }
}

fn tell(slider: &HtmlInputElement, kind: &str) {
    let init = EventInit::new();
    init.set_bubbles(true);
    if let Ok(event) = Event::new_with_event_init_dict(kind, &init) {
        let _ = slider.dispatch_event(&event);
    }
}
