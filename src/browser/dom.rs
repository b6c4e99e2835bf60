//! The document: finding elements, writing to them only what changed, and listening.

// The boot bundle needs little of it.
#![cfg_attr(not(feature = "draw"), allow(dead_code))]

use wasm_bindgen::convert::FromWasmAbi;
use wasm_bindgen::prelude::*;
use web_sys::{
    Document, Element, EventTarget, HtmlElement, HtmlOptionElement, HtmlSelectElement, Window,
};

pub fn window() -> Window {
    web_sys::window().expect("a page has a window")
}

pub fn document() -> Document {
    window().document().expect("a window has a document")
}

/// The element of an id in our own HTML.
pub fn find<T: JsCast>(id: &str) -> T {
    let element = document().get_element_by_id(id);
    let element = element.unwrap_or_else(|| panic!("index.html has no #{id}"));
    element.dyn_into().unwrap_or_else(|_| panic!("#{id} in index.html is of another kind"))
}

/// The first descendant that a selector finds in a template of ours.
pub fn within<T: JsCast>(parent: &Element, selector: &str) -> T {
    let found = parent.query_selector(selector).ok().flatten();
    let found = found.unwrap_or_else(|| panic!("index.html has no {selector} where it belongs"));
    found.dyn_into().unwrap_or_else(|_| panic!("{selector} in index.html is of another kind"))
}

/// A copy of the only child of a `<template>`.
pub fn copy_of_template(id: &str) -> HtmlElement {
    let template: web_sys::HtmlTemplateElement = find(id);
    let child = template.content().first_element_child();
    let copy = child.and_then(|c| c.clone_node_with_deep(true).ok());
    copy.and_then(|c| c.dyn_into().ok()).unwrap_or_else(|| panic!("template #{id} is empty"))
}

/// Writes a text, unless it is there already, be it in another language (`interpreter`).
pub fn set_text(element: &Element, text: &str) {
    let there = element.text_content().unwrap_or_default();
    let is_said =
        || element.get_attribute("data-said") == Some([there.as_str(), "\n", text].concat());
    if there != text && !is_said() {
        element.set_text_content(Some(text));
    }
}

pub fn set_attribute(element: &Element, name: &str, value: impl AsRef<str>) {
    set_attribute_to(element, name, value.as_ref());
}

// Once, whatever holds the text: bytes count.
#[inline(never)]
fn set_attribute_to(element: &Element, name: &str, value: &str) {
    if element.get_attribute(name).as_deref() != Some(value) {
        // Fails only for names that are none.
        let _ = element.set_attribute(name, value);
    }
}

/// Styles an element. The policy of the page refuses styles in an attribute.
pub fn set_style(element: &HtmlElement, property: &str, value: &str) {
    // Fails only for names that are none.
    let _ = element.style().set_property(property, value);
}

/// Adds an option to a select.
pub fn offer(select: &HtmlSelectElement, value: &str, text: &str) {
    if let Ok(option) = HtmlOptionElement::new_with_text_and_value(text, value) {
        let _ = select.append_child(&option);
    }
}

/// Sets or takes away an attribute without a value.
pub fn set_flag(element: &Element, name: &str, on: bool) {
    let _ = element.toggle_attribute_with_force(name, on);
}

/// Marks a picture with `data-missing` when its file is not there.
pub fn mark_when_missing(picture: &Element) -> Listener {
    let missing = picture.clone();
    on(picture, "error", move |_: web_sys::Event| set_flag(&missing, "data-missing", true))
}

/// Something that listens until it is dropped.
pub struct Listener {
    target: EventTarget,
    kind: &'static str,
    /// Whether it hears before the elements within do.
    is_first: bool,
    callback: JsValue,
    /// Keeps the Rust side of `callback` alive.
    _closure: Box<dyn std::any::Any>,
}

/// What an object of the browser has under a name; undefined where it has nothing.
#[inline(never)]
pub fn member(object: &JsValue, name: &str) -> JsValue {
    js_sys::Reflect::get(object, &name.into()).unwrap_or_default()
}

/// Listens to events of a kind.
pub fn on<E: FromWasmAbi + 'static>(
    target: &EventTarget,
    kind: &'static str,
    hear: impl FnMut(E) + 'static,
) -> Listener {
    listen(target, kind, false, hear)
}

/// Listens to events of a kind before the elements within the target do.
pub fn on_first<E: FromWasmAbi + 'static>(
    target: &EventTarget,
    kind: &'static str,
    hear: impl FnMut(E) + 'static,
) -> Listener {
    listen(target, kind, true, hear)
}

fn listen<E: FromWasmAbi + 'static>(
    target: &EventTarget,
    kind: &'static str,
    is_first: bool,
    hear: impl FnMut(E) + 'static,
) -> Listener {
    let closure = Closure::<dyn FnMut(E)>::new(hear);
    let callback = closure.as_ref().clone();
    begin(target.clone(), kind, is_first, callback, Box::new(closure))
}

/// All of it that is the same for all kinds of events: bytes count.
#[inline(never)]
fn begin(
    target: EventTarget,
    kind: &'static str,
    is_first: bool,
    callback: JsValue,
    closure: Box<dyn std::any::Any>,
) -> Listener {
    let function = callback.unchecked_ref();
    target
        .add_event_listener_with_callback_and_bool(kind, function, is_first)
        .expect("any element can be listened to");
    Listener { target, kind, is_first, callback, _closure: closure }
}

impl Drop for Listener {
    fn drop(&mut self) {
        let callback = self.callback.unchecked_ref();
        let _ = self.target.remove_event_listener_with_callback_and_bool(
            self.kind,
            callback,
            self.is_first,
        );
    }
}
