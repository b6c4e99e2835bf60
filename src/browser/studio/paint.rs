//! The brushes: what is drawn over the plant goes on its skin, and makes a plant of the visitor's own.

use super::brushes::brushes_of;
use super::painted;
use super::skin::{Seen, Skin};
use super::{subject, with};
use crate::browser::dom::{
    Listener, document, find, offer, on, on_first, set_attribute, set_flag, set_text, within,
};
use crate::browser::files;
use crate::import::{Brush, MOST_RADIUS, Painted, Spot, Stroke, Way};
use crate::surface::unpack;
use glam::Vec2;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{
    Element, Event, HtmlElement, HtmlInputElement, HtmlSelectElement, KeyboardEvent, PointerEvent,
};

/// Pixels between the points of a stroke that is drawn by hand, at least.
const APART_PX: f32 = 6.0;
/// Steps of the slider for the radius in the size of the plant, squared: small brushes are set finely.
const RADIUS_STEPS: f32 = 80.0;

pub struct Paint {
    card: HtmlElement,
    /// Over the stage: what is drawn, at once.
    sheet: Element,
    skin: Option<Skin>,
    drawing: Option<Drawing>,
    /// Where a straight line of the keyboard begins.
    start: Option<Spot>,
    _listeners: Vec<Listener>,
}

/// A stroke that is being drawn.
struct Drawing {
    seen: Seen,
    spots: Vec<Spot>,
    from_px: Vec2,
    last_px: Vec2,
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
            pointer("pointercancel", |paint, _| paint.forget()),
        ]);
        listeners.push(on_first(&document(), "keydown", |event: KeyboardEvent| {
            with(|studio| studio.paint.hear_key(&event));
        }));
        Paint { card, sheet, skin: None, drawing: None, start: None, _listeners: listeners }
    }

    pub fn open(&mut self) {
        self.say("One moment …");
        self.card.set_hidden(false);
        let _ = self.card.focus();
        let base = painted::now().base;
        spawn_local(async move {
            let mesh = files::read_mesh(base.body.mesh.name).await;
            let skin = mesh.and_then(|mesh| Skin::new(base, unpack(&mesh)));
            with(|studio| match skin {
                Ok(skin) => studio.paint.begin(skin),
                Err(why) => studio.paint.say(&format!("The plant's body did not come: {why}.")),
            });
        });
    }

    fn begin(&mut self, skin: Skin) {
        let brushes: HtmlSelectElement = self.part(".brush");
        brushes.set_text_content(None);
        for (word, told) in brushes_of(skin.base) {
            offer(&brushes, &word, &told);
        }
        self.skin = Some(skin);
        self.say("");
        self.agree();
    }

    /// Closes the card, and leaves the plant as it is.
    pub fn close(&mut self) {
        self.forget();
        self.skin = None;
        self.card.set_hidden(true);
        self.agree();
        let _ = find::<HtmlElement>("stage").focus();
    }

    /// Agrees with what is chosen, and with the plant that is there.
    pub fn agree(&mut self) {
        let is_open = self.skin.is_some();
        let turns = self.part::<HtmlInputElement>(".turn").checked();
        set_flag(&self.sheet, "data-on", is_open && !turns);
        let is_scale = matches!(self.word().as_str(), "r" | "p" | "df" | "db" | "dm");
        set_flag(&self.part::<Element>(".how-much"), "hidden", !is_scale);
        set_flag(&self.part::<Element>(".of-radius"), "hidden", self.way() == "p");
        if is_open {
            let told = format!("{} cm", f64::from(self.radius()) / 1000.0);
            set_text(&self.part::<Element>(".radius-told"), &told);
            let none = painted::now().strokes.is_empty();
            set_flag(&self.part::<Element>(".undo"), "disabled", none);
            set_flag(&self.part::<Element>(".clear"), "disabled", none);
        }
    }

    /// The page shows something else than before.
    pub fn follow(&mut self) {
        let root = document().document_element().expect("a document has a root");
        if self.drawing.is_none() && root.get_attribute("data-state").as_deref() == Some("ready") {
            self.sheet.set_text_content(None);
        }
        let Some(skin) = &self.skin else { return };
        if painted::now().base == skin.base { self.agree() } else { self.close() }
    }

    fn press(&mut self, event: &PointerEvent) {
        let Some(skin) = &self.skin else { return };
        // The other buttons and a second finger move the plant.
        if event.button() != 0 || event.shift_key() || !event.is_primary() {
            return self.forget();
        }
        let (seen, at_px) = (skin.seen(), place(event, &self.sheet));
        // Beside the plant a hand turns it.
        let Some(spot) = seen.spot(at_px) else { return };
        event.stop_propagation();
        let _ = self.sheet.set_pointer_capture(event.pointer_id());
        self.drawing = Some(Drawing { seen, spots: vec![spot], from_px: at_px, last_px: at_px });
        self.draw();
    }

    fn drag(&mut self, event: &PointerEvent) {
        let (way, at_px) = (self.way(), place(event, &self.sheet));
        let Some(drawing) = &mut self.drawing else { return };
        event.stop_propagation();
        if at_px.distance(drawing.last_px) < APART_PX {
            return;
        }
        drawing.last_px = at_px;
        match &*way {
            "w" => drawing.spots.extend(drawing.seen.spot(at_px)),
            "l" => {
                let from = drawing.from_px;
                let steps = (from.distance(at_px) / (2.0 * APART_PX)) as u32 + 1;
                let along = (0..=steps).map(|k| from.lerp(at_px, k as f32 / steps as f32));
                drawing.spots = along.filter_map(|at| drawing.seen.spot(at)).collect();
            }
            _ => drawing.spots = drawing.seen.spot(at_px).into_iter().collect(),
        }
        self.draw();
    }

    fn lift(&mut self, event: &PointerEvent) {
        let Some(drawing) = self.drawing.take() else { return };
        event.stop_propagation();
        self.add(drawing.spots);
    }

    /// Shows the stroke as far as it is drawn.
    fn draw(&self) {
        let Some(Drawing { seen, spots, .. }) = &self.drawing else { return };
        if let Some(stroke) = self.stroke(spots.clone()) {
            self.show(seen, &stroke);
        }
    }

    fn show(&self, seen: &Seen, stroke: &Stroke) {
        let (lines, width_px) = seen.lines(stroke);
        let colour = self.colour(stroke.brush);
        let line = |points: &Vec<Vec2>| {
            // A dab is a line to itself.
            let last = points.last().into_iter();
            let points = points.iter().chain(last).map(|at| format!("{},{}", at.x, at.y));
            format!("<polyline points='{}'/>", points.collect::<Vec<_>>().join(" "))
        };
        let lines: String = lines.iter().map(line).collect();
        self.sheet.set_inner_html(&format!(
            "<g stroke='{colour}' stroke-opacity='.6' stroke-width='{width_px}'>{lines}</g>"
        ));
    }

    /// The colour in which a brush draws: that of its type, or ink.
    fn colour(&self, brush: Brush) -> String {
        let look = subject::wished().look;
        let [r, g, b] = match brush {
            Brush::Put(kind) | Brush::Only(kind) => look.cells[kind as usize],
            Brush::Erase | Brush::Never(_) => [1.0; 3],
            Brush::Lead => [0.1, 0.1, 0.35],
            _ => [0.75, 0.3, 0.2],
        }
        .map(|part| (part * 255.0) as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    fn stroke(&self, points: Vec<Spot>) -> Option<Stroke> {
        let word = self.word();
        let percent = self.part::<HtmlInputElement>(".percent").value();
        let with_percent = format!("{word}{percent}");
        let brush = Brush::of_word(&word).or_else(|| Brush::of_word(&with_percent))?;
        let way = match &*self.way() {
            "r" => Way::Around,
            "a" => Way::Along,
            "p" => Way::Part,
            _ => Way::Free,
        };
        let is_mirrored = self.part::<HtmlInputElement>(".mirror").checked();
        (!points.is_empty()).then(|| Stroke {
            brush,
            radius: self.radius(),
            way,
            is_mirrored,
            points,
        })
    }

    /// Adds a stroke to those of the plant.
    fn add(&mut self, mut points: Vec<Spot>) {
        points.dedup();
        let Some(stroke) = self.stroke(points) else {
            return self.say("Say how much, in per cent from 0 to 1000.");
        };
        let mut painted = painted::now();
        painted.strokes.push(stroke);
        self.make(painted);
    }

    fn make(&mut self, painted: Painted) {
        self.start = None;
        let Some(obj) = self.skin.as_ref().map(|skin| skin.obj.clone()) else { return };
        // What is made is known to the studio, which is in hand now.
        super::presenter::after(0, move || {
            let shown = painted::show(&painted, &obj);
            with(|studio| match shown {
                Ok(()) => {
                    let told = match painted.strokes.len() {
                        0 => "As the plant was before.".to_string(),
                        1 => "1 stroke.".to_string(),
                        strokes => format!("{strokes} strokes."),
                    };
                    studio.paint.say(&told);
                    studio.paint.agree();
                }
                Err(why) => {
                    studio.paint.forget();
                    studio.paint.say(&format!("This cannot be painted: {why}."));
                }
            });
        });
    }

    fn undo(&mut self) {
        let mut painted = painted::now();
        if painted.strokes.pop().is_some() {
            self.make(painted);
        }
    }

    fn clear(&mut self) {
        let base = painted::now().base;
        self.make(Painted { base, strokes: Vec::new() });
    }

    fn hear_key(&mut self, event: &KeyboardEvent) {
        let Some(skin) = &self.skin else { return };
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
                let seen = skin.seen();
                let Some(spot) = seen.middle() else { return };
                match (&*self.way(), self.start) {
                    ("l", None) => {
                        self.start = Some(spot);
                        self.say("The line begins here: Enter again where it ends.");
                    }
                    ("l", Some(from)) => self.add(seen.between([from, spot])),
                    _ => {
                        if let Some(stroke) = self.stroke(vec![spot]) {
                            self.show(&seen, &stroke);
                        }
                        self.add(vec![spot]);
                    }
                }
            }
            // The plant turns below what was drawn.
            _ if on_stage => self.sheet.set_text_content(None),
            _ => {}
        }
    }

    fn forget(&mut self) {
        self.drawing = None;
        self.sheet.set_text_content(None);
    }

    /// In thousandths of a centimetre, by the size of the plant.
    fn radius(&self) -> u32 {
        let step = self.part::<HtmlInputElement>(".radius").value_as_number() as f32 / RADIUS_STEPS;
        let size_cm = self.skin.as_ref().map_or(1.0, Skin::size_cm);
        // In steps that are read well.
        let hundredths = (step * step * size_cm * 100.0).round().max(2.0);
        let fine = if hundredths < 20.0 { 1.0 } else { 5.0 };
        ((hundredths / fine).round() * fine * 10.0).min(MOST_RADIUS as f32) as u32
    }

    fn word(&self) -> String {
        self.part::<HtmlSelectElement>(".brush").value()
    }

    fn way(&self) -> String {
        self.part::<HtmlSelectElement>(".way").value()
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
