//! The document: finding elements, writing to them only what changed, and listening.

// The boot bundle needs little of it.
#![cfg_attr(not(feature = "draw"), allow(dead_code))]

use std::fmt::Display;
use wasm_bindgen::convert::FromWasmAbi;
use wasm_bindgen::prelude::*;
use web_sys::{
    Document, Element, EventTarget, HtmlElement, HtmlInputElement, HtmlOptionElement,
    HtmlSelectElement, Window,
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

pub fn set_text(element: &Element, text: &str) {
    if element.text_content().as_deref() != Some(text) {
        element.set_text_content(Some(text));
    }
}

pub fn set_attribute(element: &Element, name: &str, value: impl Display) {
    let value = value.to_string();
    if element.get_attribute(name).as_deref() != Some(&value) {
        // Fails only for names that are none.
        let _ = element.set_attribute(name, &value);
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

/// Sets the value of an input, unless the visitor is typing in it (see `watch_typing`).
pub fn set_value(input: &HtmlInputElement, value: impl Display) {
    let value = value.to_string();
    if input.value() != value && !input.has_attribute("data-typing") {
        input.set_value(&value);
    }
}

/// Marks a number field while the visitor types in it.
pub fn watch_typing(input: &HtmlInputElement) -> [Listener; 2] {
    let (begun, ended) = (input.clone(), input.clone());
    [
        on(input, "input", move |_: web_sys::Event| set_flag(&begun, "data-typing", true)),
        on(input, "blur", move |_: web_sys::Event| set_flag(&ended, "data-typing", false)),
    ]
}

/// The number in a field whose typing is done; not a number if there is none.
pub fn typed(input: &HtmlInputElement) -> f64 {
    set_flag(input, "data-typing", false);
    input.value_as_number()
}

/// Tells at a field why what was put in it cannot be, if so.
pub fn show_refusal(input: &Element, place: &Element, why: Option<&str>) {
    set_attribute(input, "aria-invalid", why.is_some());
    set_text(place, why.unwrap_or_default());
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
    callback: JsValue,
    /// Keeps the Rust side of `callback` alive.
    _closure: Box<dyn std::any::Any>,
}

/// Listens to events of a kind.
pub fn on<E: FromWasmAbi + 'static>(
    target: &EventTarget,
    kind: &'static str,
    hear: impl FnMut(E) + 'static,
) -> Listener {
    let closure = Closure::<dyn FnMut(E)>::new(hear);
    let callback = closure.as_ref().clone();
    target
        .add_event_listener_with_callback(kind, callback.unchecked_ref())
        .expect("any element can be listened to");
    Listener { target: target.clone(), kind, callback, _closure: Box::new(closure) }
}

impl Drop for Listener {
    fn drop(&mut self) {
        let callback = self.callback.unchecked_ref();
        let _ = self.target.remove_event_listener_with_callback(self.kind, callback);
    }
}
