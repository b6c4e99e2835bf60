//! A young croton shrub in its pot: leaves in a spiral round an upright stem.

use super::sketch::{Sketch, jitter, jitter_at, on_circle, sin_cos};
use crate::surface::PolygonMesh;
use glam::{Vec2, Vec3};

const LEAVES: u32 = 18;
/// The golden angle, 360° / τ² (Song07 3): no leaf stands right above another.
const DIVERGENCE_TURNS: f32 = 137.5 / 360.0;
/// Azimuth of the oldest leaf: the one, of those tried, at which the three lowest leaves hide the
/// foot of the stem and few undersides are seen.
const FIRST_TURNS: f32 = 0.36;
const POT_HEIGHT_CM: f32 = 9.0;
/// Where the light comes from in which the shrub grew up: a window behind the viewer.
const LIGHT: Vec3 = Vec3::new(0.0, 0.6, 0.8);
const STEM_TOP_CM: f32 = 28.5;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    for k in 0..LEAVES {
        let leaf = Leaf::new(k);
        sketch.group(&format!("leaf {}", k + 1), "blade");
        leaf.blade(&mut sketch);
    }
    sketch.group("petioles", "bare:petiole");
    for k in 0..LEAVES {
        Leaf::new(k).petiole(&mut sketch);
    }
    sketch.group("stem", "bare:bark");
    let stem = [(7.0, 0.8), (12.0, 0.66), (17.0, 0.55), (22.0, 0.45), (STEM_TOP_CM, 0.3)];
    sketch.tube(6, &stem.map(|(height, radius)| (stem_at(height), radius)));
    pot(&mut sketch);
    sketch.mesh
}

/// The stem is not quite straight.
fn stem_at(height: f32) -> Vec3 {
    Vec3::new(0.4 * sin_cos(height / 40.0).0, height, 0.3 * sin_cos(height / 31.0 + 0.2).0)
}

fn pot(sketch: &mut Sketch) {
    sketch.group("pot", "bare:pot");
    let outside = [(4.6, 0.0), (4.7, 0.0), (4.9, 0.2), (5.9, 6.4), (6.0, 6.7), (6.5, 6.75)];
    let rim = [(6.6, 6.8), (6.75, 8.9), (6.7, POT_HEIGHT_CM), (6.2, POT_HEIGHT_CM), (6.0, 8.0)];
    let profile: Vec<_> = outside.into_iter().chain(rim).collect();
    sketch.turned(16, &profile, |p| p);
    sketch.group("soil", "bare:soil");
    sketch.disc(4, 1, |turns, rho| {
        let lump = 0.15 * jitter_at(turns, rho, 7);
        on_circle(turns, 6.1 * rho, 8.4 + 0.5 * (1.0 - rho * rho) + lump)
    });
}

/// One leaf; the first is the oldest.
struct Leaf {
    number: u32,
    /// 0 for the oldest leaf to 1 for the youngest.
    youth: f32,
    outward: Vec3,
    /// Of the petiole at the stem, above the horizon.
    elevation_rad: f32,
    /// How far the midrib bends down from base to tip.
    droop_rad: f32,
    petiole_cm: f32,
    length_cm: f32,
    half_width_cm: f32,
    height_cm: f32,
}

impl Leaf {
    fn new(number: u32) -> Leaf {
        let youth = number as f32 / (LEAVES - 1) as f32;
        let shaken = |purpose| jitter(number, purpose);
        let turns = number as f32 * DIVERGENCE_TURNS + FIRST_TURNS + 0.012 * shaken(1);
        let outward = on_circle(turns, 1.0, 0.0);
        // Full-grown below, the last ones still unfolding.
        let grown = 1.0 - 0.5 * youth * youth * youth;
        // Blades come to stand across the light.
        let to_light = (0.3 + 0.3 * youth) * outward.dot(LIGHT);
        Leaf {
            number,
            youth,
            outward,
            elevation_rad: 0.5 + 0.72 * youth - to_light + 0.05 * shaken(2),
            droop_rad: 1.25 - 0.3 * youth + 0.12 * shaken(3),
            petiole_cm: 3.2 * grown,
            length_cm: 17.8 * grown + 0.8 * shaken(4),
            half_width_cm: 4.1 * (1.0 - 0.5 * youth * youth),
            height_cm: 12.5 + (STEM_TOP_CM - 12.8) * youth,
        }
    }

    /// Where the blade begins.
    fn base(&self) -> Vec3 {
        stem_at(self.height_cm) + self.direction(0.0) * self.petiole_cm
    }

    /// The midrib's direction at `t`, from 0 at the blade's base to 1 at its tip.
    fn direction(&self, t: f32) -> Vec3 {
        let angle = self.elevation_rad - self.droop_rad * t * libm::sqrtf(t);
        self.outward * libm::cosf(angle) + Vec3::Y * libm::sinf(angle)
    }

    fn midrib(&self, t: f32) -> Vec3 {
        const STEPS: u32 = 32;
        let step = t / STEPS as f32;
        let way: Vec3 = (0..STEPS).map(|k| self.direction((k as f32 + 0.5) * step) * step).sum();
        self.base() + way * self.length_cm
    }

    /// A point of the blade: `x` from -1 at the left rim to 1 at the right, `t` along the midrib.
    fn point(&self, x: f32, t: f32) -> Vec3 {
        let along = self.direction(t);
        let flat_side = self.outward.cross(Vec3::Y);
        let flat_up = flat_side.cross(along);
        // Blades turn about their midrib, about half-way to the light.
        let roll = (0.75 - 0.5 * self.youth) * flat_side.dot(LIGHT) * t.clamp(0.0, 1.0)
            + 0.12 * jitter(self.number, 5);
        let up = flat_up * libm::cosf(roll) + flat_side * libm::sinf(roll);
        let side = along.cross(up);
        // Oblong, with a wedge at the base and a long tip.
        let width = libm::powf(sin_cos(0.5 * libm::powf(t.clamp(0.0, 1.0), 0.92)).0.max(0.0), 0.8);
        let across = self.half_width_cm * width * x;
        let fold = 0.34 * across.abs() - 0.03 * across * across;
        let phase = 0.3 * self.number as f32 + if x < 0.0 { 0.37 } else { 0.0 };
        let wave = 0.5 * width * x * x * sin_cos(2.3 * t + phase).0;
        self.midrib(t) + side * across + up * (fold + wave)
    }

    /// Four columns of quads between rim and rim; their rows slant forward from the midrib, like
    /// the side veins, and close at base and tip without a fan of slivers.
    fn blade(&self, sketch: &mut Sketch) {
        // Quads about as long as they are wide.
        let rows = libm::roundf(self.length_cm / 2.05) as usize - 1;
        let step = 1.0 / (rows + 1) as f32;
        let mut put =
            |x: f32, t: f32| sketch.blade_vertex(self.point(x, t), Vec2::new(x, t.min(1.0)));
        let base = put(0.0, 0.0);
        let grid: Vec<[u32; 5]> = (1..=rows)
            .map(|row| {
                [-1.0, -0.5, 0.0, 0.5, 1.0]
                    .map(|x: f32| put(x, (row as f32 + 0.55 * x.abs()) * step))
            })
            .collect();
        // The spline of the rim does not reach its control points: the tip is drawn out.
        let tip = put(0.0, 1.0 + 0.4 * step);
        let (first, last) = (grid[0], grid[rows - 1]);
        sketch.face(&[base, first[2], first[1], first[0]]);
        sketch.face(&[base, first[4], first[3], first[2]]);
        for pair in grid.windows(2) {
            for c in 0..4 {
                sketch.face(&[pair[0][c], pair[0][c + 1], pair[1][c + 1], pair[1][c]]);
            }
        }
        sketch.face(&[last[0], last[1], last[2], tip]);
        sketch.face(&[last[2], last[3], last[4], tip]);
    }

    /// From the axil to a little way under the blade.
    fn petiole(&self, sketch: &mut Sketch) {
        let axil = stem_at(self.height_cm);
        let sag = Vec3::Y * (0.06 * self.petiole_cm);
        let path = [
            (axil, 0.3),
            (axil.lerp(self.base(), 0.5) - sag, 0.24),
            (self.base() - sag * 0.8, 0.22),
            (self.midrib(0.12) - Vec3::Y * 0.2, 0.12),
        ];
        sketch.tube(5, &path);
    }
}
