//! A polka dot begonia in its pot: wing-shaped leaves along two canes.

use super::blade::{Blade, Outline, lay_veins, pot, ribs};
use super::sketch::Sketch;
use crate::surface::PolygonMesh;
use glam::Vec3;

/// A wing: one half reaches far out and back beside the petiole, the other one is narrow.
const BROAD: Outline = [
    (0.0, 0.0),
    (0.16, -0.16),
    (0.31, -0.2),
    (0.41, -0.1),
    (0.44, 0.06),
    (0.42, 0.22),
    (0.36, 0.39),
    (0.275, 0.56),
    (0.18, 0.72),
    (0.085, 0.87),
    (0.0, 1.0),
];
const NARROW: Outline = [
    (0.0, 0.0),
    (0.09, 0.0),
    (0.16, 0.06),
    (0.2, 0.14),
    (0.22, 0.24),
    (0.22, 0.35),
    (0.2, 0.47),
    (0.165, 0.6),
    (0.12, 0.73),
    (0.062, 0.87),
    (0.0, 1.0),
];
/// Where side veins leave the midrib: as far apart as the narrow half has room for, more in the broad one.
const SIDE_VEINS: [&[f32]; 2] = [&[0.16, 0.38, 0.6, 0.8], &[0.12, 0.26, 0.42, 0.58, 0.74, 0.88]];

const CANES: [[Vec3; 4]; 2] = [
    [
        Vec3::new(-1.2, 8.6, -0.6),
        Vec3::new(-2.0, 20.0, -0.8),
        Vec3::new(-3.4, 32.0, -1.0),
        Vec3::new(-4.2, 41.0, -1.0),
    ],
    [
        Vec3::new(1.6, 8.6, 0.0),
        Vec3::new(3.2, 18.0, 0.0),
        Vec3::new(5.0, 27.0, -0.2),
        Vec3::new(6.2, 35.0, -0.4),
    ],
];

/// Where a petiole leaves its cane and where it meets the blade; how far the midrib turns from the plumb line
/// and the upper side from the viewer, to the right; its length, and whether the broad half is on the left.
const LEAVES: [(Vec3, Vec3, f32, f32, f32, bool); 9] = [
    (CANES[0][3], Vec3::new(-8.0, 43.0, 1.0), -0.75, -0.35, 11.6, false),
    (CANES[0][3], Vec3::new(-1.4, 45.0, 0.2), 0.5, 0.2, 10.2, true),
    (CANES[0][2], Vec3::new(-9.0, 32.5, 3.4), -0.6, -0.3, 13.6, false),
    (CANES[0][2], Vec3::new(-0.6, 34.0, 3.4), 0.16, 0.05, 12.4, true),
    (CANES[0][1], Vec3::new(-7.6, 20.6, 5.0), -0.5, -0.3, 12.8, false),
    (CANES[1][3], Vec3::new(10.2, 37.0, 0.6), 0.65, 0.3, 11.4, true),
    (CANES[1][2], Vec3::new(10.4, 26.0, 3.6), 0.55, 0.35, 13.2, true),
    (CANES[1][1], Vec3::new(3.4, 20.4, 6.0), 0.06, 0.1, 12.0, true),
    (CANES[1][3], Vec3::new(6.8, 39.0, -1.4), 0.1, -0.2, 7.2, false),
];

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves = LEAVES.map(|leaf| (leaf.0, blade(leaf)));
    let mut veins = Vec::new();
    for (k, (_, leaf)) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, &format!("leaf {}", k + 1));
        let [narrow, broad] = SIDE_VEINS;
        veins.extend(ribs(k as u32, if LEAVES[k].5 { [broad, narrow] } else { [narrow, broad] }));
    }
    sketch.group("petioles", "bare:petiole");
    for (foot, leaf) in &leaves {
        leaf.petiole(&mut sketch, *foot, 0.22);
    }
    sketch.group("canes", "bare:cane");
    for cane in CANES {
        let path: Vec<_> = cane.into_iter().zip([0.6, 0.52, 0.44, 0.3]).collect();
        sketch.tube(6, &path);
    }
    pot(&mut sketch, 9.0, 6.6);
    lay_veins(&mut sketch, veins);
    sketch.mesh
}

fn blade(
    (_, base, tilt_rad, yaw_rad, length_cm, left): (Vec3, Vec3, f32, f32, f32, bool),
) -> Blade {
    let facing = Vec3::new(libm::sinf(yaw_rad), 0.0, libm::cosf(yaw_rad));
    let right = Vec3::Y.cross(facing);
    let down = right * libm::sinf(tilt_rad) - Vec3::Y * libm::cosf(tilt_rad);
    // Held out, so that the upper side is turned to the light.
    let along = down * libm::cosf(0.5) + facing * libm::sinf(0.5);
    // Seen with the tip downwards, the left half is on the right.
    let halves = if left { [&BROAD, &NARROW] } else { [&NARROW, &BROAD] };
    Blade {
        droop_rad: 0.75,
        fold: [0.3, 0.045],
        wave_cm: 0.3,
        waves: 1.7,
        phase_turns: 0.13 * length_cm,
        is_double: true,
        ..Blade::new(base, along, facing, length_cm, halves)
    }
}
