//! Watermelons that lie on the ground: a round one that turns its stem end to the viewer, and a
//! long one that shows its side.

use super::sketch::{Sketch, jitter, jitter_at, sin_cos};
use crate::plants::{long_watermelon, watermelon};
use crate::surface::PolygonMesh;
use glam::Vec3;
use std::f32::consts::FRAC_PI_4;

/// Quads along a side of the cube that is blown up to the fruit; even, so that the ends of the
/// fruit are vertices.
const GRID: i32 = 8;

pub fn grow() -> PolygonMesh {
    let (axis, centre) = (watermelon::AXIS, watermelon::CENTRE);
    Melon { axis, centre, half_length: watermelon::HALF_LENGTH_CM, half_width: 12.2 }.grow()
}

pub fn grow_long() -> PolygonMesh {
    let (axis, centre) = (long_watermelon::AXIS, long_watermelon::CENTRE);
    Melon { axis, centre, half_length: long_watermelon::HALF_LENGTH_CM, half_width: 10.4 }.grow()
}

/// How a fruit lies, and its measures in centimetres.
struct Melon {
    /// Towards the stem end; of unit length.
    axis: Vec3,
    centre: Vec3,
    half_length: f32,
    half_width: f32,
}

impl Melon {
    fn grow(&self) -> PolygonMesh {
        let mut sketch = Sketch::default();
        sketch.group("fruit", "rind");
        // Divided by equal angles: quads of like size.
        sketch.cube(GRID, |at| self.lay(self.rind(at)));
        sketch.group("stem end", "bare:stem");
        self.stem(&mut sketch);
        sketch.group("blossom scar", "bare:scar");
        self.scar(&mut sketch);
        sketch.mesh
    }

    /// From the fruit's own axes (`y` towards the stem end) to where it lies.
    fn lay(&self, p: Vec3) -> Vec3 {
        let side = self.axis.cross(Vec3::Y).normalize();
        self.centre + side * p.x + self.axis * p.y + side.cross(self.axis) * p.z
    }

    /// The fruit's surface in the direction of a point of the cube.
    fn rind(&self, cube: [i32; 3]) -> Vec3 {
        let even = |c: i32| libm::tanf(c as f32 / (GRID / 2) as f32 * FRAC_PI_4);
        let direction = Vec3::from(cube.map(even)).normalize();
        // Refinement pulls a round control mesh inwards by this much.
        let size = Vec3::new(self.half_width, self.half_length, self.half_width) * 1.014;
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
    fn stem(&self, sketch: &mut Sketch) {
        let foot = self.half_length - 1.5;
        let at = |x: f32, y: f32, z: f32| self.lay(Vec3::new(x, foot + y, z));
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
    fn scar(&self, sketch: &mut Sketch) {
        let end = -self.half_length + 0.2;
        sketch.disc(2, 1, |turns, rho| {
            let (sin, cos) = sin_cos(turns);
            // Seen from below the fruit: mirrored, so that its outside is there.
            let lump = 0.06 * jitter_at(turns, rho, 11);
            self.lay(Vec3::new(-0.75 * rho * cos, end + 0.15 * rho - 0.12 + lump, 0.75 * rho * sin))
        });
    }
}
