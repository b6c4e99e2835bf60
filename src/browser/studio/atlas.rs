//! Steps of two numbers as a map: the pictures stand in rows and columns, and one leads to the values around it.

use super::subject;
use crate::browser::address::fragment;
use crate::browser::dom::{find, set_attribute, set_style, set_text, within};
use crate::plants;
use crate::play::atlas::{Atlas, Axis};
use crate::play::link;
use crate::play::series::asked_view;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, MouseEvent};

/// On the list of the pictures, as long as one of them leads to the values around it.
const CLOSER: &str = "data-closer";

/// The map that the address asks for.
fn asked() -> Option<Atlas> {
    let fragment = fragment();
    let (view, link) = asked_view(&fragment)?;
    Atlas::read(link).filter(|_| view.key == "steps")
}

/// Puts the pictures into rows and columns, if they are a map.
pub fn dress(list: &Element, days: &Element) {
    let Some(Atlas { axes: [across, down], .. }) = asked() else {
        let _ = list.remove_attribute(CLOSER);
        return;
    };
    let pictures: HtmlElement = within(list, ".pictures");
    let columns = format!("repeat({}, minmax(0, 1fr))", across.values.len());
    set_style(&pictures, "grid-template-columns", &columns);
    set_attribute(&pictures, "data-atlas", "");
    let _ = days.insert_adjacent_html("afterend", include_str!("atlas.html"));
    let plant = link::read(&first(list), plants::all()).scene.plant;
    let told = |Axis { number, values }: &Axis| {
        let [from, to] = [values.first(), values.last()].map(|value| value.copied().unwrap_or(0.0));
        format!("{}, {from} to {to}", number.label(plant))
    };
    let told = format!("Across: {}. Down: {}.", told(&across), told(&down));
    set_text(&within(list, ".axes"), &told);
    show_closer(list);
}

/// The link of the first picture.
fn first(list: &Element) -> String {
    let address = within::<Element>(list, ".picture").get_attribute("href").unwrap_or_default();
    subject::link_of(&address).to_string()
}

fn show_closer(list: &Element) {
    set_attribute(&within(list, ".closer"), "aria-pressed", list.has_attribute(CLOSER).to_string());
}

/// Does what a click within the list is for, if that is a matter of the map's.
pub fn hear(event: &MouseEvent) {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let closest = |selector: &str| target.as_ref()?.closest(selector).ok().flatten();
    let list: Element = find("figure-list");
    if closest(".closer").is_some() {
        let _ = list.toggle_attribute(CLOSER);
        show_closer(&list);
    } else if closest(".wider").is_some() {
        let pictures = list.query_selector_all(".picture").ok();
        let middle = pictures.and_then(|all| all.item(all.length() / 2));
        if let Some(middle) = middle {
            go(&middle.unchecked_into(), 2.0);
        }
    } else if list.has_attribute(CLOSER)
        && !(event.ctrl_key() || event.meta_key())
        && let Some(picture) = closest(".picture")
    {
        event.prevent_default();
        go(&picture, 0.5);
    }
}

/// Goes to the map around a picture's values, so many times as wide.
fn go(picture: &Element, times: f64) {
    let address = picture.get_attribute("href").unwrap_or_default();
    let scene = link::read(subject::link_of(&address), plants::all()).scene;
    if let Some(atlas) = asked() {
        subject::go_to(&format!("steps/{}", atlas.around(&scene, times).write()));
    }
}
