//! A winter squash that stands on its blossom end: ten ribs, and a corky stalk.

use super::sketch::{Sketch, jitter, on_circle};
use crate::plants::winter_squash::{HEIGHT_CM, RIBS};
use crate::surface::PolygonMesh;
use glam::Vec3;

const HALF_WIDTH_CM: f32 = 8.0;
/// Refinement draws the rounding under the fruit upwards by this much.
const SUNK_CM: f32 = 0.55;
/// Rings of four vertices a rib: furrow, flank, crest, flank.
const RINGS: usize = 11;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    sketch.group("fruit", "rind");
    let rings: Vec<Vec<u32>> =
        (1..=RINGS).map(|k| ring(&mut sketch, k as f32 / (RINGS + 1) as f32, 4)).collect();
    for pair in rings.windows(2) {
        sketch.band(&pair[1], &pair[0]);
    }
    // Flanks end before the poles, where crests and furrows go on to the middle.
    for (at, last, is_top) in [(0.03, &rings[0], true), (0.97, &rings[RINGS - 1], false)] {
        let inner = ring(&mut sketch, at, 2);
        for k in 0..inner.len() {
            let next = (k + 1) % inner.len();
            let outer = |k: usize| last[k % last.len()];
            let mut face =
                [inner[k], inner[next], outer(2 * k + 2), outer(2 * k + 1), outer(2 * k)];
            if !is_top {
                face.reverse();
            }
            sketch.face(&face);
        }
        let mut lid = inner;
        if is_top {
            lid.reverse();
        }
        sketch.face(&lid);
    }
    sketch.group("stalk", "bare:stalk");
    let top = HEIGHT_CM - 1.7 - SUNK_CM;
    let path = [
        (0.0, 0.0, 1.75),
        (0.0, 0.7, 1.25),
        (0.1, 1.7, 0.85),
        (0.35, 2.9, 0.8),
        (0.8, 3.9, 0.95),
        (1.0, 4.3, 1.0),
    ];
    sketch.tube(5, &path.map(|(x, y, radius)| (Vec3::new(x, top + y, 0.4 * x), radius)));
    sketch.mesh
}

/// A ring around the fruit at a share of the way from stalk to blossom, with so many vertices a rib.
fn ring(sketch: &mut Sketch, at: f32, of_rib: usize) -> Vec<u32> {
    let angle_rad = std::f32::consts::PI * at;
    let (sin, cos) = (libm::sinf(angle_rad), libm::cosf(angle_rad));
    // Flatter than a sphere, and drawn in at both ends.
    let radius = HALF_WIDTH_CM * libm::powf(sin, 0.8);
    let dimple = if cos > 0.0 { 2.1 } else { 0.9 } * libm::expf(-(radius / 2.6) * (radius / 2.6));
    let height = 0.5 * HEIGHT_CM * (1.0 + libm::powf(cos.abs(), 0.9) * cos.signum())
        - dimple * cos.signum()
        - SUNK_CM;
    let count = RIBS as usize * of_rib;
    let points: Vec<Vec3> = (0..count)
        .map(|k| {
            let is_furrow = k % of_rib == 0;
            let is_crest = 2 * (k % of_rib) == of_rib;
            let rib = (k / of_rib) as u32;
            let share = if is_furrow {
                0.83
            } else if is_crest {
                1.0 + 0.02 * jitter(rib, 3)
            } else {
                0.97
            };
            on_circle(k as f32 / count as f32, radius * share, height)
        })
        .collect();
    sketch.ring(points)
}
