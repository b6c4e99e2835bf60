//! Coleus in its pot: toothed leaves in crossed pairs along a four-sided stem.

use super::blade::{Blade, Outline, lay_veins, pot, ribs};
use super::sketch::{Sketch, jitter, on_circle};
use crate::surface::PolygonMesh;
use glam::Vec3;

const OVATE: Outline = [
    (0.0, 0.0),
    (0.14, 0.0),
    (0.26, 0.06),
    (0.33, 0.15),
    (0.355, 0.26),
    (0.345, 0.38),
    (0.31, 0.51),
    (0.255, 0.64),
    (0.18, 0.77),
    (0.09, 0.89),
    (0.0, 1.0),
];

const SIDE_VEINS: [f32; 6] = [0.1, 0.24, 0.38, 0.52, 0.66, 0.8];

/// Height of each pair over the pot, how high its leaves point, and their length.
const PAIRS: [(f32, f32, f32); 5] = [
    (10.6, -0.2, 11.0),
    (14.2, 0.0, 11.5),
    (17.8, 0.18, 10.5),
    (20.8, 0.4, 8.6),
    (22.8, 0.75, 5.6),
];

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves: Vec<(Vec3, Blade)> = (0..10).map(leaf).collect();
    let mut veins = Vec::new();
    for (k, (_, leaf)) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, &format!("leaf {}", k + 1));
        veins.extend(ribs(k as u32, [&SIDE_VEINS; 2]));
    }
    sketch.group("petioles", "bare:petiole");
    for (foot, leaf) in &leaves {
        leaf.petiole(&mut sketch, *foot, 0.17);
    }
    sketch.group("stem", "bare:petiole");
    sketch.tube(
        4,
        &[(7.0, 0.5), (12.0, 0.45), (18.0, 0.36), (23.2, 0.2)].map(|(y, r)| (Vec3::Y * y, r)),
    );
    pot(&mut sketch, 8.0, 5.8);
    lay_veins(&mut sketch, veins);
    sketch.mesh
}

fn leaf(number: u32) -> (Vec3, Blade) {
    let (height_cm, rise_rad, length_cm) = PAIRS[number as usize / 2];
    // Each pair stands across the one below it.
    let turns =
        0.11 + 0.25 * (number / 2) as f32 + 0.5 * (number % 2) as f32 + 0.012 * jitter(number, 1);
    let outward = on_circle(turns, 1.0, 0.0);
    let along = outward * libm::cosf(rise_rad) + Vec3::Y * libm::sinf(rise_rad);
    let foot = Vec3::Y * (height_cm - 0.5);
    let base = foot + (outward + Vec3::Y * 0.45).normalize() * (0.24 * length_cm);
    let blade = Blade {
        droop_rad: 0.7,
        fold: [0.22, 0.05],
        wave_cm: 0.15,
        phase_turns: 0.3 * number as f32,
        rows: libm::roundf(1.1 * length_cm) as usize,
        teeth: 0.24,
        columns: 2,
        ..Blade::new(base, along, Vec3::Y, length_cm, [&OVATE; 2])
    };
    (foot, blade)
}
