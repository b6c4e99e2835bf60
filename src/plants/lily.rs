//! Golden lily: freckles towards the throat, each a clone that began in the bud. While the flower opens they are
//! stretched with the skin that they are in.

use super::paint::{Image, ImageRule, Paint, Pixels};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::Wrap;
use crate::tissue::CellType::Background;
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "lily",
    name: "Golden lily",
    latin: "Lilium",
    source: "",
    colour_names: ["brown", "golden", ""],
    recipe: Recipe {
        initial_cells: 5_000,
        // Where the image lets them.
        initial_probability: [0.16, 0.84, 0.0],
        clock: Clock::Exponential,
        division_days: [11.0, 13.0, 13.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.5,
        repulsion: 0.12,
        initial_relaxations: 20,
        relaxations_per_day: 5,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.42, 0.2, 0.08], [0.95, 0.7, 0.11], [0.9, 0.6, 0.2]],
        tinted: &[(Background, [0.83, 0.47, 0.05])],
        variation: 0.07,
        border: 0.1,
        gloss: 0.2,
        skin: Skin { through: 0.7, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("filament", [0.88, 0.84, 0.5], 0.1),
            ("anther", [0.45, 0.22, 0.08], 0.0),
            ("pistil", [0.74, 0.75, 0.36], 0.3),
            ("pedicel", [0.33, 0.47, 0.2], 0.2),
            ("leaf", [0.24, 0.42, 0.17], 0.25),
        ],
    },
    view: View { azimuth_deg: 20.0, elevation_deg: 14.0, zoom: 1.05 },
    body: shape(mesh_file!("lily.obj")),
    paint: &[FRECKLES, MIDRIB],
    guides: None,
    motion: Motion::STILL,
};

/// A flower, whose filaments are too thin to be refined.
pub(super) const fn shape(mesh: super::MeshFile) -> Shape {
    let but = &[
        Levels { group: "bare:filament", levels: 0 },
        Levels { group: "bare:anther", levels: 1 },
        Levels { group: "bare:pistil", levels: 1 },
    ];
    Shape { mesh, levels: 2, but, growths: Growths::Nothing }
}

/// F in the lower half of each tepal, the more the nearer to the throat.
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
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000000",
                "000000000000000000000f00",
                "00000000f00000000f0ff000",
                "00fff0f0000ff0f0ff0f0000",
                "000ff00000f0ffff00000f00",
                "000ff000ffff0ff0f0f0ff00",
                "00000fff0f0f0ff000000f00",
                "00ff00ff0fffffffffffff00",
                "00ffffffffffffff00ffff00",
                "000fffffff000fffffffff00",
                "00f0fff00ffffff00fffff00",
                "000000000000000000000000",
            ],
        }),
    },
    use_as: Use::FOREGROUND,
};

/// A darker midrib.
const MIDRIB: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 23,
        height: 1,
        rule: ImageRule::Pixels(Pixels { rows: &["0000000014bfb4100000000"] }),
    },
    use_as: Use::Colour { of: Background },
};
