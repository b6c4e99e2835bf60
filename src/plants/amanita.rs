//! Ragged fly agaric: red spreads between the remains of the veil (Thesis, Fig. 4.14).

use super::paint::{Image, ImageRule, Paint, Warts};
use super::{Plant, Rules, View, mushroom};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "amanita",
    name: "Ragged fly agaric",
    source: "Thesis, Fig. 4.14",
    recipe: Recipe {
        initial_cells: 3_000,
        // Open in the thesis. One cell in ten between the warts of the veil makes small flecks; with
        // half of them white the cap is dusty and the warts are lost.
        initial_probability: [0.9, 0.1, 0.0],
        division_days: [5.0, 30.0, 30.0],
        radius_scale: 1.0,
        // Open in the thesis. Red cells multiply sixty-fold, white ones hardly: with 0.4 and ten
        // events a day they crush the white from a third to a tenth of the caps; with less than 0.05
        // hardly anything moves.
        repulsion: 0.05,
        // Open in the thesis: as above.
        relaxations_per_day: 4,
        days: 30,
        // Individuals have from 117,000 to 127,000 cells.
        max_cells: 150_000,
        ..mushroom::FIRST.recipe
    },
    first_day: 30,
    paint: &[GROWN_CAP, BUTTON, mushroom::ORANGE_RIMS],
    ..mushroom::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.14",
    recipe: Recipe {
        // Solid white patches with rough borders: red cells are slower and none begins among the warts,
        // white ones are faster, and all feel each other farther.
        initial_probability: [1.0, 0.0, 0.0],
        division_days: [8.0, 12.0, 12.0],
        radius_scale: 2.0,
        ..FIRST.recipe
    },
    first_day: 14,
    // From above: the cap is what it differs in from the other fly agaric.
    view: View { azimuth_deg: 20.0, elevation_deg: 36.0, zoom: 1.12 },
    paint: &[turned(GROWN_CAP, CAP_WARTS), turned(BUTTON, BUTTON_WARTS), mushroom::ORANGE_RIMS],
    ..FIRST
};

/// The same warts, in each individual turned around the cap.
const fn turned(paint: Paint, warts: Warts) -> Paint {
    let rule = ImageRule::Warts(Warts { astray: 0.5, ..warts });
    Paint { image: Image { rule, ..paint.image }, ..paint }
}

/// Each cap of `meshes/mushroom.obj` has warts where the veil is thick: no first cell is red there.
/// Smaller warts are crushed, larger ones run together at the top: these leave a fifth of the last day
/// white.
const CAP_WARTS: Warts =
    Warts { radius_cm: 6.3, height_cm: 3.7, count: 66, wart_radius_cm: 0.72, astray: 0.0 };
const BUTTON_WARTS: Warts =
    Warts { radius_cm: 2.55, height_cm: 2.7, count: 18, wart_radius_cm: 0.46, astray: 0.0 };
const GROWN_CAP: Paint = cap(Vec3::new(1.8, 12.4, 0.0), CAP_WARTS);
const BUTTON: Paint = cap(Vec3::new(-4.6, 4.1, 2.2), BUTTON_WARTS);

const fn cap(rim: Vec3, warts: Warts) -> Paint {
    let height = warts.height_cm;
    Paint {
        wrap: Wrap::Cylinder(Cylinder { base: rim, axis: Vec3::Y, zero: Vec3::X, height }),
        image: Image { width: 256, height: 128, rule: ImageRule::Warts(warts) },
        use_as: Use::FOREGROUND,
    }
}
