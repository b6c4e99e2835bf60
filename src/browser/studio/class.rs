//! The dialog of a teacher: presenting, simple sliders, a page on paper, and links that leave out parts of the
//! page or hide numbers that are to be found out.

use super::subject::{self, link_of};
use super::{leaflet, picture, presenter, pupils, simple, with};
use crate::browser::address::UI;
use crate::browser::dom::{Listener, document, find, on, set_flag, set_text, window, within};
use crate::plants;
use crate::play::classroom::{Class, PARTS, SIMPLE, changed};
use crate::play::link;
use crate::play::parameters::PARAMETERS;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    Element, Event, HtmlDialogElement, HtmlInputElement, HtmlSelectElement, HtmlTextAreaElement,
};

pub struct ClassDialog {
    dialog: HtmlDialogElement,
    /// The address that the page would print.
    address: String,
    _listeners: Vec<Listener>,
}

impl ClassDialog {
    pub fn new() -> ClassDialog {
        let body = document().body().expect("a page has a body");
        let _ = body.insert_adjacent_html("beforeend", include_str!("class.html"));
        let dialog: HtmlDialogElement = find("class-dialog");
        let parts: Element = within(&dialog, ".parts");
        for part in &PARTS {
            let ticked = part.word != SIMPLE;
            tick(&parts, "data-part", part.word, part.name, ticked);
        }
        let listeners = vec![
            on(&dialog, "click", |event: Event| {
                let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
                let Some(target) = target else { return };
                if let Some(what) = target.get_attribute("data-do") {
                    act(&what);
                }
                if let Some(which) = target.get_attribute("data-copy") {
                    copy(&which);
                }
            }),
            on(&dialog, "change", |event: Event| {
                let target = event.target().and_then(|t| t.dyn_into::<HtmlInputElement>().ok());
                if let Some(key) = target.filter(|target| target.class_name() == "has-key") {
                    presenter::has_key(key.checked());
                }
                with(|studio| studio.class.write());
            }),
        ];
        ClassDialog { dialog, address: String::new(), _listeners: listeners }
    }

    /// Opens it on what the page shows.
    pub fn open(&mut self) {
        let before = std::mem::replace(&mut self.address, subject::address());
        let scene = link::read(link_of(&self.address), plants::all()).scene;
        let told =
            format!("{}, individual {}, day {}", scene.plant.name, scene.individual, scene.day);
        set_text(&within(&self.dialog, ".subject"), &told);
        // What was ticked stays for as long as the plant does.
        if before != self.address {
            let numbers: Element = within(&self.dialog, ".numbers");
            let legend: Element = within(&numbers, "legend");
            numbers.replace_children_with_node_1(&legend);
            let changed = changed(&scene);
            let (first, others): (Vec<_>, Vec<_>) = PARAMETERS
                .iter()
                .filter(|number| number.is_for(scene.plant))
                .partition(|number| changed.contains(&number.key));
            for number in first.into_iter().chain(others) {
                let mut name = number.label(scene.plant);
                if changed.contains(&number.key) {
                    name += ", changed here";
                }
                tick(&numbers, "data-number", number.key, &name, false);
            }
        }
        self.write();
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
    }

    /// What is ticked.
    fn class(&self) -> Class {
        let all_parts = PARTS
            .iter()
            .all(|part| self.is_ticked("data-part", part.word) == (part.word != SIMPLE));
        let parts = PARTS.iter().filter(|part| self.is_ticked("data-part", part.word));
        let numbers = PARAMETERS.iter().filter(|n| self.is_ticked("data-number", n.key));
        Class {
            only: (!all_parts).then(|| parts.map(|part| part.word).collect()),
            hide: numbers.map(|number| number.key).collect(),
            answers: false,
        }
    }

    fn is_ticked(&self, kind: &str, key: &str) -> bool {
        let found = self.dialog.query_selector(&format!("[{kind}={key}]")).ok().flatten();
        found.is_some_and(|found| found.unchecked_into::<HtmlInputElement>().checked())
    }

    /// Writes the links for what is ticked.
    fn write(&self) {
        let class = self.class();
        let for_students = with_class(&self.address, &class);
        let for_teacher = with_class(&self.address, &Class { answers: true, ..class.clone() });
        let scene = link::read(link_of(&self.address), plants::all()).scene;
        let framed = match &*within::<HtmlSelectElement>(&self.dialog, ".ui").value() {
            "full" => for_students.clone(),
            // There are no parts then that could be left out, and no numbers that could be hidden.
            ui => format!("{}{UI}{ui}", self.address),
        };
        let embed = format!(
            "<iframe src=\"{}\" title=\"{}\" width=\"800\" height=\"600\" loading=\"lazy\" allow=\"fullscreen; clipboard-write\"></iframe>",
            framed.replace('&', "&amp;"),
            scene.plant.name
        );
        for (part, text) in
            [(".link", &for_students), (".teacher", &for_teacher), (".embed", &embed)]
        {
            within::<HtmlTextAreaElement>(&self.dialog, part).set_value(text);
        }
        set_flag(&within(&self.dialog, ".for-teacher"), "hidden", class.hide.is_empty());
        picture::show_qr(&within(&self.dialog, ".qr"), &for_students);
        set_text(&within(&self.dialog, ".said"), "");
    }
}

fn with_class(address: &str, class: &Class) -> String {
    match class.write() {
        said if said.is_empty() => address.to_string(),
        said => format!("{address}~{}/{said}", pupils::VIEW),
    }
}

/// Does what a button is for, with the dialog out of the way.
fn act(what: &str) {
    let mut page = None;
    with(|studio| {
        let dialog = &studio.class;
        dialog.dialog.close();
        let class = dialog.class();
        page = Some((dialog.address.clone(), with_class(&dialog.address, &class), class));
    });
    match (what, page) {
        ("present", _) => presenter::open(),
        ("simple", _) => subject::want(simple::VIEW),
        ("print", Some((address, for_students, class))) => {
            leaflet::print(link_of(&address), &for_students, &class.hide);
        }
        _ => {}
    }
}

/// Copies one of the texts, or marks it where the browser does not allow that.
fn copy(which: &str) {
    let dialog: Element = find("class-dialog");
    let area: HtmlTextAreaElement = within(&dialog, which);
    area.select();
    spawn_local(async move {
        let clipboard = window().navigator().clipboard();
        // Pages without https have no clipboard.
        let copied = !clipboard.is_undefined()
            && JsFuture::from(clipboard.write_text(&area.value())).await.is_ok();
        let said = if copied { "Copied." } else { "It is marked: copy it with Ctrl C." };
        set_text(&within(&dialog, ".said"), said);
    });
}

/// Adds something to tick.
fn tick(list: &Element, kind: &str, key: &str, name: &str, ticked: bool) {
    let checked = if ticked { " checked" } else { "" };
    let html =
        format!("<label class=tick><input type=checkbox {kind}={key}{checked}> {name}</label>");
    let _ = list.insert_adjacent_html("beforeend", &html);
}
