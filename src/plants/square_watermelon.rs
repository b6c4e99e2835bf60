//! Square watermelon: the stripes of the round one, over the edges of a cube (Thesis, Fig. 4.18).

use super::paint::{Cube, Image, ImageRule, Paint, Stripes};
use super::{Plant, Rules, View, watermelon};
use crate::surface::{Cylinder, Wrap};
use crate::tissue::Use;
use glam::Vec3;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "square-watermelon",
    name: "Square watermelon",
    // Its recipe is that of Fig. 4.17, number by number: only the body differs.
    source: "Thesis, Fig. 4.18",
    view: View { azimuth_deg: 33.0, elevation_deg: 24.0, zoom: 0.96 },
    body: watermelon::shape(mesh_file!("square_watermelon.obj")),
    paint: &[STRIPES],
    ..watermelon::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, Fig. 4.18",
    recipe: watermelon::RECIPE,
    look: watermelon::LOOK,
    paint: &[watermelon::astray(STRIPES, OVER_EDGES)],
    ..FIRST
};

/// Without the bulge of its faces it is a cube of 18 cm.
pub(super) const HALF_SIDE_CM: f32 = 9.0;
/// How far the middles of its faces stand out: with less the upper face has too few rows of the
/// control image for jagged stripes, with 1 it is no cube any more.
pub(super) const BULGE_CM: f32 = 0.55;

/// Dark stripes that leave the stem on the upper face, bend over its edges and run down the sides.
const STRIPES: Paint = Paint {
    wrap: Wrap::Cylinder(Cylinder {
        base: Vec3::ZERO,
        axis: Vec3::Y,
        zero: Vec3::X,
        height: 2.0 * HALF_SIDE_CM + BULGE_CM,
    }),
    image: Image { width: 512, height: 512, rule: ImageRule::Stripes(OVER_EDGES) },
    use_as: Use::FOREGROUND,
};

const OVER_EDGES: Stripes = Stripes {
    cube: Some(Cube { half_side_cm: HALF_SIDE_CM, bulge_cm: BULGE_CM }),
    ..watermelon::JAGGED
};
