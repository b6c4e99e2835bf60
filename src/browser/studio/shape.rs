//! The dialog in which a body is made by rule: its numbers answer with the bare body at once, and its pattern grows
//! when that is asked for.

use super::field::{Field, TYPED, each};
use super::strokes::{self, Strokes};
use super::subject;
use super::wish::{ANEW, SHAPE, SHAPE_NUMBERS};
use super::work::{Said, Work, refusal};
use super::{files, own, with};
use crate::browser::dom::{Listener, find, on, set_attribute, set_flag, set_text, window, within};
use crate::play::origin::PAINTED;
use js_sys::{Array, Float64Array, Uint8ClampedArray};
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{
    CanvasRenderingContext2d, Element, Event, HtmlCanvasElement, HtmlDialogElement, HtmlElement,
    HtmlInputElement, HtmlSelectElement, ImageData, KeyboardEvent,
};

pub struct ShapeView {
    pub(super) dialog: HtmlDialogElement,
    /// The workshop, as long as the dialog is open: it stays, so that a slider is answered at once.
    work: Option<Work>,
    /// The wish that it is at.
    asked: Option<&'static str>,
    /// The wish that comes after that.
    next: Option<&'static str>,
    asked_ms: f64,
    /// Words that no slider has moved since: of a link, or of a kind to begin with. They say what no slider can.
    pub(super) exact: Vec<(String, String)>,
    /// The petals as they are drawn.
    pub(super) strokes: Vec<Strokes>,
    /// The words as they are now, and those before each act.
    now: String,
    past: Vec<String>,
    /// The words of the leaf that was made last.
    leaf: String,
    /// What the last act has changed: as long as it is the same, it is one act.
    acted_on: String,
    _listeners: Vec<Listener>,
}

/// Ways to numbers of one of several kinds: what is said of one says that it is no other.
const ONE_OF_SEVERAL: [&str; 4] = ["length", "width", "border", "petals.arrangement"];

/// Petals in circles, or one after the other.
const WHORLS: &str = "petals.arrangement.whorls";
const SPIRAL: &str = "petals.arrangement.spiral";

/// The choice of leaves on a tree, and with what their numbers begin.
const LEAF: &str = "leaf";
const OF_LEAF: &str = "leaf.";

impl ShapeView {
    pub fn new() -> ShapeView {
        let dialog: HtmlDialogElement = find("shape-dialog");
        let mut listeners = vec![
            on(&dialog, "input", |event: Event| {
                if let Some(target) = event.target() {
                    let element = target.unchecked_into();
                    with(|studio| studio.shape.change(&element));
                }
            }),
            on(&dialog, "close", |_: Event| {
                with(|studio| {
                    let shape = &mut studio.shape;
                    (shape.work, shape.asked, shape.next) = (None, None, None);
                });
            }),
        ];
        for (selector, wish) in [(".grow", ANEW), (".numbers-file", SHAPE_NUMBERS)] {
            listeners.push(on(
                &within::<HtmlElement>(&dialog, selector),
                "click",
                move |_: Event| with(|studio| studio.shape.wish(wish)),
            ));
        }
        listeners.push(on(&within::<HtmlElement>(&dialog, ".back"), "click", |_: Event| {
            with(|studio| studio.shape.undo());
        }));
        listeners.push(on(&within::<HtmlElement>(&dialog, ".hang"), "click", |_: Event| {
            with(|studio| studio.shape.hang_leaf());
        }));
        listeners.push(on(&dialog, "keydown", |event: KeyboardEvent| {
            // In what is typed the key is the browser's own.
            let is_typed = |element: Element| {
                element
                    .matches("textarea, input:not([type=range], [type=checkbox])")
                    .unwrap_or(false)
            };
            let target = event.target().map(|target| target.unchecked_into());
            if (event.ctrl_key() || event.meta_key())
                && event.key() == "z"
                && !target.is_some_and(is_typed)
            {
                event.prevent_default();
                with(|studio| studio.shape.undo());
            }
        }));
        let strokes = strokes::all(&dialog);
        ShapeView {
            dialog,
            work: None,
            asked: None,
            next: None,
            asked_ms: 0.0,
            exact: Vec::new(),
            strokes,
            now: String::new(),
            past: Vec::new(),
            leaf: String::new(),
            acted_on: String::new(),
            _listeners: listeners,
        }
    }

    /// Opens the dialog on the body of what the page shows, if that is one by rule; else as it was.
    pub fn open(&mut self) {
        let words = subject::origin();
        if !words.is_empty() && !words.starts_with(PAINTED) {
            self.show_words(&words);
        }
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
        self.show_kind();
        (self.now, self.past) = (self.words(), Vec::new());
        self.keep_leaf();
        self.wish(SHAPE);
    }

    /// Keeps the words of a leaf, so that a tree may have it.
    fn keep_leaf(&mut self) {
        if let Some(words) = self.now.strip_prefix("leaf=") {
            self.leaf = words.to_string();
        }
    }

    /// Hangs the leaf that was made last on the tree. What says how large it is, which one and what grows on it is not
    /// its form.
    fn hang_leaf(&mut self) {
        let is_form = |word: &&str| {
            !word.is_empty()
                && !["size:", "individual:", "on:"].iter().any(|other| word.starts_with(other))
        };
        let leaf = self.leaf.split(',').filter(is_form).map(|word| format!("{OF_LEAF}{word}"));
        let words = self.words();
        let words = words.split_once('=').map_or("", |(_, words)| words);
        let tree = words.split(',').filter(|word| !word.starts_with(OF_LEAF)).map(String::from);
        let words: Vec<String> = tree.chain(leaf).collect();
        self.set(&words.join(","));
        self.choice(&format!("select[data-key=\"{LEAF}\"]")).set_value(TYPED);
        self.tell_numbers();
        self.begin_act();
        self.act_on(LEAF);
        self.wish(SHAPE);
    }

    fn show_words(&mut self, words: &str) {
        let (kind, words) = words.split_once('=').unwrap_or((words, ""));
        self.choice(".kind").set_value(kind);
        self.set(words);
    }

    /// What is changed from now on is another act than what was before.
    pub(super) fn begin_act(&mut self) {
        self.acted_on.clear();
    }

    /// The act on something has changed the words.
    pub(super) fn act_on(&mut self, key: &str) {
        let words = self.words();
        let before = std::mem::replace(&mut self.now, words);
        self.keep_leaf();
        if self.acted_on != key && before != self.now {
            self.past.push(before);
            self.acted_on = key.to_string();
        }
        set_flag(&self.part(".back"), "disabled", self.past.is_empty());
    }

    fn undo(&mut self) {
        if let Some(words) = self.past.pop() {
            self.show_words(&words);
            self.show_kind();
            self.now = self.words();
            self.begin_act();
            set_flag(&self.part(".back"), "disabled", self.past.is_empty());
            self.wish(SHAPE);
        }
    }

    /// A number has changed, or what is seen.
    fn change(&mut self, element: &Element) {
        if element.matches(".like").unwrap_or(false) {
            self.set(&element.unchecked_ref::<HtmlSelectElement>().value());
        } else if let Some(key) = element.get_attribute("data-key") {
            let of = |key: &str| ONE_OF_SEVERAL.iter().find(|way| key.starts_with(**way));
            let other_kind = |other: &str| of(other).is_some() && of(other) == of(&key);
            let of_leaf = |other: &str| key == LEAF && other.starts_with(LEAF);
            self.exact.retain(|(other, _)| *other != key && !other_kind(other) && !of_leaf(other));
        } else {
            if element.matches(".kind").unwrap_or(false) {
                self.exact.clear();
            }
            self.show_kind();
        }
        self.tell_numbers();
        let key = element.get_attribute("data-key");
        self.act_on(&key.unwrap_or_else(|| element.get_attribute("class").unwrap_or_default()));
        self.wish(SHAPE);
    }

    /// The part of the dialog for the kind that is chosen alone.
    fn show_kind(&mut self) {
        let kind = self.kind();
        for part in each(&self.dialog, "[data-kind]") {
            set_flag(&part, "hidden", part.get_attribute("data-kind").as_deref() != Some(&kind));
        }
        self.tell_numbers();
    }

    fn kind(&self) -> String {
        self.choice(".kind").value()
    }

    /// The numbers of the kind that is chosen, by their words.
    fn fields(&self) -> Vec<(String, Field)> {
        let selector = format!("[data-kind={}] [data-key]", self.kind());
        let field = |element: Element| {
            let key = element.get_attribute("data-key")?;
            Some((key, Field::of(element)))
        };
        each(&self.dialog, &selector).into_iter().filter_map(field).collect()
    }

    /// The body in words, as the address has them.
    fn words(&self) -> String {
        let fields = self.fields();
        let mut words: Vec<String> = Vec::new();
        for (key, field) in &fields {
            let exact = self.exact.iter().find(|(other, _)| other == key);
            let value = match exact {
                Some((_, value)) => Some(value.clone()),
                None => field.changed(),
            };
            let word = value.map(|value| format!("{key}:{value}"));
            words.extend(word.filter(|word| !words.contains(word)));
        }
        let rest =
            self.exact.iter().filter(|(key, _)| fields.iter().all(|(other, _)| other != key));
        words.extend(rest.map(|(key, value)| format!("{key}:{value}")));
        format!("{}={}", self.kind(), words.join(","))
    }

    /// Sets all numbers of the kind that is chosen: to what the words say, and the others to what is usual.
    fn set(&mut self, words: &str) {
        self.exact = words
            .split(',')
            .filter_map(|word| word.split_once(':'))
            .map(|(key, value)| (key.to_string(), value.to_string()))
            .collect();
        for (key, field) in self.fields() {
            let value = self.exact.iter().find(|(other, _)| *other == key);
            field.set(value.map(|(_, value)| &**value));
        }
        for (choice, way) in [(WHORLS, SPIRAL), (LEAF, OF_LEAF)] {
            if self.exact.iter().any(|(key, _)| key.starts_with(way)) {
                self.choice(&format!("select[data-key=\"{choice}\"]")).set_value(TYPED);
            }
        }
        self.tell_numbers();
    }

    /// Writes each number beside its slider.
    pub(super) fn tell_numbers(&mut self) {
        for label in each(&self.dialog, "label:has(output)") {
            let value = within::<HtmlInputElement>(&label, "input").value();
            set_text(&within::<Element>(&label, "output"), &value);
        }
        for part in each(&self.dialog, "[data-if]") {
            let key = part.get_attribute("data-if").unwrap_or_default();
            let is_typed = self.choice(&format!("select[data-key=\"{key}\"]")).value() == TYPED;
            set_flag(&part, "hidden", !is_typed);
        }
        self.show_strokes();
    }

    /// Has the workshop do something with the body, now or when it has done what it is at.
    pub(super) fn wish(&mut self, wish: &'static str) {
        if self.asked.is_some() {
            // A picture must not push out what was asked for in earnest.
            if wish != SHAPE || self.next.is_none() {
                self.next = Some(wish);
            }
            return;
        }
        (self.asked, self.asked_ms) = (Some(wish), now_ms());
        let canvas = self.canvas();
        let number =
            |selector| within::<HtmlInputElement>(&self.dialog, selector).value_as_number();
        let view = [
            f64::from(canvas.width()),
            f64::from(canvas.height()),
            number(".around"),
            number(".above"),
            number(".time"),
        ];
        let words = self.words();
        let view = Float64Array::from(&view[..]);
        if let Some(work) = &self.work {
            return work.wish([wish, &words, ""], view);
        }
        let hear = |said| with(|studio| studio.shape.hear(said));
        match Work::start([wish, &words, ""], view, hear) {
            Ok(work) => self.work = Some(work),
            Err(why) => self.refuse(&why),
        }
    }

    fn hear(&mut self, said: Said) {
        let asked = self.asked.take();
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                self.work = None;
                self.refuse(&refusal(&why, format!("There is no such body: {why}.")));
            }
            Said::Done(answer) => match asked {
                Some(SHAPE) => self.draw(&answer),
                Some(SHAPE_NUMBERS) => {
                    files::save(&format!("{}.json", self.kind()), &answer.get(1).unchecked_into());
                }
                _ => {
                    self.dialog.close();
                    return own::put_made(&answer, &self.words())
                        .into_iter()
                        .for_each(own::show_preset);
                }
            },
        }
        if let Some(next) = self.next.take() {
            self.wish(next);
        }
    }

    fn refuse(&mut self, why: &str) {
        self.asked = None;
        set_text(&self.part(".said"), why);
    }

    fn draw(&self, answer: &Array) {
        let canvas = self.canvas();
        let pixels = answer.get(1).unchecked_into::<Uint8ClampedArray>().to_vec();
        let [width, height] = [canvas.width(), canvas.height()];
        let picture = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&pixels), width, height);
        let pen = canvas.get_context("2d").ok().flatten();
        if let (Ok(picture), Some(pen)) = (picture, pen) {
            let _ =
                pen.unchecked_into::<CanvasRenderingContext2d>().put_image_data(&picture, 0.0, 0.0);
        }
        set_text(&self.part(".said"), &answer.get(0).as_string().unwrap_or_default());
        set_attribute(
            &self.dialog,
            "data-drawn-ms",
            format!("{}", (now_ms() - self.asked_ms).round()),
        );
        set_attribute(&self.dialog, "data-drawn", self.words());
    }

    fn canvas(&self) -> HtmlCanvasElement {
        within(&self.dialog, "canvas")
    }

    fn choice(&self, selector: &str) -> HtmlSelectElement {
        within(&self.dialog, selector)
    }

    fn part(&self, selector: &str) -> Element {
        within(&self.dialog, selector)
    }
}

fn now_ms() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}
