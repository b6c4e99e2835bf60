//! Two fly agarics in moss: a grown one with gills, hanging ring and bulb, and a button beside it.

use super::sketch::{Sketch, jitter, jitter_at, on_circle, sin_cos};
use crate::surface::PolygonMesh;
use glam::Vec3;

const LAMELLAE: u32 = 60;

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    sketch.group("cap", "cap");
    GROWN.cap(&mut sketch, 5, 4);
    sketch.group("button", "cap");
    BUTTON.cap(&mut sketch, 4, 3);
    gills(&mut sketch);
    stems(&mut sketch);
    moss(&mut sketch);
    sketch.mesh
}

/// One mushroom's measures, in centimetres.
struct Agaric {
    foot: Vec3,
    cap_radius: f32,
    cap_height: f32,
    /// Of the rim above the ground.
    rim: f32,
    /// How far the cap stands beside the foot, and how steeply it slopes that way.
    lean: f32,
    slope: f32,
}

const GROWN: Agaric = Agaric {
    foot: Vec3::new(0.7, 0.0, 0.0),
    cap_radius: 6.3,
    cap_height: 3.7,
    rim: 12.4,
    lean: 0.9,
    slope: 0.06,
};

const BUTTON: Agaric = Agaric {
    foot: Vec3::new(-4.0, 0.0, 2.2),
    cap_radius: 2.55,
    cap_height: 2.7,
    rim: 4.1,
    lean: -0.6,
    slope: -0.1,
};

impl Agaric {
    /// From an upright mushroom around the y axis to where it stands: the stem is bent and the cap
    /// sits on it at an angle.
    fn stand(&self, p: Vec3) -> Vec3 {
        let up = p.y / self.rim;
        self.foot + Vec3::new(p.x + self.lean * up * up, p.y - self.slope * up * p.x * up, p.z)
    }

    fn cap(&self, sketch: &mut Sketch, k: usize, rings: usize) {
        let profile = self.profile();
        sketch.disc(k, rings, |turns, rho| {
            let (radius, height) = along(&profile, rho);
            // Not quite a circle, and the rim not quite level.
            let (second, third) = (sin_cos(2.0 * turns + 0.1).0, sin_cos(3.0 * turns).0);
            let uneven = 1.0 + 0.012 * second + 0.008 * third;
            let wave = 0.02 * self.cap_radius * rho * rho * sin_cos(3.0 * turns + 0.2).1;
            self.stand(on_circle(turns, radius * uneven, self.rim + height + wave))
        });
    }

    /// Radius and height over the rim, from the top over the rim to its rolled-in edge.
    fn profile(&self) -> Vec<(f32, f32)> {
        let dome = (0..=40).map(|k| {
            let (sin, cos) = sin_cos(k as f32 / 40.0 * 0.25);
            (self.cap_radius * sin, self.cap_height * libm::powf(cos.max(0.0), 0.92))
        });
        let roll = (1..=10).map(|k| {
            let (sin, cos) = sin_cos(k as f32 / 10.0 * 0.42);
            (self.cap_radius - 0.3 + 0.3 * cos, -0.42 * sin)
        });
        dome.chain(roll).collect()
    }
}

/// The point at a share of a polyline's length.
fn along(line: &[(f32, f32)], share: f32) -> (f32, f32) {
    let length = |pair: &[(f32, f32)]| {
        let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        libm::sqrtf(dx * dx + dy * dy)
    };
    let mut left = share * line.windows(2).map(length).sum::<f32>();
    for pair in line.windows(2) {
        let (here, [from, to]) = (length(pair), [pair[0], pair[1]]);
        if left <= here {
            let t = left / here;
            return (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1));
        }
        left -= here;
    }
    line[line.len() - 1]
}

/// The grown cap's flesh from below, and the lamellae that hang from it, every second one short of
/// the stem.
fn gills(sketch: &mut Sketch) {
    let place = |p: Vec3| GROWN.stand(p + Vec3::Y * GROWN.rim);
    sketch.group("flesh", "bare:flesh");
    let under = [(0.8, 1.2), (2.5, 1.0), (4.2, 0.6), (5.3, 0.22), (5.55, 0.15)];
    sketch.turned(20, &under, place);
    sketch.group("lamellae", "bare:gills");
    for k in 0..LAMELLAE {
        let turns = k as f32 / LAMELLAE as f32;
        let inner = if k % 2 == 0 { 1.0 } else { 2.4 };
        let at = |share: f32, hang: f32| {
            let radius = inner + (5.5 - inner) * share;
            // The flesh rises towards the stem.
            let flesh = 0.25 + 1.1 * (1.0 - radius / 5.5);
            place(on_circle(turns, radius, flesh - hang))
        };
        let top: Vec<u32> = [0.0, 0.5, 1.0].map(|s| sketch.vertex(at(s, 0.0))).to_vec();
        let edge: Vec<u32> = [(0.0, 0.7), (0.6, 1.05), (1.0, 0.4)]
            .map(|(s, hang)| sketch.vertex(at(s, hang)))
            .to_vec();
        for j in 0..2 {
            sketch.face(&[edge[j], edge[j + 1], top[j + 1], top[j]]);
        }
    }
}

fn stems(sketch: &mut Sketch) {
    sketch.group("stem", "bare:stem");
    let grown = [
        (1.5, 0.1),
        (2.1, 0.5),
        (2.15, 1.4),
        (1.5, 2.5),
        (1.15, 4.0),
        (1.02, 6.5),
        (0.95, 9.5),
        (1.0, 12.0),
        (1.25, 13.2),
        (1.3, 13.8),
    ];
    sketch.turned(10, &grown, |p| GROWN.stand(p));
    let button =
        [(1.5, 0.1), (2.0, 0.6), (1.95, 1.5), (1.45, 2.6), (1.4, 3.6), (2.2, 4.3), (2.3, 4.6)];
    sketch.turned(10, &button, |p| BUTTON.stand(p));
    sketch.group("ring", "bare:ring");
    skirt(sketch);
    // The veil's remains: rings of warts on the bulb.
    sketch.group("volva", "bare:stem");
    let rings = [(2.0, 1.2, 12), (1.72, 2.0, 11), (1.3, 2.8, 9)];
    for (ring, (radius, height, count)) in rings.into_iter().enumerate() {
        for k in 0..count {
            let seed = 100 * ring as u32 + k;
            let turns = (k as f32 + 0.5 * ring as f32 + 0.2 * jitter(seed, 2)) / count as f32;
            let at = GROWN.stand(on_circle(turns, radius, height + 0.1 * jitter(seed, 3)));
            sketch.pebble(at, Vec3::new(0.26, 0.2, 0.26), seed);
        }
    }
}

/// The hanging ring: a thin skirt with a wavy hem.
fn skirt(sketch: &mut Sketch) {
    const SIDES: u32 = 18;
    let profile = [(0.9, 10.9), (1.1, 10.75), (1.45, 10.2), (1.75, 9.6), (1.85, 9.3)];
    let rings = profile.into_iter().enumerate().map(|(k, (radius, height))| {
        let hem = k as f32 / 4.0;
        (0..SIDES)
            .map(|s| {
                let (pleat, sag) = (0.16 * hem * jitter(s, 4), 0.22 * hem * jitter(s, 5));
                let turns = s as f32 / SIDES as f32;
                sketch.vertex(GROWN.stand(on_circle(turns, radius + pleat, height + sag)))
            })
            .collect()
    });
    let rings: Vec<Vec<u32>> = rings.collect();
    for pair in rings.windows(2) {
        sketch.band(&pair[1], &pair[0]);
    }
}

/// A cushion of moss. `plants::mushroom` grows short shoots on it when it loads the mesh.
fn moss(sketch: &mut Sketch) {
    sketch.group("moss", "bare:moss");
    sketch.disc(6, 2, |turns, rho| {
        let lump = jitter_at(turns, rho, 6);
        let height = (1.5 + 0.5 * lump) * (1.0 - rho * rho);
        let p = on_circle(turns, (5.8 + 0.6 * lump) * rho, height);
        Vec3::new(1.15 * p.x - 0.9, p.y, p.z + 0.5)
    });
}
