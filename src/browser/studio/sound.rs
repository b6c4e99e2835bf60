//! The share of the first colour as a tone while days go by, for who likes to hear it: silent until it is ticked.

use super::subject;
use crate::browser::dom::{Listener, document, find, on};
use std::cell::RefCell;
use wasm_bindgen::JsValue;
use web_sys::{AudioContext, Element, Event, GainNode, HtmlInputElement, OscillatorNode};

/// The tone of no such cell; that of nothing but such cells is two octaves higher.
const LOWEST_HZ: f32 = 220.0;
const OCTAVES: f32 = 2.0;
/// How loud it is, of 1; how long it sounds, and how fast it comes and goes, in seconds.
const LOUDNESS: f32 = 0.12;
const SOUNDS_S: f64 = 0.12;
const FADES_S: f64 = 0.02;

pub struct Sound {
    tone: RefCell<Option<Tone>>,
    /// The day that sounded last.
    day: RefCell<String>,
    _listener: Listener,
}

struct Tone {
    context: AudioContext,
    oscillator: OscillatorNode,
    gain: GainNode,
}

impl Sound {
    pub fn new() -> Sound {
        let tick: HtmlInputElement = find("sound");
        let ticked = tick.clone();
        let listener = on(&tick, "change", move |_: Event| {
            let is_on = ticked.checked();
            super::with(|studio| studio.sound.turn(is_on));
        });
        subject::on_change(|| super::with(|studio| studio.sound.hear()));
        Sound { tone: RefCell::default(), day: RefCell::default(), _listener: listener }
    }

    fn turn(&self, is_on: bool) {
        // A browser without sound stays silent.
        *self.tone.borrow_mut() = if is_on { Tone::new().ok() } else { None };
        self.hear();
    }

    /// Sounds if another day is on the screen.
    fn hear(&self) {
        let tone = self.tone.borrow();
        let Some(tone) = &*tone else { return };
        let root = document().document_element().expect("a document has a root");
        let day = root.get_attribute("data-day").unwrap_or_default();
        if *self.day.borrow() == day {
            return;
        }
        let share = find::<Element>("fact-share").text_content().unwrap_or_default();
        if let Some(percent) = percent(&share) {
            let _ = tone.sound(LOWEST_HZ * (OCTAVES * percent / 100.0).exp2());
        }
        *self.day.borrow_mut() = day;
    }
}

/// The first number of a text: 38 of `38% yellow`.
fn percent(text: &str) -> Option<f32> {
    let from = text.find(|c: char| c.is_ascii_digit())?;
    let digits = text[from..].split(|c: char| !c.is_ascii_digit()).next()?;
    // What reads fractions brings ten kilobytes of a table.
    digits.parse::<u16>().ok().map(f32::from)
}

impl Tone {
    fn new() -> Result<Tone, JsValue> {
        let context = AudioContext::new()?;
        let (oscillator, gain) = (context.create_oscillator()?, context.create_gain()?);
        gain.gain().set_value(0.0);
        oscillator.connect_with_audio_node(&gain)?;
        gain.connect_with_audio_node(&context.destination())?;
        oscillator.start()?;
        Ok(Tone { context, oscillator, gain })
    }

    fn sound(&self, pitch_hz: f32) -> Result<(), JsValue> {
        let now_s = self.context.current_time();
        self.oscillator.frequency().set_value_at_time(pitch_hz, now_s)?;
        let gain = self.gain.gain();
        gain.cancel_scheduled_values(now_s)?;
        gain.set_target_at_time(LOUDNESS, now_s, FADES_S)?;
        gain.set_target_at_time(0.0, now_s + SOUNDS_S, FADES_S)?;
        Ok(())
    }
}

impl Drop for Tone {
    fn drop(&mut self) {
        let _ = self.context.close();
    }
}
