//! Lotus: white petals that blush towards their tips, with streaks of deeper pink, each a clone that began in the
//! bud. Petals open from the outermost to the innermost.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Look, Motion, Plant, Rules, Skin, View, lily};
use crate::surface::Wrap;
use crate::tissue::CellType::{Background, Foreground};
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "lotus",
    name: "Lotus",
    latin: "Nelumbo nucifera",
    source: "",
    colour_names: ["pink", "white", ""],
    recipe: Recipe {
        initial_cells: 7_000,
        // Where the image lets them.
        initial_probability: [0.8, 0.2, 0.0],
        clock: Clock::Exponential,
        division_days: [11.0, 13.0, 13.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.0], [0.0, 0.6, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.0,
        repulsion: 0.2,
        initial_relaxations: 20,
        relaxations_per_day: 2,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.95, 0.77, 0.82], [0.97, 0.91, 0.9], [0.9, 0.7, 0.8]],
        tinted: &[(Background, [0.93, 0.6, 0.79]), (Foreground, [0.86, 0.42, 0.68])],
        variation: 0.05,
        border: 0.06,
        gloss: 0.15,
        skin: Skin { through: 0.4, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("filament", [0.95, 0.88, 0.6], 0.0),
            ("anther", [0.93, 0.75, 0.22], 0.0),
            ("receptacle", [0.84, 0.76, 0.28], 0.1),
            ("pistil", [0.48, 0.52, 0.16], 0.1),
            ("pedicel", [0.4, 0.54, 0.3], 0.1),
            ("leaf", [0.26, 0.46, 0.28], 0.1),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 30.0, zoom: 1.1 },
    body: lily::shape(mesh_file!("lotus.obj")),
    paint: &[STREAKS, BLUSH, STREAKS_BLUSH],
    guides: None,
    motion: Motion::STILL,
};

/// F in lines that run up to the tip, as the fine veins of a petal do.
const STREAKS: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 36,
        height: 12,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "000f0000ff000ff0f0f00fffff0f000fffff",
                "000f0000ff000ff0f0f00fffff0f000fffff",
                "000f0000ff000ff0f0f00fffff0f000fffff",
                "000f0000ff000ff0f0f00fffff0f000fffff",
                "000f0000ff000ff0f0f00fffff0f000fffff",
                "000f0000f0000ff000000fffff0f000fff0f",
                "000f0000f00000f000000fffff0f0000ff00",
                "000f0000f00000f000000ff00f0f00000f00",
                "00000000f00000f000000ff00f0000000f00",
                "000000000000000000000ff0000000000f00",
                "000000000000000000000000000000000000",
                "000000000000000000000000000000000000",
            ],
        }),
    },
    use_as: Use::FOREGROUND,
};

/// Both types are pinker the nearer to the tip, and farther down along the rims.
const BLUSH: Paint =
    Paint { wrap: Wrap::Leaf, image: PINK, use_as: Use::Colour { of: Background } };
const STREAKS_BLUSH: Paint = Paint { use_as: Use::Colour { of: Foreground }, ..BLUSH };

const PINK: Image = Image {
    width: 9,
    height: 8,
    rule: ImageRule::Pixels(Pixels {
        rows: &[
            "fffffffff",
            "feedddeef",
            "dcbaaabcd",
            "b9766679b",
            "853333358",
            "410000014",
            "000000000",
            "000000000",
        ],
    }),
};
