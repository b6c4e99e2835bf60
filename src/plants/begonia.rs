//! Polka dot begonia: silver spots of many sizes between the veins, never on them. They are air under the
//! skin of the leaf, and veins have no room for it (Sheue et al., Annals of Botany 109, 2012).

use super::paint::{AWAY, NEAR, Paint};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::tissue::CellType::{Background, Foreground, Middle};
use crate::tissue::{Clock, Recipe, Scaled, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "begonia",
    name: "Polka dot begonia",
    latin: "Begonia maculata",
    source: "",
    colour_names: ["silver", "olive green", "vein green"],
    recipe: Recipe {
        initial_cells: 12_000,
        initial_probability: [0.07, 0.93, 0.0],
        // Spots that begin with one cell each, and of any size at any time.
        clock: Clock::Exponential,
        division_days: [7.5, 40.0, 40.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.0], [0.0, 0.8, 0.8], [0.0, 0.8, 0.8]],
        radius_scale: 2.0,
        repulsion: 0.09,
        initial_relaxations: 20,
        relaxations_per_day: 6,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.87, 0.89, 0.86], [0.2, 0.3, 0.15], [0.31, 0.4, 0.2]],
        tinted: &[],
        variation: 0.08,
        border: 0.12,
        gloss: 0.4,
        skin: Skin { through: 0.3, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("underside", [0.42, 0.1, 0.14], 0.3),
            ("petiole", [0.55, 0.17, 0.17], 0.3),
            ("cane", [0.4, 0.36, 0.2], 0.2),
            ("pot", [0.86, 0.84, 0.8], 0.25),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 12.0, zoom: 0.98 },
    body: Shape {
        mesh: mesh_file!("begonia.obj"),
        levels: 2,
        but: &[Levels { group: "bare:cane", levels: 1 }, Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[
        Paint::along_veins(2, 1.0, AWAY, Use::FOREGROUND),
        Paint::along_veins(2, 0.24, AWAY, Use::FirstCells { of: Background, instead: Middle }),
        Paint::along_veins(
            2,
            0.8,
            NEAR,
            Use::Scale { number: Scaled::DivisionDays(Foreground), black: 1.0, white: 10.0 },
        ),
    ],
    guides: None,
    motion: Motion::STILL,
};
