//! Young croton: gold dust on green leaves, one clone a fleck (Thesis, Fig. 4.1, 4.2 and 4.4).

use super::{Plant, Rules, View, croton};
use crate::tissue::Recipe;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "croton-shrub",
    name: "Young croton",
    source: "Thesis, Fig. 4.1",
    recipe: Recipe {
        initial_cells: 2_000,
        // In Fig. 4.4 it goes from 0.9 to 0.1: `pf` in links.
        initial_probability: [0.5, 0.5, 0.0],
        division_days: [10.0; 3],
        // Repulsion and events are those of the grown croton; from 4 events a day on flecks look
        // alike.
        days: 35,
        // Individuals have from 17,600 to 18,200 cells.
        max_cells: 60_000,
        ..croton::FIRST.recipe
    },
    first_day: 35,
    paint: &[],
    ..croton::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.1",
    recipe: Recipe {
        // A green plant with flecks, as the living ones are.
        initial_probability: [0.2, 0.8, 0.0],
        ..FIRST.recipe
    },
    look: croton::LOOK,
    // From another side than the croton, whose body it shares.
    view: View { azimuth_deg: 60.0, elevation_deg: 20.0, zoom: 1.02 },
    ..FIRST
};
