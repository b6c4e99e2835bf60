//! Banded cactus: yellow belts round green columns (Thesis, Fig. 4.13).

use super::paint::{Belts, Image, ImageRule, Paint};
use super::{Plant, Rules, cactus};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "banded-cactus",
    name: "Banded cactus",
    source: "Thesis, Fig. 4.13",
    recipe: Recipe {
        // Open in the thesis. Three cells in a hundred leave the belts a few green flecks; with ten
        // they are spotted.
        initial_probability: [0.97, 0.03, 0.0],
        division_days: [15.0, 60.0, 60.0],
        adhesion: [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 3.0,
        // Open in the thesis. 0.04 * 3^2 = 0.36 keeps steps small; at 0.005 the belts' borders stay
        // as sharp as in the image.
        repulsion: 0.04,
        // Individuals have from 7,800 to 8,100 cells.
        ..cactus::FIRST.recipe
    },
    paint: &[BELTS],
    ..cactus::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.13",
    recipe: Recipe {
        // Smaller cells that feel each other less far leave the belts rough and peppered with green.
        initial_cells: 14_000,
        initial_probability: [0.93, 0.07, 0.0],
        radius_scale: 1.3,
        repulsion: 0.2,
        ..FIRST.recipe
    },
    look: cactus::LOOK,
    paint: &[Paint {
        image: Image {
            rule: ImageRule::Belts(Belts { astray_cm: 5.0, lobes_cm: [2.2, 0.9], ..LOBED }),
            ..BELTS.image
        },
        ..BELTS
    }],
    ..FIRST
};

/// Towards the small column; of unit length.
const ACROSS: Vec3 = Vec3::new(0.96, 0.0, 0.28);
const HEIGHT_CM: f32 = 40.0;

/// Belts round each column. The axis of the cylinder stands between the two, so that each has half
/// of the image to itself.
const BELTS: Paint = Paint {
    wrap: Wrap::Cylinder(Cylinder {
        base: Vec3::new(ACROSS.x * 6.5, 0.0, ACROSS.z * 6.5),
        axis: Vec3::Y,
        zero: ACROSS,
        height: HEIGHT_CM,
    }),
    image: Image { width: 256, height: 256, rule: ImageRule::Belts(LOBED) },
    use_as: Use::FOREGROUND,
};

const LOBED: Belts = Belts {
    height_cm: HEIGHT_CM,
    near_cm: &[[9.0, 15.5]],
    far_cm: &[[3.5, 8.0], [14.5, 24.0], [31.5, 36.0]],
    // Straight borders look painted on, with twice as much belts break.
    lobes_cm: [1.5, 0.9],
    astray_cm: 0.0,
};
