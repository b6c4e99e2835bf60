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
#[cfg(all(test, not(target_arch = "wasm32")))]
mod bodies;
mod cactus;
mod chance;
mod croton;
mod croton_shrub;
mod diagram;
mod document;
mod guides;
mod long_watermelon;
mod look;
mod mushroom;
pub mod original;
pub mod paint;
mod philodendron;
mod philodendron_shoot;
mod red_croton;
mod sansevieria;
mod shape;
mod show;
mod spikes;
mod square_watermelon;
mod watermelon;

use crate::surface::{DirectionField, Mesh, ObjError, SurfaceError};
use crate::tissue::{Control, Growth, Recipe, RecipeError, Rules};
use chance::Chance;
pub use diagram::{Diagram, Layer};
pub use document::PlantError;
use document::{List, Text, kept, kept_list, kept_text, kept_texts};
pub use guides::{GuideVector, Guides};
pub use look::{Look, Skin, linear, srgb};
use paint::Paint;
use serde::{Deserialize, Serialize};
pub use shape::{Growths, Levels, Shape};
pub use show::{CLAN_PALETTE, Show};
use std::sync::Arc;

/// A plant of the playground: nothing but data, which `document` writes and reads as JSON.
#[derive(Clone, Debug, PartialEq)]
pub struct Plant {
    /// The rules that it lives by.
    pub rules: Rules,
    /// What links of earlier rules mean by its key.
    pub earlier: Option<&'static Plant>,
    /// Its word in links: `croton`.
    pub key: Text,
    /// English name: `Croton`.
    pub name: Text,
    pub latin: Text,
    /// The picture, or else the rule, of the thesis that it follows: `Thesis, Fig. 4.3`.
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

/// What moves while cells grow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// The day on which each part of the body unfolds, in their order; those that are not named are
    /// there from day 0.
    #[serde(deserialize_with = "kept_list")]
    pub unfolding_days: List<u32>,
}

impl Motion {
    /// All is there from day 0.
    pub const STILL: Motion = Motion { unfolding_days: &[] };
}

impl Plant {
    /// The plant as it is under a version of the rules, if it was there then.
    pub fn under(&'static self, version: u32) -> Option<&'static Plant> {
        let of_all_rules = std::iter::successors(Some(self), |plant| plant.earlier);
        of_all_rules.into_iter().find(|plant| plant.rules as u32 == version)
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
            .under(self.rules)
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
    pub fn embedded_body(&self) -> crate::surface::Body {
        self.body.grow(self.body.mesh.text).expect("our own meshes are sound")
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

/// All plants in the order of the chooser.
pub fn all() -> &'static [Plant] {
    static ALL: [Plant; 13] = [
        croton::PLANT,
        cactus::PLANT,
        watermelon::PLANT,
        mushroom::PLANT,
        philodendron::PLANT,
        sansevieria::PLANT,
        square_watermelon::PLANT,
        croton_shrub::PLANT,
        red_croton::PLANT,
        banded_cactus::PLANT,
        long_watermelon::PLANT,
        amanita::PLANT,
        philodendron_shoot::PLANT,
    ];
    &ALL
}

/// The plant of a key, as it stands in links.
pub fn find(key: &str) -> Option<&'static Plant> {
    all().iter().find(|plant| plant.key == key)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Cylinder, NO_TWIN, Place, Wrap};
    use crate::tissue::{CellType, CellType::Foreground, Progress};
    use glam::Vec3;

    fn surface(key: &str) -> Mesh {
        find(key).unwrap().embedded_body().surface
    }

    /// What becomes of a first F cell in the middle of a triangle.
    fn first_type(mesh: &Mesh, controls: &[Control], triangle: u32) -> CellType {
        let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
        controls.iter().fold(Foreground, |kind, c| c.first_type(mesh, centre, kind))
    }

    #[test]
    fn every_plant_is_sound() {
        for plant in all() {
            assert!(std::ptr::eq(find(plant.key).unwrap(), plant));
            plant.recipe.check().unwrap();
            assert_eq!(plant.guides.is_some(), plant.recipe.anisotropy > 0.0, "{}", plant.key);
            assert!(plant.first_day <= plant.recipe.days, "{}", plant.key);
            let body = plant.embedded_body();
            body.surface.check().unwrap();
            let triangles = body.surface.triangles.len();
            assert!((3_500..=16_000).contains(&triangles), "{}: {triangles}", plant.key);
            for part in &body.ornaments {
                let named = plant.look.bare.iter().any(|&(name, ..)| name == part.material);
                assert!(named, "{} has no colour for {}", plant.key, part.material);
            }
        }
        assert!(find("nettle").is_none());
    }

    #[test]
    fn triangles_are_of_like_size_and_no_slivers() {
        for plant in all() {
            let mesh = plant.embedded_body().surface;
            let mut areas = mesh.areas.clone();
            areas.sort_by(f32::total_cmp);
            let at = |share: f32| areas[(share * (areas.len() - 1) as f32) as usize];
            assert!(at(0.95) < 2.0 * at(0.5), "{}", plant.key);
            assert!(at(0.05) > 0.25 * at(0.5), "{}", plant.key);
            // 1 for an equilateral triangle, 0 for a line.
            let quality = |t: u32| {
                let [a, b, c] = mesh.corners(t);
                let squares = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
                4.0 * 3_f32.sqrt() * mesh.areas[t as usize] / squares
            };
            let worst = (0..mesh.triangles.len() as u32).map(quality).fold(1.0, f32::min);
            assert!(worst > 0.35, "{}: {worst}", plant.key);
        }
    }

    #[test]
    fn every_plant_stands_on_the_ground() {
        for plant in all() {
            let body = plant.embedded_body();
            let bare = body.ornaments.iter().flat_map(|part| &part.positions);
            let lowest = body.surface.positions.iter().chain(bare).map(|p| p.y).fold(9.0, f32::min);
            assert!((-0.15..0.1).contains(&lowest), "{}: {lowest}", plant.key);
        }
    }

    #[test]
    fn melons_are_closed_and_caps_and_leaves_are_open() {
        for (key, parts, closed) in [
            ("croton", 18, false),
            ("cactus", 2, false),
            ("mushroom", 2, false),
            ("philodendron", 6, false),
            ("sansevieria", 6, false),
            ("watermelon", 1, true),
            ("square-watermelon", 1, true),
            ("long-watermelon", 1, true),
        ] {
            let mesh = surface(key);
            assert_eq!(mesh.part_count(), parts, "{key}");
            assert_eq!(!mesh.twins.contains(&NO_TWIN), closed, "{key}");
        }
    }

    #[test]
    fn the_leaves_of_a_shoot_are_of_the_ages_of_the_figure() {
        let shoot = find("philodendron-shoot").unwrap();
        let unfolding_days = shoot.motion.unfolding_days;
        assert_eq!(unfolding_days.len(), surface(shoot.key).part_count());
        let ages = unfolding_days.iter().map(|unfolded| shoot.first_day - unfolded);
        assert!(ages.eq([32, 30, 27, 25, 23, 20]));
    }

    #[test]
    fn stripes_of_lying_fruits_begin_level_with_their_axes() {
        for key in ["watermelon", "long-watermelon"] {
            let Wrap::Cylinder(Cylinder { axis, zero, .. }) = find(key).unwrap().paint[0].wrap
            else {
                panic!("{key} has a cylinder");
            };
            assert_eq!(zero, axis.cross(Vec3::Y).normalize(), "{key}");
        }
    }

    #[test]
    fn a_square_melon_is_a_cube() {
        let mesh = surface("square-watermelon");
        let far = |axis: Vec3| mesh.positions.iter().map(|p| p.dot(axis)).fold(0.0, f32::max);
        for width in [far(Vec3::X) + far(-Vec3::X), far(Vec3::Z) + far(-Vec3::Z), far(Vec3::Y)] {
            assert!((18.0..19.2).contains(&width), "{width} cm");
        }
        // To the middle of an upright edge that is rounded by 3 cm.
        let edge = far(Vec3::new(1.0, 0.0, 1.0).normalize());
        assert!((edge - (6.0 * 2_f32.sqrt() + 3.0)).abs() < 0.3, "{edge} cm");
    }

    #[test]
    fn a_snake_plant_has_clean_margins_and_bands_within() {
        let mesh = surface("sansevieria");
        let controls = find("sansevieria").unwrap().controls(1);
        let mut shares = [0.0; 3];
        for triangle in 0..mesh.triangles.len() as u32 {
            let kind = first_type(&mesh, &controls, triangle);
            shares[kind as usize] += mesh.areas[triangle as usize] / mesh.area;
            // No leaf coordinate of one leaf lies on another's place in the image.
            let corners = mesh.triangles[triangle as usize].map(|v| mesh.uvs[v as usize].x);
            let place = mesh.parts[triangle as usize] as f32;
            assert!(corners.iter().all(|x| (-1e-4..1.0001).contains(&(5.0 * (x + 1.0) - place))));
        }
        let expected = [0.21, 0.47, 0.31];
        assert!(shares.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.04), "{shares:?}");
    }

    #[test]
    fn leaves_know_their_midrib_and_rims() {
        for key in ["croton", "philodendron"] {
            let mesh = surface(key);
            assert_eq!(mesh.uvs.len(), mesh.positions.len());
            assert!(mesh.uvs.iter().all(|uv| uv.x.abs() <= 1.0 && (0.0..=1.0).contains(&uv.y)));
            // On the upper side of a blade the texture is not mirrored.
            let along = |t: usize| {
                let [a, b, c] = mesh.triangles[t].map(|v| mesh.uvs[v as usize]);
                (b - a).perp_dot(c - a) > 0.0
            };
            assert!((0..mesh.triangles.len()).all(along), "{key}");
        }
    }

    #[test]
    fn control_images_leave_both_types_their_share() {
        for (key, white) in [
            ("croton", 0.7),
            ("watermelon", 0.36),
            ("mushroom", 0.9),
            ("philodendron", 0.4),
            ("square-watermelon", 0.36),
            ("long-watermelon", 0.36),
            ("banded-cactus", 0.4),
            ("amanita", 0.7),
        ] {
            let mesh = surface(key);
            let plant = find(key).unwrap();
            for paint in plant.paint {
                let Wrap::Cylinder(Cylinder { axis, zero, .. }) = paint.wrap else { continue };
                assert!((axis.length() - 1.0).abs() < 1e-6);
                assert!((zero.length() - 1.0).abs() < 1e-6);
                assert!(axis.dot(zero).abs() < 1e-6);
            }
            let share = |individual| {
                let controls = plant.controls(individual);
                let allowed: f32 = (0..mesh.triangles.len() as u32)
                    .filter(|&t| first_type(&mesh, &controls, t) == Foreground)
                    .map(|t| mesh.areas[t as usize])
                    .sum();
                allowed / mesh.area
            };
            let share = (1..=6).map(share).sum::<f32>() / 6.0;
            assert!((share - white).abs() < 0.06, "{key}: {share}");
        }
    }

    #[test]
    fn walks_on_our_meshes_are_never_caught() {
        for plant in all() {
            let recipe = Recipe { days: 1, ..plant.recipe.clone() };
            let mesh = Arc::new(plant.embedded_body().surface);
            let mut growth = plant.sow(mesh, recipe, 1).unwrap();
            while growth.step() != Progress::Done {}
            assert_eq!(growth.caught_walks(), 0, "{}", plant.key);
        }
    }
}
