//! Croton: a shrub whose leaves turn from green to yellow in one run (Thesis, Fig. 4.3).

use super::paint::{Grain, Image, ImageRule, Paint};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "croton",
    name: "Croton",
    latin: "Codiaeum variegatum",
    source: "Thesis, Fig. 4.3",
    colour_names: ["yellow", "green", ""],
    recipe: Recipe {
        initial_cells: 10_000,
        // Open in the thesis. A share of about 0.13 is left by `YOUNG_LEAVES`: under 0.1 yellow has
        // a third of day 30, over 0.2 day 5 is no green plant and day 30 has 180,000 cells.
        initial_probability: [0.19, 0.81, 0.0],
        division_days: [5.0, 10.0, 10.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.0,
        // Open in the thesis. Half of what would move two unlike cells out of each other's reach at
        // once: below, the crowded yellow clones lag and stay small, above, borders tremble.
        repulsion: 0.5,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. With 10 yellow has 48% of day 30, with 16 it has 51%.
        relaxations_per_day: 16,
        days: 30,
        // Individuals have from 131,000 to 138,000 cells.
        max_cells: 160_000,
        ..Recipe::DEFAULT
    },
    first_day: 15,
    look: Look {
        cells: [[0.91, 0.784, 0.227], [0.122, 0.353, 0.165], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.12,
        border: 0.25,
        gloss: 0.65,
        skin: Skin::LEAF,
        veins: true,
        bare: &[
            ("petiole", [0.42, 0.47, 0.2], 0.3),
            ("bark", [0.36, 0.29, 0.2], 0.05),
            ("pot", [0.66, 0.36, 0.24], 0.08),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 24.0, zoom: 0.95 },
    body: Shape {
        mesh: mesh_file!("croton.obj"),
        levels: 2,
        but: &[
            Levels { group: "bare:petiole", levels: 1 },
            Levels { group: "bare:soil", levels: 1 },
        ],
        growths: Growths::Nothing,
    },
    paint: &[YOUNG_LEAVES],
    guides: None,
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.3",
    look: LOOK,
    // Gold dust is green with flecks at any age; on day 15 half of it is yellow.
    first_day: 8,
    ..FIRST
};

/// Leaf greens of nature lean to yellow, and bark to grey.
pub(super) const LOOK: Look = Look {
    cells: [[0.91, 0.784, 0.227], [0.15, 0.33, 0.12], [0.5, 0.5, 0.2]],
    bare: &[
        ("petiole", [0.42, 0.47, 0.2], 0.3),
        ("bark", [0.47, 0.42, 0.33], 0.05),
        ("pot", [0.66, 0.36, 0.24], 0.08),
        ("soil", [0.2, 0.15, 0.11], 0.0),
    ],
    ..FIRST.look
};

/// Young leaves are greener than old ones: the higher in the shrub, the fewer first cells are left
/// yellow, in a fine random grain.
const YOUNG_LEAVES: Paint = Paint {
    wrap: Wrap::Cylinder(Cylinder {
        base: Vec3::new(0.0, 10.0, 0.0),
        axis: Vec3::Y,
        zero: Vec3::X,
        height: 28.0,
    }),
    image: Image {
        width: 256,
        height: 128,
        rule: ImageRule::Grain(Grain { black_at_the_top: 0.65 }),
    },
    use_as: Use::FOREGROUND,
};
