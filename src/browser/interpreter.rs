//! The interpreter: says what the page says in another language. It is a bundle of its own, which stands beside the
//! page and hears all that is written into the document, so that the page knows English alone and who reads that
//! loads none of it. Which language it is, the `lang` of the `<html>` element says from then on.

use super::boot::{CHOSEN, chosen_language};
use super::dom::{document, find, on, set_attribute, window};
use super::files;
use crate::play::phrasebook::{Numbers, PHRASEBOOKS, Phrasebook};
use js_sys::{Array, Intl, Object, Reflect, WeakMap};
use std::cell::RefCell;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::spawn_local;
use web_sys::{
    CharacterData, Element, Event, HtmlSelectElement, MutationObserver, MutationObserverInit,
    MutationRecord, Node,
};

/// What the page itself speaks.
const ENGLISH: &str = "en";

/// Attributes that are read out or shown.
const ATTRIBUTES: [&str; 6] =
    ["aria-label", "title", "placeholder", "alt", "aria-valuetext", "aria-roledescription"];

/// What is no text of the page, or says itself of which language it is.
const FOREIGN: &str = "script, style, noscript, code, textarea, [translate=no], body [lang]";

thread_local! {
    static INTERPRETER: RefCell<Option<Interpreter>> = const { RefCell::new(None) };
}

struct Interpreter {
    language: String,
    /// None in the page's own English.
    book: Option<Phrasebook<Browser>>,
    /// What texts were in English, and what they were made, by their nodes.
    texts: WeakMap,
    /// The same of each of the attributes, by their elements.
    attributes: [WeakMap; ATTRIBUTES.len()],
    observer: MutationObserver,
}

/// Begins to listen.
pub fn start() {
    let hear = Closure::<dyn FnMut(Array)>::new(|records: Array| {
        let records = records.iter().map(|record| record.unchecked_into::<MutationRecord>());
        INTERPRETER.with_borrow(|interpreter| {
            if let Some(interpreter) = interpreter {
                interpreter.hear(records);
            }
        });
        agree();
    });
    let observer = MutationObserver::new(hear.into_js_value().unchecked_ref());
    let observer = observer.expect("a page may be observed");
    let what = MutationObserverInit::new();
    what.set_child_list(true);
    what.set_character_data(true);
    what.set_subtree(true);
    let names: Array = ATTRIBUTES.into_iter().chain(["lang"]).map(JsValue::from).collect();
    what.set_attribute_filter(&names);
    let root = document().document_element().expect("a document has a root");
    let _ = observer.observe_with_options(&root, &what);
    INTERPRETER.set(Some(Interpreter {
        language: ENGLISH.to_string(),
        book: None,
        texts: WeakMap::new(),
        attributes: std::array::from_fn(|_| WeakMap::new()),
        observer,
    }));
    choose();
    agree();
}

/// Finds out which language is wished: the one that was chosen while this was loaded, else that of the address,
/// `lang=pt`, else the one that was chosen before, else the browser's; and listens to what is chosen from now on.
fn choose() {
    let select: HtmlSelectElement = find("language");
    if select.value() == ENGLISH {
        let wished = asked_language().or_else(|| {
            let wished = chosen_language().or_else(|| window().navigator().language())?;
            languages().find(|language| wished.starts_with(language))
        });
        let language = wished.unwrap_or(ENGLISH);
        select.set_value(language);
        speak(language);
    } else {
        keep(&select.value());
    }
    let chosen = select.clone();
    // It listens as long as the page is there.
    std::mem::forget(on(&select, "change", move |_: Event| keep(&chosen.value())));
}

fn languages() -> impl Iterator<Item = &'static str> {
    [ENGLISH].into_iter().chain(PHRASEBOOKS)
}

fn asked_language() -> Option<&'static str> {
    let address = window().location().href().unwrap_or_default();
    languages().find(|language| address.contains(&said(language)))
}

/// How an address says a language.
fn said(language: &str) -> String {
    format!("lang={language}")
}

/// Speaks a language and keeps it for the next time.
fn keep(language: &str) {
    if let Ok(Some(storage)) = window().local_storage() {
        let _ = storage.set_item(CHOSEN, language);
    }
    // An address that says another one would win when it is opened again.
    if let (Some(asked), Ok(history)) = (asked_language(), window().history()) {
        let address = window().location().href().unwrap_or_default();
        let address = address.replace(&said(asked), &said(language));
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
    speak(language);
}

fn speak(language: &str) {
    let root = document().document_element().expect("a document has a root");
    set_attribute(&root, "lang", language);
}

/// Brings the language into agreement with the `<html>` element's.
fn agree() {
    let root = document().document_element().expect("a document has a root");
    let wished = root.get_attribute("lang").unwrap_or_default();
    let is_new = INTERPRETER.with_borrow_mut(|interpreter| {
        let interpreter = interpreter.as_mut()?;
        (interpreter.language != wished).then(|| interpreter.language.clone_from(&wished))
    });
    if is_new.is_some() {
        spawn_local(learn(wished));
    }
}

/// Fetches a phrasebook and says everything anew, unless another one is wished by now. Without it the page stays
/// as it is.
async fn learn(language: String) {
    let mut book = None;
    if PHRASEBOOKS.contains(&language.as_str()) {
        let Ok(text) = files::read(&format!("words/{language}.txt")).await else { return };
        book = Phrasebook::read(&text, Browser::new(&language)).ok();
    }
    INTERPRETER.with_borrow_mut(|interpreter| {
        let Some(interpreter) = interpreter.as_mut().filter(|i| i.language == language) else {
            return;
        };
        interpreter.book = book;
        if let Some(root) = document().document_element() {
            interpreter.tell_all(&root);
            // For who waits for it.
            set_attribute(&root, "data-language", &language);
        }
        interpreter.observer.take_records();
    });
}

impl Interpreter {
    fn hear(&self, records: impl Iterator<Item = MutationRecord>) {
        for record in records {
            let Some(target) = record.target() else { continue };
            match record.type_().as_str() {
                "childList" => {
                    let added = record.added_nodes();
                    for node in (0..added.length()).filter_map(|k| added.item(k)) {
                        self.tell_all(&node);
                    }
                }
                "characterData" => self.tell_all(&target),
                _ => {
                    let element: Element = target.unchecked_into();
                    if !is_foreign(&element) {
                        self.tell_attributes(&element);
                    }
                }
            }
        }
        // What it wrote itself is not to be heard.
        self.observer.take_records();
    }

    /// Says a node and all that is within it.
    fn tell_all(&self, node: &Node) {
        let around = node.dyn_ref::<Element>().cloned().or_else(|| node.parent_element());
        if around.is_some_and(|element| !is_foreign(&element)) {
            self.tell_within(node);
        }
    }

    fn tell_within(&self, node: &Node) {
        if let Some(text) = node.dyn_ref::<CharacterData>() {
            return self.tell_text(text);
        }
        let Some(element) = node.dyn_ref::<Element>() else { return };
        self.tell_attributes(element);
        let children = element.child_nodes();
        for child in (0..children.length()).filter_map(|k| children.item(k)) {
            let is_foreign = child.dyn_ref::<Element>().is_some_and(is_foreign_itself);
            if !is_foreign {
                self.tell_within(&child);
            }
        }
    }

    fn tell_text(&self, node: &CharacterData) {
        let now = node.data();
        let english = in_english(&self.texts, node, &now);
        let told = self.tell(&english);
        if told != now {
            node.set_data(&told);
        }
        remember(&self.texts, node, &english, &told);
        let Some(around) = node.parent_element() else { return };
        // So that whoever writes it again sees that it is there (`dom::set_text`).
        if told != english {
            set_attribute(&around, "data-said", format!("{told}\n{english}"));
        } else if around.has_attribute("data-said") {
            let _ = around.remove_attribute("data-said");
        }
    }

    fn tell_attributes(&self, element: &Element) {
        for (name, texts) in ATTRIBUTES.into_iter().zip(&self.attributes) {
            let Some(now) = element.get_attribute(name) else { continue };
            let english = in_english(texts, element, &now);
            let told = self.tell(&english);
            if told != now {
                let _ = element.set_attribute(name, &told);
            }
            remember(texts, element, &english, &told);
        }
    }

    fn tell(&self, english: &str) -> String {
        let told = self.book.as_ref().and_then(|book| book.tell(english));
        told.unwrap_or_else(|| english.to_string())
    }
}

/// What was there in English before it was said in another language, or what is there if that is new.
fn in_english(texts: &WeakMap, node: &Object, now: &str) -> String {
    let remembered: Array = match texts.get(node).dyn_into() {
        Ok(pair) => pair,
        Err(_) => return now.to_string(),
    };
    let [english, told] = [0, 1].map(|k| remembered.get(k).as_string().unwrap_or_default());
    if told == now { english } else { now.to_string() }
}

fn remember(texts: &WeakMap, node: &Object, english: &str, told: &str) {
    if told == english {
        texts.delete(node);
    } else {
        texts.set(node, &Array::of2(&english.into(), &told.into()));
    }
}

fn is_foreign(element: &Element) -> bool {
    element.closest(FOREIGN).is_ok_and(|found| found.is_some())
}

fn is_foreign_itself(element: &Element) -> bool {
    element.matches(FOREIGN).unwrap_or(false)
}

/// Numbers as the browser writes them (ECMA-402, "Internationalization API Specification").
struct Browser {
    locales: Array,
    plurals: Intl::PluralRules,
}

impl Browser {
    fn new(language: &str) -> Browser {
        let locales = Array::of1(&language.into());
        let plurals = Intl::PluralRules::new(&locales, &Object::new());
        Browser { locales, plurals }
    }
}

impl Numbers for Browser {
    fn written(&self, value: f64, decimals: usize, grouped: bool) -> String {
        let how = Object::new();
        let digits = JsValue::from(decimals as u32);
        for (name, value) in [
            ("minimumFractionDigits", &digits),
            ("maximumFractionDigits", &digits),
            ("useGrouping", &JsValue::from(grouped)),
        ] {
            // Fails for nothing that is an object.
            let _ = Reflect::set(&how, &name.into(), value);
        }
        let format = Intl::NumberFormat::new(&self.locales, &how).format();
        let written = format.call1(&JsValue::UNDEFINED, &value.into());
        written.ok().and_then(|text| text.as_string()).unwrap_or_else(|| value.to_string())
    }

    fn category(&self, value: f64) -> String {
        self.plurals.select(value).into()
    }
}
