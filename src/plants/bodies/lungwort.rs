//! Lungwort: a rosette of rough lance-shaped leaves, and a few flowers over it.

use super::blade::{Blade, Outline, lay_veins, pot};
use super::sketch::{Sketch, jitter, on_circle};
use crate::surface::PolygonMesh;
use glam::Vec3;

const LANCE: Outline = [
    (0.0, 0.0),
    (0.075, 0.03),
    (0.115, 0.1),
    (0.132, 0.19),
    (0.145, 0.3),
    (0.143, 0.42),
    (0.13, 0.54),
    (0.107, 0.66),
    (0.085, 0.78),
    (0.052, 0.9),
    (0.0, 1.0),
];

const LEAVES: u32 = 11;
const DIVERGENCE_TURNS: f32 = 137.5 / 360.0;
const SOIL_CM: f32 = 7.6;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves: Vec<(Vec3, Blade)> = (0..LEAVES).map(leaf).collect();
    for (k, (_, leaf)) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, &format!("leaf {}", k + 1));
    }
    sketch.group("petioles", "bare:petiole");
    for (foot, leaf) in &leaves {
        leaf.petiole(&mut sketch, *foot, 0.2);
    }
    flowers(&mut sketch);
    pot(&mut sketch, 8.0, 7.4);
    lay_veins(&mut sketch, Vec::new());
    sketch.mesh
}

/// The foot of its petiole and the blade; the first leaf is the oldest and lies lowest.
fn leaf(number: u32) -> (Vec3, Blade) {
    let youth = number as f32 / (LEAVES - 1) as f32;
    let turns = 0.21 + number as f32 * DIVERGENCE_TURNS + 0.01 * jitter(number, 1);
    let outward = on_circle(turns, 1.0, 0.0);
    let rise_rad = 0.42 + 0.62 * youth + 0.05 * jitter(number, 2);
    let along = outward * libm::cosf(rise_rad) + Vec3::Y * libm::sinf(rise_rad);
    let foot = outward * (1.3 - 0.9 * youth) + Vec3::Y * (SOIL_CM - 0.4);
    let base = foot + along * (3.4 - 1.4 * youth);
    let length_cm = 16.0 - 5.0 * youth * youth + 0.8 * jitter(number, 3);
    let blade = Blade {
        droop_rad: 1.05 - 0.45 * youth + 0.1 * jitter(number, 4),
        fold: [0.32, 0.07],
        wave_cm: 0.28,
        waves: 2.6,
        phase_turns: 0.31 * number as f32,
        columns: 2,
        rows: libm::roundf(length_cm / 1.7) as usize,
        ..Blade::new(base, along, Vec3::Y - outward * 0.3, length_cm, [&LANCE; 2])
    };
    (foot, blade)
}

/// A stalk that forks into bells, pink when they open and blue when they are old.
fn flowers(sketch: &mut Sketch) {
    let top = Vec3::new(0.3, 22.0, 0.6);
    sketch.group("flower stalk", "bare:petiole");
    sketch.tube(
        5,
        &[(Vec3::Y * (SOIL_CM - 0.4), 0.26), (Vec3::new(0.1, 15.0, 0.2), 0.22), (top, 0.14)],
    );
    for (number, (turns, rise)) in
        [(0.3, 0.2), (0.05, 0.55), (0.55, 0.5), (0.8, 0.25), (0.18, 1.2), (0.45, -0.25)]
            .into_iter()
            .enumerate()
    {
        let way = (on_circle(turns, 1.0, 0.0) + Vec3::Y * rise).normalize();
        let at = |cm: f32| top - Vec3::Y * 0.3 + way * cm;
        sketch.group("calyx", "bare:petiole");
        sketch.tube(5, &[(at(0.0), 0.1), (at(0.7), 0.16), (at(1.4), 0.3)]);
        sketch.group("bell", if number % 2 == 0 { "bare:pink" } else { "bare:blue" });
        sketch.tube(
            6,
            &[(at(1.3), 0.22), (at(1.9), 0.3), (at(2.3), 0.62), (at(2.5), 0.78), (at(2.4), 0.4)],
        );
    }
}
