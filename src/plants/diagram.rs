//! Drawings on a body in place of its cells: the direction field, and the control images with their
//! cylinders.

use super::{Plant, Show};
use crate::surface::{ControlImage, Cylinder, DirectionField, Mesh, Wrap};
use crate::tissue::{CellType, Control, Use};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// What is drawn on a body in place of its cells. Colours are sRGB.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    pub surface: Coat,
    /// Thin lines in space, from point to point, and their colour.
    pub lines: Vec<[Vec3; 2]>,
    pub ink: [f32; 3],
}

/// What covers the surface under a diagram's lines.
#[derive(Clone, Debug, PartialEq)]
pub enum Coat {
    /// A colour for each triangle.
    Triangles(Vec<[u8; 3]>),
    /// Grey, place by place: white, and then what each layer makes of it.
    Layers(Vec<Layer>),
}

/// A control image on a body: black, it turns the grey `from` into the grey `to`.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    pub wrap: Wrap,
    pub image: ControlImage,
    pub from: f32,
    pub to: f32,
}

/// Dry ink on pale paper for arrows; for cylinders red pencil, which is seen on black and white.
const PAPER: [u8; 3] = [222, 216, 196];
const INK: [f32; 3] = [0.16, 0.2, 0.12];
const PENCIL: [f32; 3] = [0.85, 0.22, 0.1];

impl Show {
    /// The drawing that it is, None for cells and for what the plant does not have. `mesh`: the
    /// plant's surface. Takes as long as a direction field or control images take to make: a few
    /// milliseconds.
    pub fn diagram(self, plant: &Plant, mesh: &Mesh) -> Option<Diagram> {
        let field = || plant.field.map(|lead| lead(mesh));
        match self {
            Show::Cells => None,
            Show::FieldArrows => field().map(|field| arrows(mesh, &field)),
            Show::FieldAngle(axis) => field().map(|field| angles(mesh, &field, Vec3::AXES[axis])),
            Show::ControlImages => Some(images(mesh, plant.controls())),
        }
    }
}

/// An arrow on each triangle, along the field.
fn arrows(mesh: &Mesh, field: &DirectionField) -> Diagram {
    let count = mesh.triangles.len();
    let length_cm = 1.25 * (mesh.area / count as f32).sqrt();
    let mut lines = Vec::new();
    for triangle in 0..count as u32 {
        let along = field.at(triangle);
        if along == Vec2::ZERO {
            continue;
        }
        let [x, y] = mesh.axes(triangle);
        let at = |forwards: f32, sideways: f32| {
            let flat = (along * forwards + along.perp() * sideways) * length_cm;
            mesh.centroid(triangle) + x * flat.x + y * flat.y
        };
        let tip = at(0.5, 0.0);
        lines.extend([[at(-0.5, 0.0), tip], [at(0.15, 0.2), tip], [at(0.15, -0.2), tip]]);
    }
    Diagram { surface: Coat::Triangles(vec![PAPER; count]), lines, ink: INK }
}

/// Each triangle in the hue of the angle between the field and an axis.
fn angles(mesh: &Mesh, field: &DirectionField, axis: Vec3) -> Diagram {
    let colour = |triangle: u32| {
        let along = field.at(triangle);
        let [x, y] = mesh.axes(triangle);
        match along == Vec2::ZERO {
            true => PAPER,
            false => hue_of_angle((x * along.x + y * along.y).dot(axis)),
        }
    };
    let colours = (0..mesh.triangles.len() as u32).map(colour).collect();
    Diagram { surface: Coat::Triangles(colours), lines: Vec::new(), ink: INK }
}

/// The colour whose hue in HSV is the angle, given by its cosine: red along (0 degrees),
/// yellow-green across (90), cyan against (180) (Thesis 3.2.4).
fn hue_of_angle(cosine: f32) -> [u8; 3] {
    let sixths = libm::acosf(cosine.clamp(-1.0, 1.0)) / (TAU / 6.0);
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    [byte(2.0 - sixths), byte(sixths), byte(sixths - 2.0)]
}

/// The types of cells that the images leave a first F cell, white for F, grey for M, black for B;
/// and the cylinders.
fn images(mesh: &Mesh, controls: Vec<Control>) -> Diagram {
    let cylinders: Vec<Cylinder> = controls
        .iter()
        .filter_map(|control| match control.wrap {
            Wrap::Cylinder(cylinder) => Some(cylinder),
            Wrap::Leaf => None,
        })
        .collect();
    let lines = cylinders.iter().flat_map(|c| outline(c, radius_cm(c, &cylinders, mesh))).collect();
    let layers = controls.into_iter().map(|Control { wrap, image, use_as }| {
        let [from, to] = match use_as {
            Use::FirstCells { of, instead } => [grey(of), grey(instead)],
            Use::DivisionDays { .. } => [1.0, 0.0],
        };
        Layer { wrap, image, from, to }
    });
    Diagram { surface: Coat::Layers(layers.collect()), lines, ink: PENCIL }
}

fn grey(kind: CellType) -> f32 {
    match kind {
        CellType::Foreground => 1.0,
        CellType::Middle => 0.5,
        CellType::Background => 0.0,
    }
}

/// How far a cylinder must reach to hold what it wraps: all points of the mesh at its heights that
/// are nearer to its axis than to those of the others.
fn radius_cm(cylinder: &Cylinder, all: &[Cylinder], mesh: &Mesh) -> f32 {
    let off_axis =
        |c: &Cylinder, point: Vec3| (point - c.base).reject_from_normalized(c.axis).length();
    let wrapped = mesh.positions.iter().filter(|&&point| {
        (0.0..=1.0).contains(&cylinder.coordinates(point).1)
            && all.iter().all(|other| off_axis(cylinder, point) <= off_axis(other, point))
    });
    wrapped.map(|&point| off_axis(cylinder, point)).fold(0.0, f32::max)
}

/// Bottom, top and axis of a cylinder, and the line where its images begin and end.
fn outline(cylinder: &Cylinder, radius_cm: f32) -> Vec<[Vec3; 2]> {
    const SEGMENTS: u32 = 72;
    let Cylinder { base, axis, zero, height } = *cylinder;
    let up = axis * height;
    let rim = |k: u32| {
        let (sin, cos) = libm::sincosf(k as f32 / SEGMENTS as f32 * TAU);
        base + (zero * cos + axis.cross(zero) * sin) * radius_cm
    };
    let past = up * 0.06;
    let mut lines = vec![[base - past, base + up + past], [rim(0), rim(0) + up]];
    for k in 0..SEGMENTS {
        let [from, to] = [rim(k), rim(k + 1)];
        lines.extend([[from, to], [from + up, to + up]]);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::find;

    #[test]
    fn along_is_red_and_across_is_yellow_green() {
        assert_eq!(hue_of_angle(1.0), [255, 0, 0]);
        assert_eq!(hue_of_angle(0.5), [255, 255, 0]);
        assert_eq!(hue_of_angle(0.0), [128, 255, 0]);
        assert_eq!(hue_of_angle(-0.5), [0, 255, 0]);
        assert_eq!(hue_of_angle(-1.0), [0, 255, 255]);
    }

    #[test]
    fn arrows_lie_on_their_triangles_along_the_field() {
        let plant = find("philodendron").unwrap();
        let mesh = plant.embedded_body().surface;
        let field = (plant.field.unwrap())(&mesh);
        let diagram = Show::FieldArrows.diagram(plant, &mesh).unwrap();
        let arrows = diagram.lines.chunks_exact(3);
        assert_eq!(arrows.len(), mesh.triangles.len());
        for (triangle, arrow) in (0..).zip(arrows) {
            let [from, to] = arrow[0];
            assert!(from.midpoint(to).distance(mesh.centroid(triangle)) < 1e-4);
            let [x, y] = mesh.axes(triangle);
            let along = field.at(triangle);
            let shaft = (to - from).normalize();
            assert!(shaft.distance(x * along.x + y * along.y) < 1e-3, "triangle {triangle}");
            assert!(arrow.iter().all(|line| line[1] == to), "all lines end at the tip");
        }
    }

    #[test]
    fn a_cylinder_just_holds_what_it_wraps() {
        for (key, count) in [("watermelon", 1), ("croton", 1), ("philodendron", 0)] {
            let plant = find(key).unwrap();
            let mesh = plant.embedded_body().surface;
            let cylinders: Vec<Cylinder> = plant
                .controls()
                .iter()
                .filter_map(|c| if let Wrap::Cylinder(c) = c.wrap { Some(c) } else { None })
                .collect();
            assert_eq!(cylinders.len(), count, "{key}");
            let lines = Show::ControlImages.diagram(plant, &mesh).unwrap().lines;
            assert_eq!(lines.is_empty(), count == 0, "{key}");
        }
    }
}
