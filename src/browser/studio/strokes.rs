//! The strokes of a petal as points that are drawn: each lies in a field of the dialog as text, `0_0;1.5_4`, and here
//! it is moved by mouse, finger or arrow keys.

use super::field::each;
use super::with;
use crate::browser::dom::{Listener, on, set_attribute};
use crate::play::typed;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlInputElement, KeyboardEvent, PointerEvent};

/// Of a drawing: its element, and how its centimetres lie on the screen.
pub struct Strokes {
    view: Element,
    /// Left, top, width and height of what is seen, in centimetres; `y` goes down.
    frame: [f64; 4],
    /// The point in hand: its stroke and which of it.
    in_hand: Option<(String, usize)>,
    _listeners: Vec<Listener>,
}

/// Centimetres that an arrow key moves a point, and with the shift key.
const STEP_CM: [f64; 2] = [0.1, 0.5];
/// Free around the strokes, in centimetres.
const MARGIN_CM: f64 = 1.2;

impl Strokes {
    /// A drawing of the strokes that its attribute names; `which` of them it is, for its listeners.
    pub fn new(view: Element, which: usize) -> Strokes {
        let listeners = vec![
            on(&view, "pointerdown", move |event: PointerEvent| {
                let Some((key, k)) = point_of(&event) else { return };
                event.prevent_default();
                with(|studio| {
                    studio.shape.begin_act();
                    let strokes = &mut studio.shape.strokes[which];
                    let _ = strokes.view.set_pointer_capture(event.pointer_id());
                    strokes.in_hand = Some((key, k));
                });
            }),
            on(&view, "pointermove", move |event: PointerEvent| {
                with(|studio| {
                    let strokes = &studio.shape.strokes[which];
                    if let Some((key, k)) = strokes.in_hand.clone() {
                        let at = strokes.place([event.client_x(), event.client_y()].map(f64::from));
                        studio.shape.move_point(&key, k, |_| at);
                    }
                });
            }),
            on(&view, "pointerup", move |_: PointerEvent| {
                with(|studio| studio.shape.strokes[which].in_hand = None);
            }),
            on(&view, "keydown", move |event: KeyboardEvent| {
                let way = match &*event.key() {
                    "ArrowLeft" => [-1.0, 0.0],
                    "ArrowRight" => [1.0, 0.0],
                    "ArrowUp" => [0.0, 1.0],
                    "ArrowDown" => [0.0, -1.0],
                    _ => return,
                };
                let Some((key, k)) = point_of(&event) else { return };
                event.prevent_default();
                let step = STEP_CM[usize::from(event.shift_key())];
                with(|studio| {
                    if !event.repeat() {
                        studio.shape.begin_act();
                    }
                    studio
                        .shape
                        .move_point(&key, k, |[x, y]| [x + step * way[0], y + step * way[1]]);
                });
            }),
        ];
        Strokes { view, frame: [0.0; 4], in_hand: None, _listeners: listeners }
    }

    /// Draws the strokes, each by its name in words and its points. What is seen stays while a point is in hand.
    pub fn show(&mut self, strokes: &[(String, String, Vec<[f64; 2]>)]) {
        let points = || strokes.iter().flat_map(|(_, _, points)| points).copied();
        if self.in_hand.is_none() {
            let low = points().fold([f64::MAX; 2], |a, b| [a[0].min(b[0]), a[1].min(b[1])]);
            let high = points().fold([f64::MIN; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
            let [width, height] = [0, 1].map(|k| high[k] - low[k] + 2.0 * MARGIN_CM);
            self.frame = [low[0] - MARGIN_CM, -high[1] - MARGIN_CM, width, height];
            let frame = self.frame.map(|cm| cm.to_string()).join(" ");
            set_attribute(&self.view, "viewBox", frame);
        }
        let counts: Vec<String> =
            strokes.iter().map(|(.., points)| points.len().to_string()).collect();
        let counts = counts.join(" ");
        if self.view.get_attribute("data-counts").as_deref() != Some(&counts) {
            set_attribute(&self.view, "data-counts", &counts);
            let mut html = String::new();
            for (key, name, points) in strokes {
                html += &format!("<polyline data-line=\"{key}\"/>");
                for k in 0..points.len() {
                    html += &format!(
                        "<circle tabindex=0 role=button data-of=\"{key}\" data-at={k}><title>{name}, point {}</title></circle>",
                        k + 1
                    );
                }
            }
            self.view.set_inner_html(&html);
        }
        let radius = (0.045 * self.frame[2]).to_string();
        let dots = each(&self.view, "circle");
        let all = strokes.iter().flat_map(|(_, _, points)| points);
        for (dot, [x, y]) in dots.iter().zip(all) {
            set_attribute(dot, "cx", x.to_string());
            set_attribute(dot, "cy", (-y).to_string());
            set_attribute(dot, "r", &radius);
        }
        for (line, (.., points)) in each(&self.view, "polyline").iter().zip(strokes) {
            let corners: Vec<String> = points.iter().map(|[x, y]| format!("{x},{}", -y)).collect();
            set_attribute(line, "points", corners.join(" "));
        }
    }

    /// Where in centimetres a place on the screen is, to a hundredth.
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let on_screen = self.view.get_bounding_client_rect();
        let [left, top, width, height] = self.frame;
        let [x, y] = [
            left + width * (x - on_screen.left()) / on_screen.width(),
            -(top + height * (y - on_screen.top()) / on_screen.height()),
        ];
        [x, y].map(hundredths)
    }

    /// The strokes that it shows.
    pub fn keys(&self) -> Vec<String> {
        let keys = self.view.get_attribute("data-strokes").unwrap_or_default();
        keys.split(' ').map(String::from).collect()
    }
}

pub fn hundredths(cm: f64) -> f64 {
    (100.0 * cm).round() / 100.0 + 0.0
}

/// The points of a field, or none where they are no points.
pub fn points(field: &HtmlInputElement) -> Option<Vec<[f64; 2]>> {
    let value = field.value();
    let point = |point: &str| {
        let (x, y) = point.split_once('_')?;
        let both = [x, y].map(|number| typed::number(number, false));
        both.iter().all(|number| number.is_finite()).then_some(both)
    };
    value.split_terminator(';').map(point).collect()
}

/// Writes points into a field.
pub fn write(field: &HtmlInputElement, points: &[[f64; 2]]) {
    let words: Vec<String> = points.iter().map(|[x, y]| format!("{x}_{y}")).collect();
    field.set_value(&words.join(";"));
}

/// The point that an event is at.
fn point_of(event: &Event) -> Option<(String, usize)> {
    let dot: Element = event.target()?.dyn_into().ok()?;
    let dot = dot.closest("circle").ok()??;
    Some((dot.get_attribute("data-of")?, dot.get_attribute("data-at")?.parse().ok()?))
}

/// A drawing for each element of the dialog that is one.
pub fn all(dialog: &Element) -> Vec<Strokes> {
    let views = each(dialog, "svg[data-strokes]");
    views.into_iter().enumerate().map(|(k, view)| Strokes::new(view, k)).collect()
}

/// What a field is called.
pub fn name_of(field: &HtmlInputElement) -> String {
    let label = field.closest("label").ok().flatten();
    let text = label.and_then(|label| label.text_content()).unwrap_or_default();
    text.trim().to_string()
}
