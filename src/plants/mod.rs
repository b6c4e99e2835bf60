//! The catalogue: what each plant is made of, how its cells live, and how it looks.

/// A `MeshFile` by its name.
macro_rules! mesh_file {
    ($name:literal) => {
        crate::plants::MeshFile {
            name: $name,
            #[cfg(not(target_arch = "wasm32"))]
            text: include_str!(concat!("../../meshes/", $name)),
        }
    };
}

mod amanita;
mod banded_cactus;
mod begonia;
#[cfg(all(test, not(target_arch = "wasm32")))]
mod bodies;
mod brought;
mod cactus;
mod chance;
mod coleus;
mod croton;
mod croton_shrub;
mod diagram;
mod document;
mod expected;
mod ficus;
mod fittonia;
mod goeppertia;
mod guides;
mod lily;
mod long_watermelon;
mod look;
mod lotus;
mod lungwort;
mod moon_and_stars;
mod mushroom;
pub mod original;
pub mod paint;
mod palmate;
mod philodendron;
mod philodendron_shoot;
mod red_croton;
mod rules;
mod sansevieria;
mod shape;
mod show;
mod spikes;
mod square_watermelon;
#[cfg(test)]
mod tests;
mod tiger_lily;
mod watermelon;
mod winter_squash;
mod words;

use crate::surface::{Body, DirectionField, Mesh, ObjError, SurfaceError};
use crate::tissue::{Control, Growth, Recipe, RecipeError, Use};
pub use brought::{OWN, bring, brought, to_text};
use chance::Chance;
pub use diagram::{Diagram, Layer};
pub use document::PlantError;
use document::{List, Text, kept, kept_list, kept_text, kept_texts};
use glam::Vec3;
pub use guides::{GuideVector, Guides};
pub use look::{Look, Skin, linear, srgb};
use paint::Paint;
pub use rules::Rules;
use serde::{Deserialize, Serialize};
pub use shape::{Growths, Levels, Shape};
pub use show::{CLAN_PALETTE, Show};
use std::sync::Arc;

/// A plant of the playground: nothing but data, which `document` writes and reads as JSON.
#[derive(Clone, Debug, PartialEq)]
pub struct Plant {
    /// The rules that it lives by.
    pub rules: Rules,
    /// Its word in links: `croton`.
    pub key: Text,
    /// English name: `Croton`.
    pub name: Text,
    pub latin: Text,
    /// The picture, or else the rule, of the thesis that it follows: `Thesis, Fig. 4.3`; empty if none.
    pub source: Text,
    /// What the colours of F, B and M are called: `["yellow", "green", ""]`.
    pub colour_names: [Text; 3],
    pub body: Shape,
    /// Its control images, in the order in which they are asked.
    pub paint: List<Paint>,
    /// What leads its direction field, if it has one.
    pub guides: Option<Guides>,
    pub recipe: Recipe,
    pub motion: Motion,
    pub look: Look,
    pub view: View,
    /// The day that a visitor sees first.
    pub first_day: u32,
}

/// What moves while cells grow, beside the moments that a mesh may have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The day on which each part of the body unfolds, in their order; those that are not named are
    /// there from day 0.
    #[serde(default, deserialize_with = "kept_list")]
    pub unfolding_days: List<u32>,
    /// How large the body is on some days, in the order of these; in between it grows evenly. Empty: it is always
    /// as it was made.
    #[serde(default, deserialize_with = "kept_list")]
    pub growth: List<Stretch>,
}

/// How large a body is on a day.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stretch {
    pub day: u32,
    /// Times its size as it was made, along x, y and z, from the origin; 0.01 to 100.
    pub factors: [f32; 3],
}

impl Motion {
    /// All is there from day 0, as it was made.
    pub const STILL: Motion = Motion { unfolding_days: &[], growth: &[] };

    fn check(&self) -> Result<(), String> {
        if let Some(day) = self.unfolding_days.iter().find(|&&day| day > 1000) {
            return Err(format!("a part unfolds on day {day}: at most 1000"));
        }
        if let Some(pair) = self.growth.windows(2).find(|pair| pair[0].day >= pair[1].day) {
            return Err(format!("growth: day {} stands after day {}", pair[1].day, pair[0].day));
        }
        let mut factors = self.growth.iter().flat_map(|stretch| stretch.factors);
        factors.try_for_each(|factor| document::kept("a factor of growth", factor, 0.01, 100.0))
    }
}

impl Plant {
    /// Its body, grown from the text of its mesh file.
    pub fn grow_body(&self, obj: &str) -> Result<Body, BodyError> {
        Ok(self.growing(self.body.grow(obj)?))
    }

    /// A body that grows as the plant's own does, with its walls.
    pub fn growing(&self, body: Body) -> Body {
        let sizes = self.motion.growth.iter().map(|s| (s.day as f32, Vec3::from(s.factors)));
        let mut body = body.stretched(&sizes.collect::<Vec<_>>());
        for wall in self.paint.iter().filter(|paint| paint.use_as == Use::Wall) {
            wall.control(Chance::PLANT).wall_off(&mut body.surface);
        }
        body
    }

    /// The plant as links of a version of the rules have it, if it was there then.
    pub fn under(&'static self, version: u32) -> Option<&'static Plant> {
        let of_all_rules = std::iter::once(self).chain(earlier());
        of_all_rules
            .filter(|plant| plant.key == self.key)
            .find(|plant| plant.rules as u32 == version)
    }

    /// Sows an individual on the plant's surface, under its control images and along its direction
    /// field, each part on its day; the recipe may be another than the plant's own.
    pub fn sow(
        &self,
        surface: Arc<Mesh>,
        recipe: Recipe,
        individual: u32,
    ) -> Result<Growth, RecipeError> {
        let field = self.field(&surface).map_err(RecipeError)?;
        let growth = Growth::new(surface, recipe, &self.controls(individual), individual)?
            .unfolding(self.motion.unfolding_days);
        Ok(match field {
            Some(field) => growth.along(field),
            None => growth,
        })
    }

    /// Whether it has a bare part of a material.
    pub fn has_bare(&self, material: &str) -> bool {
        self.look.bare.iter().any(|(name, ..)| *name == material)
    }

    /// The control images of an individual, painted anew, in the order in which they are asked. Under the
    /// first rules all individuals have the same.
    pub fn controls(&self, individual: u32) -> Vec<Control> {
        let chance = match self.rules {
            Rules::First => Chance::PLANT,
            Rules::Second => Chance::of(individual),
        };
        self.paint.iter().map(|paint| paint.control(chance)).collect()
    }

    /// Its direction field on a surface, if it has one, or in words why its guides lead none there.
    pub fn field(&self, surface: &Mesh) -> Result<Option<DirectionField>, String> {
        self.guides.map(|guides| guides.lead(surface)).transpose()
    }
}

/// One of the files under `meshes/`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshFile {
    /// `croton.obj`
    pub name: &'static str,
    /// What stands in it. A page loads the file of the plant that it shows instead, so that nobody
    /// downloads them all.
    #[cfg(not(target_arch = "wasm32"))]
    pub text: &'static str,
}

/// Why a text is not the mesh of a plant.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum BodyError {
    #[error(transparent)]
    Obj(#[from] ObjError),
    #[error(transparent)]
    Surface(#[from] SurfaceError),
}

#[cfg(not(target_arch = "wasm32"))]
impl Plant {
    /// The body, grown from the mesh file that this program carries.
    pub fn embedded_body(&self) -> Body {
        self.grow_body(self.body.mesh.text).expect("our own meshes are sound")
    }
}

/// From where the plant is first seen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct View {
    /// Degrees around the upright axis, and above the horizon.
    pub azimuth_deg: f32,
    pub elevation_deg: f32,
    /// 1: the bounding sphere just fills the shorter side of the picture.
    pub zoom: f32,
}

/// All plants in the order of the chooser, kind by kind.
pub fn all() -> &'static [Plant] {
    static ALL: [Plant; 25] = [
        croton::PLANT,
        cactus::PLANT,
        mushroom::PLANT,
        lungwort::PLANT,
        moon_and_stars::PLANT,
        croton_shrub::PLANT,
        red_croton::PLANT,
        amanita::PLANT,
        philodendron::PLANT,
        palmate::PLANT,
        banded_cactus::PLANT,
        philodendron_shoot::PLANT,
        watermelon::PLANT,
        sansevieria::PLANT,
        winter_squash::PLANT,
        square_watermelon::PLANT,
        long_watermelon::PLANT,
        begonia::PLANT,
        fittonia::PLANT,
        goeppertia::PLANT,
        coleus::PLANT,
        ficus::PLANT,
        lily::PLANT,
        lotus::PLANT,
        tiger_lily::PLANT,
    ];
    &ALL
}

/// What links of earlier rules mean by the keys of plants that live by newer ones now.
fn earlier() -> &'static [Plant] {
    static EARLIER: [Plant; 15] = [
        croton::FIRST,
        cactus::FIRST,
        mushroom::FIRST,
        croton_shrub::FIRST,
        red_croton::FIRST,
        amanita::FIRST,
        philodendron::FIRST,
        banded_cactus::FIRST,
        philodendron_shoot::FIRST,
        watermelon::FIRST,
        sansevieria::FIRST,
        winter_squash::FIRST,
        square_watermelon::FIRST,
        long_watermelon::FIRST,
        coleus::FIRST,
    ];
    &EARLIER
}

/// How far a pattern has a structure of its own beside what clones make, and how many plants are of that kind; the last
/// ones move.
const KINDS: [(Text, usize); 6] = [
    ("Not structured", 8),
    ("Partly structured", 4),
    ("Structured", 5),
    ("Led by veins", 4),
    ("Branched by a rule", 1),
    ("Flowers that open", 3),
];

/// The plants by the structure of their patterns: the name of each kind, and its plants.
pub fn kinds() -> impl Iterator<Item = (Text, &'static [Plant])> {
    let mut rest = all();
    KINDS.iter().map(move |&(name, count)| {
        let (of_kind, others) = rest.split_at(count);
        rest = others;
        (name, of_kind)
    })
}

/// The plant of a key, as it stands in links.
pub fn find(key: &str) -> Option<&'static Plant> {
    all().iter().find(|plant| plant.key == key)
}
