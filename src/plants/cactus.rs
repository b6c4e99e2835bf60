//! Cactus: yellow blotches on blue-green columns (Thesis, Fig. 4.8).

use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::tissue::Recipe;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "cactus",
    name: "Cactus",
    latin: "Cereus hildmannianus",
    source: "Thesis, Fig. 4.8",
    colour_names: ["yellow", "green", ""],
    recipe: Recipe {
        initial_cells: 5_000,
        // The largest of the three shares of Fig. 4.8: fifteen clones over two columns, so that
        // each side of the plant has some and those that meet make lobes.
        initial_probability: [0.003, 0.997, 0.0],
        division_days: [3.0, 60.0, 60.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 4.0,
        // Open in the thesis. 0.02 * 4^2 = 0.32 keeps steps small; at 0.09 they reach 1.5 radii and
        // cells along the borders are drawn out.
        repulsion: 0.02,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. With 4 the clones stay crowded and small, with 10 nothing looks
        // better and growth takes half as long again.
        relaxations_per_day: 6,
        days: 25,
        // Some fifteen clones that double every few days: individuals have 8,000 to 18,000 cells.
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 25,
    look: Look {
        cells: [[0.925, 0.824, 0.341], [0.235, 0.455, 0.335], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.08,
        border: 0.18,
        gloss: 0.3,
        skin: Skin { wax: 0.14, unevenness: 0.015, ..Skin::EVEN },
        veins: false,
        bare: &[
            ("areole", [0.78, 0.72, 0.6], 0.0),
            ("spine", [0.4, 0.26, 0.14], 0.2),
            ("soil", [0.43, 0.35, 0.27], 0.0),
            ("stone", [0.6, 0.57, 0.52], 0.05),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 14.0, zoom: 1.05 },
    body: Shape {
        mesh: mesh_file!("cactus.obj"),
        levels: 2,
        but: &[
            Levels { group: "bare:areole", levels: 0 },
            // About as many triangles as cells: the repulsive radius is four times the spacing, and
            // a mesh four times as fine has 16 times as much to unfold around each cell.
            Levels { group: "skin", levels: 1 },
        ],
        growths: Growths::Spines,
    },
    paint: &[],
    guides: None,
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.8",
    recipe: Recipe {
        // With a few green children of yellow cells and half the reach, patches are freckled and their
        // borders rough, as in living variegated plants. More clones keep a third of the skin yellow, and
        // 0.08 * 2^2 = 0.32 gives steps the length that they had.
        initial_cells: 10_000,
        initial_probability: [0.005, 0.995, 0.0],
        mutation: [[0.97, 0.03, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        radius_scale: 2.0,
        repulsion: 0.08,
        ..FIRST.recipe
    },
    look: LOOK,
    ..FIRST
};

/// Under a waxy bloom the green is pale and grey, and less glossy.
pub(super) const LOOK: Look = Look {
    cells: [[0.925, 0.824, 0.341], [0.36, 0.52, 0.44], [0.5, 0.5, 0.2]],
    gloss: 0.15,
    ..FIRST.look
};
