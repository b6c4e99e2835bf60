//! Lotus: white petals that blush towards their tips, with flecks of deeper pink, each a clone that began in the
//! bud. Petals open from the outermost to the innermost.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Growths, Levels, Look, Motion, Plant, Shape, Skin, View};
use crate::surface::Wrap;
use crate::tissue::CellType::Background;
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    key: "lotus",
    name: "Lotus",
    latin: "Nelumbo nucifera",
    source: "",
    colour_names: ["pink", "white", ""],
    recipe: Recipe {
        initial_cells: 6_000,
        // Where the image lets them.
        initial_probability: [0.3, 0.7, 0.0],
        clock: Clock::Exponential,
        division_days: [13.0, 13.0, 13.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.0], [0.0, 0.6, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.0,
        repulsion: 0.2,
        initial_relaxations: 20,
        relaxations_per_day: 4,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.87, 0.42, 0.58], [0.97, 0.91, 0.9], [0.9, 0.7, 0.8]],
        tinted: &[(Background, [0.9, 0.52, 0.65])],
        variation: 0.05,
        border: 0.06,
        gloss: 0.15,
        skin: Skin { through: 0.8, ..Skin::LEAF },
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
    body: Shape {
        mesh: mesh_file!("lotus.obj"),
        levels: 2,
        but: &[
            Levels { group: "bare:filament", levels: 0 },
            Levels { group: "bare:anther", levels: 1 },
            Levels { group: "bare:pistil", levels: 1 },
        ],
        growths: Growths::Nothing,
    },
    paint: &[FLECKS, BLUSH],
    guides: None,
    motion: Motion::STILL,
};

/// F towards the tip and the rims.
const FLECKS: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 24,
        height: 16,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "fffffff0ff0f0ffff0ffffff",
                "ff0f0000f0f00fff0fffffff",
                "f000000f000f0f0fff00f0ff",
                "f00f0f0f0000ff0fff0ff0f0",
                "0f0000000000ff000f00f00f",
                "000000ff00f0000000f00f00",
                "ff00f00f00000f00000f0f00",
                "f000000000000000f000000f",
                "000000000000000000f00000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
            ],
        }),
    },
    use_as: Use::FOREGROUND,
};

/// Pink from the tip downwards, farther along the rims.
const BLUSH: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
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
    },
    use_as: Use::Colour { of: Background },
};
