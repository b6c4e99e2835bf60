//! Snake plant: yellow margins round a banded green middle (Thesis, Fig. 4.19).

use super::paint::{Bands, Image, ImageRule, Margins, Paint};
use super::{Growths, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::Wrap;
use crate::tissue::{CellType, Recipe, Use};

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "sansevieria",
    name: "Snake plant",
    latin: "Sansevieria trifasciata",
    source: "Thesis, Fig. 4.19",
    colour_names: ["yellow", "dark green", "grey-green"],
    recipe: Recipe {
        initial_cells: 15_000,
        // Open in the thesis. `MARGINS` leaves F the margins; with less than 1 they would
        // have green flecks, which those of the plant have not.
        initial_probability: [1.0, 0.0, 0.0],
        // F is the margin, B the ground. The bands are M, and M lives by the numbers of B in all: it
        // is the ground in another colour, which the control image gives.
        division_days: [5.0, 70.0, 70.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.7, 0.0, 0.0], [0.0, 0.7, 0.7], [0.0, 0.7, 0.7]],
        radius_scale: 0.7,
        // Open in the thesis. 0.5 * 0.7^2 = 0.25 keeps steps small; at 0.05 the crowded margins
        // widen half as much.
        repulsion: 0.5,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. With 3 the margins widen half as much, with 30 nothing looks better.
        relaxations_per_day: 10,
        days: 15,
        // Individuals have about 39,000 cells.
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 15,
    look: Look {
        cells: [[0.902, 0.812, 0.333], [0.145, 0.29, 0.19], [0.56, 0.655, 0.478]],
        tinted: &[],
        variation: 0.08,
        border: 0.12,
        gloss: 0.4,
        skin: Skin { through: 0.4, wax: 0.04, ..Skin::LEAF },
        veins: false,
        bare: &[("pot", [0.66, 0.36, 0.24], 0.08), ("soil", [0.2, 0.15, 0.11], 0.0)],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 14.0, zoom: 0.93 },
    body: Shape {
        mesh: mesh_file!("sansevieria.obj"),
        levels: 2,
        but: &[],
        growths: Growths::Nothing,
    },
    paint: &[MARGINS, BANDS],
    guides: None,
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.19",
    recipe: Recipe {
        // More cells that feel each other farther: margins are clean and even.
        initial_cells: 20_000,
        radius_scale: 1.3,
        repulsion: 0.2,
        ..FIRST.recipe
    },
    look: Look {
        cells: [[0.902, 0.812, 0.333], [0.17, 0.28, 0.18], [0.56, 0.655, 0.478]],
        ..FIRST.look
    },
    paint: &[
        // They widen more.
        side_by_side(
            ImageRule::Margins(Margins { margin_cm: 0.45 }),
            CellType::Foreground,
            CellType::Middle,
        ),
        side_by_side(
            ImageRule::Bands(Bands { astray: 1.0, ..ZIGZAG }),
            CellType::Middle,
            CellType::Background,
        ),
    ],
    ..FIRST
};

/// The leaf coordinates of all leaves lie side by side, as in an atlas, so that each leaf has bands
/// of its own: so many places are there, the last ones empty.
pub(super) const ATLAS_PLACES: usize = 10;
/// Each leaf from the soil to its tip.
pub(super) const LENGTHS_CM: [f32; 6] = [51.0, 45.0, 47.5, 37.0, 40.0, 24.0];

/// Half the width of a blade at `t`, from 0 in the soil to 1 at the tip.
pub(super) fn half_width_cm(length_cm: f32, t: f32) -> f32 {
    let broad = 1.9 + 0.02 * length_cm;
    // A narrow channelled foot, and a tip that is drawn out to a point.
    let foot = 0.5 + 0.5 * smooth_step(t / 0.5);
    let tip = 1.0 - libm::powf(((t - 0.5) / 0.5).clamp(0.0, 1.0), 2.8);
    broad * foot * tip
}

fn smooth_step(t: f32) -> f32 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

const fn side_by_side(rule: ImageRule, of: CellType, instead: CellType) -> Paint {
    Paint {
        wrap: Wrap::Leaf,
        image: Image { width: 1280, height: 256, rule },
        use_as: Use::FirstCells { of, instead },
    }
}

/// F along the rims alone, instead of it M. On day 0, when cells stand a quarter of a centimetre apart;
/// it widens by a quarter up to day 15. With 0.3 it is a broken line at first, with 1 the young leaf has
/// hardly a middle.
const MARGINS: Paint = side_by_side(
    ImageRule::Margins(Margins { margin_cm: 0.6 }),
    CellType::Foreground,
    CellType::Middle,
);

/// M in bands alone, instead of it B.
const BANDS: Paint = side_by_side(ImageRule::Bands(ZIGZAG), CellType::Middle, CellType::Background);

const ZIGZAG: Bands =
    Bands { apart_cm: 2.4, share: 0.3, share_varies: 0.22, zigzag_cm: 0.9, astray: 0.0 };
