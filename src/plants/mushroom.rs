//! Fly agaric: white warts on a red cap (Thesis, Fig. 4.15).

use super::{Look, Plant, View};
use crate::surface::{Body, Control};
use crate::tissue::Recipe;

pub const PLANT: Plant = Plant {
    key: "mushroom",
    name: "Fly agaric",
    latin: "Amanita muscaria",
    source: "Thesis, Fig. 4.15",
    colour_names: ["red", "white", ""],
    recipe: Recipe {
        initial_cells: 6_000,
        initial_probability: [0.8, 0.2, 0.0],
        division_days: [8.0, 8.0, 8.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.7, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 3.0,
        repulsion: 0.04,
        initial_relaxations: 20,
        relaxations_per_day: 10,
        days: 20,
        max_cells: 120_000,
    },
    first_day: 20,
    look: Look {
        cells: [[0.761, 0.118, 0.102], [0.957, 0.925, 0.847], [0.5, 0.5, 0.2]],
        variation: 0.08,
        border: 0.15,
        gloss: 0.6,
        veins: false,
        bare: &[
            ("gills", [0.95, 0.93, 0.87], 0.0),
            ("stem", [0.93, 0.91, 0.85], 0.1),
            ("ring", [0.95, 0.92, 0.82], 0.05),
            ("moss", [0.24, 0.33, 0.12], 0.0),
            ("shoot", [0.38, 0.5, 0.18], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 12.0, zoom: 1.0 },
    body: grow_body,
    controls: no_controls,
};

fn grow_body() -> Body {
    super::body(include_str!("../../meshes/mushroom.obj"), |group| {
        match (group.part.as_str(), group.material.as_str()) {
            ("cap", _) => 3,
            (_, "bare:shoot") => 0,
            ("lamellae" | "volva", _) => 1,
            _ => 2,
        }
    })
}

fn no_controls() -> Vec<Control> {
    Vec::new()
}
