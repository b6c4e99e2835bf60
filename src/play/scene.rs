//! A scene: everything that decides the picture, in one value. A link is a scene written down, a
//! preset is a scene with a name, and every control makes the same scene with one thing changed.

use super::camera::Orbit;
use super::link;
use crate::plants::{Look, Plant, Show};
use crate::surface::Mesh;
use crate::tissue::{Growth, Noise, Recipe, RecipeError};
use std::sync::Arc;

/// The individual that a visitor meets first.
pub const FIRST_INDIVIDUAL: u32 = 1;

/// Everything that decides the picture.
#[derive(Clone, Debug)]
pub struct Scene {
    pub plant: &'static Plant,
    /// The seed; every u32 is one, 0 too.
    pub individual: u32,
    /// The wished day, `0..=recipe.days`.
    pub day: u32,
    /// The preset of the plant with the visitor's changes.
    pub recipe: Recipe,
    /// Whether the cells have the types of Perlin noise instead of their own, to compare.
    pub noise: bool,
    /// The colours of the plant with the visitor's changes.
    pub look: Look,
    /// What is seen on the body; the plant has it.
    pub show: Show,
    /// The cell whose clone is in hand, by its number; it may be yet to be born, or never be.
    pub cell: Option<u32>,
    pub orbit: Orbit,
}

impl Scene {
    /// The named state of a plant, as the catalogue has it.
    pub fn preset(plant: &'static Plant, individual: u32) -> Scene {
        Scene {
            plant,
            individual,
            day: plant.first_day.min(plant.recipe.days),
            recipe: plant.recipe.clone(),
            noise: false,
            look: plant.look.clone(),
            show: Show::Cells,
            cell: None,
            orbit: Orbit::of(&plant.view),
        }
    }

    /// Sows the plant on its surface: its growth, and the noise if that is to be seen.
    pub fn sow(&self, surface: Arc<Mesh>) -> Result<(Growth, Option<Noise>), RecipeError> {
        let noise = self.noise.then(|| Noise::new(&surface, self.individual));
        Ok((self.plant.sow(surface, self.recipe.clone(), self.individual)?, noise))
    }

    /// Whether two scenes need the same growth (their days and looks may differ).
    pub fn grows_like(&self, other: &Scene) -> bool {
        self.plant.key == other.plant.key
            && self.plant.rules == other.plant.rules
            && self.individual == other.individual
            && self.recipe == other.recipe
            && self.noise == other.noise
    }

    /// Whether two scenes differ at most in how they are looked at.
    pub fn differs_only_in_view(&self, other: &Scene) -> bool {
        Scene { orbit: other.orbit, ..self.clone() } == *other
    }
}

/// Two scenes are equal when their links are.
impl PartialEq for Scene {
    fn eq(&self, other: &Scene) -> bool {
        link::write(self) == link::write(other)
    }
}
