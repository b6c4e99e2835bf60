//! The picture in words with its patches, which the page does not count: they are counted by the workshop, which grows the
//! plant again up to the day on the screen. Only while this is open, so that nobody else waits for it.

use super::wish::NUMBERS;
use super::work::{Said, Work};
use super::{subject, with};
use crate::browser::address::fragment;
use crate::browser::dom::{Listener, document, find, on, set_attribute, set_text, within};
use crate::export::{DayNumbers, pattern_in_words};
use crate::plants;
use crate::play::series::asked_view;
use crate::play::{Scene, link};
use js_sys::Float64Array;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, Event, HtmlElement};

/// The elements that describe the plant to who hears the page, without and with the patches.
const DESCRIBED_BY: [&str; 2] = ["summary stage-keys", "summary in-words-told stage-keys"];

pub struct InWords {
    view: HtmlElement,
    told: Element,
    /// What is told, or is being counted.
    scene: Option<Scene>,
    /// The day of it and the one before.
    days: Vec<DayNumbers>,
    leaves: u32,
    /// What was told before.
    before: Option<(Scene, DayNumbers)>,
    work: Option<Work>,
    _listeners: [Listener; 2],
}

impl InWords {
    pub fn new() -> InWords {
        let view: HtmlElement = find("words-view");
        let click = |button: &str, act: fn(&mut InWords)| {
            on(&within::<Element>(&view, button), "click", move |_: Event| {
                with(|studio| act(&mut studio.in_words));
            })
        };
        let listeners = [click(".again", InWords::say_again), click(".close", InWords::close)];
        subject::on_change(|| with(|studio| studio.in_words.follow()));
        InWords {
            told: find("in-words-told"),
            view,
            scene: None,
            days: Vec::new(),
            leaves: 0,
            before: None,
            work: None,
            _listeners: listeners,
        }
    }

    /// Opens it, or says once more what was told last.
    pub fn say_again(&mut self) {
        self.view.set_hidden(false);
        set_attribute(&find::<Element>("stage"), "aria-describedby", DESCRIBED_BY[1]);
        let text = self.told.text_content().unwrap_or_default();
        if self.scene.is_some() && !text.is_empty() {
            // Taken away for a moment: a text that stays is not said.
            self.told.set_text_content(None);
            let _ = self.view.offset_width();
            let told = self.told.clone();
            return super::presenter::after(60, move || set_text(&told, &text));
        }
        self.follow();
    }

    fn close(&mut self) {
        self.view.set_hidden(true);
        self.work = None;
        self.scene = None;
        self.before = None;
        set_text(&self.told, "");
        set_attribute(&find::<Element>("stage"), "aria-describedby", DESCRIBED_BY[0]);
        let _ = find::<HtmlElement>("in-words").focus();
    }

    /// Counts what is at rest on the screen, unless that is told.
    fn follow(&mut self) {
        let root = document().document_element().expect("a document has a root");
        let is_ready = root.get_attribute("data-state").as_deref() == Some("ready");
        let fragment = fragment();
        if self.view.hidden() || !is_ready || asked_view(&fragment).is_some() {
            return;
        }
        let scene = link::read(&fragment, plants::all()).scene;
        let is_told = |old: &Scene| old.day == scene.day && old.grows_like(&scene);
        if self.scene.as_ref().is_some_and(is_told) {
            return;
        }
        if let (Some(before), Some(day)) = (self.scene.take(), self.days.pop()) {
            self.before = Some((before, day));
        }
        self.work = None;
        self.days.clear();
        self.scene = Some(scene.clone());
        set_text(&self.told, "Counting the patches …");
        spawn_local(async move {
            let mesh = subject::mesh_of(&scene).await;
            with(|studio| studio.in_words.count(&scene, mesh));
        });
    }

    fn count(&mut self, scene: &Scene, mesh: Result<String, String>) {
        if self.scene.as_ref() != Some(scene) {
            return;
        }
        let hear = |said| with(|studio| studio.in_words.hear(said));
        let started = mesh
            .map_err(|why| format!("The plant's body did not come: {why}."))
            .and_then(|mesh| Work::start([NUMBERS, &link::write(scene), &mesh], "2", hear));
        match started {
            Ok(work) => self.work = Some(work),
            Err(why) => set_text(&self.told, &why),
        }
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                self.work = None;
                set_text(&self.told, &why);
            }
            Said::Done(answer) => match answer.get(0).dyn_into::<Float64Array>() {
                Ok(row) => {
                    self.days.extend(DayNumbers::of_row(&row.to_vec()));
                    self.leaves = answer.get(2).as_f64().unwrap_or(0.0) as u32;
                }
                Err(_) => {
                    self.work = None;
                    self.tell();
                }
            },
        }
    }

    /// Against what was told before, if it is of the same plant, or else against the day before.
    fn tell(&self) {
        let (Some(scene), Some((now, earlier))) = (&self.scene, self.days.split_last()) else {
            return;
        };
        let before = self.before.as_ref().filter(|(was, _)| was.plant.key == scene.plant.key);
        let before = match before {
            Some((was, day)) => Some((day, was.grows_like(scene))),
            None => earlier.last().map(|day| (day, true)),
        };
        set_text(&self.told, &pattern_in_words(scene.plant, self.leaves, now, before));
    }
}
