//! Philodendron: a lime blaze along the midrib that spreads to the rim in feathered strokes
//! (Thesis, Fig. 4.12).

use super::paint::{Blaze, Image, ImageRule, Paint};
use super::{Growths, GuideVector, Guides, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::Wrap;
use crate::tissue::{Recipe, Use};
use glam::Vec2;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "philodendron",
    name: "Philodendron",
    latin: "Philodendron hederaceum",
    source: "Thesis, Fig. 4.12",
    colour_names: ["lime", "green", ""],
    recipe: Recipe {
        initial_cells: 10_000,
        // Open in the thesis. Within the blaze of the control image; one green cell in twenty gives
        // it green flecks, with one in five it is more fleck than blaze.
        initial_probability: [0.95, 0.05, 0.0],
        division_days: [30.0, 120.0, 120.0],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 2.0,
        // Open in the thesis. 0.09 * 2^2 = 0.36 keeps steps small.
        repulsion: 0.09,
        // Open in the thesis. Up to a half, a cell that is pushed back goes back, and clones run
        // together in rings and worms as without a field; over it none goes back and they are drawn
        // out in strokes; from 0.65 on the cells leave the midrib bare and crowd at the rim.
        anisotropy: 0.6,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. With 1 there are flecks and no strokes yet, with 6 the midrib is bare.
        relaxations_per_day: 3,
        days: 32,
        // Individuals have about 12,000 cells.
        max_cells: 40_000,
        ..Recipe::DEFAULT
    },
    first_day: 30,
    look: Look {
        cells: [[0.76, 0.83, 0.29], [0.15, 0.385, 0.19], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.1,
        border: 0.15,
        gloss: 0.45,
        skin: Skin::LEAF,
        veins: true,
        bare: &[
            ("petiole", [0.5, 0.56, 0.24], 0.3),
            ("stem", [0.4, 0.46, 0.22], 0.3),
            ("pot", [0.86, 0.84, 0.8], 0.25),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 12.0, zoom: 0.98 },
    body: Shape {
        mesh: mesh_file!("philodendron.obj"),
        levels: 2,
        but: &[Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[BLAZE],
    guides: Some(SIDE_VEINS),
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.12",
    recipe: RECIPE,
    look: Look { cells: [[0.76, 0.83, 0.29], [0.2, 0.37, 0.15], [0.5, 0.5, 0.2]], ..FIRST.look },
    paint: &[Paint {
        image: Image {
            rule: ImageRule::Blaze(Blaze { astray: 0.6, uneven: 0.45, ..FEATHERED }),
            ..BLAZE.image
        },
        ..BLAZE
    }],
    ..FIRST
};

/// More and smaller cells, none of them green within the blaze, that feel each other half as far: the blaze
/// is solid, and its border brushed.
pub(super) const RECIPE: Recipe = Recipe {
    initial_cells: 20_000,
    initial_probability: [1.0, 0.0, 0.0],
    radius_scale: 1.0,
    repulsion: 0.25,
    ..FIRST.recipe
};

/// How far a side vein goes along the leaf on its way from midrib to rim.
const LEAN: f32 = 0.2;

/// Lime along the middle, fading out towards the rim.
const BLAZE: Paint = Paint {
    wrap: Wrap::Leaf,
    image: Image { width: 256, height: 256, rule: ImageRule::Blaze(FEATHERED) },
    use_as: Use::FOREGROUND,
};

const FEATHERED: Blaze =
    Blaze { all: 0.1, none: 0.7, uneven: 0.3, strokes: 30.0, broad: 0.2, lean: LEAN, astray: 0.0 };

/// From the midrib to the rim and a little towards the tip, as the side veins run. The vectors are
/// about 2 cm apart. At 0.2 per cm those of one half of a leaf turn the field of the other around beside
/// the midrib; at 4 nothing looks better.
const SIDE_VEINS: Guides = Guides { epsilon_per_cm: 0.4, vectors: &SIDE_VEIN_VECTORS };

const SIDE_VEIN_VECTORS: [GuideVector; 20] = {
    /// Leaf coordinates of the control vectors, across on either side and along.
    const ACROSS: [f32; 4] = [-0.8, -0.35, 0.35, 0.8];
    const ALONG: [f32; 5] = [0.12, 0.3, 0.5, 0.7, 0.88];
    let mut vectors = [GuideVector::OnLeaves { at: Vec2::ZERO, direction: Vec2::X }; 20];
    let mut k = 0;
    while k < vectors.len() {
        let at = Vec2::new(ACROSS[k % 4], ALONG[k / 4]);
        let outward = if at.x < 0.0 { -1.0 } else { 1.0 };
        vectors[k] = GuideVector::OnLeaves { at, direction: Vec2::new(outward, LEAN) };
        k += 1;
    }
    vectors
};
