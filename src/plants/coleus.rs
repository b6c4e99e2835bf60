//! Coleus: a wine-red middle that runs out in fingers along the veins into lime, within a thin green rim.

use super::paint::{Blaze, Image, ImageRule, Paint, Pixels};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{AlongVeins, Wrap};
use crate::tissue::CellType::{Background, Foreground, Middle};
use crate::tissue::{Clock, Recipe, Use};

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "coleus",
    name: "Coleus",
    latin: "Coleus scutellarioides",
    source: "",
    colour_names: ["wine red", "green", "lime"],
    recipe: Recipe {
        initial_cells: 10_000,
        // All, until they hear of middle, veins and rim.
        initial_probability: [1.0, 0.0, 0.0],
        // Any of them at any time, so that edges are ever more ragged and no day jumps.
        clock: Clock::Exponential,
        division_days: [18.0, 18.0, 18.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.0], [0.0, 0.6, 0.0], [0.0, 0.0, 0.6]],
        radius_scale: 1.0,
        repulsion: 0.25,
        initial_relaxations: 20,
        relaxations_per_day: 5,
        days: 20,
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.42, 0.07, 0.15], [0.17, 0.4, 0.16], [0.72, 0.8, 0.26]],
        tinted: &[],
        variation: 0.1,
        border: 0.14,
        gloss: 0.15,
        skin: Skin { through: 0.6, ..Skin::LEAF },
        veins: false,
        bare: &[
            ("petiole", [0.45, 0.42, 0.25], 0.2),
            ("pot", [0.66, 0.36, 0.24], 0.08),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 30.0, zoom: 1.03 },
    body: Shape {
        mesh: mesh_file!("coleus.obj"),
        levels: 2,
        but: &[Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[MIDDLE, FINGERS, RIM],
    guides: None,
    motion: Motion::STILL,
};

/// The same, and in each individual its own.
pub const PLANT: Plant = Plant { rules: Rules::Second, ..FIRST };

/// F in the middle of the leaf; what is left is M.
const MIDDLE: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 128,
        height: 128,
        rule: ImageRule::Blaze(Blaze {
            all: 0.16,
            none: 0.34,
            uneven: 0.2,
            strokes: 25.0,
            broad: 0.15,
            lean: 0.0,
            astray: 0.0,
        }),
    },
    use_as: Use::FirstCells { of: Foreground, instead: Middle },
};

/// M away from the veins alone: beside them F goes on, in fingers that taper from the midrib out.
const FINGERS: Paint = Paint {
    wrap: Wrap::Veins(AlongVeins { order: 2, reach_cm: 0.5 }),
    image: Image {
        width: 10,
        height: 6,
        rule: ImageRule::Pixels(Pixels {
            rows: &[
                "ffffffffff",
                "ffffffffff",
                "00ffffffff",
                "00000fffff",
                "00000000ff",
                "000000000f",
            ],
        }),
    },
    use_as: Use::FirstCells { of: Middle, instead: Foreground },
};

/// M up to the rim alone; that is B.
const RIM: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image {
        width: 20,
        height: 1,
        rule: ImageRule::Pixels(Pixels { rows: &["0ffffffffffffffffff0"] }),
    },
    use_as: Use::FirstCells { of: Middle, instead: Background },
};
