//! The brushes: what is drawn over the plant goes on its skin, and makes a plant of the visitor's own.

mod making;

use super::drawing::Drawing;
use super::work::Work;
use super::{brushes, painted, with};
use crate::browser::dom::{
    Listener, document, find, on, on_first, set_attribute, set_flag, set_text, within,
};
use crate::browser::files;
use crate::import::{Painted, Spot, Stroke};
use glam::Vec2;
use making::{Asked, Skin};
use std::collections::VecDeque;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement, KeyboardEvent, PointerEvent};

pub struct Paint {
    card: HtmlElement,
    /// Over the stage: what is drawn, at once.
    sheet: Element,
    skin: Option<Skin>,
    /// The workshop, as long as the card is open.
    work: Option<Work>,
    /// What it is at.
    asked: Option<Asked>,
    /// Strokes that are not on the plant yet, the first one first.
    drawings: VecDeque<Drawing>,
    /// The strokes that the plant is to have next.
    wished: Option<Painted>,
    /// Where a straight line of the keyboard begins.
    start: Option<Spot>,
    _listeners: Vec<Listener>,
}

impl Paint {
    pub fn new() -> Paint {
        let panel: Element = find("panel");
        let _ = panel.insert_adjacent_html("afterend", include_str!("paint.html"));
        let stage: HtmlElement = find("stage");
        let svg = document().create_element_ns(Some("http://www.w3.org/2000/svg"), "svg");
        let sheet = svg.expect("a page may have drawings");
        set_attribute(&sheet, "class", "painting");
        set_attribute(&sheet, "aria-hidden", "true");
        let _ = stage.append_child(&sheet);
        let card: HtmlElement = find("paint-card");
        let button = |selector: &str, act: fn(&mut Paint)| {
            on(&within::<HtmlElement>(&card, selector), "click", move |_: Event| {
                with(|studio| act(&mut studio.paint));
            })
        };
        let mut listeners = vec![
            button(".undo", Paint::undo),
            button(".clear", Paint::clear),
            button(".done", Paint::close),
            on(&card, "input", |_: Event| with(|studio| studio.paint.agree())),
        ];
        let pointer = |kind: &'static str, act: fn(&mut Paint, &PointerEvent)| {
            on(&sheet, kind, move |event: PointerEvent| {
                with(|studio| act(&mut studio.paint, &event));
            })
        };
        listeners.extend([
            pointer("pointerdown", Paint::press),
            pointer("pointermove", Paint::drag),
            pointer("pointerup", Paint::lift),
            pointer("pointercancel", |paint, _| paint.let_go()),
        ]);
        listeners.push(on_first(&document(), "keydown", |event: KeyboardEvent| {
            with(|studio| studio.paint.hear_key(&event));
        }));
        Paint {
            card,
            sheet,
            skin: None,
            work: None,
            asked: None,
            drawings: VecDeque::new(),
            wished: None,
            start: None,
            _listeners: listeners,
        }
    }

    pub fn open(&mut self) {
        self.say("One moment …");
        self.card.set_hidden(false);
        let _ = self.card.focus();
        let base = painted::now().base;
        spawn_local(async move {
            let mesh = files::read_mesh(base.body.mesh.name).await;
            with(|studio| match mesh {
                Ok(mesh) => studio.paint.hold(Skin { base, mesh, size_cm: 0.0 }),
                Err(why) => studio.paint.say(&format!("The plant's body did not come: {why}.")),
            });
        });
    }

    /// Closes the card, and leaves the plant as it is.
    pub fn close(&mut self) {
        self.forget();
        (self.skin, self.work, self.asked) = (None, None, None);
        self.card.set_hidden(true);
        self.agree();
        let _ = find::<HtmlElement>("stage").focus();
    }

    /// Agrees with what is chosen, and with the plant that is there.
    pub fn agree(&mut self) {
        let is_open = self.is_ready();
        let turns = self.part::<HtmlInputElement>(".turn").checked();
        set_flag(&self.sheet, "data-on", is_open && !turns);
        brushes::agree(&self.card, self.size_cm());
        if is_open {
            let none = painted::now().strokes.is_empty();
            set_flag(&self.part::<Element>(".undo"), "disabled", none);
            set_flag(&self.part::<Element>(".clear"), "disabled", none);
        }
    }

    /// The page shows something else than before.
    pub fn follow(&mut self) {
        let root = document().document_element().expect("a document has a root");
        if self.drawings.is_empty() && root.get_attribute("data-state").as_deref() == Some("ready")
        {
            self.sheet.set_text_content(None);
        }
        let Some(skin) = &self.skin else { return };
        if painted::now().base == skin.base { self.agree() } else { self.close() }
    }

    /// Whether the workshop holds the plant ready.
    fn is_ready(&self) -> bool {
        self.size_cm() > 0.0
    }

    fn size_cm(&self) -> f32 {
        self.skin.as_ref().map_or(0.0, |skin| skin.size_cm)
    }

    /// The stroke that would be drawn, without points yet, and whether that is a straight line.
    fn chosen(&self) -> Option<(Stroke, bool)> {
        let chosen = brushes::chosen(&self.card, self.size_cm());
        if chosen.is_none() {
            self.say("Say how much, in per cent from 0 to 1000.");
        }
        chosen
    }

    fn press(&mut self, event: &PointerEvent) {
        // The other buttons and a second finger move the plant.
        if event.button() != 0 || event.shift_key() || !event.is_primary() {
            return self.let_go();
        }
        if !self.is_ready() {
            return;
        }
        let Some((stroke, is_straight)) = self.chosen() else { return };
        event.stop_propagation();
        let _ = self.sheet.set_pointer_capture(event.pointer_id());
        if self.drawings.is_empty() {
            self.sheet.set_text_content(None);
        }
        let at_px = place(event, &self.sheet);
        self.drawings.push_back(Drawing::press(stroke, is_straight, at_px, event.clone()));
        self.go_on();
    }

    /// The stroke that a pointer draws which is still down.
    fn in_hand(&mut self) -> Option<&mut Drawing> {
        self.drawings.back_mut().filter(|drawing| drawing.is_in_hand())
    }

    fn drag(&mut self, event: &PointerEvent) {
        let at_px = place(event, &self.sheet);
        if let Some(drawing) = self.in_hand() {
            event.stop_propagation();
            drawing.drag(at_px);
            self.go_on();
        }
    }

    fn lift(&mut self, event: &PointerEvent) {
        if let Some(drawing) = self.in_hand() {
            event.stop_propagation();
            drawing.lift();
            self.go_on();
        }
    }

    /// Gives up the stroke that is in hand.
    fn let_go(&mut self) {
        if self.in_hand().is_some() {
            self.give_up();
        }
    }

    /// Gives up the last stroke that is not on the plant yet; false without one.
    fn give_up(&mut self) -> bool {
        let is_there = self.drawings.pop_back().is_some();
        if self.drawings.is_empty() {
            self.sheet.set_text_content(None);
            if let Some(Asked::Places) = self.asked {
                self.asked = Some(Asked::Nothing);
            }
        }
        is_there
    }

    fn forget(&mut self) {
        while self.give_up() {}
        (self.wished, self.start) = (None, None);
    }

    fn undo(&mut self) {
        if !self.give_up() {
            let mut painted = self.latest();
            painted.strokes.pop();
            self.wish(painted);
        }
    }

    fn clear(&mut self) {
        let base = painted::now().base;
        self.forget();
        self.wish(Painted { base, strokes: Vec::new() });
    }

    fn wish(&mut self, painted: Painted) {
        self.start = None;
        self.wished = Some(painted);
        self.go_on();
    }

    fn hear_key(&mut self, event: &KeyboardEvent) {
        if !self.is_ready() {
            return;
        }
        let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
        let on_stage = target.is_some_and(|target| target.id() == "stage");
        match &*event.key() {
            "Escape" => {
                event.stop_propagation();
                self.close();
            }
            "Enter" if on_stage && !event.shift_key() => {
                event.stop_propagation();
                event.prevent_default();
                let Some((mut stroke, is_straight)) = self.chosen() else { return };
                stroke.points.extend(self.start.take().filter(|_| is_straight));
                self.drawings.push_back(Drawing::key(stroke, is_straight));
                self.go_on();
            }
            // The plant turns below what was drawn.
            _ if on_stage => self.sheet.set_text_content(None),
            _ => {}
        }
    }

    fn say(&self, text: &str) {
        set_text(&self.part::<Element>(".said"), text);
    }

    fn part<T: JsCast>(&self, selector: &str) -> T {
        within(&self.card, selector)
    }
}

/// Where in the sheet something happens, in pixels.
fn place(event: &PointerEvent, sheet: &Element) -> Vec2 {
    let around = sheet.get_bounding_client_rect();
    let [x, y] = [event.client_x(), event.client_y()].map(f64::from);
    Vec2::new((x - around.left()) as f32, (y - around.top()) as f32)
}
