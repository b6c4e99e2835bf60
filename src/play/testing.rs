//! Small plants for the tests of this room, so that they need no catalogue and grow in no time.

use crate::plants::{
    Growths, GuideVector, Guides, Look, MeshFile, Motion, Plant, Rules, Shape, Skin, View,
};
use crate::tissue::Recipe;
use glam::Vec3;

/// Two plants of one square sheet each; the first has M cells and a direction field.
pub const PLANTS: &[Plant] =
    &[plant("leaf", "Leaf", 6, "red", Some(EASTWARDS)), plant("fruit", "Fruit", 4, "", None)];

const fn plant(
    key: &'static str,
    name: &'static str,
    days: u32,
    middle: &'static str,
    guides: Option<Guides>,
) -> Plant {
    Plant {
        rules: Rules::First,
        key,
        name,
        latin: "Folium quadratum",
        source: "made for tests",
        colour_names: ["yellow", "green", middle],
        recipe: Recipe {
            initial_cells: 100,
            initial_probability: [0.5, 0.5, 0.0],
            division_days: [5.0, 8.0, 10.0],
            mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
            radius_scale: 1.0,
            repulsion: 0.09,
            initial_relaxations: 3,
            relaxations_per_day: 2,
            days,
            max_cells: 100_000,
            ..Recipe::DEFAULT
        },
        first_day: 3,
        look: Look {
            cells: [[0.9, 0.8, 0.2], [0.1, 0.4, 0.2], [0.5, 0.5, 0.5]],
            tinted: &[],
            variation: 0.1,
            border: 0.3,
            gloss: 0.5,
            skin: Skin::EVEN,
            veins: false,
            bare: &[],
        },
        view: View { azimuth_deg: 0.0, elevation_deg: 20.0, zoom: 1.0 },
        body: Shape {
            mesh: MeshFile { name: key, text: SHEET },
            levels: 0,
            but: &[],
            growths: Growths::Nothing,
        },
        paint: &[],
        guides,
        motion: Motion::STILL,
    }
}

/// A square of 4 by 4 centimetres in 16 quads.
pub const SHEET: &str = "\
    v 0 1 -0\nv 1 1 -0\nv 2 1 -0\nv 3 1 -0\nv 4 1 -0\nv 0 1 -1\nv 1 1 -1\nv 2 1 -1\nv 3 1 -1\n\
    v 4 1 -1\nv 0 1 -2\nv 1 1 -2\nv 2 1 -2\nv 3 1 -2\nv 4 1 -2\nv 0 1 -3\nv 1 1 -3\nv 2 1 -3\n\
    v 3 1 -3\nv 4 1 -3\nv 0 1 -4\nv 1 1 -4\nv 2 1 -4\nv 3 1 -4\nv 4 1 -4\nf 1 2 7 6\nf 2 3 8 7\n\
    f 3 4 9 8\nf 4 5 10 9\nf 6 7 12 11\nf 7 8 13 12\nf 8 9 14 13\nf 9 10 15 14\nf 11 12 17 16\n\
    f 12 13 18 17\nf 13 14 19 18\nf 14 15 20 19\nf 16 17 22 21\nf 17 18 23 22\nf 18 19 24 23\n\
    f 19 20 25 24\n";

const EASTWARDS: Guides = Guides { epsilon_per_cm: 1.0, vectors: &EASTWARD };
const EASTWARD: [GuideVector; 1] =
    [GuideVector::Near { point_cm: Vec3::new(0.5, 1.0, -0.5), direction: Vec3::X }];
