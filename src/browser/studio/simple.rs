//! Four plain sliders beside the plant, and a recipe by chance. They move the numbers of the recipe and say which;
//! the page does the rest.

use super::presenter::after;
use super::{subject, with};
use crate::browser::address::fragment;
use crate::browser::dom::{Listener, find, on, set_attribute, set_flag, set_text, within};
use crate::plants;
use crate::play::simple::{DIALS, Dial, LAST, surprise};
use crate::play::{Scene, link};
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement, KeyboardEvent};

/// What stands in the address while they are open.
pub const VIEW: &str = "simple";
/// Milliseconds that a slider stands before the plant grows again.
const STILL_MS: i32 = 250;

pub struct SimpleView {
    view: HtmlElement,
    rows: Vec<Row>,
    /// The scene that a slider has made, until the page is asked for it, and how often it was made.
    made: Option<Scene>,
    turns: u32,
    _listeners: Vec<Listener>,
}

struct Row {
    dial: &'static Dial,
    element: Element,
    input: HtmlInputElement,
    _listener: Listener,
}

impl SimpleView {
    pub fn new() -> SimpleView {
        let panel: Element = find("panel");
        let _ = panel.insert_adjacent_html("afterend", include_str!("simple.html"));
        let view: HtmlElement = find("simple-view");
        let list: Element = within(&view, ".list");
        let rows = (0..DIALS.len()).map(|k| Row::new(k, &list)).collect();
        let listeners = vec![
            on(&within::<Element>(&view, ".close"), "click", |_: Event| subject::want("")),
            on(&view, "click", |event: Event| {
                let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
                match target.and_then(|target| target.get_attribute("data-do")).as_deref() {
                    Some("undo") => find::<HtmlElement>("undo").click(),
                    Some("surprise") => with(|studio| studio.simple.surprise()),
                    Some("own") => with(|studio| studio.simple.go_back()),
                    _ => {}
                }
            }),
            on(&view, "keydown", |event: KeyboardEvent| {
                let is_closable = !find::<HtmlElement>("simple-view").has_attribute("data-stays");
                if event.key() == "Escape" && is_closable {
                    subject::want("");
                }
            }),
        ];
        subject::on_change(|| with(|studio| studio.show_simple()));
        SimpleView { view, rows, made: None, turns: 0, _listeners: listeners }
    }

    pub fn is_open(&self) -> bool {
        !self.view.hidden()
    }

    /// Agrees with the address. For a class that gets them, they stay.
    pub fn follow(&mut self, is_wanted: bool, stays: bool) {
        let is_inside = self.view.has_attribute("data-stays");
        if stays != is_inside {
            set_flag(&self.view, "data-stays", stays);
            let beside: Element = find(if stays { "sheet" } else { "panel" });
            let _ = beside.insert_adjacent_element("afterend", &self.view);
        }
        if is_wanted == self.is_open() {
            return;
        }
        self.view.set_hidden(!is_wanted);
        match is_wanted {
            // A phone has the panel in a sheet, which is drawn up for them.
            true if stays => {
                let sheet: HtmlElement = find("sheet");
                let is_up = sheet.get_attribute("aria-expanded").as_deref() == Some("true");
                if !is_up && sheet.offset_height() > 0 {
                    sheet.click();
                }
            }
            true => {
                let _ = self.view.focus();
            }
            false => {
                let _ = find::<HtmlElement>("class").focus();
            }
        }
    }

    /// Shows where the sliders stand for what the page shows; those that would tell what is hidden are shut.
    pub fn show(&self, is_hidden: impl Fn(&str) -> bool) {
        if !self.is_open() {
            return;
        }
        let scene = self.made.clone().unwrap_or_else(scene);
        let mut shut = false;
        for row in &self.rows {
            let is_shut = row.dial.numbers(&scene).any(|number| is_hidden(number.key));
            row.show(&scene, is_shut, self.made.is_some());
            shut |= is_shut;
        }
        for what in ["surprise", "own"] {
            set_flag(&within(&self.view, &format!("[data-do={what}]")), "hidden", shut);
        }
        let can_undo = !find::<Element>("undo").has_attribute("disabled");
        set_flag(&within(&self.view, "[data-do=undo]"), "disabled", !can_undo);
    }

    /// A slider was moved.
    fn turn(&mut self, k: usize) {
        let row = &self.rows[k];
        let made = row
            .dial
            .turned(&self.made.clone().unwrap_or_else(scene), row.input.value_as_number() as u32);
        row.say(&made);
        self.made = Some(made);
        self.turns += 1;
        let turns = self.turns;
        after(STILL_MS, move || {
            with(|studio| {
                if studio.simple.turns == turns {
                    studio.simple.go();
                }
            });
        });
    }

    /// Asks the page for what was made.
    fn go(&mut self) {
        if let Some(made) = self.made.take() {
            subject::show(&link::write(&made));
        }
    }

    fn surprise(&mut self) {
        let Ok(chance) = getrandom::u32() else { return };
        let scene = scene();
        let made = surprise(&scene, chance);
        self.made = Some(made);
        self.go();
        let told = format!("A recipe by chance for the {}.", scene.plant.name.to_ascii_lowercase());
        set_text(&within(&self.view, ".made"), &told);
    }

    fn go_back(&mut self) {
        let now = scene();
        let own = Scene::preset(now.plant, now.individual);
        self.made = Some(Scene { recipe: own.recipe, look: own.look, noise: false, ..now });
        self.go();
        set_text(&within(&self.view, ".made"), "The plant's own recipe.");
    }
}

impl Row {
    fn new(k: usize, list: &Element) -> Row {
        let dial = &DIALS[k];
        let [low, high] = dial.ends;
        let html = format!(
            "<div class=dial><label for=simple-{key}></label>\
             <input type=range id=simple-{key} max={LAST} aria-describedby=simple-{key}-moves>\
             <p class=ends aria-hidden=true><span>{low}</span><span>{high}</span></p>\
             <p class='moves hint' id=simple-{key}-moves></p></div>",
            key = dial.key
        );
        let _ = list.insert_adjacent_html("beforeend", &html);
        let element = list.last_element_child().expect("it was put there");
        let input: HtmlInputElement = within(&element, "input");
        let listener = on(&input, "input", move |_: Event| with(|studio| studio.simple.turn(k)));
        Row { dial, element, input, _listener: listener }
    }

    fn show(&self, scene: &Scene, is_shut: bool, is_held: bool) {
        set_text(&within(&self.element, "label"), &self.dial.label(scene));
        set_flag(&self.input, "disabled", is_shut);
        if is_shut {
            self.input.set_value(&(LAST / 2).to_string());
            set_attribute(&self.input, "aria-valuetext", "hidden");
            return set_text(&within(&self.element, ".moves"), "It moves a number that is hidden.");
        }
        if !is_held {
            self.input.set_value(&self.dial.position(scene).to_string());
        }
        self.say(scene);
    }

    /// Says which numbers it moves, and to what.
    fn say(&self, scene: &Scene) {
        let numbers: Vec<String> = self
            .dial
            .numbers(scene)
            .map(|number| {
                let value = number.said(number.get(scene));
                format!("{} ({}) {value}", number.label(scene.plant), number.key)
            })
            .collect();
        set_text(&within(&self.element, ".moves"), &numbers.join(" · "));
        let [low, high] = self.dial.ends;
        let place = self.input.value_as_number();
        let word = match place / f64::from(LAST) {
            way if way < 0.2 => low.to_string(),
            way if way > 0.8 => high.to_string(),
            _ => format!("between {low} and {high}"),
        };
        set_attribute(&self.input, "aria-valuetext", format!("{place}, {word}"));
    }
}

fn scene() -> Scene {
    link::read(&fragment(), plants::all()).scene
}
