//! Philodendron shoot: its leaves have unfolded one after another, and stand at six ages (Thesis,
//! Fig. 4.10).

use super::{Motion, Plant, Rules, View, philodendron};
use crate::tissue::Recipe;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "philodendron-shoot",
    name: "Philodendron shoot",
    source: "Thesis, Fig. 4.10",
    recipe: Recipe {
        // Open in the thesis. At 0.09 leaves of 20 and of 32 days look alike; here the strokes of the
        // oldest reach the rim, and those of the youngest do not.
        repulsion: 0.25,
        ..philodendron::FIRST.recipe
    },
    // On the last day the leaves, from the oldest near the pot to the youngest, are of 32, 30, 27, 25,
    // 23 and 20 days.
    motion: Motion { unfolding_days: &[0, 2, 5, 7, 9, 12], ..Motion::STILL },
    first_day: philodendron::FIRST.recipe.days,
    ..philodendron::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.10",
    recipe: philodendron::RECIPE,
    look: philodendron::PLANT.look,
    paint: philodendron::PLANT.paint,
    // Along the shoot, from its oldest leaves to the youngest.
    view: View { azimuth_deg: 318.0, elevation_deg: 16.0, zoom: 1.1 },
    ..FIRST
};
