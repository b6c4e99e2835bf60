//! A snake plant in its pot: sword leaves from one base.

use super::sketch::{Sketch, jitter_at, on_circle, sin_cos};
use crate::plants::sansevieria::{ATLAS_PLACES, LENGTHS_CM, half_width_cm};
use crate::surface::PolygonMesh;
use glam::{Vec2, Vec3};

const SOIL_CM: f32 = 11.0;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    for (number, leaf) in LEAVES.iter().enumerate() {
        sketch.group(&format!("leaf {}", number + 1), "blade");
        leaf.blade(&mut sketch, number);
    }
    pot(&mut sketch);
    sketch.mesh
}

/// One leaf; its length stands beside its pattern.
struct Leaf {
    /// Where it stands, in turns from the right over the viewer's side, and how far from the middle.
    turns: f32,
    from_middle_cm: f32,
    /// How far it leans outward at its foot, and how much more at its tip.
    lean_rad: [f32; 2],
    /// Where its channelled side looks at its foot, and how far it turns up to its tip.
    face_turns: [f32; 2],
}

const fn leaf(turns: f32, from_middle_cm: f32, lean_rad: [f32; 2], face_turns: [f32; 2]) -> Leaf {
    Leaf { turns, from_middle_cm, lean_rad, face_turns }
}

/// Three behind, two at the sides and a young one in front; all turn a broad side to the viewer.
const LEAVES: [Leaf; 6] = [
    leaf(0.78, 1.2, [0.02, 0.05], [0.3, -0.14]),
    leaf(0.9, 2.6, [0.16, 0.12], [0.36, -0.12]),
    leaf(0.57, 2.5, [0.13, 0.06], [0.13, 0.16]),
    leaf(0.1, 2.8, [0.3, 0.22], [0.42, -0.16]),
    leaf(0.41, 2.9, [0.28, 0.12], [0.1, 0.1]),
    leaf(0.25, 2.7, [0.12, 0.1], [0.24, 0.1]),
];

impl Leaf {
    /// A point of the blade: `x` from -1 at the left rim to 1 at the right, `t` along the midrib.
    fn point(&self, length_cm: f32, x: f32, t: f32) -> Vec3 {
        let outward = on_circle(self.turns, 1.0, 0.0);
        let along = |t: f32| {
            let angle_rad = self.lean_rad[0] + self.lean_rad[1] * t * t;
            Vec3::Y * libm::cosf(angle_rad) + outward * libm::sinf(angle_rad)
        };
        const STEPS: u32 = 16;
        let way: Vec3 = (0..STEPS)
            .map(|k| along((k as f32 + 0.5) / STEPS as f32 * t) * (t * length_cm / STEPS as f32))
            .sum();
        let foot = outward * self.from_middle_cm + Vec3::Y * (SOIL_CM - 1.0);
        let face = on_circle(self.face_turns[0] + self.face_turns[1] * t, 1.0, 0.0);
        let side = along(t).cross(face).normalize();
        let face = side.cross(along(t));
        let across = half_width_cm(length_cm, t.min(1.0)) * x;
        // A deep channel at the foot, nearly flat above; one rim waves a little.
        let channel = (0.34 - 0.24 * t.min(0.8)) * across * across / 1.6;
        let wave = 0.25 * x * sin_cos(1.7 * t + self.turns).0;
        foot + way + side * across + face * (channel + wave)
    }

    /// Three columns of quads; their rows stand closer where the blade is narrow.
    fn blade(&self, sketch: &mut Sketch, number: usize) {
        let length_cm = LENGTHS_CM[number];
        let mut put = |x: f32, t: f32| {
            let place = (2.0 * number as f32 + 1.0 + x) / ATLAS_PLACES as f32 - 1.0;
            sketch.blade_vertex(self.point(length_cm, x, t), Vec2::new(place, t.min(1.0)))
        };
        let mut stations = vec![0.0];
        while let Some(&t) = stations.last() {
            let quad_cm = 2.0 / 3.0 * half_width_cm(length_cm, t);
            let next = t + (0.8 + 0.5 * quad_cm) / length_cm;
            if next > 1.0 - 0.9 / length_cm {
                break;
            }
            stations.push(next);
        }
        let rows: Vec<[u32; 4]> = stations
            .iter()
            .map(|&t| [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0].map(|x| put(x, t)))
            .collect();
        let tip = put(0.0, 1.0 + 0.5 / length_cm);
        for pair in rows.windows(2) {
            for c in 0..3 {
                sketch.face(&[pair[0][c], pair[0][c + 1], pair[1][c + 1], pair[1][c]]);
            }
        }
        let [a, b, c, d] = rows[rows.len() - 1];
        sketch.face(&[a, b, c, d, tip]);
    }
}

fn pot(sketch: &mut Sketch) {
    sketch.group("pot", "bare:pot");
    let outside = [(5.9, 0.0), (6.0, 0.0), (6.2, 0.2), (7.6, 8.6), (7.7, 9.0), (8.3, 9.05)];
    let rim = [(8.4, 9.1), (8.6, 11.9), (8.5, 12.1), (7.9, 12.1), (7.7, 11.0)];
    let profile: Vec<_> = outside.into_iter().chain(rim).collect();
    sketch.turned(16, &profile, |p| p);
    sketch.group("soil", "bare:soil");
    sketch.disc(4, 1, |turns, rho| {
        let lump = 0.15 * jitter_at(turns, rho, 7);
        on_circle(turns, 7.8 * rho, SOIL_CM + 0.3 + 0.5 * (1.0 - rho * rho) + lump)
    });
}
