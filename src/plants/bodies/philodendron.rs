//! A trailing philodendron in its pot: six heart-shaped leaves along a stem that arches over.

use super::sketch::{Sketch, jitter_at, on_circle, sin_cos};
use crate::surface::PolygonMesh;
use glam::{Vec2, Vec3};

const POT_CM: f32 = 7.0;
const POT_CENTRE: Vec3 = Vec3::new(-5.2, 0.0, -3.0);

/// The stem from the soil to its hanging tip.
const STEM: [Vec3; 8] = [
    Vec3::new(-5.2, 6.0, -3.0),
    Vec3::new(-6.0, 11.5, -2.6),
    Vec3::new(-5.0, 16.4, -1.8),
    Vec3::new(-1.6, 18.8, -1.0),
    Vec3::new(2.8, 17.6, -0.3),
    Vec3::new(6.4, 13.6, 0.3),
    Vec3::new(8.6, 8.8, 0.6),
    Vec3::new(9.6, 3.6, 0.6),
];

/// The leaves from the oldest to the youngest.
const LEAVES: [Leaf; 6] = [
    Leaf::new(1.2, Vec3::new(-10.4, 14.6, 0.4), -0.42, -0.35, 9.8),
    Leaf::new(1.8, Vec3::new(-2.6, 12.4, 2.8), 0.06, -0.08, 9.4),
    Leaf::new(2.7, Vec3::new(-4.6, 22.6, 0.6), -0.3, -0.22, 9.2),
    Leaf::new(3.7, Vec3::new(3.8, 21.6, 1.0), 0.32, 0.2, 8.8),
    Leaf::new(4.9, Vec3::new(5.0, 11.6, 3.2), 0.0, 0.12, 8.2),
    Leaf::new(5.6, Vec3::new(11.0, 14.4, 2.2), 0.42, 0.35, 7.4),
];

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    for (k, leaf) in LEAVES.iter().enumerate() {
        sketch.group(&format!("leaf {}", k + 1), "blade");
        leaf.blade(&mut sketch, k as u32);
    }
    sketch.group("petioles", "bare:petiole");
    for leaf in &LEAVES {
        leaf.petiole(&mut sketch);
    }
    sketch.group("stem", "bare:stem");
    let thickness = |k: usize| 0.36 - 0.03 * k as f32;
    let path: Vec<_> = STEM.iter().enumerate().map(|(k, &p)| (p, thickness(k))).collect();
    sketch.tube(6, &path);
    pot(&mut sketch);
    sketch.mesh
}

fn pot(sketch: &mut Sketch) {
    sketch.group("pot", "bare:pot");
    let outside = [(3.1, 0.0), (3.3, 0.0), (3.6, 0.3), (4.5, 5.8), (4.75, POT_CM - 0.1)];
    let rim = [(4.7, POT_CM), (4.3, POT_CM), (4.2, POT_CM - 0.3), (4.1, 5.9)];
    let profile: Vec<_> = outside.into_iter().chain(rim).collect();
    sketch.turned(16, &profile, |p| p + POT_CENTRE);
    sketch.group("soil", "bare:soil");
    sketch.disc(4, 1, |turns, rho| {
        let lump = 0.15 * jitter_at(turns, rho, 7);
        POT_CENTRE + on_circle(turns, 4.25 * rho, 6.1 + 0.5 * (1.0 - rho * rho) + lump)
    });
}

/// One leaf. Blades hang from their petioles and show their upper side to the viewer's window.
struct Leaf {
    /// Where its petiole leaves the stem, in points of `STEM`.
    node: f32,
    /// Where the petiole meets the blade, in the notch of the heart.
    base: Vec3,
    /// Of the midrib to the right of the plumb line, and of the upper side to the right of `+z`.
    tilt_rad: f32,
    yaw_rad: f32,
    /// Of the midrib.
    length_cm: f32,
}

/// The outline of the right half in units of the midrib: across and along it, from the notch round
/// the lobe to the tip, in even steps of the leaf coordinate along the midrib.
const OUTLINE: [(f32, f32); 11] = [
    (0.0, 0.0),
    (0.12, -0.16),
    (0.27, -0.2),
    (0.4, -0.1),
    (0.46, 0.06),
    (0.455, 0.23),
    (0.4, 0.39),
    (0.31, 0.54),
    (0.2, 0.69),
    (0.08, 0.84),
    (0.0, 1.0),
];

impl Leaf {
    const fn new(node: f32, base: Vec3, tilt_rad: f32, yaw_rad: f32, length_cm: f32) -> Leaf {
        Leaf { node, base, tilt_rad, yaw_rad, length_cm }
    }

    /// The midrib's direction and the blade's upper side at a share of the midrib, below 0 in the
    /// lobes behind the notch: the blade bends down towards its tip.
    fn frame(&self, along: f32) -> (Vec3, Vec3) {
        let facing = Vec3::new(libm::sinf(self.yaw_rad), 0.0, libm::cosf(self.yaw_rad));
        let right = Vec3::Y.cross(facing);
        let down = right * libm::sinf(self.tilt_rad) - Vec3::Y * libm::cosf(self.tilt_rad);
        let pitch_rad = 0.62 - 0.75 * along.max(0.0);
        let (sin, cos) = (libm::sinf(pitch_rad), libm::cosf(pitch_rad));
        (down * cos + facing * sin, facing * cos - down * sin)
    }

    /// A point of the midrib, or of its straight continuation behind the notch.
    fn midrib(&self, along: f32) -> Vec3 {
        const STEPS: u32 = 16;
        let step = along / STEPS as f32;
        let way: Vec3 = (0..STEPS).map(|k| self.frame((k as f32 + 0.5) * step).0 * step).sum();
        self.base + way * self.length_cm
    }

    /// A point of the blade in its leaf coordinates: `x` from -1 at the left rim to 1 at the right,
    /// `t` from the notch to the tip. Lines of equal `t` run like the side veins.
    fn point(&self, x: f32, t: f32, number: u32) -> Vec3 {
        let last = OUTLINE.len() - 1;
        let step = ((t * last as f32) as usize).min(last - 1);
        let part = t * last as f32 - step as f32;
        let (from, to) = (OUTLINE[step], OUTLINE[step + 1]);
        let rim = (from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part);
        let from_midrib = x.abs();
        let across = rim.0 * from_midrib * self.length_cm;
        // Side veins leave the midrib crosswise and then bend to where they end.
        let along = t + (rim.1 - t) * from_midrib * libm::sqrtf(from_midrib);
        let (direction, up) = self.frame(along);
        let side = direction.cross(up) * x.signum();
        // A shallow channel whose flanks bend down again, and a slow wave of the rim.
        let fold = 0.34 * across - 0.06 * across * across;
        let wave = 0.22 * x * x * sin_cos(1.6 * t + 0.3 * number as f32 + 0.2 * x.signum()).0;
        self.midrib(along) + side * across + up * (fold + wave)
    }

    /// Six columns of quads between rim and rim, four in the narrow part before the tip; a pentagon
    /// for each half at the notch and a quad at the tip.
    fn blade(&self, sketch: &mut Sketch, number: u32) {
        const BROAD: &[f32] = &[-1.0, -0.67, -0.34, 0.0, 0.34, 0.67, 1.0];
        const NARROW: &[f32] = &[-1.0, -0.5, 0.0, 0.5, 1.0];
        // Quads about as long as they are wide.
        let rows = libm::roundf(self.length_cm / 0.95) as usize;
        let step = 1.0 / (rows as f32 + 1.9);
        let mut put = |x: f32, t: f32| {
            sketch.blade_vertex(self.point(x, t, number), Vec2::new(x, t.clamp(0.0, 1.0)))
        };
        let notch = put(0.0, 0.0);
        let grid: Vec<Vec<u32>> = (1..=rows)
            .map(|row| {
                let columns = if row + 2 > rows { NARROW } else { BROAD };
                columns.iter().map(|&x| put(x, row as f32 * step)).collect()
            })
            .collect();
        // The spline of the rim does not reach its control points: the tip is drawn out.
        let tip = put(0.0, 1.0 + 1.6 * step);
        let first = &grid[0];
        sketch.face(&[notch, first[3], first[2], first[1], first[0]]);
        sketch.face(&[notch, first[6], first[5], first[4], first[3]]);
        for pair in grid.windows(2) {
            let (below, above) = (&pair[0], &pair[1]);
            if below.len() > above.len() {
                // Two quads and a triangle between them for each half.
                for (b, a) in [(0, 0), (2, 1), (3, 2), (5, 3)] {
                    sketch.face(&[below[b], below[b + 1], above[a + 1], above[a]]);
                }
                sketch.face(&[below[1], below[2], above[1]]);
                sketch.face(&[below[4], below[5], above[3]]);
                continue;
            }
            for c in 0..below.len() - 1 {
                sketch.face(&[below[c], below[c + 1], above[c + 1], above[c]]);
            }
        }
        let last = &grid[rows - 1];
        sketch.face(&[last[0], last[1], last[2], tip]);
        sketch.face(&[last[2], last[3], last[4], tip]);
    }

    /// From the stem to a little way under the blade.
    fn petiole(&self, sketch: &mut Sketch) {
        let k = self.node as usize;
        let axil = STEM[k].lerp(STEM[k + 1], self.node - k as f32);
        let (_, up) = self.frame(0.0);
        let middle = axil.lerp(self.base, 0.55) + Vec3::Y * 0.9 - up * 0.6;
        let under = |along: f32, depth: f32| self.midrib(along) - self.frame(along).1 * depth;
        let path =
            [(axil, 0.24), (middle, 0.17), (under(0.0, 0.25), 0.15), (under(0.1, 0.2), 0.08)];
        sketch.tube(5, &path);
    }
}
