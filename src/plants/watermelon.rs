//! Watermelon: dark jagged stripes from end to end (Thesis, Fig. 4.17).

use super::{BodyError, Look, Plant, Skin, View, rough};
use crate::surface::{Body, ControlImage, Cylinder, Wrap};
use crate::tissue::{Control, Recipe};
use glam::Vec3;

pub const PLANT: Plant = Plant {
    key: "watermelon",
    name: "Watermelon",
    latin: "Citrullus lanatus",
    source: "Thesis, Fig. 4.17",
    colour_names: ["dark green", "light green", ""],
    recipe: Recipe {
        initial_cells: 10_000,
        // Open in the thesis. The stripes of the control image take a third of the fruit; one light
        // cell in ten within them gives dark stripes their light flecks.
        initial_probability: [0.9, 0.1, 0.0],
        division_days: [5.0, 10.0, 10.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 0.5,
        // Open in the thesis. From 0.05 to 0.6 the stripes look alike: with so short a radius a cell
        // meets few others.
        repulsion: 0.25,
        // Open in the thesis. With so short a radius 5 would do.
        initial_relaxations: 20,
        // Open in the thesis. Children must leave their parents' sides before they divide again.
        relaxations_per_day: 10,
        days: 20,
        // Individuals have from 64,000 to 68,000 cells.
        max_cells: 100_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.114, 0.29, 0.133], [0.525, 0.69, 0.376], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.07,
        border: 0.12,
        gloss: 0.5,
        skin: Skin { gloss: [1.0, 0.85, 1.0], wax: 0.04, unevenness: 0.03, ..Skin::EVEN },
        veins: false,
        bare: &[("stem", [0.54, 0.478, 0.333], 0.05), ("scar", [0.5, 0.4, 0.28], 0.0)],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 16.0, zoom: 1.0 },
    mesh: mesh_file!("watermelon.obj"),
    body: grow_body,
    controls: Some(stripes),
    field: None,
    unfolding_days: &[],
};

/// Towards the stem end; of unit length.
pub(super) const AXIS: Vec3 = Vec3::new(0.48, 0.36, 0.8);
pub(super) const HALF_LENGTH_CM: f32 = 13.0;
/// So that the lowest point of the fruit lies on the ground.
pub(super) const CENTRE: Vec3 = Vec3::new(0.0, 12.3, 0.0);

const STRIPES: u32 = 11;

fn grow_body(obj: &str) -> Result<Body, BodyError> {
    Ok(Body::new(&super::smooth(obj, &|_| 2)?)?)
}

fn stripes() -> Vec<Control> {
    stripes_along(AXIS, CENTRE, HALF_LENGTH_CM)
}

/// Dark stripes on a cylinder along a fruit.
pub(super) fn stripes_along(axis: Vec3, centre: Vec3, half_length_cm: f32) -> Vec<Control> {
    let cylinder = Cylinder {
        base: centre - axis * half_length_cm,
        axis,
        zero: axis.cross(Vec3::Y).normalize(),
        height: 2.0 * half_length_cm,
    };
    let image = ControlImage::paint(512, 256, is_stripe);
    vec![Control::foreground(Wrap::Cylinder(cylinder), image)]
}

/// Whether a first cell at this angle, in turns, and height may be dark.
pub(super) fn is_stripe(turns: f32, height: f32) -> bool {
    let stripe = (turns * STRIPES as f32) as u32 % STRIPES;
    let from_middle = turns * STRIPES as f32 - stripe as f32 - 0.5;
    let side = u32::from(from_middle > 0.0);
    // Stripes wander, are of unlike width, and have teeth of two sizes.
    let wander = 0.1 * rough(height * 5.0, stripe, 0);
    let width = 0.17 + 0.03 * rough(0.0, stripe, 1) + 0.05 * rough(height * 9.0, stripe, 2 + side);
    let teeth = 0.09 * rough(height * 34.0, stripe, 4 + side);
    (from_middle - wander).abs() < width + teeth
}
