//! Leaf blades of any outline, their petioles and veins, and a pot to stand in.

use super::sketch::{Sketch, jitter_at, on_circle, sin_cos};
use crate::surface::{Body, Line, Mesh};
use glam::{Vec2, Vec3};

/// The outline of half a blade in units of its length: across and along the midrib, from the petiole to the
/// tip, in even steps of the leaf coordinate along the midrib. Side veins run from the midrib to the outline
/// at the same step.
pub type Outline = [(f32, f32); 11];

/// A blade and how it is held.
#[derive(Clone)]
pub struct Blade {
    /// Where the petiole meets it.
    pub base: Vec3,
    /// Of the midrib there, and of the upper side; unit vectors across each other.
    pub along: Vec3,
    pub up: Vec3,
    pub length_cm: f32,
    /// The left half and the right one.
    pub halves: [&'static Outline; 2],
    /// What the midrib bends down from base to tip.
    pub droop_rad: f32,
    /// What halves rise from the midrib, as a slope, and by how much less a centimetre farther out.
    pub fold: [f32; 2],
    pub wave_cm: f32,
    /// Along the rim.
    pub waves: f32,
    pub phase_turns: f32,
    /// Columns of quads in each half at most, and rows.
    pub columns: usize,
    pub rows: usize,
    /// How far teeth between the rows are cut in, as a share of the half width; two rows a tooth.
    pub teeth: f32,
    /// Whether it has an underside of its own colour.
    pub is_double: bool,
}

impl Blade {
    /// A blade with a row every 1.4 cm that goes along a direction with its upper side as nearly as it can towards
    /// another one.
    pub fn new(
        base: Vec3,
        along: Vec3,
        up: Vec3,
        length_cm: f32,
        halves: [&'static Outline; 2],
    ) -> Blade {
        let along = along.normalize();
        let up = (up - along * along.dot(up)).normalize();
        Blade {
            base,
            along,
            up,
            length_cm,
            halves,
            droop_rad: 0.6,
            fold: [0.25, 0.03],
            wave_cm: 0.2,
            waves: 2.0,
            phase_turns: 0.0,
            columns: 4,
            rows: libm::roundf(length_cm / 1.4) as usize,
            teeth: 0.0,
            is_double: false,
        }
    }

    /// The midrib's direction and the blade's upper side so far along, below 0 behind the petiole.
    fn frame(&self, along: f32) -> (Vec3, Vec3) {
        let angle_rad = self.droop_rad * along.max(0.0);
        let (sin, cos) = (libm::sinf(angle_rad), libm::cosf(angle_rad));
        (self.along * cos - self.up * sin, self.up * cos + self.along * sin)
    }

    /// A point of the midrib, or of its straight continuation behind the petiole.
    pub fn midrib(&self, along: f32) -> Vec3 {
        const STEPS: u32 = 16;
        let step = along / STEPS as f32;
        let way: Vec3 = (0..STEPS).map(|k| self.frame((k as f32 + 0.5) * step).0 * step).sum();
        self.base + way * self.length_cm
    }

    /// A point of the control mesh by leaf coordinates, and so far below.
    fn point(&self, x: f32, t: f32, below_cm: f32) -> Vec3 {
        let rim = self.rim(usize::from(x >= 0.0), t);
        let from_midrib = x.abs();
        let across = rim.0 * from_midrib * self.length_cm;
        // Side veins leave the midrib crosswise and then bend to where they end.
        let along = t + (rim.1 - t) * from_midrib * libm::sqrtf(from_midrib);
        let (direction, up) = self.frame(along);
        let side = direction.cross(up) * x.signum();
        let fold = self.fold[0] * across - self.fold[1] * across * across;
        let turns = self.waves * t + self.phase_turns + 0.2 * x.signum();
        let wave = self.wave_cm * x * x * sin_cos(turns).0;
        self.midrib(along) + side * across + up * (fold + wave - below_cm)
    }

    /// Adds the blade as a part of the material `blade`, and its underside as `bare:underside`.
    pub fn lay(&self, sketch: &mut Sketch, part: &str) {
        sketch.group(part, "blade");
        self.sheet(sketch, 0.0, false);
        if self.is_double {
            sketch.group(part, "bare:underside");
            self.sheet(sketch, 0.06, true);
        }
    }

    /// Rows of quads about as long as they are wide; at base and tip a polygon for each half.
    fn sheet(&self, sketch: &mut Sketch, below_cm: f32, is_under: bool) {
        let step = 1.0 / (self.rows as f32 + 0.9);
        let put = |sketch: &mut Sketch, x: f32, t: f32, cut: f32| {
            let is_rim = x.abs() == 1.0 || t == 0.0 || t >= 1.0;
            // Nearly the same rim, and no vertices in common, which would round it.
            let below_cm = if is_rim { 0.3 * below_cm } else { below_cm };
            let p = self.point(x * (1.0 - cut * x.abs()), t, below_cm);
            match is_under {
                true => sketch.vertex(p),
                false => sketch.blade_vertex(p, Vec2::new(x, t.clamp(0.0, 1.0))),
            }
        };
        let base = put(sketch, 0.0, 0.0, 0.0);
        // Of each half the last row, from the midrib outward.
        let mut below = [vec![base], vec![base]];
        for row in 1..=self.rows + 1 {
            let t = row as f32 * step;
            let cut = if row % 2 == 0 { self.teeth } else { 0.0 };
            // The spline of the rim does not reach its control points: the tip is drawn out.
            let is_tip = row > self.rows;
            let middle = put(sketch, 0.0, if is_tip { 1.0 + 0.4 * step } else { t }, 0.0);
            for (half, side) in [-1.0, 1.0].into_iter().enumerate() {
                let columns = if is_tip { 0 } else { self.columns_at(half, t, step) };
                let outward = (1..=columns).map(|c| side * c as f32 / columns as f32);
                let above: Vec<u32> =
                    [middle].into_iter().chain(outward.map(|x| put(sketch, x, t, cut))).collect();
                sketch.strip(&below[half], &above, (half == 0) != is_under);
                below[half] = above;
            }
        }
    }

    /// So many columns of quads are in a half at `t`.
    fn columns_at(&self, half: usize, t: f32, step: f32) -> usize {
        let quads = self.rim(half, t).0 / step;
        (libm::ceilf(quads - 0.4) as usize).clamp(1, self.columns)
    }

    /// The rim in units of the length: across and along the midrib.
    fn rim(&self, half: usize, t: f32) -> (f32, f32) {
        let outline = self.halves[half];
        let last = outline.len() - 1;
        let step = ((t * last as f32) as usize).min(last - 1);
        let part = t * last as f32 - step as f32;
        let (from, to) = (outline[step], outline[step + 1]);
        (from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part)
    }

    /// A stalk from its foot to a little way under the blade, which it meets from below.
    pub fn petiole(&self, sketch: &mut Sketch, foot: Vec3, radius_cm: f32) {
        let under = |along: f32, depth: f32| self.midrib(along) - self.frame(along).1 * depth;
        let middle = foot.lerp(self.base, 0.55) - self.up * (0.06 * foot.distance(self.base));
        sketch.tube(
            5,
            &[
                (foot, 1.3 * radius_cm),
                (middle, radius_cm),
                (under(0.0, 1.1 * radius_cm), 0.9 * radius_cm),
                (under(0.12, 0.9 * radius_cm), 0.6 * radius_cm),
            ],
        );
    }
}

/// A vein in leaf coordinates.
pub struct LeafVein {
    pub part: u32,
    pub order: u32,
    pub path: Vec<Vec2>,
}

/// A midrib, and side veins at these steps along it in each half.
pub fn ribs(part: u32, halves: [&[f32]; 2]) -> Vec<LeafVein> {
    let path = (0..=6).map(|k| Vec2::new(0.0, k as f32 / 6.0)).collect();
    let mut veins = vec![LeafVein { part, order: 1, path }];
    for (steps, side) in halves.into_iter().zip([-1.0, 1.0]) {
        for &t in steps {
            let path = [0.0, 0.3, 0.65, 0.95].map(|x| Vec2::new(side * x, t)).to_vec();
            veins.push(LeafVein { part, order: 2, path });
        }
    }
    veins
}

/// Lays veins on the surface that the sketch becomes after two rounds of refinement.
pub fn lay_veins(sketch: &mut Sketch, mut veins: Vec<LeafVein>) {
    sketch.mesh.uvs.resize(sketch.mesh.positions.len(), Vec2::ZERO);
    let surface = Body::new(&sketch.mesh.refined(2)).expect("a sketch of leaves").surface;
    veins.sort_by_key(|vein| vein.order);
    for LeafVein { part, order, path } in veins {
        let vertices: Vec<u32> =
            path.iter().map(|&leaf| sketch.vertex(on_leaf(&surface, part, leaf))).collect();
        sketch.mesh.lines.push(Line { vertices, order });
    }
    sketch.mesh.uvs.resize(sketch.mesh.positions.len(), Vec2::ZERO);
}

/// The point of a part with these leaf coordinates, or the nearest that there is.
fn on_leaf(mesh: &Mesh, part: u32, leaf: Vec2) -> Vec3 {
    let mut best = (f32::NEG_INFINITY, Vec3::ZERO);
    for t in (0..mesh.triangles.len()).filter(|&t| mesh.parts[t] == part) {
        let [a, b, c] = mesh.triangles[t].map(|v| mesh.uvs[v as usize]);
        let area = (b - a).perp_dot(c - a);
        let b1 = (leaf - a).perp_dot(c - a) / area;
        let b2 = (b - a).perp_dot(leaf - a) / area;
        let least = b1.min(b2).min(1.0 - b1 - b2);
        if least > best.0 {
            let shares = [1.0 - b1 - b2, b1, b2].map(|share| share.max(0.0));
            let sum: f32 = shares.iter().sum();
            let corners = mesh.corners(t as u32);
            let point: Vec3 = corners.iter().zip(shares).map(|(p, share)| *p * share / sum).sum();
            best = (least, point);
        }
    }
    best.1
}

/// A pot on the ground, filled with soil, of this height and radius of its rim.
pub fn pot(sketch: &mut Sketch, height_cm: f32, radius_cm: f32) {
    sketch.group("pot", "bare:pot");
    let profile = [
        (0.68, 0.0),
        (0.7, 0.0),
        (0.73, 0.03),
        (0.89, 0.72),
        (0.9, 0.755),
        (0.97, 0.76),
        (0.985, 0.775),
        (1.0, 0.98),
        (0.99, 1.0),
        (0.92, 1.0),
        (0.9, 0.88),
    ];
    let profile = profile.map(|(radius, height)| (radius * radius_cm, height * height_cm));
    sketch.turned(16, &profile, |p| p);
    sketch.group("soil", "bare:soil");
    sketch.disc(4, 1, |turns, rho| {
        let lump = 0.12 * jitter_at(turns, rho, 7);
        on_circle(turns, 0.91 * radius_cm * rho, 0.93 * height_cm + 0.3 * (1.0 - rho * rho) + lump)
    });
}
