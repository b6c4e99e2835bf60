//! Drawings on a body in place of its cells: the direction field, and the control images with their
//! cylinders.

use super::{Plant, Show};
use crate::surface::{ControlImage, Cylinder, DirectionField, Mesh, Place, Wrap};
use crate::tissue::{CellType, Control, Use};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// What is drawn on a body in place of its cells: colours or layers, and lines. Without colours and
/// layers the cells are seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagram {
    /// The sRGB colour of each triangle; the fourth byte is nothing.
    pub colours: Vec<[u8; 4]>,
    /// Grey, place by place: white, and then what each layer makes of it.
    pub layers: Vec<Layer>,
    /// Thin lines in space, from point to point, and their colour, sRGB.
    pub lines: Vec<[Vec3; 2]>,
    pub ink: [f32; 3],
    /// Share of a line that is an arrow's head at its end; 0 for none.
    pub head: f32,
}

/// A control image on a body: it turns the grey `from` into the grey `black` where it is black, into
/// `white` where it is white, and between into what lies between.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    pub wrap: Wrap,
    pub image: ControlImage,
    pub from: f32,
    pub black: f32,
    pub white: f32,
}

impl Layer {
    /// What it makes of a grey at a place, as `diagram.wgsl` does.
    fn of(&self, mesh: &Mesh, place: Place, grey: f32) -> f32 {
        if (grey - self.from).abs() >= 0.1 {
            return grey;
        }
        let (turns, height) = self.wrap.coordinates(&self.image, mesh, place);
        let share = f32::from(self.image.nearest(turns, height)) / 255.0;
        self.black + (self.white - self.black) * share
    }
}

/// Dry ink on pale paper for arrows; for cylinders red pencil, which is seen on black and white.
const PAPER: [u8; 4] = [222, 216, 196, 0];
const INK: [f32; 3] = [0.16, 0.2, 0.12];
const PENCIL: [f32; 3] = [0.85, 0.22, 0.1];

impl Show {
    /// The drawing that it is of an individual, empty for cells and for what the plant does not have.
    /// `mesh`: the plant's surface. Takes as long as a direction field or control images take to make: a few
    /// milliseconds.
    pub fn diagram(self, plant: &Plant, individual: u32, mesh: &Mesh) -> Diagram {
        match self {
            Show::Cells | Show::Clans => Diagram::default(),
            Show::ControlImages => images(mesh, plant.controls(individual)),
            _ => match plant.field(mesh) {
                Ok(Some(field)) => directions(self, mesh, &field),
                _ => Diagram::default(),
            },
        }
    }
}

/// The direction field: an arrow on each triangle, or its angle with an axis as the triangle's
/// colour. Triangles without direction are bare paper.
fn directions(show: Show, mesh: &Mesh, field: &DirectionField) -> Diagram {
    let count = mesh.triangles.len();
    // So long that those of neighbours that point the same way do not run into each other.
    let length_cm = 0.9 * (mesh.area / count as f32).sqrt();
    let mut colours = vec![PAPER; count];
    let mut lines = Vec::new();
    for triangle in 0..count as u32 {
        let flat = field.at(triangle);
        if flat == Vec2::ZERO {
            continue;
        }
        let [x, y] = mesh.axes(triangle);
        let along = x * flat.x + y * flat.y;
        let cosine = match show {
            Show::FieldX => along.x,
            Show::FieldY => along.y,
            Show::FieldZ => along.z,
            _ => {
                let (centre, half) = (mesh.centroid(triangle), along * (0.5 * length_cm));
                lines.push([centre - half, centre + half]);
                continue;
            }
        };
        colours[triangle as usize] = hue_of_angle(cosine);
    }
    Diagram { colours, lines, ink: INK, head: 0.4, ..Diagram::default() }
}

/// The colour whose hue in HSV is the angle, given by its cosine: red along (0 degrees),
/// yellow-green across (90), cyan against (180) (Thesis 3.2.4). Not as bright as can be, so that light
/// and shade are seen on it.
fn hue_of_angle(cosine: f32) -> [u8; 4] {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let sixths = libm::atan2f(sine, cosine) / (TAU / 6.0);
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 216.0) as u8;
    [byte(2.0 - sixths), byte(sixths), byte(sixths - 2.0), 0]
}

/// What the images leave of a first F cell, white for F, grey for M, black for B, each a little
/// lighter the more it is tinted; and the cylinders.
/// Images along veins have no layers: all of them are seen in the middle of each triangle.
fn images(mesh: &Mesh, controls: Vec<Control>) -> Diagram {
    let mut lines = Vec::new();
    let mut layers = Vec::new();
    for Control { wrap, image, use_as } in controls {
        if let Wrap::Cylinder(cylinder) = wrap {
            draw_outline(&cylinder, radius_cm(&cylinder, mesh), &mut lines);
        }
        let grey = |kind: CellType| GREYS[kind as usize];
        let [from, black, white] = match use_as {
            Use::FirstCells { of, instead } => [of, instead, of].map(grey),
            Use::Scale { .. } | Use::Wall => [1.0, 0.0, 1.0],
            Use::Colour { of } => {
                let untinted = 0.65 * grey(of);
                [grey(of), untinted, untinted + 0.35]
            }
        };
        layers.push(Layer { wrap, image, from, black, white });
    }
    let mut colours = Vec::new();
    if layers.iter().any(|layer| matches!(layer.wrap, Wrap::Veins(_))) {
        for triangle in 0..mesh.triangles.len() as u32 {
            let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let grey = layers.iter().fold(1.0, |grey, layer| layer.of(mesh, centre, grey));
            // Between a black and a white that still show their shading.
            let byte = (255.0 * libm::powf(0.015 + 0.785 * grey, 1.0 / 2.2)) as u8;
            colours.push([byte, byte, byte, 0]);
        }
        layers.clear();
    }
    Diagram { colours, layers, lines, ink: PENCIL, ..Diagram::default() }
}

/// Of F, B and M.
const GREYS: [f32; 3] = [1.0, 0.0, 0.5];

/// How far a cylinder must reach to hold all points of the mesh at its heights.
fn radius_cm(cylinder: &Cylinder, mesh: &Mesh) -> f32 {
    let mut radius_cm = 0.0;
    for &point in &mesh.positions {
        let from_base = point - cylinder.base;
        let up_cm = from_base.dot(cylinder.axis);
        if (0.0..=cylinder.height).contains(&up_cm) {
            radius_cm = (from_base - cylinder.axis * up_cm).length().max(radius_cm);
        }
    }
    radius_cm
}

/// Bottom, top and axis of a cylinder, and the line where its images begin and end.
fn draw_outline(cylinder: &Cylinder, radius_cm: f32, lines: &mut Vec<[Vec3; 2]>) {
    const SEGMENTS: u32 = 72;
    let Cylinder { base, axis, zero, height } = *cylinder;
    let (up, side) = (axis * height, axis.cross(zero));
    let mut from = base + zero * radius_cm;
    lines.extend([[base - up * 0.06, base + up * 1.06], [from, from + up]]);
    for k in 1..=SEGMENTS {
        let (sin, cos) = libm::sincosf(k as f32 / SEGMENTS as f32 * TAU);
        let to = base + (zero * cos + side * sin) * radius_cm;
        lines.extend([[from, to], [from + up, to + up]]);
        from = to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::find;

    #[test]
    fn along_is_red_and_across_is_yellow_green() {
        assert_eq!(hue_of_angle(1.0), [216, 0, 0, 0]);
        assert_eq!(hue_of_angle(0.5), [216, 216, 0, 0]);
        assert_eq!(hue_of_angle(0.0), [108, 216, 0, 0]);
        assert_eq!(hue_of_angle(-0.5), [0, 216, 0, 0]);
        assert_eq!(hue_of_angle(-1.0), [0, 216, 216, 0]);
    }

    #[test]
    fn arrows_lie_on_their_triangles_along_the_field() {
        let plant = find("philodendron").unwrap();
        let mesh = plant.embedded_body().surface;
        let field = plant.field(&mesh).unwrap().unwrap();
        let diagram = Show::FieldArrows.diagram(plant, 1, &mesh);
        assert_eq!(diagram.lines.len(), mesh.triangles.len());
        for (triangle, &[from, to]) in (0..).zip(&diagram.lines) {
            assert!(from.midpoint(to).distance(mesh.centroid(triangle)) < 1e-4);
            let [x, y] = mesh.axes(triangle);
            let along = field.at(triangle);
            let way = (to - from).normalize();
            assert!(way.distance(x * along.x + y * along.y) < 1e-3, "triangle {triangle}");
        }
    }

    #[test]
    fn tints_are_shown_on_what_first_cells_may_be() {
        let plant = find("mushroom").unwrap();
        let mesh = plant.embedded_body().surface;
        let layers = Show::ControlImages.diagram(plant, 1, &mesh).layers;
        let greys: Vec<_> = layers.iter().map(|l| [l.from, l.black, l.white]).collect();
        assert_eq!(greys, [[1.0, 0.0, 1.0], [1.0, 0.65, 1.0]]);
        assert!(Show::ControlImages.meaning(plant).ends_with("are tinted."));
        assert!(!Show::ControlImages.meaning(find("croton").unwrap()).contains("tint"));
    }

    #[test]
    fn cylinders_just_hold_what_they_wrap() {
        let plant = find("watermelon").unwrap();
        let mesh = plant.embedded_body().surface;
        let [Control { wrap: Wrap::Cylinder(cylinder), .. }] = plant.controls(1)[..] else {
            panic!("one cylinder");
        };
        let radius_cm = radius_cm(&cylinder, &mesh);
        let off_axis =
            |p: &Vec3| (*p - cylinder.base).reject_from_normalized(cylinder.axis).length();
        let farthest = mesh.positions.iter().map(off_axis).fold(0.0, f32::max);
        assert!((radius_cm - farthest).abs() < 1e-4, "{radius_cm} cm for {farthest} cm");
        for line in Show::ControlImages.diagram(plant, 1, &mesh).lines {
            assert!(line.iter().all(|p| off_axis(p) < radius_cm + 1e-3));
        }

        // Each fly agaric has a cylinder of its own, no wider than its cap.
        let plant = find("amanita").unwrap();
        let mesh = plant.embedded_body().surface;
        for control in &plant.controls(1)[..2] {
            let Wrap::Cylinder(cylinder) = control.wrap else { panic!("a cylinder") };
            let radius_cm = super::radius_cm(&cylinder, &mesh);
            assert!((2.0..6.5).contains(&radius_cm), "{radius_cm} cm");
        }
    }
}
