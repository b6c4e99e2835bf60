//! Painted plants, and how the page goes on from one to the next.

use super::subject;
use crate::import::{Brush, Painted};
use crate::plants::{self, OWN, Plant, Show};
use crate::play::{Scene, link, origin};

/// The strokes of the plant that the page shows, and the one below them; of any other plant none yet.
pub fn now() -> Painted {
    let scene = subject::wished();
    let of_address = Painted::read(&subject::origin()).and_then(Result::ok);
    match of_address.filter(|_| scene.plant.key.starts_with(OWN)) {
        Some(painted) => painted,
        None => Painted { base: scene.plant, strokes: Vec::new() },
    }
}

/// The plant of strokes, if it has been made before, or has none.
pub fn known(painted: &Painted) -> Option<&'static Plant> {
    match painted.strokes[..] {
        [] => Some(painted.base),
        _ => plants::brought(&origin::made_of(&painted.write())?),
    }
}

/// Shows a plant with strokes.
pub fn show(painted: &Painted, plant: &'static Plant) {
    let is_led = painted.strokes.last().is_some_and(|stroke| stroke.brush == Brush::Lead);
    subject::show(&link::write(&on(plant, &subject::wished(), is_led)));
}

/// The scene that is there, on the plant below all strokes.
pub fn below(base: &'static Plant) -> Scene {
    on(base, &subject::wished(), false)
}

/// A scene on another plant of the same body: what the visitor has changed stays.
fn on(plant: &'static Plant, scene: &Scene, is_led: bool) -> Scene {
    let before = scene.plant;
    let mut recipe = scene.recipe.clone();
    if recipe.anisotropy == before.recipe.anisotropy {
        recipe.anisotropy = plant.recipe.anisotropy;
    }
    let look = plants::Look { bare: plant.look.bare, ..scene.look.clone() };
    let show = match scene.show {
        _ if is_led => Show::FieldArrows,
        Show::FieldArrows => Show::Cells,
        show if show.is_of(plant) => show,
        _ => Show::Cells,
    };
    Scene { plant, recipe, look, show, cell: None, ..scene.clone() }
}
