//! Variegated sycamore: cream sectors and splashes that end at the main veins of a lobed leaf. The body has a
//! part between each two main veins, so that no cell comes from one to the other.

use super::{Growths, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::tissue::{Clock, Recipe};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "palmate",
    name: "Variegated sycamore",
    latin: "Acer pseudoplatanus",
    source: "",
    colour_names: ["cream", "green", "pale green"],
    recipe: Recipe {
        // Some twenty founders to each part of a leaf.
        initial_cells: 400,
        initial_probability: [0.14, 0.8, 0.06],
        clock: Clock::Exponential,
        division_days: [3.4, 3.4, 3.4],
        // Green cells lose their green, now and then: late ones make flecks.
        mutation: [[1.0, 0.0, 0.0], [0.01, 0.985, 0.005], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.2], [0.0, 0.7, 0.2], [0.2, 0.2, 0.6]],
        radius_scale: 1.0,
        repulsion: 0.3,
        initial_relaxations: 20,
        relaxations_per_day: 8,
        days: 16,
        max_cells: 80_000,
        ..Recipe::DEFAULT
    },
    first_day: 16,
    look: Look {
        cells: [[0.93, 0.9, 0.66], [0.19, 0.39, 0.15], [0.55, 0.66, 0.33]],
        tinted: &[],
        variation: 0.08,
        border: 0.12,
        gloss: 0.3,
        skin: Skin::LEAF,
        veins: false,
        bare: &[
            ("vein", [0.66, 0.7, 0.4], 0.2),
            ("petiole", [0.55, 0.25, 0.2], 0.3),
            ("bark", [0.42, 0.36, 0.28], 0.05),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 10.0, zoom: 1.0 },
    body: Shape { mesh: mesh_file!("palmate.obj"), levels: 2, but: &[], growths: Growths::Nothing },
    paint: &[],
    guides: None,
    motion: Motion::STILL,
};
