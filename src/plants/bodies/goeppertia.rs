//! A rose-painted calathea in its pot: round leaves on long stalks that turn their upper side to the light.

use super::blade::{Blade, Outline, lay_veins, pot, ribs};
use super::sketch::{Sketch, on_circle};
use crate::surface::PolygonMesh;
use glam::Vec3;

const ROUND: Outline = [
    (0.0, 0.0),
    (0.14, 0.0),
    (0.26, 0.06),
    (0.345, 0.15),
    (0.385, 0.27),
    (0.392, 0.4),
    (0.37, 0.53),
    (0.32, 0.66),
    (0.24, 0.79),
    (0.13, 0.91),
    (0.0, 1.0),
];

const SIDE_VEINS: [f32; 11] = [0.08, 0.16, 0.24, 0.32, 0.4, 0.48, 0.56, 0.64, 0.72, 0.8, 0.88];

/// Where a blade begins, where its midrib goes and its upper side looks, and its length.
const LEAVES: [(Vec3, Vec3, Vec3, f32); 6] = [
    (Vec3::new(-3.0, 17.0, 3.6), Vec3::new(-0.62, -0.4, 0.5), Vec3::new(-0.1, 0.75, 0.7), 16.0),
    (Vec3::new(3.4, 18.0, 3.4), Vec3::new(0.66, -0.3, 0.5), Vec3::new(0.1, 0.72, 0.7), 16.5),
    (Vec3::new(-4.0, 26.0, -0.4), Vec3::new(-0.75, 0.42, 0.1), Vec3::new(-0.1, 0.45, 0.9), 17.0),
    (Vec3::new(4.2, 27.0, -0.6), Vec3::new(0.72, 0.5, 0.1), Vec3::new(0.1, 0.4, 0.9), 16.5),
    (Vec3::new(0.0, 29.0, -2.4), Vec3::new(0.02, 0.9, -0.1), Vec3::new(0.0, 0.2, 1.0), 16.0),
    (Vec3::new(0.2, 11.6, 6.2), Vec3::new(0.05, -0.25, 0.9), Vec3::new(0.0, 0.9, 0.5), 12.5),
];

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves = LEAVES.map(|(base, along, up, length_cm)| Blade {
        droop_rad: 0.45,
        fold: [0.2, 0.02],
        wave_cm: 0.3,
        waves: 2.3,
        phase_turns: 0.2 * base.x,
        is_double: true,
        ..Blade::new(base, along, up, length_cm, [&ROUND; 2])
    });
    let mut veins = Vec::new();
    for (k, leaf) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, &format!("leaf {}", k + 1));
        veins.extend(ribs(k as u32, [&SIDE_VEINS; 2]));
    }
    sketch.group("petioles", "bare:petiole");
    for (k, leaf) in leaves.iter().enumerate() {
        let foot = on_circle(0.13 + k as f32 * 0.382, 0.9, 9.6);
        leaf.petiole(&mut sketch, foot, 0.26);
    }
    pot(&mut sketch, 10.4, 7.8);
    lay_veins(&mut sketch, veins);
    sketch.mesh
}
