//! Tiger lily: raised freckles, denser towards the throat and none at the tips. A freckle is a clone of cells that
//! divide more than those around it.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Look, Motion, Plant, Rules, Skin, View, lily};
use crate::surface::Wrap;
use crate::tissue::CellType::Background;
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "tiger-lily",
    name: "Tiger lily",
    latin: "Lilium lancifolium",
    source: "",
    colour_names: ["purple-brown", "orange", ""],
    recipe: Recipe {
        initial_cells: 5_000,
        // Where the image lets them.
        initial_probability: [0.1, 0.9, 0.0],
        clock: Clock::Exponential,
        division_days: [8.5, 14.0, 14.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 3.0,
        repulsion: 0.04,
        initial_relaxations: 20,
        relaxations_per_day: 6,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.27, 0.09, 0.11], [0.91, 0.44, 0.16], [0.9, 0.6, 0.3]],
        tinted: &[(Background, [0.8, 0.27, 0.09])],
        variation: 0.08,
        border: 0.1,
        gloss: 0.25,
        skin: Skin { raised: [0.35, 0.0, 0.0], through: 0.6, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("filament", [0.85, 0.62, 0.3], 0.1),
            ("anther", [0.5, 0.2, 0.09], 0.0),
            ("pistil", [0.8, 0.5, 0.22], 0.3),
            ("pedicel", [0.3, 0.38, 0.2], 0.2),
            ("leaf", [0.22, 0.4, 0.17], 0.25),
        ],
    },
    view: View { azimuth_deg: 62.0, elevation_deg: 4.0, zoom: 1.05 },
    body: lily::shape(mesh_file!("tiger_lily.obj")),
    paint: &[FRECKLES, THROAT],
    guides: None,
    motion: Motion::STILL,
};

/// F but for the tips, the more the nearer to the throat.
const FRECKLES: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 24,
        height: 20,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "0000f000f0f0f000000f00f0",
                "00f0f00000000000f00f0000",
                "0000f0fffff00000f0000000",
                "00ff0f0fffff0000f0000000",
                "00ff00000f00f0ff00f000f0",
                "0ff0f0f0f000fff0000f0000",
                "000f000000ff0ff0000ff0f0",
                "0f000fff00f0f000f00f0f00",
                "000fff00ffff000f0f0000f0",
                "0000ff0000f00000f00f0ff0",
                "0ffffff0fff000f0fffff0f0",
                "0ff00fffffff0ffff0ffff00",
                "0ff0ff0ffff00ffffff0f0f0",
                "0fffff00ff0fffffff0f0ff0",
                "000000000000000000000000",
                "000000000000000000000000",
            ],
        }),
    },
    use_as: Use::FOREGROUND,
};

/// Darker towards the throat and along the midrib.
const THROAT: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 11,
        height: 8,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "00000100000",
                "00001310000",
                "00001410000",
                "00012521000",
                "00123632100",
                "01234743210",
                "12456865421",
                "35679a97653",
            ],
        }),
    },
    use_as: Use::Colour { of: Background },
};
