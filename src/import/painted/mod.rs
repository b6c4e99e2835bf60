//! A plant that a visitor paints on: strokes on the skin of another plant, which make a plant of their own. Its
//! strokes are lines of its mesh (`surface::STROKES`) and images along them, and vectors that lead its field.

mod layers;
mod lead;
mod skin;
mod stroke;
mod ways;

use super::Own;
use crate::plants::{self, Plant, Shape, to_text};
use crate::play::origin::{self, PAINTED};
use crate::surface::{Body, Line, PolygonMesh};
use glam::Vec2;
use layers::Layer;
pub use skin::Skin;
use std::sync::Arc;
pub use stroke::{Brush, MOST_RADIUS, Spot, Stroke, Way};

/// Strokes, and the plant below them.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    pub base: &'static Plant,
    pub strokes: Vec<Stroke>,
}

impl Painted {
    /// As it stands behind the `~` of an address: `painted/croton/2/f.500.w.k3f7a2`, with the version of the rules
    /// that the plant lives by.
    pub fn write(&self) -> String {
        let Painted { base, strokes } = self;
        format!("{PAINTED}{}/{}/{}", base.key, base.rules as u32, stroke::write(strokes))
    }

    /// Of what a plant is made of; none where that is something else.
    ///
    /// # Errors
    /// In plain words, why it cannot be painted.
    pub fn read(words: &str) -> Option<Result<Painted, String>> {
        words.strip_prefix(PAINTED).map(Painted::of_words)
    }

    fn of_words(text: &str) -> Result<Painted, String> {
        let mut words = text.splitn(3, '/');
        let [key, version, strokes] = [(); 3].map(|()| words.next().unwrap_or_default());
        let known = plants::find(key).or_else(|| plants::brought(key));
        let base = known.zip(version.parse().ok()).and_then(|(plant, version)| {
            if plants::find(key).is_some() { plant.under(version) } else { Some(plant) }
        });
        let base = base.ok_or_else(|| {
            format!("the plant below the strokes, {}, is not here", crate::surface::quoted(key))
        })?;
        Ok(Painted { base, strokes: stroke::read(strokes)? })
    }

    /// Makes the plant. `obj` is the text of the mesh of the one below.
    ///
    /// # Errors
    /// In plain words, why it cannot be grown.
    pub fn make(&self, obj: &str) -> Result<Own, String> {
        let Painted { base, strokes } = self;
        let body = base.body.grow(obj).map_err(|why| why.to_string())?;
        let layers = Layer::of(strokes, &body.surface)?;
        let (shape, mut mesh) = self.body(&layers, &body, obj)?;
        for (number, layer) in (1..).zip(&layers) {
            for line in &layer.lines {
                add(&mut mesh, layer.order(number, line.radius), &line.points());
            }
        }
        let mut paint = base.paint.to_vec();
        for (number, layer) in (1..).zip(&layers) {
            paint.extend(layer.paint(number, base));
        }
        let mut look = base.look.clone();
        let mut bare = look.bare.to_vec();
        if mesh.groups.iter().any(|group| group.material == layers::BARE) {
            bare.push((layers::PAINTED_BARE, look.cells[1], look.gloss));
        }
        look.bare = bare.leak();
        let mut plant = Plant {
            name: format!("{}, painted", base.name).leak(),
            body: shape,
            paint: paint.leak(),
            look,
            ..base.as_written()
        };
        lead::lead(&mut plant, &layers, &body.surface)?;
        let obj = mesh.to_obj();
        let grown = plant.grow_body(&obj).map_err(|why| why.to_string())?;
        plant.check_on(&Arc::new(grown.surface)).map_err(|why| why.to_string())?;
        let (key, text) = to_text(&plant, &obj);
        Ok(Own { key, text, told: Vec::new() })
    }

    /// The mesh below the strokes, and what its faces that no pattern grows on are made of.
    fn body(
        &self,
        layers: &[Layer],
        body: &Body,
        obj: &str,
    ) -> Result<(Shape, PolygonMesh), String> {
        let shape = self.base.as_written().body;
        if !layers.iter().any(|layer| layer.brush == Brush::Bare) {
            return PolygonMesh::parse(obj)
                .map(|mesh| (shape, mesh))
                .map_err(|why| why.to_string());
        }
        if !self.base.motion.unfolding_days.is_empty() {
            return Err("its parts unfold one by one, and one that is cut would be two".to_string());
        }
        let mut mesh = self.base.body.refined(obj).map_err(|why| why.to_string())?;
        layers::bare(&mut mesh, layers, &body.surface);
        Ok((Shape { levels: 0, but: &[], ..shape }, mesh))
    }
}

/// Adds a line to a mesh, on vertices of its own that stand still.
fn add(mesh: &mut PolygonMesh, order: u32, points: &[glam::Vec3]) {
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(points);
    if !mesh.uvs.is_empty() {
        mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
    }
    for moment in &mut mesh.moments {
        moment.positions.extend(points);
    }
    let vertices = (first..mesh.positions.len() as u32).collect();
    mesh.lines.push(Line { vertices, order });
}

/// The strokes of a whole link, if its plant is a painted one.
///
/// # Errors
/// As `Painted::read`.
pub fn painted_of_link(link: &str) -> Option<Result<Painted, String>> {
    let [origin, _] = origin::parts(link.split_once('~')?.1);
    Painted::read(origin.trim_start_matches('~'))
}

#[cfg(test)]
mod tests;
