//! What the workshop does for the brushes: it finds the places of strokes and makes plants of them, one after the other.

use super::super::brushes::{brushes_of, colour_of};
use super::super::drawing::{Drawing, Fate};
use super::super::presenter::after;
use super::super::wish::{ANEW, SKIN};
use super::super::work::{Said, Work, refusal};
use super::super::{own, painted, with};
use super::Paint;
use crate::browser::dom::{find, offer, set_flag};
use crate::import::Painted;
use crate::plants::Plant;
use js_sys::Array;
use wasm_bindgen::JsValue;
use web_sys::{HtmlElement, HtmlSelectElement, PointerEvent, PointerEventInit};

/// What is painted on.
pub struct Skin {
    pub base: &'static Plant,
    /// The text of its mesh.
    pub mesh: String,
    /// A length that suits it; 0 until the workshop has told it.
    pub size_cm: f32,
}

/// What the workshop is at.
pub enum Asked {
    Skin,
    /// Places of the first stroke.
    Places,
    /// Those of a stroke that is given up.
    Nothing,
    Plant(Painted),
}

impl Paint {
    /// Has the workshop hold a plant ready.
    pub(super) fn hold(&mut self, skin: Skin) {
        if self.card.hidden() {
            return;
        }
        let words = Painted { base: skin.base, strokes: Vec::new() }.write();
        let hear = |said| with(|studio| studio.paint.hear(said));
        match Work::start([SKIN, &words, &skin.mesh], JsValue::NULL, hear) {
            Ok(work) => {
                (self.work, self.asked) = (Some(work), Some(Asked::Skin));
                self.skin = Some(skin);
            }
            Err(why) => self.say(&why),
        }
    }

    fn hear(&mut self, said: Said) {
        match (self.asked.take(), said) {
            (Some(Asked::Skin), Said::Done(answer)) => self.begin(&answer),
            (Some(Asked::Places), Said::Done(answer)) => self.place(&answer),
            (Some(Asked::Plant(painted)), Said::Done(answer)) => {
                if let Some(plant) = own::put_made(&answer, &painted.write()) {
                    self.show_plant(&painted, plant);
                }
            }
            (Some(Asked::Skin), Said::Refused(why)) => {
                (self.skin, self.work) = (None, None);
                self.say(&refusal(&why, format!("The plant's body did not come: {why}.")));
            }
            (_, Said::Refused(why)) => {
                self.forget();
                self.say(&refusal(&why, format!("This cannot be painted: {why}.")));
                // The workshop may have ended.
                if let Some(skin) = self.skin.take() {
                    self.hold(skin);
                }
            }
            _ => {}
        }
        self.go_on();
    }

    /// The workshop holds the plant ready.
    fn begin(&mut self, answer: &Array) {
        let Some(skin) = &mut self.skin else { return };
        let (base, is_new) = (skin.base, skin.size_cm == 0.0);
        skin.size_cm = answer.get(0).as_f64().unwrap_or(1.0) as f32;
        if is_new {
            let brushes: HtmlSelectElement = self.part(".brush");
            brushes.set_text_content(None);
            for (word, told) in brushes_of(base) {
                offer(&brushes, &word, &told);
            }
            self.say("");
        }
        self.agree();
    }

    /// Has the workshop do what comes next, unless it is at something.
    pub(super) fn go_on(&mut self) {
        while self.asked.is_none() && self.step() {}
        set_flag(&self.sheet, "data-busy", self.asked.is_some());
    }

    /// Does one thing of what waits; false if nothing does.
    fn step(&mut self) -> bool {
        let (Some(work), Some(skin)) = (&self.work, &self.skin) else { return false };
        if let Some(painted) = self.wished.take() {
            if let Some(plant) = painted::known(&painted) {
                self.show_plant(&painted, plant);
            } else {
                work.wish([ANEW, &painted.write(), &skin.mesh], JsValue::NULL);
                self.asked = Some(Asked::Plant(painted));
            }
            return true;
        }
        let Some(drawing) = self.drawings.front_mut() else { return false };
        match drawing.go_on(work, skin.base) {
            Fate::Asked => self.asked = Some(Asked::Places),
            Fate::Open => return false,
            fate => self.end(&fate),
        }
        true
    }

    /// The first stroke is drawn.
    fn end(&mut self, fate: &Fate) {
        let Some(Drawing { stroke, .. }) = self.drawings.pop_front() else { return };
        match fate {
            Fate::Begun => {
                self.start = stroke.points.first().copied();
                self.say("The line begins here: Enter again where it ends.");
            }
            Fate::Done => {
                let mut painted = self.latest();
                painted.strokes.push(stroke);
                self.wished = Some(painted);
            }
            _ => {}
        }
    }

    /// The workshop has said where the first stroke lies, and where it is seen.
    fn place(&mut self, answer: &Array) {
        let Some(drawing) = self.drawings.front_mut() else { return };
        let word = |k| answer.get(k).as_string().unwrap_or_default();
        if let Some(press) = drawing.hear(&word(0)) {
            self.drawings.pop_front();
            return give_back(&press);
        }
        let colour = colour_of(drawing.stroke.brush);
        let width_px = answer.get(2).as_f64().unwrap_or_default();
        self.sheet.set_inner_html(&format!(
            "<g stroke='{colour}' stroke-opacity='.6' stroke-width='{width_px}'>{}</g>",
            word(1)
        ));
    }

    /// The strokes that the plant has, or will have when all that is wished is done.
    pub(super) fn latest(&self) -> Painted {
        let coming = match &self.asked {
            Some(Asked::Plant(painted)) => Some(painted),
            _ => None,
        };
        self.wished.as_ref().or(coming).cloned().unwrap_or_else(painted::now)
    }

    fn show_plant(&mut self, painted: &Painted, plant: &'static Plant) {
        painted::show(painted, plant);
        self.say(&match painted.strokes.len() {
            0 => "As the plant was before.".to_string(),
            1 => "1 stroke.".to_string(),
            strokes => format!("{strokes} strokes."),
        });
        self.agree();
    }
}

/// Has the page hear of a pointer that came down beside the plant: there a hand turns it.
fn give_back(press: &PointerEvent) {
    let same = PointerEventInit::new();
    same.set_bubbles(true);
    same.set_pointer_id(press.pointer_id());
    same.set_is_primary(true);
    same.set_client_x(press.client_x());
    same.set_client_y(press.client_y());
    if let Ok(event) = PointerEvent::new_with_event_init_dict("pointerdown", &same) {
        // The studio hears it, too, and is in hand now.
        after(0, move || {
            let _ = find::<HtmlElement>("stage").dispatch_event(&event);
        });
    }
}
