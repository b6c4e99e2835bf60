//! Nerve plant: the cells along all veins are white, down to those of the third order.

use super::paint::{NEAR, Paint};
use super::{Growths, Levels, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::tissue::CellType::{Background, Foreground, Middle};
use crate::tissue::{Clock, Recipe, Use};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "fittonia",
    name: "Nerve plant",
    latin: "Fittonia albivenis",
    source: "",
    colour_names: ["white", "green", "net white"],
    recipe: Recipe {
        initial_cells: 20_000,
        // All, until they hear of the veins.
        initial_probability: [1.0, 0.0, 0.0],
        // Any of them at any time, so that edges are ever more ragged and no day jumps.
        clock: Clock::Exponential,
        division_days: [25.0, 21.0, 25.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.5], [0.0, 0.5, 0.0], [0.5, 0.0, 0.5]],
        radius_scale: 0.8,
        repulsion: 0.2,
        initial_relaxations: 20,
        relaxations_per_day: 4,
        days: 15,
        max_cells: 100_000,
        ..Recipe::DEFAULT
    },
    first_day: 15,
    look: Look {
        cells: [[0.95, 0.96, 0.91], [0.12, 0.32, 0.16], [0.84, 0.9, 0.8]],
        tinted: &[],
        variation: 0.07,
        border: 0.1,
        gloss: 0.35,
        skin: Skin::LEAF,
        veins: false,
        bare: &[
            ("petiole", [0.45, 0.5, 0.3], 0.2),
            ("pot", [0.66, 0.36, 0.24], 0.08),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 36.0, zoom: 1.05 },
    body: Shape {
        mesh: mesh_file!("fittonia.obj"),
        levels: 2,
        but: &[Levels { group: "bare:soil", levels: 1 }],
        growths: Growths::Nothing,
    },
    paint: &[
        // White beside the main veins, and what is left paler beside all others.
        Paint::along_veins(2, 0.17, NEAR, Use::FirstCells { of: Foreground, instead: Middle }),
        Paint::along_veins(3, 0.098, NEAR, Use::FirstCells { of: Middle, instead: Background }),
    ],
    guides: None,
    motion: Motion::STILL,
};
