//! What stands below the pictures of a series: buttons that turn them all, for who cannot drag, and, where plants are
//! compared, one more of them with another number.

use super::{atlas, subject};
use crate::browser::address::{fragment, wanted};
use crate::browser::dom::{document, find, offer, on, set_attribute, set_text, window, within};
use crate::plants;
use crate::play::atlas::rounded;
use crate::play::link;
use crate::play::parameters::{PARAMETERS, Parameter};
use crate::play::series::{MOST_PICTURES, asked_view, turned};
use crate::play::typed::plain;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    Element, Event, HtmlInputElement, HtmlSelectElement, KeyboardEvent, KeyboardEventInit,
    MouseEvent,
};

/// Milliseconds from a turn to the address that says it.
const TURN_RESTS_MS: i32 = 400;

/// The buttons beside the page's plant, and the keys on a picture that do the same.
const KEYS: [(&str, &str); 6] = [
    ("turn-left", "ArrowLeft"),
    ("turn-right", "ArrowRight"),
    ("turn-up", "ArrowUp"),
    ("turn-down", "ArrowDown"),
    ("nearer", "+"),
    ("farther", "-"),
];

/// Listens to what will stand below the pictures, for as long as the page is there.
pub fn listen() {
    let list: Element = find("figure-list");
    std::mem::forget(on(&list, "click", |event: MouseEvent| {
        atlas::hear(&event);
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let button = target.and_then(|target| target.closest("[data-key]").ok().flatten());
        if let Some(key) = button.and_then(|button| button.get_attribute("data-key")) {
            press(&key);
        }
    }));
    std::mem::forget(on(&list, "change", |_: Event| propose()));
    std::mem::forget(on(&list, "submit", |event: Event| {
        event.prevent_default();
        if let Err(why) = add() {
            set_text(&within(&find("figure-list"), ".one-more .refusal"), &why);
        }
    }));
}

/// Puts it there for a view, unless it stands there.
pub fn dress(view: &str) {
    let list: Element = find("figure-list");
    if matches!(list.query_selector(".looks"), Ok(Some(_))) {
        return;
    }
    let days: Element = within(&list, ".days");
    if view == "compare" {
        let _ = days.insert_adjacent_html("afterend", include_str!("pictures.html"));
        let number: HtmlSelectElement = within(&list, ".one-more .number");
        let plant = last().plant;
        for parameter in PARAMETERS.iter().filter(|p| p.is_for(plant) && p.is_number()) {
            offer(&number, parameter.key, &parameter.label(plant));
        }
        propose();
    }
    atlas::dress(&list, &days);
    let plate: Element = document().document_element().expect("a document has a root");
    let looks: Element = within(&plate, ".turns");
    let Ok(looks) = looks.clone_node_with_deep(true) else { return };
    let looks: Element = looks.unchecked_into();
    looks.set_class_name("row looks");
    for (id, key) in KEYS {
        let button: Element = within(&looks, &format!("#{id}"));
        let _ = button.remove_attribute("id");
        set_attribute(&button, "data-key", key);
    }
    let _ = days.insert_adjacent_element("afterend", &looks);
}

/// Presses a key on the first picture.
fn press(key: &str) {
    let init = KeyboardEventInit::new();
    init.set_key(key);
    init.set_bubbles(true);
    if let Ok(event) = KeyboardEvent::new_with_keyboard_event_init_dict("keydown", &init) {
        let _ = within::<Element>(&find("figure-list"), ".picture").dispatch_event(&event);
    }
}

/// Keeps the address in step with the hand that turns the pictures, once it rests: browsers let nobody write it at each
/// frame.
pub fn follow_turns() {
    let waits = std::rc::Rc::new(std::cell::Cell::new(false));
    subject::on_attribute(&find::<Element>("figure-list"), "href", move || {
        if !waits.replace(true) {
            let waits = waits.clone();
            super::presenter::after(TURN_RESTS_MS, move || {
                waits.set(false);
                write_turns();
            });
        }
    });
}

fn write_turns() {
    let hash = fragment();
    let Some((view, asked)) = asked_view(&hash).filter(|(view, _)| !view.is_of_figures()) else {
        return;
    };
    let now = format!("#{}/{}", view.key, turned(asked, &links()));
    if now != hash
        && let Ok(history) = window().history()
    {
        let address = format!("{now}{}", wanted());
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

/// The links of the pictures.
fn links() -> Vec<String> {
    let pictures = find::<Element>("figure-list").query_selector_all(".picture").ok();
    let pictures = pictures.into_iter().flat_map(|all| (0..all.length()).map(move |k| all.item(k)));
    let addresses = pictures.flatten().filter_map(|picture| {
        let picture: Element = picture.unchecked_into();
        picture.get_attribute("href")
    });
    addresses.map(|address| subject::link_of(&address).to_string()).collect()
}

/// The scene of the last picture.
fn last() -> crate::play::Scene {
    link::read(&links().pop().unwrap_or_default(), plants::all()).scene
}

fn chosen() -> Option<&'static Parameter> {
    let number: HtmlSelectElement = within(&find("figure-list"), ".one-more .number");
    Parameter::of_key(&number.value())
}

/// Writes the number of the last picture into the field, to be changed.
fn propose() {
    if let Some(number) = chosen() {
        let field: HtmlInputElement = within(&find("figure-list"), ".one-more .value");
        field.set_value(&rounded(number, number.get(&last())).to_string());
    }
}

/// Shows the pictures with one more.
fn add() -> Result<(), String> {
    let number = chosen().ok_or("No number is chosen.")?;
    let field: HtmlInputElement = within(&find("figure-list"), ".one-more .value");
    let mut scene = last();
    let name = number.label(scene.plant);
    let typed = plain(&field.value().trim().replace(',', "."));
    let value = typed.ok_or_else(|| format!("{name}: that is no number."))?;
    if value == number.get(&scene) {
        return Err(format!("{name} is {value} in the last picture, too: type another number."));
    }
    number.set(&mut scene, value).map_err(|why| format!("{name} {value}: {why}."))?;
    let mut links = links();
    links.push(link::write(&scene));
    if links.len() > MOST_PICTURES {
        return Err(format!("There are {MOST_PICTURES} pictures at most."));
    }
    subject::go_to(&format!("compare/{}", links.join("/")));
    Ok(())
}
