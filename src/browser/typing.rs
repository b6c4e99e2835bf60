//! Fields in which numbers are typed. They are fields of text: those for numbers take "6,5" for 65 where
//! the browser does not speak German.

use super::dom::{Listener, on, set_attribute, set_flag, set_text};
use crate::play::typed;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlInputElement, KeyboardEvent};

/// Marks a field in which something is typed that does not count yet.
const TYPING: &str = "data-typing";

/// Listens to a field of numbers, of whole ones if `step` is whole: arrow keys go so far. `take` gets
/// what was typed, or not a number.
pub fn watch(field: &HtmlInputElement, step: f64, take: impl Fn(f64) + 'static) -> [Listener; 4] {
    let field = Rc::new(Field { input: field.clone(), step, take: Box::new(take) });
    ["input", "blur", "change", "keydown"].map(|kind| {
        let heard = field.clone();
        on(&field.input, kind, move |event: Event| heard.hear(kind, &event))
    })
}

struct Field {
    input: HtmlInputElement,
    step: f64,
    take: Box<dyn Fn(f64)>,
}

impl Field {
    fn hear(&self, kind: &str, event: &Event) {
        if kind != "keydown" {
            hold(&self.input, kind == "input");
        }
        match kind {
            "change" => (self.take)(self.number()),
            "keydown" => {
                let by = match event.unchecked_ref::<KeyboardEvent>().key().as_str() {
                    "ArrowUp" => self.step,
                    "ArrowDown" => -self.step,
                    _ => return,
                };
                event.prevent_default();
                hold(&self.input, false);
                // Without the digits that come from rounding.
                (self.take)(((self.number() + by) * 1e6).round() / 1e6);
            }
            _ => {}
        }
    }

    fn number(&self) -> f64 {
        typed::number(&self.input.value(), self.step.fract() == 0.0)
    }
}

/// Keeps a field or a slider as it is, whatever its value is set to, or no longer.
pub fn hold(input: &HtmlInputElement, holds: bool) {
    set_flag(input, TYPING, holds);
}

/// Sets the value of an input, unless the visitor is typing in it or is to correct what was refused.
pub fn set_value(input: &HtmlInputElement, value: &str) {
    let is_refused = input.get_attribute("aria-invalid").as_deref() == Some("true");
    if input.value() != value && !input.has_attribute(TYPING) && !is_refused {
        input.set_value(value);
    }
}

/// Shows the number of a field, and in the place for it why what was put in cannot be, if so.
pub fn show(field: &HtmlInputElement, value: &str, place: &Element, refusal: Option<&str>) {
    set_attribute(field, "aria-invalid", refusal.is_some().to_string());
    set_text(place, refusal.unwrap_or_default());
    set_value(field, value);
}
