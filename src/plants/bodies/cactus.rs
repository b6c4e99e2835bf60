//! Two ribbed columns of *Cereus* in stony soil.

use super::sketch::{Sketch, jitter, jitter_at, on_circle};
use crate::surface::{Face, PolygonMesh};
use glam::Vec3;

pub fn grow() -> PolygonMesh {
    let columns = [
        Column {
            ribs: 6,
            radius: 6.9,
            height: 39.5,
            rows: 11,
            foot: Vec3::ZERO,
            lean: 0.35,
            turn: 0.03,
        },
        Column {
            ribs: 5,
            radius: 5.0,
            height: 20.5,
            rows: 5,
            foot: Vec3::new(9.4, 0.0, 3.2),
            lean: 1.1,
            turn: 0.11,
        },
    ];
    let mut sketch = Sketch::default();
    let mut areoles = Vec::new();
    for (k, column) in columns.iter().enumerate() {
        sketch.group(&format!("column {}", k + 1), "skin");
        areoles.push(column.skin(&mut sketch));
    }
    // Vertices keep their numbers in refinement, so a crest's control vertex tells where the smooth
    // crest runs.
    let smooth = sketch.mesh.refined(2);
    sketch.group("areoles", "bare:areole");
    for crest in areoles.into_iter().flatten() {
        areole(&mut sketch, &smooth, crest);
    }
    ground(&mut sketch);
    sketch.mesh
}

/// The columns begin in the soil, but above the ground under it.
const FOOT_CM: f32 = 0.6;

struct Column {
    ribs: usize,
    /// To the crests of the control mesh; the smooth ones lie a little lower.
    radius: f32,
    height: f32,
    /// Rings between the ground and the shoulder.
    rows: usize,
    foot: Vec3,
    /// How far the top stands outward from the foot.
    lean: f32,
    turn: f32,
}

/// One rib's section: turns from the crest (in ribs), share of the radius, going round from crest
/// to crest. The flanks stand near the furrow: blunt crests, sharp furrows.
const SECTION: [(f32, f32); 4] = [(0.0, 1.0), (0.33, 0.86), (0.5, 0.38), (0.67, 0.86)];

impl Column {
    /// Returns the control vertices on the crests that carry areoles.
    fn skin(&self, sketch: &mut Sketch) -> Vec<u32> {
        let dome = 0.85 * self.radius;
        let shoulder = self.height - dome;
        let mut stations: Vec<(f32, f32)> = (0..=self.rows)
            .map(|row| {
                let up = row as f32 / self.rows as f32;
                // Narrow at the foot; each year's growth leaves a faint waist.
                let waist = 0.97 + 0.03 * libm::cosf(up * 9.0);
                let foot = 1.0 - 0.16 * (1.0 - up) * (1.0 - up) * (1.0 - up);
                (waist * foot, FOOT_CM + (shoulder - FOOT_CM) * up)
            })
            .collect();
        for degrees in [27.0_f32, 51.0] {
            let (sin, cos) = (libm::sinf(degrees.to_radians()), libm::cosf(degrees.to_radians()));
            stations.push((cos, shoulder + dome * sin));
        }
        let rings: Vec<Vec<u32>> = stations
            .iter()
            .map(|&(wide, height)| sketch.ring(self.section(wide, height, &SECTION)))
            .collect();
        for pair in rings.windows(2) {
            sketch.band(&pair[0], &pair[1]);
        }
        let last = rings[rings.len() - 1].clone();
        self.crown(sketch, &last, shoulder + dome);
        // One areole a row, from above the soil to the shoulder; rings hold four vertices a rib.
        rings[2..].iter().flat_map(|ring| ring.iter().step_by(SECTION.len()).copied()).collect()
    }

    /// The ribs run together: flanks end, crests and furrows go on to the middle.
    fn crown(&self, sketch: &mut Sketch, shoulder: &[u32], top: f32) {
        let section = [SECTION[0], (0.5, 0.62)];
        let ring = sketch.ring(self.section(0.33, top - 0.02 * self.radius, &section));
        let n = ring.len();
        for k in 0..n {
            let s = |j: usize| shoulder[(2 * k + j) % (2 * n)];
            sketch.face(&[s(0), ring[k], ring[(k + 1) % n], s(2), s(1)]);
        }
        let middle = sketch.vertex(self.place(0.0, 0.0, top - 0.09 * self.radius));
        for rib in 0..self.ribs {
            let furrow_before = ring[(2 * rib + n - 1) % n];
            sketch.face(&[middle, ring[2 * rib + 1], ring[2 * rib], furrow_before]);
        }
    }

    fn section(&self, wide: f32, height: f32, section: &[(f32, f32)]) -> Vec<Vec3> {
        let one_rib = |rib: usize| {
            section.iter().map(move |&(ribs, share)| {
                self.place((rib as f32 + ribs) / self.ribs as f32, wide * share, height)
            })
        };
        (0..self.ribs).flat_map(one_rib).collect()
    }

    fn place(&self, turns: f32, share: f32, height: f32) -> Vec3 {
        let up = (height / self.height).max(0.0);
        let outward = self.foot.normalize_or(Vec3::X);
        self.foot
            + outward * (self.lean * up * up)
            + on_circle(turns + self.turn, share * self.radius, height)
    }
}

/// The foot of an areole: a diamond that lies on the crest. `plants::cactus` raises a cushion with
/// spines on each when it loads the mesh.
fn areole(sketch: &mut Sketch, smooth: &PolygonMesh, crest: u32) {
    let centre = smooth.positions[crest as usize];
    let at = |corner: &u32| smooth.positions[*corner as usize];
    let quads = smooth.faces.iter().filter(|face| face.vertices.contains(&crest));
    let normal = |f: &Face| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| at(&f.vertices[k]));
        (c - a).cross(d - b)
    };
    let outward = quads.map(normal).sum::<Vec3>().normalize();
    let side = Vec3::Y.cross(outward).normalize();
    let along = outward.cross(side);
    let corners = [side * 0.3, along * 0.4, side * -0.3, along * -0.4];
    let diamond = corners.map(|corner| sketch.vertex(centre - outward * 0.06 + corner));
    sketch.face(&diamond);
}

/// A low heap of soil with stones.
fn ground(sketch: &mut Sketch) {
    let middle = Vec3::new(3.2, 0.0, 1.0);
    let heap = |turns: f32, rho: f32| {
        let lump = jitter_at(turns, rho, 1);
        let height = 2.0 * (1.0 - rho * rho) + 0.3 * lump * (1.0 - rho);
        middle + on_circle(turns, (13.0 + 0.7 * lump) * rho, height) * Vec3::new(1.25, 1.0, 1.0)
    };
    sketch.group("soil", "bare:soil");
    sketch.disc(4, 2, heap);
    sketch.group("stones", "bare:stone");
    for k in 0..18 {
        let shaken = |purpose| jitter(k, purpose);
        let rho = 0.75 + 0.24 * shaken(2);
        let size = 0.55 + 0.35 * shaken(3) * shaken(3) + 0.2 * shaken(4);
        let at = heap(k as f32 * 0.382 + 0.03 * shaken(1), rho);
        let half_size = Vec3::new(1.3, 0.8, 1.0) * size;
        sketch.pebble(at.with_y(at.y.max(half_size.y)), half_size, k);
    }
}
