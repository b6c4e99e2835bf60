//! What the page shows: the scene that it would print now, and its mesh.

use crate::browser::address::{fragment, wanted};
use crate::browser::dom::{document, find, set_text, window};
use crate::browser::files;
use crate::plants;
use crate::play::{Scene, link, origin};
use std::cell::Cell;
use wasm_bindgen::prelude::*;
use web_sys::{Element, Event, MutationObserver, MutationObserverInit};

/// The address of what the page shows, which opens anywhere: the page is asked to put into the document what it would
/// print, which is the link and the picture.
pub fn address() -> String {
    if let Ok(event) = Event::new("beforeprint") {
        let _ = window().dispatch_event(&event);
    }
    find::<Element>("printed-link").text_content().unwrap_or_default()
}

/// Has what the page prints say what the plant is made of.
pub fn print_origin() {
    let printed: Element = find("printed-link");
    let address = printed.text_content().unwrap_or_default();
    if !address.contains('~') {
        set_text(&printed, &format!("{address}{}", origin::of_link(link_of(&address))));
    }
}

/// The link of an address, which is the part after its `#`, up to a `~`.
pub fn link_of(address: &str) -> &str {
    whole_link_of(address).split('~').next().unwrap_or_default()
}

/// That with what stands behind it.
pub fn whole_link_of(address: &str) -> &str {
    address.split_once('#').map_or("", |(_, link)| link)
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

thread_local! {
    /// Whether a plant is being made that the address asks for.
    static IS_COMING: Cell<bool> = const { Cell::new(false) };
}

/// What the plant of the address is made of, without its `~`; empty if that is not said.
pub fn origin() -> String {
    let [origin, _] = origin::parts(&wanted());
    origin.trim_start_matches('~').to_string()
}

/// What else the studio is to do with the plant, without its `~`.
pub fn view() -> String {
    let [_, view] = origin::parts(&wanted());
    view.trim_start_matches('~').to_string()
}

/// Says whether the plant of the address is being made.
pub fn is_coming(is_coming: bool) {
    IS_COMING.set(is_coming);
}

/// Has the address say of the plant that is there what it is made of, and of another one nothing.
pub fn mend() {
    let ([origin, rest], link) = (origin::parts(&wanted()), fragment());
    let wished = origin::of_link(&link);
    if !IS_COMING.get()
        && origin != wished
        && let Ok(history) = window().history()
    {
        let address = format!("{link}{wished}{rest}");
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}

/// Shows a scene on the page, by its link, which may say what its plant is made of; what the studio does with it goes on.
pub fn show(link: &str) {
    let said = if link.contains('~') { String::new() } else { origin::of_link(link) };
    let [_, rest] = origin::parts(&wanted());
    let _ = window().location().set_hash(&format!("{link}{said}{rest}"));
}

/// Does something else with the plant that is there, or nothing: `lesson/chance/2`. This makes an entry of the
/// browser's history.
pub fn want(what: &str) {
    let link = fragment();
    let beside = if what.is_empty() { String::new() } else { format!("~{what}") };
    let _ = window().location().set_hash(&format!("{link}{}{beside}", origin::of_link(&link)));
}

/// Shows a scene, by its link, and does something with it: one entry of the browser's history.
pub fn go(link: &str, what: &str) {
    let _ = window().location().set_hash(&format!("{link}{}~{what}", origin::of_link(link)));
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
    files::held(&format!("meshes/{}.txt", wished().plant.key)).unwrap_or_default()
}

/// The address of a link, which opens anywhere.
pub fn address_of(link: &str) -> String {
    let href = window().location().href().unwrap_or_default();
    let page = href.split('#').next().unwrap_or_default();
    let (link, beside) = link.split_at(link.find('~').unwrap_or(link.len()));
    format!("{page}#{link}{}{beside}", origin::of_link(link))
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
