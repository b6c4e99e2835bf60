//! Weeping fig: a small tree whose leaves are marbled in cream. A midrib is a wall, so that many a leaf has two
//! halves that know nothing of each other.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::Wrap;
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "ficus",
    name: "Weeping fig",
    latin: "Ficus benjamina",
    source: "",
    colour_names: ["cream", "green", "pale green"],
    recipe: Recipe {
        // Some dozen founders to each leaf.
        initial_cells: 4_000,
        initial_probability: [0.3, 0.62, 0.08],
        clock: Clock::Exponential,
        division_days: [6.0, 6.0, 6.0],
        mutation: [[1.0, 0.0, 0.0], [0.01, 0.98, 0.01], [0.0, 0.0, 1.0]],
        adhesion: [[0.7, 0.0, 0.2], [0.0, 0.7, 0.2], [0.2, 0.2, 0.6]],
        radius_scale: 1.0,
        repulsion: 0.3,
        initial_relaxations: 20,
        relaxations_per_day: 6,
        days: 14,
        max_cells: 80_000,
        ..Recipe::DEFAULT
    },
    first_day: 14,
    look: Look {
        cells: [[0.95, 0.92, 0.72], [0.13, 0.35, 0.14], [0.5, 0.64, 0.34]],
        tinted: &[],
        variation: 0.08,
        border: 0.08,
        gloss: 0.45,
        skin: Skin::LEAF,
        veins: false,
        bare: &[
            ("bark", [0.5, 0.44, 0.36], 0.1),
            ("pot", [0.86, 0.84, 0.8], 0.25),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 8.0, zoom: 1.0 },
    body: Shape {
        mesh: mesh_file!("ficus.obj"),
        levels: 2,
        but: &[Levels { group: "wood", levels: 1 }, Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[Paint {
        wrap: Wrap::Leaf,
        image: Image { width: 2, height: 1, rule: ImageRule::Pixels(Pixels { rows: &["0f"] }) },
        use_as: Use::Wall,
    }],
    guides: None,
    motion: Motion::STILL,
};
