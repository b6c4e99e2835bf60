//! Winter squash: a pale band along each furrow, green backs of the ribs, and flecks of either on the other.

use super::paint::{Image, ImageRule, Paint, Stripes};
use super::{Growths, Look, Motion, Plant, Rules, Shape, Skin, View};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::{Clock, Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    rules: Rules::First,
    key: "winter-squash",
    name: "Winter squash",
    latin: "Cucurbita pepo",
    source: "",
    colour_names: ["cream", "green", "orange"],
    recipe: Recipe {
        initial_cells: 6_000,
        initial_probability: [0.92, 0.05, 0.03],
        clock: Clock::Exponential,
        division_days: [10.0, 10.0, 8.0],
        mutation: [[0.985, 0.005, 0.01], [0.012, 0.978, 0.01], [0.0, 0.0, 1.0]],
        adhesion: [[0.6, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.6]],
        radius_scale: 1.0,
        repulsion: 0.25,
        initial_relaxations: 20,
        relaxations_per_day: 8,
        days: 18,
        max_cells: 100_000,
        ..Recipe::DEFAULT
    },
    first_day: 18,
    look: Look {
        cells: [[0.91, 0.85, 0.64], [0.13, 0.28, 0.13], [0.86, 0.53, 0.16]],
        tinted: &[],
        variation: 0.08,
        border: 0.12,
        gloss: 0.12,
        skin: Skin { unevenness: 0.03, ..Skin::EVEN },
        veins: false,
        bare: &[("stalk", [0.6, 0.53, 0.38], 0.0)],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 28.0, zoom: 0.95 },
    body: Shape {
        mesh: mesh_file!("winter_squash.obj"),
        levels: 1,
        but: &[],
        growths: Growths::Nothing,
    },
    paint: &[Paint {
        wrap: Wrap::Cylinder(Cylinder {
            base: Vec3::ZERO,
            axis: Vec3::Y,
            zero: ZERO,
            height: HEIGHT_CM,
        }),
        image: Image {
            width: 512,
            height: 256,
            rule: ImageRule::Stripes(Stripes {
                count: RIBS,
                half_width: 0.2,
                varies_between: 0.02,
                varies_along: 0.05,
                wander: 0.03,
                teeth: 0.07,
                astray: 0.0,
                cube: None,
            }),
        },
        use_as: Use::FOREGROUND,
    }],
    guides: None,
    motion: Motion::STILL,
};

/// The same, and in each individual its own.
pub const PLANT: Plant = Plant { rules: Rules::Second, ..FIRST };

pub(super) const HEIGHT_CM: f32 = 11.5;
pub(super) const RIBS: u32 = 10;
/// Half a rib before the furrow at `x`: a stripe has its middle in the middle of its room.
const ZERO: Vec3 = Vec3::new(0.951_056_5, 0.0, 0.309_017);
