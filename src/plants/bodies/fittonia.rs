//! A nerve plant: a low pot of oval leaves in crossed pairs, each with its net of veins.

use super::blade::{Blade, LeafVein, Outline, lay_veins, pot, ribs};
use super::sketch::{Sketch, jitter, on_circle};
use crate::surface::PolygonMesh;
use glam::{Vec2, Vec3};

const OVAL: Outline = [
    (0.0, 0.0),
    (0.13, 0.02),
    (0.24, 0.09),
    (0.31, 0.19),
    (0.34, 0.31),
    (0.34, 0.43),
    (0.31, 0.55),
    (0.26, 0.67),
    (0.19, 0.79),
    (0.1, 0.9),
    (0.0, 1.0),
];

/// Where side veins leave the midrib.
const SIDE_VEINS: [f32; 8] = [0.07, 0.19, 0.31, 0.43, 0.55, 0.67, 0.79, 0.91];
/// Across, where veins of the third order go from one side vein to the next.
const BRIDGES: [f32; 2] = [0.33, 0.66];

/// In turns around the middle, from the right to the viewer; how far out and how high the blade begins; how
/// high it points, and its length.
const LEAVES: [(f32, f32, f32, f32, f32); 10] = [
    (0.23, 2.9, 7.4, 0.02, 8.4),
    (0.73, 2.6, 8.4, 0.3, 7.8),
    (0.98, 3.0, 7.6, 0.1, 8.6),
    (0.48, 3.0, 7.6, 0.1, 8.6),
    (0.11, 2.0, 9.2, 0.26, 8.0),
    (0.61, 1.9, 9.8, 0.5, 7.4),
    (0.36, 2.0, 9.2, 0.26, 8.0),
    (0.86, 1.9, 9.8, 0.5, 7.4),
    (0.22, 0.8, 11.0, 0.45, 6.0),
    (0.72, 0.7, 11.4, 0.8, 5.6),
];

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves = LEAVES.map(blade);
    let mut veins = Vec::new();
    for (k, leaf) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, &format!("leaf {}", k + 1));
        veins.extend(ribs(k as u32, [&SIDE_VEINS; 2]));
        net(k as u32, &mut veins);
    }
    sketch.group("petioles", "bare:petiole");
    for (leaf, (turns, from_middle_cm, height_cm, ..)) in leaves.iter().zip(LEAVES) {
        let foot = on_circle(turns, 0.2 * from_middle_cm, height_cm - 1.6);
        leaf.petiole(&mut sketch, foot, 0.13);
    }
    sketch.group("stem", "bare:petiole");
    sketch.tube(6, &[4.4, 7.0, 9.6, 11.0].map(|height| (Vec3::Y * height, 0.3 - 0.015 * height)));
    pot(&mut sketch, 5.4, 4.6);
    lay_veins(&mut sketch, veins);
    sketch.mesh
}

fn blade(
    (turns, from_middle_cm, height_cm, rise_rad, length_cm): (f32, f32, f32, f32, f32),
) -> Blade {
    let outward = on_circle(turns, 1.0, 0.0);
    let along = outward * libm::cosf(rise_rad) + Vec3::Y * libm::sinf(rise_rad);
    Blade {
        droop_rad: 0.75,
        fold: [0.3, 0.08],
        wave_cm: 0.12,
        phase_turns: turns,
        rows: libm::roundf(length_cm) as usize,
        ..Blade::new(
            on_circle(turns, from_middle_cm, height_cm),
            along,
            Vec3::Y,
            length_cm,
            [&OVAL; 2],
        )
    }
}

/// Veins of the third order: bridges between side veins, and one along the rim that joins their ends.
fn net(part: u32, veins: &mut Vec<LeafVein>) {
    let mut lay = |path: Vec<Vec2>| veins.push(LeafVein { part, order: 3, path });
    for (half, side) in (0..).zip([-1.0, 1.0]) {
        for (gap, ends) in (0..).zip(SIDE_VEINS.windows(2)) {
            let chance = |purpose| jitter(64 * part + 8 * half + gap, purpose);
            for (bridge, x) in (0..).zip(BRIDGES) {
                let [from, to] = [0, 1].map(|end| x + 0.055 * chance(40 + 2 * bridge + end));
                lay(vec![Vec2::new(side * from, ends[0]), Vec2::new(side * to, ends[1])]);
            }
        }
        let rim = |(k, t): (usize, &f32)| Vec2::new(side * if k % 2 == 0 { 0.93 } else { 0.9 }, *t);
        lay(SIDE_VEINS.iter().enumerate().map(rim).collect());
    }
}
