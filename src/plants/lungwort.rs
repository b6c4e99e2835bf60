//! Lungwort: pale blotches of all sizes that defy counting, wherever clones of pale cells began.

use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::tissue::{Clock, Recipe};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "lungwort",
    name: "Lungwort",
    latin: "Pulmonaria officinalis",
    source: "",
    colour_names: ["pale", "green", ""],
    recipe: Recipe {
        initial_cells: 3_000,
        initial_probability: [0.09, 0.91, 0.0],
        // Clones of any size.
        clock: Clock::Exponential,
        division_days: [5.4, 9.0, 9.0],
        // Some more begin later, and stay small.
        mutation: [[1.0, 0.0, 0.0], [0.006, 0.994, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.5,
        repulsion: 0.16,
        initial_relaxations: 20,
        relaxations_per_day: 8,
        days: 20,
        max_cells: 80_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.74, 0.82, 0.68], [0.22, 0.42, 0.2], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.1,
        border: 0.16,
        gloss: 0.12,
        skin: Skin { unevenness: 0.1, ..Skin::LEAF },
        veins: true,
        bare: &[
            ("petiole", [0.42, 0.5, 0.26], 0.1),
            ("pink", [0.86, 0.4, 0.55], 0.1),
            ("blue", [0.36, 0.36, 0.75], 0.1),
            ("pot", [0.66, 0.36, 0.24], 0.08),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 34.0, zoom: 1.05 },
    body: Shape {
        mesh: mesh_file!("lungwort.obj"),
        levels: 2,
        but: &[Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[],
    guides: None,
    motion: Motion::STILL,
};
