//! The strokes of a petal as points that are drawn: each lies in a field of the dialog as text, `0_0;1.5_4`, and here
//! it is moved by mouse, finger or arrow keys.

use super::field::each;
use super::shape::ShapeView;
use super::wish::SHAPE;
use super::with;
use crate::browser::dom::{Listener, on, set_attribute, within};
use crate::import::{in_few_points, line_meant};
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
    /// A line that is being drawn anew.
    drawn: Vec<[f64; 2]>,
    _listeners: Vec<Listener>,
}

/// Centimetres that an arrow key moves a point, and with the shift key.
const STEP_CM: [f64; 2] = [0.1, 0.5];
/// A line that is drawn anew is at least so long.
const LEAST_CM: f64 = 1.0;
/// Free around the strokes, in centimetres.
const MARGIN_CM: f64 = 1.2;

impl Strokes {
    /// A drawing of the strokes that its attribute names; `which` of them it is, for its listeners.
    pub fn new(view: Element, which: usize) -> Strokes {
        let listeners = vec![
            on(&view, "pointerdown", move |event: PointerEvent| {
                event.prevent_default();
                with(|studio| {
                    studio.shape.begin_act();
                    let strokes = &mut studio.shape.strokes[which];
                    let _ = strokes.view.set_pointer_capture(event.pointer_id());
                    strokes.in_hand = point_of(&event);
                    if strokes.in_hand.is_none() {
                        strokes.draw_on(&event);
                    }
                });
            }),
            on(&view, "pointermove", move |event: PointerEvent| {
                with(|studio| {
                    let strokes = &mut studio.shape.strokes[which];
                    if let Some((key, k)) = strokes.in_hand.clone() {
                        let at = strokes.place(&event);
                        studio.shape.move_point(&key, k, |_| at);
                    } else if !strokes.drawn.is_empty() {
                        strokes.draw_on(&event);
                    }
                });
            }),
            on(&view, "pointerup", move |_: PointerEvent| {
                with(|studio| {
                    studio.shape.strokes[which].in_hand = None;
                    studio.shape.take_drawn(which);
                });
            }),
            on(&view, "pointercancel", move |_: PointerEvent| {
                with(|studio| {
                    let strokes = &mut studio.shape.strokes[which];
                    strokes.in_hand = None;
                    strokes.lift_pen();
                });
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
        Strokes { view, frame: [0.0; 4], in_hand: None, drawn: Vec::new(), _listeners: listeners }
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
            html += "<polyline class=pen />";
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

    /// Goes on with the line that is being drawn.
    fn draw_on(&mut self, event: &PointerEvent) {
        self.drawn.push(self.place(event));
        let corners: Vec<String> = self.drawn.iter().map(|[x, y]| format!("{x},{}", -y)).collect();
        set_attribute(&within::<Element>(&self.view, ".pen"), "points", corners.join(" "));
    }

    /// The line that was drawn; it is seen no longer.
    fn lift_pen(&mut self) -> Vec<[f64; 2]> {
        set_attribute(&within::<Element>(&self.view, ".pen"), "points", "");
        std::mem::take(&mut self.drawn)
    }

    /// Where in centimetres the pointer is, to a hundredth.
    fn place(&self, event: &PointerEvent) -> [f64; 2] {
        let [x, y] = [event.client_x(), event.client_y()].map(f64::from);
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

/// The edges of a petal, which may mirror each other.
const EDGES: [&str; 2] = ["petals.left_cm", "petals.right_cm"];

impl ShapeView {
    /// Moves a point of a stroke, and the one across it where both edges are alike.
    pub(super) fn move_point(&mut self, key: &str, k: usize, to: impl Fn([f64; 2]) -> [f64; 2]) {
        let field = |key: &str| field(&self.dialog, key);
        let Some(mut points) = points_of(&field(key)) else { return };
        let Some(point) = points.get_mut(k) else { return };
        *point = to(*point).map(|cm| hundredths(cm.clamp(-100.0, 100.0)));
        self.set_stroke(key, &points);
    }

    /// Puts a line that was drawn by hand in the place of the stroke that it is nearest to.
    fn take_drawn(&mut self, which: usize) {
        let drawn = self.strokes[which].lift_pen();
        let keys = self.strokes[which].keys();
        let field = |key: &str| field(&self.dialog, key);
        let lines = keys.iter().map(|key| points_of(&field(key))).collect::<Option<Vec<_>>>();
        let Some(lines) = lines else { return };
        let Some(meant) = line_meant(&drawn, &lines) else { return };
        let Some(points) = in_few_points(&drawn, &lines[meant], LEAST_CM) else { return };
        let points: Vec<[f64; 2]> = points.into_iter().map(|point| point.map(hundredths)).collect();
        self.set_stroke(&keys[meant], &points);
    }

    /// Gives a stroke its points, and its mirror image to the one across it where both edges are alike.
    fn set_stroke(&mut self, key: &str, points: &[[f64; 2]]) {
        write(&field(&self.dialog, key), points);
        self.exact.retain(|(other, _)| other != key);
        let is_alike = within::<HtmlInputElement>(&self.dialog, ".alike").checked();
        let edge = EDGES.iter().position(|edge| *edge == key).filter(|_| is_alike);
        if let Some(across) = edge.map(|edge| EDGES[1 - edge]) {
            let mirrored: Vec<[f64; 2]> = points.iter().map(|[x, y]| [-x + 0.0, *y]).collect();
            write(&field(&self.dialog, across), &mirrored);
            self.exact.retain(|(other, _)| other != across);
        }
        self.act_on(key);
        self.tell_numbers();
        self.wish(SHAPE);
    }

    /// Draws the petals that the fields have.
    pub(super) fn show_strokes(&mut self) {
        let field = |key: &str| field(&self.dialog, key);
        for drawing in &mut self.strokes {
            let stroke = |key: String| {
                let field = field(&key);
                let points = points_of(&field)?;
                Some((key, name_of(&field), points))
            };
            let strokes: Vec<_> = drawing.keys().into_iter().filter_map(stroke).collect();
            drawing.show(&strokes);
        }
    }
}

/// The field of a stroke.
fn field(dialog: &Element, key: &str) -> HtmlInputElement {
    within(dialog, &format!("[data-key=\"{key}\"]"))
}

fn hundredths(cm: f64) -> f64 {
    (100.0 * cm).round() / 100.0 + 0.0
}

/// The points of a field, or none where they are no points.
fn points_of(field: &HtmlInputElement) -> Option<Vec<[f64; 2]>> {
    let value = field.value();
    let point = |point: &str| {
        let (x, y) = point.split_once('_')?;
        let both = [x, y].map(|number| typed::number(number, false));
        both.iter().all(|number| number.is_finite()).then_some(both)
    };
    value.split_terminator(';').map(point).collect()
}

/// Writes points into a field.
fn write(field: &HtmlInputElement, points: &[[f64; 2]]) {
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
fn name_of(field: &HtmlInputElement) -> String {
    let label = field.closest("label").ok().flatten();
    let text = label.and_then(|label| label.text_content()).unwrap_or_default();
    text.trim().to_string()
}
