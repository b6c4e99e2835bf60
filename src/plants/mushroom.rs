//! Fly agaric: white warts on a red cap (Thesis, Fig. 4.15).

use super::paint::{Grain, Image, ImageRule, Paint, Rims};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::CellType::Foreground;
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "mushroom",
    name: "Fly agaric",
    latin: "Amanita muscaria",
    source: "Thesis, Fig. 4.15",
    colour_names: ["red", "white", ""],
    // The cells live on the caps alone. In the thesis the stem is made of B cells that a texture
    // keeps white; a plain white stem looks the same, and saves a third of the cells.
    recipe: Recipe {
        initial_cells: 6_000,
        // Open in the thesis. With what `WARTS` adds at the top, a sixth of the cells is white;
        // with a third the warts run into worms.
        initial_probability: [0.9, 0.1, 0.0],
        division_days: [8.0, 8.0, 8.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.7, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 3.0,
        // Open in the thesis. 0.04 * 3^2 = 0.36 keeps steps small; at 0.01 warts are ragged and run
        // together.
        repulsion: 0.04,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. Warts are round from 3 on.
        relaxations_per_day: 6,
        days: 20,
        // Individuals have from 26,000 to 27,000 cells.
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.761, 0.118, 0.102], [0.957, 0.925, 0.847], [0.5, 0.5, 0.2]],
        tinted: &[(Foreground, [0.88, 0.37, 0.08])],
        variation: 0.08,
        border: 0.15,
        gloss: 0.5,
        skin: Skin {
            gloss: [1.0, 0.1, 1.0],
            raised: [0.0, 0.28, 0.0],
            unevenness: 0.015,
            ..Skin::EVEN
        },
        veins: false,
        bare: &[
            ("gills", [0.96, 0.94, 0.88], 0.0),
            ("flesh", [0.74, 0.68, 0.57], 0.0),
            ("stem", [0.93, 0.91, 0.85], 0.1),
            ("ring", [0.95, 0.92, 0.82], 0.05),
            ("moss", [0.24, 0.33, 0.12], 0.0),
            ("shoot", [0.38, 0.5, 0.18], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 15.0, zoom: 1.08 },
    body: Shape {
        mesh: mesh_file!("mushroom.obj"),
        // On the caps about as many triangles as first cells: finer, and the wide repulsive radius has
        // far more of them to unfold around each cell.
        levels: 2,
        but: &[Levels { group: "lamellae", levels: 1 }, Levels { group: "volva", levels: 1 }],
        growths: Growths::Moss,
    },
    paint: &[WARTS, ORANGE_RIMS],
    guides: None,
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.15",
    recipe: Recipe {
        // Farther felt and fewer, warts are larger and round, and none run into worms.
        initial_probability: [0.93, 0.07, 0.0],
        radius_scale: 3.0,
        ..FIRST.recipe
    },
    ..FIRST
};

/// Where the veil tore last, at the top of the cap, more of it is left: the higher, the more first
/// cells are white, in a fine random grain.
const WARTS: Paint = Paint {
    wrap: Wrap::Cylinder(Cylinder {
        base: Vec3::new(0.0, 12.5, 0.0),
        axis: Vec3::Y,
        zero: Vec3::X,
        height: 3.9,
    }),
    image: Image {
        width: 256,
        height: 128,
        rule: ImageRule::Grain(Grain { black_at_the_top: 0.2 }),
    },
    use_as: Use::FOREGROUND,
};

/// Red is tinted with orange towards the rims of the caps of `meshes/mushroom.obj`: those of the button
/// and of the grown cap.
pub(super) const ORANGE_RIMS: Paint = Paint {
    wrap: Wrap::Cylinder(Cylinder {
        base: Vec3::ZERO,
        axis: Vec3::Y,
        zero: Vec3::X,
        height: HEIGHT_CM,
    }),
    image: Image {
        width: 1,
        height: 256,
        rule: ImageRule::Rims(Rims { caps_cm: &[[4.1, 6.8], [12.4, 16.1]], height_cm: HEIGHT_CM }),
    },
    use_as: Use::Colour { of: Foreground },
};

const HEIGHT_CM: f32 = 17.0;
