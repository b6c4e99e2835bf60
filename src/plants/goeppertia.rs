//! Rose-painted calathea: a pale feathered ring on the way to the rim, and brush strokes along the side veins
//! that end at it.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{AlongVeins, Wrap};
use crate::tissue::CellType::{Background, Foreground, Middle};
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "goeppertia",
    name: "Rose-painted calathea",
    latin: "Goeppertia roseopicta",
    source: "",
    colour_names: ["rose", "dark green", "light green"],
    recipe: Recipe {
        initial_cells: 12_000,
        // All, until they hear of ring and strokes.
        initial_probability: [1.0, 0.0, 0.0],
        // Any of them at any time, so that edges are ever more ragged and no day jumps.
        clock: Clock::Exponential,
        division_days: [18.0, 18.0, 18.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.6, 0.3], [0.0, 0.3, 0.6]],
        radius_scale: 1.0,
        repulsion: 0.2,
        initial_relaxations: 20,
        relaxations_per_day: 4,
        days: 20,
        max_cells: 80_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.88, 0.82, 0.78], [0.09, 0.2, 0.13], [0.35, 0.52, 0.3]],
        tinted: &[],
        variation: 0.08,
        border: 0.12,
        gloss: 0.5,
        skin: Skin { through: 0.3, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("underside", [0.36, 0.12, 0.25], 0.25),
            ("petiole", [0.38, 0.2, 0.22], 0.2),
            ("pot", [0.86, 0.84, 0.8], 0.25),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 20.0, zoom: 1.0 },
    body: Shape {
        mesh: mesh_file!("goeppertia.obj"),
        levels: 2,
        but: &[
            Levels { group: "bare:petiole", levels: 1 },
            Levels { group: "bare:soil", levels: 1 },
        ],
        growths: Growths::Nothing,
    },
    paint: &[RING, STROKES],
    guides: None,
    motion: Motion::STILL,
};

/// F in a ring that is closed at base and tip; what is left is M.
const RING: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 24,
        height: 12,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "000000000000000000000000",
                "000000fffffffffffff00000",
                "00000ffff0fff0ffff0f0000",
                "0000fff000000000ffff0000",
                "0000fff0000000000fff0000",
                "000fff000000000000fff000",
                "0000fff0000000000fff0000",
                "000fff000000000000ff0000",
                "0000fff0000000000fff0000",
                "0000ffff00000000ffff0000",
                "00000f0ff0ff0ffffff00000",
                "000000000000000000000000",
            ],
        }),
    },
    use_as: Use::FirstCells { of: Foreground, instead: Middle },
};

/// M beside the veins, in strokes that taper from the midrib out to the ring; instead of it B.
const STROKES: Paint = Paint {
    wrap: Wrap::Veins(AlongVeins { order: 2, reach_cm: 0.6 }),
    image: Image {
        width: 10,
        height: 6,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "0000000000",
                "0000000000",
                "ff00000000",
                "ffff000000",
                "ffffff0000",
                "fffffff000",
            ],
        }),
    },
    use_as: Use::FirstCells { of: Middle, instead: Background },
};
