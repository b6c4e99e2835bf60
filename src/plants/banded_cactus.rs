//! Banded cactus: yellow belts round green columns (Thesis, Fig. 4.13).

use super::{Plant, cactus, rough};
use crate::surface::{ControlImage, Cylinder, Wrap};
use crate::tissue::{Control, Recipe};
use glam::Vec3;

pub const PLANT: Plant = Plant {
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
        ..cactus::PLANT.recipe
    },
    controls: Some(belts),
    ..cactus::PLANT
};

/// Towards the small column; of unit length.
const ACROSS: Vec3 = Vec3::new(0.96, 0.0, 0.28);
const HEIGHT_CM: f32 = 40.0;

/// Belts round each column. The axis of the cylinder stands between the two, so that each has half
/// of the image to itself.
fn belts() -> Vec<Control> {
    let base = ACROSS * 6.5;
    let cylinder = Cylinder { base, axis: Vec3::Y, zero: ACROSS, height: HEIGHT_CM };
    let image = ControlImage::paint(256, 256, is_belt);
    vec![Control::foreground(Wrap::Cylinder(cylinder), image)]
}

/// Whether a first cell at this angle, in turns, and height may be yellow.
fn is_belt(turns: f32, height: f32) -> bool {
    // From the lower to the upper border, in centimetres.
    let belts: &[[f32; 2]] = match (0.25..0.75).contains(&turns) {
        true => &[[3.5, 8.0], [14.5, 24.0], [31.5, 36.0]],
        false => &[[9.0, 15.5]],
    };
    // Borders are lobed: straight ones look painted on, with twice as much belts break.
    let lobes =
        |border| 1.5 * rough(turns * 17.0, border, 11) + 0.9 * rough(turns * 41.0, border, 12);
    let height_cm = height * HEIGHT_CM;
    (0..).zip(belts).any(|(k, [lower, upper])| {
        (lower + lobes(2 * k)..upper + lobes(2 * k + 1)).contains(&height_cm)
    })
}
