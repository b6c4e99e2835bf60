//! The sheet of controls at the bottom of a phone: drawn up and down by its handle, with a finger or a
//! click. On wide screens all of it is always in sight.

use super::dom::{Listener, find, on, set_attribute, set_flag};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlElement, PointerEvent};

/// Pixels of a pull; less is a click.
const PULL_PX: i32 = 8;

pub struct Sheet {
    _listeners: [Listener; 5],
}

/// Where the handle was taken, and how high the sheet was then.
#[derive(Clone, Copy)]
struct Pull {
    from_px: i32,
    height_px: i32,
    is_pulled: bool,
}

impl Sheet {
    pub fn new() -> Sheet {
        let (handle, panel): (HtmlElement, HtmlElement) = (find("sheet"), find("panel"));
        let pull: Rc<Cell<Option<Pull>>> = Rc::default();
        let kinds = ["pointerdown", "pointermove", "pointerup", "pointercancel", "click"];
        let listeners = kinds.map(|kind| {
            let (pull, panel, catcher) = (pull.clone(), panel.clone(), handle.clone());
            on(&handle, kind, move |event: Event| {
                pull.set(hear(pull.get(), kind, event.unchecked_ref(), &panel, &catcher));
            })
        });
        Sheet { _listeners: listeners }
    }
}

/// Does what the hand does; the pull from then on.
fn hear(
    pull: Option<Pull>,
    kind: &str,
    event: &PointerEvent,
    panel: &HtmlElement,
    handle: &HtmlElement,
) -> Option<Pull> {
    let is_pulled = pull.is_some_and(|pull| pull.is_pulled);
    let up_px = pull.map_or(0, |pull| pull.from_px - event.client_y());
    match kind {
        "pointerdown" => {
            // Fails only for pointers that are gone already.
            let _ = handle.set_pointer_capture(event.pointer_id());
            let (from_px, height_px) = (event.client_y(), panel.offset_height());
            return Some(Pull { from_px, height_px, is_pulled: false });
        }
        "pointermove" if is_pulled || up_px.abs() > PULL_PX => {
            let pull = pull?;
            set_height(panel, Some(pull.height_px + up_px));
            return Some(Pull { is_pulled: true, ..pull });
        }
        "pointerup" if is_pulled => {
            set_height(panel, None);
            open(panel, up_px > 0);
        }
        "pointercancel" => {
            set_height(panel, None);
            return None;
        }
        // The click that ends a pull is none, but one of a key is.
        "click" => {
            if !is_pulled || event.detail() == 0 {
                open(panel, !panel.has_attribute("data-open"));
            }
            return None;
        }
        _ => {}
    }
    pull
}

/// While it is pulled the sheet is as high as the hand wants it.
fn set_height(panel: &HtmlElement, px: Option<i32>) {
    let _ = match px {
        Some(px) => panel.style().set_property("height", &format!("{}px", px.max(0))),
        None => panel.style().remove_property("height").map(|_| ()),
    };
    set_flag(panel, "data-pulled", px.is_some());
}

fn open(panel: &HtmlElement, opens: bool) {
    set_flag(panel, "data-open", opens);
    set_attribute(&find::<Element>("sheet"), "aria-expanded", opens.to_string());
    if !opens {
        // What looks out is the top of the list.
        panel.set_scroll_top(0);
    }
}
