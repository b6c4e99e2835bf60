//! What the page shows: the scene that it would print now, and its mesh.

use crate::browser::address::{fragment, wanted};
use crate::browser::dom::{document, find, window};
use crate::browser::files;
use crate::plants;
use crate::play::{Scene, link};
use wasm_bindgen::prelude::*;
use web_sys::{Element, Event, MutationObserver, MutationObserverInit};

/// The address of what the page shows, with its link and the words of its body if that is by rule: the page is asked
/// to put into the document what it would print, which is the link and the picture.
pub fn address() -> String {
    if let Ok(event) = Event::new("beforeprint") {
        let _ = window().dispatch_event(&event);
    }
    let address = find::<Element>("printed-link").text_content().unwrap_or_default();
    let shape = shape_of(link_of(&address));
    address + &shape
}

/// The link of an address, which is the part after its `#`, up to a `~`.
pub fn link_of(address: &str) -> &str {
    let link = address.split_once('#').map_or("", |(_, link)| link);
    link.split('~').next().unwrap_or_default()
}

/// The scene of what the page shows.
pub fn scene() -> Scene {
    link::read(link_of(&address()), plants::all()).scene
}

/// The scene of the address: the same where the page rests, and it need not print for it.
pub fn wished() -> Scene {
    link::read(&fragment(), plants::all()).scene
}

/// What the page showed before its last change of more than day and view, as it would be seen now.
pub fn before() -> Option<Scene> {
    let now = scene();
    let link = find::<Element>("printed-link").get_attribute("data-before");
    let before = link::read(&link.filter(|link| !link.is_empty())?, plants::all()).scene;
    Some(match before.plant.key == now.plant.key {
        true => Scene { day: now.day.min(before.recipe.days), orbit: now.orbit, ..before },
        false => before,
    })
}

/// Of what stands behind the `~` the words of a body by rule, as `~leaf=lobes:7`, and all else.
fn parts() -> [String; 2] {
    let mut parts = [String::new(), String::new()];
    for part in wanted().split('~').filter(|part| !part.is_empty()) {
        let is_shape = SHAPES.iter().any(|kind| part.starts_with(kind));
        let part_of = &mut parts[usize::from(!is_shape)];
        *part_of = format!("{part_of}~{part}");
    }
    parts
}

/// With what the words of a body by rule begin.
const SHAPES: [&str; 3] = ["leaf=", "tree=", "flower="];

/// The words of the body by rule that the address has, without their `~`; empty without them.
pub fn shape() -> String {
    parts()[0].trim_start_matches('~').to_string()
}

/// What else the studio is to do with the plant, without its `~`.
pub fn view() -> String {
    parts()[1].trim_start_matches('~').to_string()
}

/// The words of its body, with their `~`, if a link is of the plant that the address has them for.
pub fn shape_of(link: &str) -> String {
    let key = |link: &str| link.trim_start_matches('#').split('?').next().map(String::from);
    let is_own = link.trim_start_matches('#').starts_with(plants::OWN);
    match is_own && key(link) == key(&fragment()) {
        true => parts()[0].clone(),
        false => String::new(),
    }
}

/// Shows a scene on the page, by its link; what the studio does with it goes on.
pub fn show(link: &str) {
    let _ = window().location().set_hash(&format!("{link}{}{}", shape_of(link), parts()[1]));
}

/// Takes the words of a body by rule out of the address of another plant.
pub fn forget_shape() {
    let [shape, rest] = parts();
    let link = fragment();
    if !shape.is_empty()
        && shape_of(&link).is_empty()
        && let Ok(history) = window().history()
    {
        let address = format!("#{}{rest}", link.trim_start_matches('#'));
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

/// Does something else with the plant that is there, or nothing: `lesson/chance/2`. This makes an entry of the
/// browser's history.
pub fn want(what: &str) {
    let link = fragment();
    let beside = if what.is_empty() { String::new() } else { format!("~{what}") };
    let _ = window().location().set_hash(&format!("{link}{}{beside}", shape_of(&link)));
}

/// Shows a scene, by its link, and does something with it: one entry of the browser's history.
pub fn go(link: &str, what: &str) {
    let _ = window().location().set_hash(&format!("{link}{}~{what}", shape_of(link)));
}

/// Shows several plants, by the fragment of their address.
pub fn go_to(fragment: &str) {
    let _ = window().location().set_hash(fragment);
}

/// The fingerprint of the day on the screen.
pub fn fingerprint() -> String {
    let root = document().document_element();
    root.and_then(|root| root.get_attribute("data-fingerprint")).unwrap_or_default()
}

/// The text of a plant's mesh, as the page has it at hand.
pub async fn mesh_of(scene: &Scene) -> Result<String, String> {
    files::read_mesh(scene.plant.body.mesh.name).await
}

/// The text of the plant that the page shows, if it is one of the visitor's own; else none.
pub fn own() -> String {
    files::held(&format!("meshes/{}.txt", scene().plant.key)).unwrap_or_default()
}

/// The address of a link, and of the words of its body if that is by rule.
pub fn address_of(link: &str) -> String {
    let href = window().location().href().unwrap_or_default();
    let page = href.split('#').next().unwrap_or_default();
    let (link, beside) = link.split_at(link.find('~').unwrap_or(link.len()));
    format!("{page}#{link}{}{beside}", shape_of(link))
}

/// Does something whenever an attribute changes of what is in an element, as long as that is there.
pub fn on_attribute(of: &Element, name: &str, act: impl FnMut() + 'static) {
    let changed = Closure::<dyn FnMut()>::new(act);
    if let Ok(observer) = MutationObserver::new(changed.as_ref().unchecked_ref()) {
        let which = MutationObserverInit::new();
        which.set_attributes(true);
        which.set_subtree(true);
        which.set_attribute_filter(&js_sys::Array::of1(&name.into()));
        let _ = observer.observe_with_options(of, &which);
    }
    changed.forget();
}

/// Does something whenever the page shows something else, as long as it is there.
pub fn on_change(act: impl FnMut() + 'static) {
    let changed = Closure::<dyn FnMut()>::new(act);
    if let Ok(observer) = MutationObserver::new(changed.as_ref().unchecked_ref()) {
        let root = document().document_element().expect("a document has a root");
        let which = MutationObserverInit::new();
        which.set_attributes(true);
        let names = ["data-day", "data-state", "data-plant", "data-individual", "data-cells"];
        let names = names.into_iter().map(JsValue::from).collect::<js_sys::Array>();
        which.set_attribute_filter(&names);
        let _ = observer.observe_with_options(&root, &which);
    }
    changed.forget();
}
