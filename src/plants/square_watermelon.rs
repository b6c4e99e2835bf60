//! Square watermelon: the stripes of the round one, over the edges of a cube (Thesis, Fig. 4.18).

use super::{Plant, View, watermelon};
use crate::surface::{ControlImage, Cylinder, Wrap};
use crate::tissue::Control;
use glam::Vec3;

pub const PLANT: Plant = Plant {
    key: "square-watermelon",
    name: "Square watermelon",
    // Its recipe is that of Fig. 4.17, number by number: only the body differs.
    source: "Thesis, Fig. 4.18",
    view: View { azimuth_deg: 33.0, elevation_deg: 24.0, zoom: 0.96 },
    mesh: mesh_file!("square_watermelon.obj"),
    controls: Some(stripes),
    ..watermelon::PLANT
};

/// Without the bulge of its faces it is a cube of 18 cm.
pub(super) const HALF_SIDE_CM: f32 = 9.0;
/// How far the middles of its faces stand out: with less the upper face has too few rows of the
/// control image for jagged stripes, with 1 it is no cube any more.
pub(super) const BULGE_CM: f32 = 0.55;

/// Dark stripes that leave the stem on the upper face, bend over its edges and run down the sides.
fn stripes() -> Vec<Control> {
    let height = 2.0 * HALF_SIDE_CM + BULGE_CM;
    let cylinder = Cylinder { base: Vec3::ZERO, axis: Vec3::Y, zero: Vec3::X, height };
    let image = ControlImage::paint(512, 512, |turns, share| {
        watermelon::is_stripe(around(turns), along(share * height))
    });
    vec![Control::foreground(Wrap::Cylinder(cylinder), image)]
}

/// The share of the way around a square that an angle, in turns, has gone: stripes keep their width
/// towards the upright edges.
fn around(turns: f32) -> f32 {
    let quarters = turns * 4.0 + 0.5;
    let face = libm::floorf(quarters);
    let from_middle_rad = (quarters - face - 0.5) * std::f32::consts::FRAC_PI_2;
    let share = (face + 0.5 + 0.5 * libm::tanf(from_middle_rad)) / 4.0 - 0.125;
    if share < 0.0 { share + 1.0 } else { share }
}

/// The share of the way from the lower to the upper end over the middles of the faces: on the upper
/// face a little height is a long way, since it is a little convex.
fn along(height_cm: f32) -> f32 {
    const SIDE_CM: f32 = 2.0 * HALF_SIDE_CM;
    let over_the_top = ((height_cm - SIDE_CM) / BULGE_CM).clamp(0.0, 1.0);
    let inward_cm = HALF_SIDE_CM * (1.0 - libm::sqrtf(1.0 - over_the_top));
    (HALF_SIDE_CM + height_cm.min(SIDE_CM) + inward_cm) / (2.0 * SIDE_CM)
}
