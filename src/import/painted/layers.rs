//! Strokes that do the same, together: what images along them say.

use super::stroke::{Brush, Stroke, Way};
use super::ways::{On, lines_of};
use crate::plants::Plant;
use crate::plants::paint::{Image, ImageRule, Paint, Pixels};
use crate::surface::{AlongVeins, Group, Mesh, PolygonMesh, STROKES, Wrap};
use crate::tissue::{CellType, Use};
use glam::Vec3;

/// The material of faces that were painted bare, and its name in a look.
pub const BARE: &str = "bare:painted";
pub const PAINTED_BARE: &str = "painted";

/// Strokes of one brush.
#[derive(Clone, Debug)]
pub struct Layer {
    pub brush: Brush,
    pub lines: Vec<Painting>,
}

/// A line on the skin, and the radius of the brush that drew it; none of the whole part that it lies on.
#[derive(Clone, Debug)]
pub struct Painting {
    pub radius: u32,
    pub on: Vec<On>,
}

impl Painting {
    /// Where its vertices are: two for a dab.
    pub fn points(&self) -> Vec<Vec3> {
        let twice = if self.on.len() == 1 { 2 } else { 1 };
        self.on.iter().flat_map(|on| std::iter::repeat_n(on.at, twice)).collect()
    }

    fn radius_cm(&self) -> f32 {
        self.radius as f32 * 0.001
    }

    /// How far a point lies from it.
    fn distance_cm(&self, point: Vec3) -> f32 {
        let points = self.points();
        points
            .windows(2)
            .map(|ends| distance_cm([ends[0], ends[1]], point))
            .fold(f32::INFINITY, f32::min)
    }
}

fn distance_cm([from, to]: [Vec3; 2], point: Vec3) -> f32 {
    let (along, way) = (to - from, point - from);
    let share = way.dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    (way - along * share.clamp(0.0, 1.0)).length()
}

impl Layer {
    /// The layers of strokes, those below first. What puts types on the skin hides what lies below, so that only
    /// those that follow each other are one; all other strokes of a brush are.
    pub fn of(strokes: &[Stroke], mesh: &Mesh) -> Result<Vec<Layer>, String> {
        let mut layers: Vec<Layer> = Vec::new();
        for stroke in strokes {
            let radius = if stroke.way == Way::Part { 0 } else { stroke.radius };
            let lines = lines_of(stroke, mesh)?.into_iter().map(|on| Painting { radius, on });
            if stroke.brush == Brush::Erase {
                for line in lines {
                    layers.iter_mut().for_each(|layer| layer.erase(&line, mesh));
                }
                continue;
            }
            let hides = matches!(stroke.brush, Brush::Put(_) | Brush::Never(_));
            let same = layers.iter().rposition(|layer| layer.brush == stroke.brush);
            let same = same.filter(|&k| !hides || k + 1 == layers.len());
            let layer = same.unwrap_or_else(|| {
                layers.push(Layer { brush: stroke.brush, lines: Vec::new() });
                layers.len() - 1
            });
            layers[layer].lines.extend(lines);
        }
        layers.retain(|layer| !layer.lines.is_empty());
        Ok(layers)
    }

    /// The order of its lines of a radius, if it is the layer of a number.
    pub fn order(&self, number: u32, radius: u32) -> u32 {
        STROKES * number + radius
    }

    /// Takes away what a brush meets of it: both skins touch.
    fn erase(&mut self, eraser: &Painting, mesh: &Mesh) {
        let part = |on: &On| mesh.parts[on.triangle as usize];
        let mut kept = Vec::new();
        for line in self.lines.drain(..) {
            let reach_cm = line.radius_cm() + eraser.radius_cm();
            let meets = |on: &On| {
                part(on) == part(&eraser.on[0])
                    && (eraser.radius == 0
                        || line.radius == 0
                        || eraser.distance_cm(on.at) < reach_cm)
            };
            // So fine that a rim of the eraser is round.
            let fine = finer(&line.on, 0.25 * reach_cm);
            if !fine.iter().any(meets) {
                kept.push(line);
                continue;
            }
            let pieces = fine.split(meets).filter(|piece| !piece.is_empty());
            kept.extend(pieces.map(|piece| Painting { on: piece.to_vec(), ..line }));
        }
        self.lines = kept;
    }

    /// Its images on a plant.
    pub fn paint(&self, number: u32, plant: &Plant) -> Vec<Paint> {
        // Those that a plant has not bear no name.
        let has = |kind: &CellType| !plant.colour_names[*kind as usize].is_empty();
        let types = || CellType::ALL.into_iter().filter(has);
        let other = |kind: CellType| match kind {
            CellType::Background => CellType::Foreground,
            _ => CellType::Background,
        };
        let image = |is_white_near: bool, use_as| {
            // The top row lies away from the line.
            const NEAR: &[&str] = &["0", "f"];
            const AWAY: &[&str] = &["f", "0"];
            let rows = if is_white_near { NEAR } else { AWAY };
            Paint {
                // Half of it is the radius.
                wrap: Wrap::Veins(AlongVeins { order: self.order(number, 0), reach_cm: 2.0 }),
                image: Image { width: 1, height: 2, rule: ImageRule::Pixels(Pixels { rows }) },
                use_as,
            }
        };
        match self.brush {
            Brush::Put(kind) => types()
                .filter(|of| *of != kind)
                .map(|of| image(false, Use::FirstCells { of, instead: kind }))
                .collect(),
            Brush::Only(of) => vec![image(true, Use::FirstCells { of, instead: other(of) })],
            Brush::Never(of) => vec![image(false, Use::FirstCells { of, instead: other(of) })],
            Brush::Scale(number, percent) => {
                let white = f64::from(percent) / 100.0;
                vec![image(true, Use::Scale { number, black: 1.0, white })]
            }
            Brush::Bare | Brush::Lead | Brush::Erase => Vec::new(),
        }
    }
}

/// A line with so many points that they lie no farther apart than a length.
fn finer(on: &[On], apart_cm: f32) -> Vec<On> {
    let mut all: Vec<On> = on.first().copied().into_iter().collect();
    for ends in on.windows(2) {
        let steps = (ends[0].at.distance(ends[1].at) / apart_cm.max(0.01)) as u32 + 1;
        for k in 1..=steps {
            let share = k as f32 / steps as f32;
            let near = if 2 * k < steps { ends[0] } else { ends[1] };
            all.push(On { at: ends[0].at + (ends[1].at - ends[0].at) * share, ..near });
        }
    }
    all
}

/// Makes the faces bare whose middles lie under a brush, on the skin that it passed over.
pub fn bare(mesh: &mut PolygonMesh, layers: &[Layer], skin: &Mesh) {
    let lines: Vec<&Painting> = layers
        .iter()
        .filter(|layer| layer.brush == Brush::Bare)
        .flat_map(|layer| &layer.lines)
        .collect();
    let normal = |[a, b, c]: [Vec3; 3]| (b - a).cross(c - a);
    let mut bare_groups: Vec<(u32, u32)> = Vec::new();
    for face in &mut mesh.faces {
        let Group { part, material } = mesh.groups[face.group as usize].clone();
        if material.starts_with("bare:") {
            continue;
        }
        let at = |k: usize| mesh.positions[face.vertices[k] as usize];
        let count = face.vertices.len();
        let centre = (0..count).map(at).sum::<Vec3>() / count as f32;
        let is_under =
            |line: &&&Painting| line.radius == 0 || line.distance_cm(centre) < line.radius_cm();
        if !lines.iter().any(|line| is_under(&line)) {
            continue;
        }
        let distance = |t: &u32| skin.centroid(*t).distance_squared(centre);
        let all = 0..skin.triangles.len() as u32;
        let Some(own) = all.min_by(|s, t| distance(s).total_cmp(&distance(t))) else { continue };
        let is_painted = lines.iter().filter(is_under).any(|line| {
            let near = line.on.iter().min_by(|s, t| {
                s.at.distance_squared(centre).total_cmp(&t.at.distance_squared(centre))
            });
            near.is_some_and(|on| {
                skin.parts[on.triangle as usize] == skin.parts[own as usize]
                    && (line.radius == 0
                        || normal(skin.corners(on.triangle)).dot(normal(skin.corners(own))) > 0.0)
            })
        });
        if is_painted {
            let known = bare_groups.iter().find(|(of, _)| *of == face.group).map(|(_, bare)| *bare);
            face.group = known.unwrap_or_else(|| {
                let number = mesh.groups.len() as u32;
                bare_groups.push((face.group, number));
                mesh.groups.push(Group { part, material: BARE.to_string() });
                number
            });
        }
    }
}
