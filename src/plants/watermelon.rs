//! Watermelon: dark jagged stripes from end to end (Thesis, Fig. 4.17).

use super::paint::{Image, ImageRule, Paint, Stripes};
use super::{Growths, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
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
    body: shape(mesh_file!("watermelon.obj")),
    paint: &[STRIPES],
    guides: None,
    motion: Motion::STILL,
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.17",
    recipe: RECIPE,
    look: LOOK,
    paint: &[astray(STRIPES, JAGGED)],
    ..FIRST
};

/// More and slower cells that feel each other farther: those of light and dark are of like size, stripes
/// reach the stalk unbroken, and the rind is mottled.
pub(super) const RECIPE: Recipe = Recipe {
    initial_cells: 14_000,
    initial_probability: [0.97, 0.03, 0.0],
    division_days: [6.0, 10.0, 10.0],
    radius_scale: 0.9,
    repulsion: 0.3,
    ..FIRST.recipe
};

pub(super) const LOOK: Look = Look {
    cells: [[0.1, 0.23, 0.1], [0.5, 0.61, 0.37], [0.5, 0.5, 0.2]],
    variation: 0.12,
    border: 0.2,
    ..FIRST.look
};

/// The same stripes, in each individual in places of its own.
pub(super) const fn astray(paint: Paint, stripes: Stripes) -> Paint {
    let rule = ImageRule::Stripes(Stripes { astray: 0.6, wander: 0.14, ..stripes });
    Paint { image: Image { rule, ..paint.image }, ..paint }
}

/// Towards the stem end; of unit length.
pub(super) const AXIS: Vec3 = Vec3::new(0.48, 0.36, 0.8);
pub(super) const HALF_LENGTH_CM: f32 = 13.0;
/// So that the lowest point of the fruit lies on the ground.
pub(super) const CENTRE: Vec3 = Vec3::new(0.0, 12.3, 0.0);

pub(super) const fn shape(mesh: super::MeshFile) -> Shape {
    Shape { mesh, levels: 2, but: &[], growths: Growths::Nothing }
}

/// Dark stripes on a cylinder along the fruit.
const STRIPES: Paint = Paint {
    wrap: Wrap::Cylinder(along(CENTRE, AXIS, HALF_LENGTH_CM, Vec3::new(ZERO_X, 0.0, ZERO_Z))),
    image: Image { width: 512, height: 256, rule: ImageRule::Stripes(JAGGED) },
    use_as: Use::FOREGROUND,
};

/// Across the axis of the fruit, and level.
const ZERO_X: f32 = -0.857_492_9;
const ZERO_Z: f32 = 0.514_495_75;

pub(super) const JAGGED: Stripes = Stripes {
    count: 11,
    half_width: 0.17,
    varies_between: 0.03,
    varies_along: 0.05,
    wander: 0.1,
    teeth: 0.09,
    astray: 0.0,
    cube: None,
};

/// The cylinder from end to end of a fruit.
pub(super) const fn along(centre: Vec3, axis: Vec3, half_length_cm: f32, zero: Vec3) -> Cylinder {
    let base = Vec3::new(
        centre.x - axis.x * half_length_cm,
        centre.y - axis.y * half_length_cm,
        centre.z - axis.z * half_length_cm,
    );
    Cylinder { base, axis, zero, height: 2.0 * half_length_cm }
}
