//! Long watermelon: stripes that widen with the reach of the push (Thesis, Fig. 4.16).

use super::paint::{Image, ImageRule, Paint};
use super::{Plant, Rules, View, watermelon};
use crate::surface::Wrap;
use crate::tissue::{Recipe, Use};
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "long-watermelon",
    name: "Long watermelon",
    source: "Thesis, Fig. 4.16",
    recipe: Recipe {
        // In Fig. 4.16 it goes from 1 to 2 and 3, `rs` in links: 42, 62 and 77% of what is seen are
        // dark.
        radius_scale: 1.0,
        // Open in the thesis. 0.02 * 3^2 = 0.18 keeps steps small at the widest reach as well; at
        // 0.05 dark stripes are wider than light ones from the first.
        repulsion: 0.02,
        ..watermelon::FIRST.recipe
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 16.0, zoom: 1.08 },
    body: watermelon::shape(mesh_file!("long_watermelon.obj")),
    paint: &[STRIPES],
    ..watermelon::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.16",
    recipe: watermelon::RECIPE,
    look: watermelon::LOOK,
    // The whole flank, level.
    view: View { azimuth_deg: 345.0, elevation_deg: 12.0, zoom: 0.95 },
    paint: &[watermelon::astray(STRIPES, watermelon::JAGGED)],
    ..FIRST
};

/// Towards the stem end; of unit length. It lies across the view, so that its length is seen.
pub(super) const AXIS: Vec3 = Vec3::new(0.8, 0.0, 0.6);
pub(super) const HALF_LENGTH_CM: f32 = 18.0;
/// So that the fruit lies on the ground.
pub(super) const CENTRE: Vec3 = Vec3::new(0.0, 10.4, 0.0);

const STRIPES: Paint = Paint {
    wrap: Wrap::Cylinder(watermelon::along(CENTRE, AXIS, HALF_LENGTH_CM, ZERO)),
    image: Image { width: 512, height: 256, rule: ImageRule::Stripes(watermelon::JAGGED) },
    use_as: Use::FOREGROUND,
};

/// Across the axis, and level.
const ZERO: Vec3 = Vec3::new(-0.6, 0.0, 0.8);
