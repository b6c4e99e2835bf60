//! Lessons: steps that show, ask, grow and explain, in the place of the controls. What a visitor says stays in
//! this window until it is taken away.

mod grow;
mod list;
mod show;
mod sketch;

use super::files::save;
use super::{picture, presenter, subject, tour, with};
use crate::browser::address::{fragment, wanted};
use crate::browser::dom::{
    Listener, document, find, on, set_attribute, set_flag, set_text, window, within,
};
use crate::export::worksheet;
use crate::play::lesson::{Answers, Kind, Lesson};
use grow::Growth;
use js_sys::Uint8Array;
use std::collections::BTreeMap;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, Event, HtmlElement, HtmlInputElement, PointerEvent};

/// The name of the lesson that was opened from a file, in the place of that of one of ours.
const FROM_A_FILE: &str = "file";

pub struct LessonView {
    view: HtmlElement,
    /// The language that they are in, but for one that was opened from a file.
    language: String,
    /// Those that were read, by their names, and their texts.
    read: BTreeMap<String, (Rc<Lesson>, String)>,
    answers: BTreeMap<String, Answers>,
    /// What is open: a lesson and its step, from 0; None for the list.
    place: Option<Place>,
    growth: Option<Growth>,
    /// Whether a button of the lesson led to where the address leads now.
    goes: bool,
    _listeners: Vec<Listener>,
}

#[derive(Clone)]
struct Place {
    name: String,
    lesson: Rc<Lesson>,
    step: usize,
}

impl LessonView {
    pub fn new() -> LessonView {
        let view: HtmlElement = find("lesson-view");
        let click = |part: &str, does: fn(&mut LessonView)| {
            let button: HtmlElement = within(&view, part);
            on(&button, "click", move |_: Event| with(|studio| does(&mut studio.lessons)))
        };
        let mut listeners = vec![
            click(".list", |lessons| lessons.want("lesson")),
            click(".close", |lessons| lessons.want("")),
            click(".back", |lessons| lessons.turn(-1)),
            click(".next", |lessons| lessons.turn(1)),
        ];
        let form: Element = within(&view, ".guess");
        listeners.push(on(&form, "submit", |event: Event| {
            event.prevent_default();
            with(|studio| studio.lessons.commit());
        }));
        listeners.push(on(&form, "input", |event: Event| {
            if let Some(input) = event.target().and_then(|t| t.dyn_into::<Element>().ok()) {
                set_flag(&input, "data-touched", true);
            }
            with(|studio| studio.lessons.considered());
        }));
        for kind in ["pointerdown", "pointermove"] {
            listeners.push(on(&form, kind, |event: PointerEvent| sketch::draw(&event)));
        }
        listeners.push(on(&view, "click", |event: Event| {
            let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
            let door = target.and_then(|t| t.closest("[data-take], [data-lesson-name]").ok()?);
            let Some(door) = door else { return };
            if door.get_attribute("data-take").as_deref() == Some("tour") {
                subject::want("");
                return presenter::after(0, tour::open);
            }
            with(|studio| match door.get_attribute("data-take") {
                Some(wanted) => studio.lessons.take(&wanted),
                None => {
                    let name = door.get_attribute("data-lesson-name").unwrap_or_default();
                    studio.lessons.go(&name, 0);
                }
            });
        }));
        let file: HtmlInputElement = within(&view, ".own input");
        listeners.push(list::watch_file(file));
        grow::watch_page();
        // `boot` has told the document by then.
        listeners.push(on(&find::<Element>("language"), "change", |_: Event| {
            if wanted().starts_with("~lesson") {
                super::follow();
            }
        }));
        LessonView {
            view,
            language: list::language(),
            read: BTreeMap::new(),
            answers: BTreeMap::new(),
            place: None,
            growth: None,
            goes: false,
            _listeners: listeners,
        }
    }

    /// Opens the list.
    pub fn open(&mut self) {
        self.want("lesson");
    }

    fn want(&mut self, what: &str) {
        self.goes = true;
        subject::want(what);
    }

    /// Lessons of another language than the page's are read anew.
    fn forget_other_languages(&mut self) {
        if self.language != list::language() {
            self.language = list::language();
            self.read.retain(|name, _| name == FROM_A_FILE);
            self.part::<Element>(".lessons").set_text_content(None);
        }
    }

    /// Agrees with the address: `chance/2`, or nothing for the list.
    pub fn follow(&mut self, of_it: &str) {
        let root = root();
        set_attribute(&root, "data-view", "lesson");
        self.forget_other_languages();
        self.view.set_hidden(false);
        let (name, step) = of_it.split_once('/').unwrap_or((of_it, "1"));
        if name.is_empty() {
            return self.show_list("");
        }
        let step = step.parse::<usize>().unwrap_or(1).saturating_sub(1);
        if let Some((lesson, _)) = self.read.get(name) {
            let (lesson, name) = (lesson.clone(), name.to_string());
            let step = step.min(lesson.steps.len() - 1);
            // An address that names no plant of its own gets that of the step.
            let link = lesson.steps[..=step].iter().rev().find_map(|step| step.link.clone());
            if let Some(link) = link.filter(|link| !list::names_no_plant(link))
                && list::names_no_plant(&fragment())
            {
                return subject::go(&link, &format!("lesson/{name}/{}", step + 1));
            }
            self.place = Some(Place { name, lesson, step });
            return self.show_step();
        }
        if name == FROM_A_FILE {
            return self.show_list("That lesson was opened from a file. Please open it again.");
        }
        let name = name.to_string();
        spawn_local(async move {
            let text = list::fetch(&name).await;
            with(|studio| studio.lessons.fetched(&name, text));
            // The address may lead elsewhere by now.
            let mut is_there = false;
            with(|studio| is_there = studio.lessons.read.contains_key(&name));
            if is_there {
                super::follow();
            }
        });
    }

    /// Leaves the page as it was before.
    pub fn leave(&mut self) {
        if self.view.hidden() {
            return;
        }
        let root = root();
        let is_ours = root.get_attribute("data-view").is_some_and(|view| view == "lesson");
        if is_ours {
            set_attribute(&root, "data-view", "plant");
        }
        set_flag(&root, "data-lesson", false);
        self.growth = None;
        self.place = None;
        self.view.set_hidden(true);
        if std::mem::take(&mut self.goes) {
            let _ = find::<HtmlElement>("lessons").focus();
        }
    }

    /// A lesson that the address leads to has come.
    fn fetched(&mut self, name: &str, text: Result<String, String>) {
        if let Err(why) = text.and_then(|text| self.keep(name, text)) {
            self.show_list(&why);
        }
    }

    /// Reads a lesson's text and keeps both.
    fn keep(&mut self, name: &str, text: String) -> Result<(), String> {
        let lesson = crate::play::lesson::read(&text).map_err(|why| why.to_string())?;
        self.read.insert(name.to_string(), (Rc::new(lesson), text));
        Ok(())
    }

    /// Goes on or back by steps.
    fn turn(&mut self, by: isize) {
        let Some(Place { name, lesson, step }) = self.place.clone() else { return };
        match step.checked_add_signed(by) {
            Some(step) if step < lesson.steps.len() => self.go(&name, step),
            Some(_) => self.want("lesson"),
            None => {}
        }
    }

    /// Goes to a step of a lesson that was read, and shows its plant.
    fn go(&mut self, name: &str, step: usize) {
        let Some((lesson, _)) = self.read.get(name) else { return };
        let link = lesson.steps[step].link.clone().unwrap_or_else(fragment_link);
        self.goes = true;
        subject::go(&link, &format!("lesson/{name}/{}", step + 1));
    }

    /// Takes the prediction that stands in the form, for good.
    fn commit(&mut self) {
        let Some(Place { name, lesson, step }) = self.place.clone() else { return };
        let Kind::Predict { guess, .. } = &lesson.steps[step].kind else { return };
        match show::said(&self.view, guess) {
            Ok(said) => {
                self.answers.entry(name).or_default().say(step, said);
                self.show_step();
                let _ = self.part::<HtmlElement>(".next").focus();
            }
            Err(why) => set_text(&self.part(".guess .refusal"), why),
        }
    }

    /// Somebody is about to say something.
    fn considered(&mut self) {
        set_text(&self.part(".guess .refusal"), "");
        if let Some(output) = self.view.query_selector(".bar output").ok().flatten() {
            let bar: HtmlInputElement = self.part(".bar input");
            set_text(&output, &format!("{} in 100", bar.value()));
            set_attribute(&bar, "aria-valuetext", format!("{} in 100", bar.value()));
        }
        sketch::trace(&self.part(".ways"));
    }

    /// Hands over what a button is for.
    fn take(&mut self, wanted: &str) {
        let Some(Place { name, lesson, .. }) = self.place.clone() else { return };
        let answers = self.answers.entry(name.clone()).or_default();
        match wanted {
            "csv" => {
                let table = answers.to_csv(&lesson);
                save(&format!("{name}-answers.csv"), &Uint8Array::from(table.as_bytes()));
            }
            "text" => {
                let text = self.read.get(&name).map(|(_, text)| text.as_bytes());
                save(&format!("{name}.txt"), &Uint8Array::from(text.unwrap_or_default()));
            }
            "print" => {
                // The window is not ours while it prints.
                let print = Closure::once_into_js(|| {
                    let _ = window().print();
                });
                let print = print.unchecked_ref();
                let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(print, 0);
            }
            _ => {
                let copied = window().navigator().clipboard().write_text(&answers.to_text(&lesson));
                spawn_local(async move {
                    let told = match JsFuture::from(copied).await {
                        Ok(_) => "Copied.",
                        Err(_) => "This browser does not let it be copied: take the CSV.",
                    };
                    with(|studio| set_text(&studio.lessons.part(".taken"), told));
                });
            }
        }
    }

    /// Puts the worksheet there, for whenever it is printed.
    fn lay_worksheet_out(&self, place: &Place) {
        let sheet: Element = find("lesson-sheet");
        let first = place.lesson.steps.iter().find_map(|step| step.link.clone());
        let mut address = String::new();
        if place.name != FROM_A_FILE {
            let href = window().location().href().unwrap_or_default();
            let page = href.split('#').next().unwrap_or_default();
            address = format!("{page}#{}~lesson/{}/1", first.unwrap_or_default(), place.name);
        }
        let none = Answers::default();
        let answers = self.answers.get(&place.name).unwrap_or(&none);
        sheet.set_inner_html(&worksheet(&place.lesson, answers, &address));
        if let Some((view_box, path)) =
            Some(&*address).filter(|a| !a.is_empty()).and_then(picture::qr)
        {
            let code =
                format!("<svg class=\"qr\" viewBox=\"{view_box}\"><path d=\"{path}\"/></svg>");
            let _ = sheet.insert_adjacent_html("beforeend", &code);
        }
    }

    fn part<T: JsCast>(&self, selector: &str) -> T {
        within(&self.view, selector)
    }
}

/// The link of what is shown, without its `#`.
fn fragment_link() -> String {
    fragment().trim_start_matches('#').to_string()
}

fn root() -> Element {
    document().document_element().expect("a document has a root")
}
