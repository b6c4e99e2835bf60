//! A fly agaric: cap with rolled rim, gills, hanging ring, bulbous stem, moss.

use super::sketch::{Sketch, jitter, jitter_at, on_circle, sin_cos};
use crate::surface::PolygonMesh;
use glam::Vec3;

const CAP_RADIUS_CM: f32 = 6.1;
const CAP_HEIGHT_CM: f32 = 3.9;
/// Of the rim above the ground.
const RIM_CM: f32 = 12.6;
const LAMELLAE: u32 = 52;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    cap(&mut sketch);
    gills(&mut sketch);
    stem(&mut sketch);
    moss(&mut sketch);
    sketch.mesh
}

/// The stem is bent and the cap sits on it at an angle.
fn bend(p: Vec3) -> Vec3 {
    let up = p.y / RIM_CM;
    Vec3::new(p.x + 0.9 * up * up, p.y - 0.055 * up * p.x * up, p.z)
}

fn cap(sketch: &mut Sketch) {
    sketch.group("cap", "cap");
    let profile = cap_profile();
    sketch.disc(5, 4, |turns, rho| {
        let (radius, height) = along(&profile, rho);
        // Not quite a circle, and the rim not quite level.
        let uneven = 1.0 + 0.012 * sin_cos(2.0 * turns + 0.1).0 + 0.008 * sin_cos(3.0 * turns).0;
        let rim = 0.12 * rho * rho * sin_cos(3.0 * turns + 0.2).1;
        bend(on_circle(turns, radius * uneven, RIM_CM + height + rim))
    });
}

/// Radius and height over the rim, from the top over the rim to its rolled-in edge.
fn cap_profile() -> Vec<(f32, f32)> {
    let dome = (0..=40).map(|k| {
        let (sin, cos) = sin_cos(k as f32 / 40.0 * 0.25);
        (CAP_RADIUS_CM * sin, CAP_HEIGHT_CM * libm::powf(cos.max(0.0), 0.92))
    });
    let roll = (1..=10).map(|k| {
        let (sin, cos) = sin_cos(k as f32 / 10.0 * 0.42);
        (CAP_RADIUS_CM - 0.3 + 0.3 * cos, -0.42 * sin)
    });
    dome.chain(roll).collect()
}

/// The point at a share of a polyline's length.
fn along(line: &[(f32, f32)], share: f32) -> (f32, f32) {
    let length = |pair: &[(f32, f32)]| {
        let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        libm::sqrtf(dx * dx + dy * dy)
    };
    let mut left = share * line.windows(2).map(length).sum::<f32>();
    for pair in line.windows(2) {
        let here = length(pair);
        if left <= here {
            let t = left / here;
            return (
                pair[0].0 + t * (pair[1].0 - pair[0].0),
                pair[0].1 + t * (pair[1].1 - pair[0].1),
            );
        }
        left -= here;
    }
    line[line.len() - 1]
}

/// Lamellae that hang from the flesh, every second one short of the stem.
fn gills(sketch: &mut Sketch) {
    sketch.group("flesh", "bare:gills");
    let under = [(0.8, 1.2), (2.5, 1.0), (4.2, 0.6), (5.2, 0.22), (5.4, 0.15)];
    sketch.turned(20, &under, |p| bend(p + Vec3::Y * RIM_CM));
    sketch.group("lamellae", "bare:gills");
    for k in 0..LAMELLAE {
        let turns = (k as f32 + 0.2 * jitter(k, 1)) / LAMELLAE as f32;
        let inner = if k % 2 == 0 { 1.0 } else { 2.6 };
        let at = |share: f32, hang: f32| {
            let radius = inner + (5.35 - inner) * share;
            // The flesh rises towards the stem.
            let flesh = 0.25 + 1.1 * (1.0 - radius / 5.4);
            bend(on_circle(turns, radius, RIM_CM + flesh - hang))
        };
        let top: Vec<u32> = [0.0, 0.5, 1.0].map(|s| sketch.vertex(at(s, 0.0))).to_vec();
        let edge: Vec<u32> = [(0.0, 0.7), (0.6, 1.35), (1.0, 0.35)]
            .map(|(s, hang)| sketch.vertex(at(s, hang)))
            .to_vec();
        for j in 0..2 {
            sketch.face(&[edge[j], edge[j + 1], top[j + 1], top[j]]);
        }
    }
}

fn stem(sketch: &mut Sketch) {
    sketch.group("stem", "bare:stem");
    let profile = [
        (1.5, -0.3),
        (2.1, 0.5),
        (2.15, 1.4),
        (1.5, 2.5),
        (1.15, 4.0),
        (1.02, 6.5),
        (0.95, 9.5),
        (1.0, 12.0),
        (1.25, 13.4),
        (1.3, 14.0),
    ];
    sketch.turned(10, &profile, bend);
    sketch.group("ring", "bare:ring");
    skirt(sketch);
    sketch.group("volva", "bare:stem");
    // The veil's remains: three rings of warts on the bulb.
    for (ring, (radius, height, count)) in
        [(2.0, 1.0, 12), (1.75, 1.9, 11), (1.3, 2.75, 9)].into_iter().enumerate()
    {
        for k in 0..count {
            let seed = 100 * ring as u32 + k;
            let turns = (k as f32 + 0.5 * ring as f32 + 0.2 * jitter(seed, 2)) / count as f32;
            let at = bend(on_circle(turns, radius, height + 0.1 * jitter(seed, 3)));
            sketch.pebble(at, Vec3::new(0.26, 0.2, 0.26), seed);
        }
    }
}

/// The hanging ring: a thin skirt with a wavy hem.
fn skirt(sketch: &mut Sketch) {
    const SIDES: u32 = 18;
    let rings = [(0.9, 10.8), (1.1, 10.65), (1.4, 10.0), (1.62, 9.3), (1.68, 9.0)];
    let rings: Vec<Vec<u32>> = rings
        .into_iter()
        .enumerate()
        .map(|(k, (radius, height))| {
            let points: Vec<Vec3> = (0..SIDES)
                .map(|s| {
                    let hem = k as f32 / 4.0;
                    let pleat = 0.16 * hem * jitter(s, 4);
                    let turns = s as f32 / SIDES as f32;
                    bend(on_circle(turns, radius + pleat, height + 0.22 * hem * jitter(s, 5)))
                })
                .collect();
            sketch.ring(points)
        })
        .collect();
    for pair in rings.windows(2) {
        sketch.band(&pair[1], &pair[0]);
    }
}

/// A cushion of moss with short shoots.
fn moss(sketch: &mut Sketch) {
    let cushion = |turns: f32, rho: f32| {
        let lump = jitter_at(turns, rho, 6);
        let height = (1.3 + 0.55 * lump) * (1.0 - rho * rho);
        on_circle(turns, (5.4 + 0.6 * lump) * rho, height)
    };
    sketch.group("moss", "bare:moss");
    sketch.disc(6, 2, cushion);
    sketch.group("shoots", "bare:shoot");
    for k in 0..110 {
        // Sunflower spiral: even over the disc.
        let rho = 0.3 + 0.66 * libm::sqrtf((k as f32 + 0.5) / 110.0);
        let foot = cushion(k as f32 * 0.381_966, rho) - Vec3::Y * 0.15;
        let outward = (foot * Vec3::new(1.0, 0.0, 1.0)).normalize_or(Vec3::X);
        let lean = Vec3::new(jitter(k, 8), 0.0, jitter(k, 9)) * 0.3 + outward * 0.15;
        sketch.spike(foot, foot + Vec3::Y * (0.75 + 0.3 * jitter(k, 7)) + lean, 0.16);
    }
}
