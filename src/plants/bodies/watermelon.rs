//! A round watermelon that lies on the ground and turns its stem end to the viewer.

use super::sketch::{Sketch, jitter, jitter_at, sin_cos};
use crate::plants::watermelon::{AXIS, CENTRE, HALF_LENGTH_CM};
use crate::surface::PolygonMesh;
use glam::Vec3;
use std::collections::HashMap;
use std::f32::consts::FRAC_PI_4;

const HALF_WIDTH_CM: f32 = 12.2;
/// Quads along a side of the cube that is blown up to the fruit; even, so that the ends of the
/// fruit are vertices.
const GRID: i32 = 8;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    sketch.group("fruit", "rind");
    fruit(&mut sketch);
    sketch.group("stem end", "bare:stem");
    stem(&mut sketch);
    sketch.group("blossom scar", "bare:scar");
    scar(&mut sketch);
    sketch.mesh
}

/// From the fruit's own axes (`y` towards the stem end) to where it lies.
fn lay(p: Vec3) -> Vec3 {
    let side = AXIS.cross(Vec3::Y).normalize();
    CENTRE + side * p.x + AXIS * p.y + side.cross(AXIS) * p.z
}

/// A cube whose faces are divided by equal angles, blown up: no poles, quads of like size.
fn fruit(sketch: &mut Sketch) {
    let mut vertices = HashMap::new();
    for axis in 0..3 {
        for end in [-1, 1] {
            for i in 0..GRID {
                for j in 0..GRID {
                    let corner = |di: i32, dj: i32| {
                        let mut at = [0; 3];
                        at[axis] = end * GRID / 2;
                        at[(axis + 1) % 3] = i + di - GRID / 2;
                        at[(axis + 2) % 3] = j + dj - GRID / 2;
                        at
                    };
                    let mut around = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if end < 0 {
                        around.reverse();
                    }
                    let face = around.map(|at| {
                        *vertices.entry(at).or_insert_with(|| sketch.vertex(lay(rind(at))))
                    });
                    sketch.face(&face);
                }
            }
        }
    }
}

/// The fruit's surface in the direction of a point of the cube.
fn rind(cube: [i32; 3]) -> Vec3 {
    let even = |c: i32| libm::tanf(c as f32 / (GRID / 2) as f32 * FRAC_PI_4);
    let direction = Vec3::from(cube.map(even)).normalize();
    // Refinement pulls a round control mesh inwards by this much.
    let size = Vec3::new(HALF_WIDTH_CM, HALF_LENGTH_CM, HALF_WIDTH_CM) * 1.014;
    // A hardly visible flatness on the side on which it grew, as real ones have.
    let uneven = 1.0 + 0.006 * jitter(cube[0] as u32, 3) * jitter(cube[2] as u32, 5);
    let mut p = direction * size * uneven;
    let from_axis = libm::sqrtf(p.x * p.x + p.z * p.z);
    let near_end = libm::expf(-(from_axis / 2.6) * (from_axis / 2.6));
    let depth = if p.y > 0.0 { 1.9 } else { 0.6 };
    p.y -= p.y.signum() * depth * near_end;
    p
}

/// The dry stem: a broad foot in the dimple, then a curl.
fn stem(sketch: &mut Sketch) {
    let foot = HALF_LENGTH_CM - 1.5;
    let at = |x: f32, y: f32, z: f32| lay(Vec3::new(x, foot + y, z));
    sketch.tube(
        7,
        &[
            (at(0.0, -0.3, 0.0), 1.1),
            (at(0.0, 0.3, 0.0), 1.05),
            (at(0.03, 0.65, 0.0), 0.6),
            (at(0.1, 1.3, 0.05), 0.46),
            (at(0.45, 2.2, 0.1), 0.42),
            (at(1.25, 3.0, 0.1), 0.4),
            (at(2.3, 3.1, -0.2), 0.36),
            (at(3.0, 2.4, -0.7), 0.32),
            (at(2.9, 1.6, -1.2), 0.26),
            (at(2.3, 1.4, -1.5), 0.2),
            (at(2.0, 1.7, -1.6), 0.12),
        ],
    );
}

/// What is left of the blossom: a small cork disc.
fn scar(sketch: &mut Sketch) {
    let end = -HALF_LENGTH_CM + 0.2;
    sketch.disc(2, 1, |turns, rho| {
        let (sin, cos) = sin_cos(turns);
        // Seen from below the fruit: mirrored, so that its outside is there.
        let lump = 0.06 * jitter_at(turns, rho, 11);
        lay(Vec3::new(-0.75 * rho * cos, end + 0.15 * rho - 0.12 + lump, 0.75 * rho * sin))
    });
}
