//! A watermelon that grew in a box: a cube with round edges that stands on its blossom end.

use super::sketch::Sketch;
use crate::plants::square_watermelon::{BULGE_CM, HALF_SIDE_CM};
use crate::surface::PolygonMesh;
use glam::Vec3;
use std::f32::consts::FRAC_PI_4;

const EDGE_CM: f32 = 3.0;
/// Quads along a side; even, so that the stem end is a vertex.
const GRID: i32 = 8;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    sketch.group("fruit", "rind");
    sketch.cube(GRID, rind);
    sketch.group("stem end", "bare:stem");
    stem(&mut sketch);
    sketch.mesh
}

/// Equal steps over the flat of a face and a quarter round at each edge.
fn rind(at: [i32; 3]) -> Vec3 {
    const FLAT_CM: f32 = HALF_SIDE_CM - EDGE_CM;
    let way = |c: i32| {
        let length = FLAT_CM + EDGE_CM * FRAC_PI_4;
        (2 * c.abs()) as f32 / GRID as f32 * length
    };
    let sign = Vec3::from(at.map(|c| c.signum() as f32));
    let flat = sign * Vec3::from(at.map(|c| way(c).min(FLAT_CM)));
    let turn = |c: i32| libm::tanf((way(c) - FLAT_CM).max(0.0) / EDGE_CM);
    let round = (sign * Vec3::from(at.map(turn))).normalize() * EDGE_CM;
    let cube = flat + round;
    // The fruit swells against the box: its faces are a little convex, but for the lowest.
    let share = cube / HALF_SIDE_CM;
    let swell =
        |own: f32, b: f32, c: f32| BULGE_CM * own * own * own * (1.0 - b * b - c * c).max(0.0);
    let mut p = cube
        + Vec3::new(
            swell(share.x, share.y, share.z),
            swell(share.y.max(0.0), share.z, share.x),
            swell(share.z, share.x, share.y),
        );
    // The dimple of the stem.
    if p.y > 0.0 {
        let from_axis = libm::sqrtf(p.x * p.x + p.z * p.z);
        p.y -= 1.3 * libm::expf(-(from_axis / 2.4) * (from_axis / 2.4));
    }
    p + Vec3::Y * HALF_SIDE_CM
}

/// The dry stem: a broad foot in the dimple, cut off after a bend.
fn stem(sketch: &mut Sketch) {
    let foot = 2.0 * HALF_SIDE_CM + BULGE_CM - 1.3;
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, foot + y, z);
    sketch.tube(
        7,
        &[
            (at(0.0, -0.3, 0.0), 1.0),
            (at(0.0, 0.25, 0.0), 0.95),
            (at(0.03, 0.6, 0.0), 0.55),
            (at(0.1, 1.1, 0.05), 0.42),
            (at(0.35, 1.8, 0.2), 0.38),
            (at(0.95, 2.4, 0.5), 0.36),
            (at(1.7, 2.6, 0.9), 0.38),
            (at(2.0, 2.6, 1.1), 0.36),
        ],
    );
}
