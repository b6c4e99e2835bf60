//! The time line: the slider of days with what has grown of it, play, steps, speed and typed day.

use super::app;
use super::dom::{Listener, find, offer, on, set_attribute, set_flag, set_text};
use super::typing::{self, set_value};
use crate::play::link::DAY;
use crate::play::page::{Event, Page};
use crate::play::playhead::SPEEDS;
use crate::play::strip::strip;
use crate::surface::{Shortest, decimal, rounded};
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlInputElement, HtmlSelectElement, KeyboardEvent};

pub struct Timeline {
    slider: HtmlInputElement,
    number: HtmlInputElement,
    refusal: Element,
    grown: Element,
    last_day: Element,
    play: Element,
    notice: Element,
    strip: Element,
    /// Growth, newest, shown and last day that the strip shows, and in which colours.
    in_strip: Option<([u32; 4], [[f32; 3]; 3])>,
    _listeners: Vec<Listener>,
}

impl Timeline {
    pub fn new() -> Timeline {
        let slider: HtmlInputElement = find("day");
        let number: HtmlInputElement = find("day-number");
        let speed: HtmlSelectElement = find("speed");
        speed.set_text_content(None);
        for times in SPEEDS {
            let times = times.shortest();
            offer(&speed, &times, &format!("{times}×"));
        }
        speed.set_value("1");
        let mut listeners = Vec::new();
        let hand = slider.clone();
        listeners.push(on(&slider, "input", move |_: web_sys::Event| {
            app::send(Event::Scrub(hand.value_as_number()));
        }));
        listeners.push(on(&slider, "change", |_: web_sys::Event| app::send(Event::LetGo)));
        listeners.push(on(&slider, "keydown", step_by_key));
        listeners.extend(typing::watch(&number, 1.0, |day| app::send(Event::Day(day))));
        for (id, event) in [
            ("first", Event::Seek(0)),
            ("back", Event::StepDays(-1)),
            ("play", Event::PlayOrPause),
            ("on", Event::StepDays(1)),
            ("last", Event::Seek(u32::MAX)),
        ] {
            let button: Element = find(id);
            listeners.push(on(&button, "click", move |_: web_sys::Event| app::send(event.clone())));
        }
        let chosen = speed.clone();
        listeners.push(on(&speed, "change", move |_: web_sys::Event| {
            if let Some(speed) = decimal(&chosen.value()) {
                app::send(Event::Speed(speed));
            }
        }));
        let looping: HtmlInputElement = find("loop");
        let checked = looping.clone();
        listeners.push(on(&looping, "change", move |_: web_sys::Event| {
            app::send(Event::Loop(checked.checked()));
        }));
        Timeline {
            slider,
            number,
            refusal: find("day-refusal"),
            grown: find("grown"),
            last_day: find("last-day"),
            play: find("play"),
            notice: find("notice"),
            strip: find("strip"),
            in_strip: None,
            _listeners: listeners,
        }
    }

    pub fn show(&mut self, page: &Page) {
        let (run, playhead) = (page.run(), page.playhead());
        let last_day = run.last_day();
        let grown = run.grown().unwrap_or(0);
        let wished = playhead.wished_day();
        for element in [self.slider.as_ref(), &self.grown] {
            set_attribute(element, "max", last_day.to_string());
        }
        set_attribute(&self.grown, "value", grown.to_string());
        set_text(&self.last_day, &last_day.to_string());
        if !playhead.is_scrubbed() {
            let time = if playhead.is_playing() { playhead.time() } else { f64::from(wished) };
            set_value(&self.slider, &rounded(time, 1e3));
        }
        let shown = page.shown().day.as_ref().map_or(wished, |d| d.day);
        set_attribute(&self.slider, "aria-valuetext", format!("day {shown}"));
        let day = if playhead.is_playing() { shown } else { wished };
        typing::show(&self.number, &day.to_string(), &self.refusal, page.refusal(DAY));
        set_attribute(
            &self.play,
            "aria-label",
            if playhead.is_playing() { "Pause" } else { "Play" },
        );
        set_flag(&self.play, "data-playing", playhead.is_playing());
        set_text(&self.notice, &page.notice());
        let colours = page.scene().look.cells;
        let in_strip =
            run.newest().map(|newest| ([run.generation, newest, shown, last_day], colours));
        if in_strip != self.in_strip {
            self.in_strip = in_strip;
            set_attribute(&self.strip, "viewBox", format!("0 0 {last_day} 1000"));
            self.strip.set_inner_html(&strip(run, &colours, shown));
        }
    }
}

/// The slider runs between the days, too; its arrow keys step by whole ones.
fn step_by_key(event: KeyboardEvent) {
    let by = match event.key().as_str() {
        "ArrowRight" | "ArrowUp" => 1,
        "ArrowLeft" | "ArrowDown" => -1,
        "PageUp" => 5,
        "PageDown" => -5,
        _ => return,
    };
    event.unchecked_ref::<web_sys::Event>().prevent_default();
    app::send(Event::StepDays(by));
}
