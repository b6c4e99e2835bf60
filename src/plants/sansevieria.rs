//! Snake plant: yellow margins round a banded green middle (Thesis, Fig. 4.19).

use super::{BodyError, Look, Plant, Skin, View, rough, scatter};
use crate::surface::{Body, ControlImage, Wrap};
use crate::tissue::{CellType, Control, Recipe, Use};

pub const PLANT: Plant = Plant {
    key: "sansevieria",
    name: "Snake plant",
    latin: "Sansevieria trifasciata",
    source: "Thesis, Fig. 4.19",
    colour_names: ["yellow", "dark green", "grey-green"],
    recipe: Recipe {
        initial_cells: 15_000,
        // Open in the thesis. `margins_and_bands` leaves F the margins; with less than 1 they would
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
    mesh: mesh_file!("sansevieria.obj"),
    body: grow_body,
    controls: Some(margins_and_bands),
    field: None,
    unfolding_days: &[],
};

/// The leaf coordinates of all leaves lie side by side, as in an atlas, so that each leaf has bands
/// of its own: so many places are there, the last ones empty.
pub(super) const ATLAS_PLACES: usize = 10;
/// Each leaf from the soil to its tip.
pub(super) const LENGTHS_CM: [f32; 6] = [51.0, 45.0, 47.5, 37.0, 40.0, 24.0];
/// On day 0, when cells stand a quarter of a centimetre apart; it widens by a quarter up to day 15.
/// With 0.3 it is a broken line at first, with 1 the young leaf has hardly a middle.
const MARGIN_CM: f32 = 0.6;

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

fn grow_body(obj: &str) -> Result<Body, BodyError> {
    Ok(Body::new(&super::smooth(obj, &|_| 2)?)?)
}

/// F along the rims alone, instead of it M; and M in bands alone, instead of it B.
fn margins_and_bands() -> Vec<Control> {
    let margins = atlas(|leaf, across, up| {
        (1.0 - across.abs()) * half_width_cm(LENGTHS_CM[leaf], up) < MARGIN_CM
    });
    let bands = atlas(|leaf, across, up| {
        let length_cm = LENGTHS_CM[leaf];
        is_band(across * half_width_cm(length_cm, up), up * length_cm, leaf as u32)
    });
    let first_cells = |image, of, instead| Control {
        wrap: Wrap::Leaf,
        image,
        use_as: Use::FirstCells { of, instead },
    };
    vec![
        first_cells(margins, CellType::Foreground, CellType::Middle),
        first_cells(bands, CellType::Middle, CellType::Background),
    ]
}

/// Paints the leaves side by side from a rule: `is_white(leaf, across, up)`, across from -1 at the
/// left rim to 1 at the right, up from 0 in the soil to 1 at the tip.
fn atlas(is_white: impl Fn(usize, f32, f32) -> bool) -> ControlImage {
    ControlImage::paint(1280, 256, |turns, up| {
        let place = turns * ATLAS_PLACES as f32;
        let leaf = (place as usize).min(LENGTHS_CM.len() - 1);
        is_white(leaf, 2.0 * (place - leaf as f32) - 1.0, up)
    })
}

/// Whether a band crosses the blade here: so far across from the midrib and up from the soil.
fn is_band(across_cm: f32, up_cm: f32, leaf: u32) -> bool {
    const BAND_CM: f32 = 2.4;
    // Bands zigzag, each in its own way, and are of unlike width.
    let band = |at: f32| libm::floorf(at) as u32;
    let bent = up_cm + 0.9 * rough(across_cm * 0.9 + 20.0, leaf * 7 + band(up_cm / 5.0), 21);
    let at = bent / BAND_CM + 0.35 * rough(up_cm * 0.5, leaf, 22);
    let share = 0.3 + 0.22 * scatter(band(at + 8.0), 23 + leaf);
    at - libm::floorf(at) < share
}
