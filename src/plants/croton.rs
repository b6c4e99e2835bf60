//! Croton: a shrub whose leaves turn from green to yellow in one run (Thesis, Fig. 4.3).

use super::{Look, Plant, View};
use crate::surface::{Body, Control};
use crate::tissue::Recipe;

pub const PLANT: Plant = Plant {
    key: "croton",
    name: "Croton",
    latin: "Codiaeum variegatum",
    source: "Thesis, Fig. 4.3",
    colour_names: ["yellow", "green", ""],
    recipe: Recipe {
        initial_cells: 10_000,
        // Open in the thesis. Over 0.2 day 5 is no longer a green plant, under 0.1 day 30 is not
        // mostly yellow.
        initial_probability: [0.13, 0.87, 0.0],
        division_days: [5.0, 10.0, 10.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.0,
        // Open in the thesis.
        repulsion: 0.25,
        initial_relaxations: 20,
        relaxations_per_day: 10,
        days: 30,
        max_cells: 200_000,
    },
    first_day: 15,
    look: Look {
        cells: [[0.91, 0.784, 0.227], [0.122, 0.353, 0.165], [0.5, 0.5, 0.2]],
        variation: 0.12,
        border: 0.25,
        gloss: 0.55,
        veins: true,
        bare: &[
            ("petiole", [0.42, 0.47, 0.2], 0.3),
            ("bark", [0.36, 0.29, 0.2], 0.05),
            ("pot", [0.66, 0.36, 0.24], 0.08),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 24.0, zoom: 1.0 },
    body: grow_body,
    controls: no_controls,
};

fn grow_body() -> Body {
    super::body(include_str!("../../meshes/croton.obj"), |group| match group.material.as_str() {
        "bare:petiole" | "bare:soil" => 1,
        _ => 2,
    })
}

fn no_controls() -> Vec<Control> {
    Vec::new()
}
