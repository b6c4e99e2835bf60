//! The dialog in which numbers are looked for that make what is wanted of a plant.

use super::subject::{self, link_of};
use super::wish::{FIT, MOST_TRIES};
use super::with;
use super::work::{Said, Work, refusal};
use crate::browser::dom::{
    Listener, document, find, offer, on, set_attribute, set_flag, set_text, within,
};
use crate::play::Scene;
use crate::play::lesson::Measure;
use crate::play::typed;
use js_sys::Array;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{
    Element, Event, HtmlDialogElement, HtmlElement, HtmlInputElement, HtmlSelectElement,
};

/// What may be wanted, of each type that the plant has.
const OF_TYPES: [&str; 4] = ["share", "area", "patches", "largest"];

pub struct FitView {
    dialog: HtmlDialogElement,
    work: Option<Work>,
    /// The link of the best so far.
    best: Option<String>,
    _listeners: Vec<Listener>,
}

/// What a button does.
type Act = fn(&mut FitView);

impl FitView {
    pub fn new() -> FitView {
        let dialog: HtmlDialogElement = find("fit-dialog");
        let acts: [(&str, Act); 3] =
            [(".begin", FitView::begin), (".stop", FitView::stop), (".best", FitView::show_best)];
        let mut listeners = Vec::from(acts.map(|(selector, act)| {
            on(&within::<HtmlElement>(&dialog, selector), "click", move |_: Event| {
                with(|studio| act(&mut studio.fit));
            })
        }));
        listeners.push(on(&dialog, "close", |_: Event| with(|studio| studio.fit.stop())));
        FitView { dialog, work: None, best: None, _listeners: listeners }
    }

    /// Opens the dialog on what the page shows.
    pub fn open(&mut self) {
        let scene = subject::scene();
        let told =
            format!("{}, individual {}, day {}", scene.plant.name, scene.individual, scene.day);
        set_text(&self.part(".subject"), &told);
        for (k, (select, _)) in self.fields().into_iter().enumerate() {
            let before = select.value();
            select.set_text_content(None);
            if k > 0 {
                offer(&select, "", "nothing else");
            }
            for words in measures(&scene) {
                if let Some(measure) = Measure::of_words(&words) {
                    offer(&select, &words, &measure.name(scene.plant));
                }
            }
            select.set_value(&before);
            if select.selected_index() < 0 {
                select.set_selected_index(0);
            }
        }
        self.forget("");
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
    }

    /// The measures and their values.
    fn fields(&self) -> Vec<(HtmlSelectElement, HtmlInputElement)> {
        let of = |selector: &str, k: u32| {
            self.dialog.query_selector_all(selector).ok().and_then(|all| all.item(k))
        };
        let field =
            |k| Some((of(".measure", k)?.unchecked_into(), of(".value", k)?.unchecked_into()));
        (0..2).filter_map(field).collect()
    }

    /// What is wanted, as the workshop takes it; in an error, what is wrong with it.
    fn wants(&self) -> Result<String, String> {
        let mut wants = Vec::new();
        for (select, input) in self.fields() {
            let words = select.value();
            let Some(measure) = Measure::of_words(&words) else { continue };
            let value = typed::number(&input.value(), false);
            let most = if measure.is_share() { 100.0 } else { 1e6 };
            if !(0.0..=most).contains(&value) {
                return Err(format!("Say how much: a number from 0 to {most}."));
            }
            let value = if measure.is_share() { value / 100.0 } else { value };
            wants.push(format!("{}={value}", words.replace(' ', "-")));
        }
        Ok(wants.join(","))
    }

    fn begin(&mut self) {
        let wants = match self.wants() {
            Ok(wants) => wants,
            Err(why) => return self.say(&why),
        };
        self.forget("Growing the first one …");
        self.show_progress(Some(0));
        let link = link_of(&subject::address()).to_string();
        spawn_local(async move {
            let mesh = subject::mesh_of(&subject::scene()).await;
            with(|studio| {
                let fit = &mut studio.fit;
                let hear = |said| with(|studio| studio.fit.hear(said));
                let started = mesh
                    .map_err(|why| format!("The plant's body did not come: {why}."))
                    .and_then(|mesh| Work::start([FIT, &link, &mesh], wants, hear));
                match started {
                    Ok(work) => fit.work = Some(work),
                    Err(why) => fit.forget(&why),
                }
            });
        });
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Day(tries) => {
                self.say(&format!("Try {tries} …"));
                self.show_progress(Some(tries));
            }
            Said::Refused(why) => {
                self.forget(&refusal(&why, format!("This cannot be looked for: {why}.")))
            }
            Said::Done(answer) if answer.length() == 2 => self.add(&answer),
            Said::Done(_) => {
                self.work = None;
                self.show_progress(None);
                self.say("No step helps any more: the first line is the best.");
            }
        }
    }

    /// A try that is better than all before comes first.
    fn add(&mut self, answer: &Array) {
        let [told, link] = [0, 1].map(|k| answer.get(k).as_string().unwrap_or_default());
        if let Ok(item) = document().create_element("li") {
            item.set_text_content(Some(&told));
            let _ = self.part(".way").prepend_with_node_1(&item);
        }
        self.best = Some(link);
        set_flag(&self.part(".best"), "hidden", false);
    }

    fn stop(&mut self) {
        if self.work.take().is_some() {
            self.say("Stopped: the first line is the best so far.");
        }
        self.show_progress(None);
    }

    fn show_best(&mut self) {
        if let Some(link) = &self.best {
            subject::show(link);
            self.dialog.close();
        }
    }

    fn forget(&mut self, why: &str) {
        (self.work, self.best) = (None, None);
        self.part(".way").set_text_content(None);
        set_flag(&self.part(".best"), "hidden", true);
        self.show_progress(None);
        self.say(why);
    }

    fn show_progress(&self, tries: Option<u32>) {
        let progress = self.part("progress");
        set_flag(&progress, "hidden", tries.is_none());
        set_flag(&self.part(".stop"), "hidden", tries.is_none());
        set_attribute(&progress, "max", MOST_TRIES.to_string());
        set_attribute(&progress, "value", tries.unwrap_or_default().to_string());
    }

    fn say(&self, text: &str) {
        set_text(&self.part(".said"), text);
    }

    fn part(&self, selector: &str) -> Element {
        within(&self.dialog, selector)
    }
}

/// What may be wanted of a plant.
fn measures(scene: &Scene) -> Vec<String> {
    let names = scene.plant.colour_names.into_iter().zip(["F", "B", "M"]);
    let types: Vec<&str> = names.filter(|(name, _)| !name.is_empty()).map(|(_, of)| of).collect();
    let of_types =
        OF_TYPES.iter().flat_map(|of| types.iter().map(move |kind| format!("{of} {kind}")));
    of_types.chain(["mixed", "cells"].map(String::from)).collect()
}
