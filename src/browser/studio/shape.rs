//! The dialog in which a body is made by rule: its numbers answer with the bare body at once, and its pattern grows
//! when that is asked for.

use super::field::{Field, TYPED, each};
use super::strokes::{self, Strokes};
use super::subject;
use super::wish::{ANEW, SHAPE, SHAPE_NUMBERS};
use super::work::{Said, Work};
use super::{files, own, with};
use crate::browser::dom::{Listener, find, on, set_attribute, set_flag, set_text, window, within};
use crate::play::origin::PAINTED;
use js_sys::{Array, Float64Array, Uint8ClampedArray};
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{
    CanvasRenderingContext2d, Element, Event, HtmlCanvasElement, HtmlDialogElement, HtmlElement,
    HtmlInputElement, HtmlSelectElement, ImageData,
};

pub struct ShapeView {
    dialog: HtmlDialogElement,
    /// The workshop, as long as the dialog is open: it stays, so that a slider is answered at once.
    work: Option<Work>,
    /// The wish that it is at.
    asked: Option<&'static str>,
    /// The wish that comes after that.
    next: Option<&'static str>,
    asked_ms: f64,
    /// Words that no slider has moved since: of a link, or of a kind to begin with. They say what no slider can.
    exact: Vec<(String, String)>,
    /// The petals as they are drawn.
    pub(super) strokes: Vec<Strokes>,
    /// The words as they are now, and those before each act.
    now: String,
    past: Vec<String>,
    /// What the last act has changed: as long as it is the same, it is one act.
    acted_on: String,
    _listeners: Vec<Listener>,
}

/// Ways to numbers of one of several kinds: what is said of one says that it is no other.
const ONE_OF_SEVERAL: [&str; 4] = ["length", "width", "border", "petals.arrangement"];

/// Petals in circles, or one after the other.
const WHORLS: &str = "petals.arrangement.whorls";
const SPIRAL: &str = "petals.arrangement.spiral";

/// The edges of a petal, which may mirror each other.
const EDGES: [&str; 2] = ["petals.left_cm", "petals.right_cm"];

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
    fn act_on(&mut self, key: &str) {
        let words = self.words();
        let before = std::mem::replace(&mut self.now, words);
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

    /// Moves a point of a stroke, and the one across it where both edges are alike.
    pub(super) fn move_point(&mut self, key: &str, k: usize, to: impl Fn([f64; 2]) -> [f64; 2]) {
        let field = |key: &str| field(&self.dialog, key);
        let Some(mut points) = strokes::points(&field(key)) else { return };
        let Some(point) = points.get_mut(k) else { return };
        *point = to(*point).map(|cm| strokes::hundredths(cm.clamp(-100.0, 100.0)));
        let [x, y] = *point;
        strokes::write(&field(key), &points);
        let is_alike = within::<HtmlInputElement>(&self.dialog, ".alike").checked();
        let across = EDGES.iter().position(|edge| *edge == key).map(|edge| EDGES[1 - edge]);
        if let Some(across) = across.filter(|_| is_alike)
            && let Some(mut others) = strokes::points(&field(across))
            && let Some(other) = others.get_mut(k)
        {
            *other = [-x + 0.0, y];
            strokes::write(&field(across), &others);
            self.exact.retain(|(other, _)| other != across);
        }
        self.exact.retain(|(other, _)| other != key);
        self.act_on(key);
        self.tell_numbers();
        self.wish(SHAPE);
    }

    /// Draws the petals that the fields have.
    fn show_strokes(&mut self) {
        let field = |key: &str| field(&self.dialog, key);
        for drawing in &mut self.strokes {
            let stroke = |key: String| {
                let field = field(&key);
                let points = strokes::points(&field)?;
                Some((key, strokes::name_of(&field), points))
            };
            let strokes: Vec<_> = drawing.keys().into_iter().filter_map(stroke).collect();
            drawing.show(&strokes);
        }
    }

    /// A number has changed, or what is seen.
    fn change(&mut self, element: &Element) {
        if element.matches(".like").unwrap_or(false) {
            self.set(&element.unchecked_ref::<HtmlSelectElement>().value());
        } else if let Some(key) = element.get_attribute("data-key") {
            let of = |key: &str| ONE_OF_SEVERAL.iter().find(|way| key.starts_with(**way));
            let other_kind = |other: &str| of(other).is_some() && of(other) == of(&key);
            self.exact.retain(|(other, _)| *other != key && !other_kind(other));
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
        if self.exact.iter().any(|(key, _)| key.starts_with(SPIRAL)) {
            self.choice(&format!("select[data-key=\"{WHORLS}\"]")).set_value(TYPED);
        }
        self.tell_numbers();
    }

    /// Writes each number beside its slider.
    fn tell_numbers(&mut self) {
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
    fn wish(&mut self, wish: &'static str) {
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
                self.refuse(&format!("There is no such body: {why}."));
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

/// The field of a stroke.
fn field(dialog: &Element, key: &str) -> HtmlInputElement {
    within(dialog, &format!("[data-key=\"{key}\"]"))
}

fn now_ms() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}
