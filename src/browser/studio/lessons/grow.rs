//! A step that grows: the page its plant, and a worker of the studio as many as are measured.

use super::{LessonView, Place, root};
use crate::browser::dom::{set_attribute, set_flag, set_text};
use crate::browser::studio::wish::MEASURE;
use crate::browser::studio::work::{Said, Work};
use crate::browser::studio::{subject, with};
use crate::plants;
use crate::play::lesson::{Growing, Grown, Kind};
use crate::play::link;
use wasm_bindgen::JsCast;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, MutationObserver, MutationObserverInit};

/// A step while it grows.
pub struct Growth {
    name: String,
    step: usize,
    values: Vec<f64>,
    work: Option<Work>,
    /// All is measured; the page may still be growing.
    is_measured: bool,
}

/// Hears of it when the page rests.
pub fn watch_page() {
    let changed = Closure::<dyn FnMut()>::new(|| with(|studio| studio.lessons.reveal()));
    if let Ok(observer) = MutationObserver::new(changed.as_ref().unchecked_ref()) {
        let which = MutationObserverInit::new();
        which.set_attributes(true);
        which.set_attribute_filter(&js_sys::Array::of1(&JsValue::from("data-state")));
        let _ = observer.observe_with_options(&root(), &which);
    }
    // It looks as long as the page is there.
    changed.forget();
}

impl LessonView {
    /// Shows what a step has grown, or begins to grow it.
    pub(super) fn grow(&mut self, place: &Place) {
        set_flag(&self.part(".outcome"), "hidden", false);
        if self.answers.get(&place.name).is_some_and(|a| a.grown(place.step).is_some()) {
            self.growth = None;
            return self.finish(place);
        }
        let is_under_way =
            self.growth.as_ref().is_some_and(|g| g.name == place.name && g.step == place.step);
        if is_under_way {
            return;
        }
        let step = &place.lesson.steps[place.step];
        let Kind::Grow(Growing { measure, individuals, .. }) = step.kind else { return };
        self.growth = Some(Growth {
            name: place.name.clone(),
            step: place.step,
            values: Vec::new(),
            work: None,
            is_measured: measure.is_none(),
        });
        self.tell("Growing …");
        let days = place.lesson.sketched_before(place.step);
        let all = days.map_or(individuals, |days| days.len() as u32);
        self.show_progress(Some((0, all)));
        let Some(measure) = measure else { return self.reveal() };
        let link = step.link.clone().unwrap_or_default();
        let which = match days {
            Some(days) => days.iter().map(u32::to_string).collect::<Vec<_>>().join(","),
            None => individuals.to_string(),
        };
        let wish = format!("{which} {}", measure.words());
        let (name, number) = (place.name.clone(), place.step);
        spawn_local(async move {
            let mesh = subject::mesh_of(&link::read(&link, plants::all()).scene).await;
            with(|studio| {
                let lessons = &mut studio.lessons;
                let growth = lessons.growth.as_mut();
                let Some(growth) = growth.filter(|g| g.name == name && g.step == number) else {
                    return;
                };
                let started = mesh
                    .map_err(|why| format!("The plant's body did not come: {why}."))
                    .and_then(|mesh| {
                        Work::start([MEASURE, &link, &mesh], wish, |said| {
                            with(|studio| studio.lessons.hear(said));
                        })
                    });
                match started {
                    Ok(work) => growth.work = Some(work),
                    Err(why) => lessons.give_up(&why),
                }
            });
        });
    }

    fn hear(&mut self, said: Said) {
        let Some(growth) = &mut self.growth else { return };
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => self.give_up(&why),
            Said::Done(answer) => match answer.get(0).as_f64() {
                Some(value) => {
                    growth.values.push(value);
                    let done = growth.values.len() as u32;
                    self.show_progress(Some((done, 0)));
                }
                None => {
                    growth.work = None;
                    growth.is_measured = true;
                    self.reveal();
                }
            },
        }
    }

    fn give_up(&mut self, why: &str) {
        self.growth = None;
        self.show_progress(None);
        self.tell(why);
    }

    /// Shows what has grown once all is measured and the page rests.
    fn reveal(&mut self) {
        let rests =
            matches!(root().get_attribute("data-state").as_deref(), Some("ready" | "error"));
        let Some(place) = self.place.clone() else { return };
        let Some(growth) = self.growth.take_if(|growth| {
            rests && growth.is_measured && growth.name == place.name && growth.step == place.step
        }) else {
            return;
        };
        let step = &place.lesson.steps[place.step];
        let scene = link::read(step.link.as_deref().unwrap_or_default(), plants::all()).scene;
        let usual = match &step.kind {
            Kind::Grow(growing) => growing.measure.and_then(|measure| measure.usual(&scene)),
            _ => None,
        };
        let grown = Grown { values: growth.values, usual };
        self.answers.entry(place.name.clone()).or_default().grow(place.step, grown);
        self.finish(&place);
    }

    /// Shows a step that has grown, and says for those who listen what stands there.
    fn finish(&self, place: &Place) {
        self.show_progress(None);
        self.show_result(place);
        let answers = self.answers.get(&place.name);
        let told = answers.map(|answers| answers.beside(&place.lesson, place.step));
        let told = told.unwrap_or_default();
        let told: Vec<String> =
            told.into_iter().map(|(name, told)| format!("{name}: {told}.")).collect();
        let is_told = !told.is_empty();
        self.tell(&if is_told { told.join(" ") } else { "It has grown.".to_string() });
        set_flag(&self.part(".outcome"), "data-told", is_told);
    }

    fn tell(&self, text: &str) {
        set_text(&self.part(".told"), text);
    }

    /// How many have grown of how many; of 0, of as many as before.
    fn show_progress(&self, done: Option<(u32, u32)>) {
        let progress: Element = self.part(".outcome progress");
        set_flag(&progress, "hidden", done.is_none());
        set_flag(&self.part(".outcome"), "data-told", false);
        if let Some((done, all)) = done {
            if all > 0 {
                set_attribute(&progress, "max", all.to_string());
            }
            set_attribute(&progress, "value", done.to_string());
        }
    }
}
