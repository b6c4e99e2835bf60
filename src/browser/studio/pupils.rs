//! What a class gets of the page: parts are left out, and numbers are hidden until the answer is shown. It keeps
//! nobody from reading the address, which holds them all.

use super::subject;
use crate::browser::address::fragment;
use crate::browser::dom::{
    Listener, document, find, on, on_first, set_attribute, set_flag, set_text, window, within,
};
use crate::plants;
use crate::play::classroom::{Class, PARTS, SIMPLE};
use crate::play::link;
use crate::play::parameters::PARAMETERS;
use web_sys::{Element, Event, HtmlElement, KeyboardEvent};

/// What stands in the address before it.
pub const VIEW: &str = "class";

pub struct Pupils {
    note: HtmlElement,
    class: Option<Class>,
    _listeners: [Listener; 2],
}

impl Pupils {
    pub fn new() -> Pupils {
        let caption = document().query_selector(".caption").ok().flatten();
        let caption = caption.expect("a plant has a caption");
        let _ = caption.insert_adjacent_html("afterend", include_str!("pupils.html"));
        let note: HtmlElement = find("pupils");
        let listeners = [
            on(&within::<Element>(&note, "button"), "click", |_: Event| {
                let Some(class) = wanted_class() else { return };
                let other = Class { answers: !class.answers, ..class };
                subject::want(&format!("{VIEW}/{}", other.write()));
            }),
            // The page's key would copy the link that has the numbers.
            on_first(&window(), "keydown", |event: KeyboardEvent| {
                let secret = wanted_class().is_some_and(|class| !class.secrets().is_empty());
                if secret && event.key() == "c" && !event.ctrl_key() && !event.meta_key() {
                    event.stop_propagation();
                }
            }),
        ];
        subject::on_change(|| super::with(|studio| studio.pupils.tell()));
        Pupils { note, class: None, _listeners: listeners }
    }

    /// Whether the page is one for a class.
    pub fn are_there(&self) -> bool {
        self.class.is_some()
    }

    /// Whether the simple sliders are for them.
    pub fn has_simple(&self) -> bool {
        self.class.as_ref().is_some_and(|class| class.has(SIMPLE))
    }

    /// Whether a number is hidden now.
    pub fn hide(&self, key: &str) -> bool {
        self.class.as_ref().is_some_and(|class| class.secrets().contains(&key))
    }

    /// Agrees with the address.
    pub fn follow(&mut self, said: Option<&str>) {
        let read = said.map(Class::read);
        let (class, left_out) = read.unzip();
        if class == self.class {
            return;
        }
        if let Some(left_out) = left_out.filter(|left_out| !left_out.is_empty()) {
            let left_out = left_out.join(", ");
            super::files::tell(&format!("Unknown to this playground and left out: {left_out}."));
        }
        self.class = class;
        let root = document().document_element().expect("a document has a root");
        let mut without = Vec::new();
        if let Some(class) = &self.class {
            without.extend(PARTS.iter().map(|part| part.word).filter(|part| !class.has(part)));
            if class.only.is_some() {
                without.push("more");
            }
            let studio = ["charts", "take"].iter().any(|part| class.has(part));
            let of_panel = ["plants", "individual", "show", "recipe", SIMPLE];
            if class.only.is_some() && !studio {
                without.push("studio");
                if !of_panel.iter().any(|part| class.has(part)) {
                    without.push("panel");
                }
            }
        }
        set_attribute(&root, "data-without", without.join(" "));
        let secrets = self.class.as_ref().map_or(&[][..], Class::secrets);
        set_flag(&root, "data-mystery", !secrets.is_empty());
        for number in PARAMETERS {
            mask(number.key, secrets.contains(&number.key));
        }
        self.tell();
    }

    /// Says what is hidden, or what it is.
    fn tell(&self) {
        let class = self.class.as_ref().filter(|class| !class.hide.is_empty());
        set_flag(&self.note, "hidden", class.is_none());
        let Some(class) = class else { return };
        let scene = link::read(&fragment(), plants::all()).scene;
        let told = match class.answers {
            true => format!("The answer: {}.", class.told(&scene).join("; ")),
            false => format!("Hidden here: {}.", class.names(&scene).join("; ")),
        };
        set_text(&within(&self.note, "p"), &told);
        let word = if class.answers { "Hide it again" } else { "Show the answer" };
        set_text(&within(&self.note, "button"), word);
    }
}

/// Hides a number of the recipe from eyes, hands and screen readers, or shows it again.
fn mask(key: &str, secret: bool) {
    let input = document().get_element_by_id(&format!("parameter-{key}"));
    let Some(row) = input.and_then(|input| input.closest(".parameter").ok().flatten()) else {
        return;
    };
    if row.has_attribute("data-secret") == secret {
        return;
    }
    set_flag(&row, "data-secret", secret);
    if let Ok(inputs) = row.query_selector_all("input, select") {
        for k in 0..inputs.length() {
            if let Some(input) = inputs.get(k) {
                set_flag(wasm_bindgen::JsCast::unchecked_ref(&input), "disabled", secret);
            }
        }
    }
    match row.query_selector(".secret").ok().flatten() {
        Some(word) => word.remove(),
        None => {
            let word = "<p class=secret>Hidden</p>";
            let _ = row.insert_adjacent_html("beforeend", word);
        }
    }
}

/// What the address says for a class.
fn wanted_class() -> Option<Class> {
    let wanted = subject::view();
    let of_it = wanted.strip_prefix(VIEW)?;
    Some(Class::read(of_it.trim_start_matches('/')).0)
}

/// What stands behind the link for a class, with its `~`; empty without it.
pub fn beside() -> String {
    match wanted_class() {
        Some(class) => format!("~{VIEW}/{}", class.write()),
        None => String::new(),
    }
}
