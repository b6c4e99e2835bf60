//! A twig of a sycamore: leaves of five lobes by the rule of `shapes::leaf`, laid as one part between each two
//! main veins, so that no clone crosses those.

use super::sketch::Sketch;
use crate::shapes::leaf::{Border, LeafNumbers, LeafPlan, Length, Lobe};
use crate::surface::PolygonMesh;
use glam::{DVec2, Vec3};

/// How a leaf is held: where its petiole leaves the twig and where it meets the blade, the direction of the
/// middle lobe and of the upper side, its size, and which individual of the rule it is.
struct Held {
    foot: Vec3,
    base: Vec3,
    along: Vec3,
    up: Vec3,
    size: f32,
    individual: u32,
}

const TWIG: [Vec3; 5] = [
    Vec3::new(0.5, 0.0, -0.6),
    Vec3::new(0.3, 4.0, -0.7),
    Vec3::new(0.1, 9.0, -0.8),
    Vec3::new(0.0, 14.4, -0.8),
    Vec3::new(0.1, 15.6, -0.7),
];

const LEAVES: [Held; 3] = [
    Held {
        foot: TWIG[3],
        base: Vec3::new(0.2, 19.0, 0.6),
        along: Vec3::new(0.06, 0.95, 0.0),
        up: Vec3::new(0.0, 0.1, 1.0),
        size: 1.45,
        individual: 1,
    },
    Held {
        foot: TWIG[2],
        base: Vec3::new(-6.6, 12.4, 2.6),
        along: Vec3::new(-0.75, -0.28, 0.3),
        up: Vec3::new(-0.15, 0.5, 0.87),
        size: 1.32,
        individual: 2,
    },
    Held {
        foot: TWIG[2],
        base: Vec3::new(7.0, 11.6, 2.6),
        along: Vec3::new(0.72, -0.36, 0.3),
        up: Vec3::new(0.15, 0.5, 0.87),
        size: 1.38,
        individual: 3,
    },
];

/// Rows between neighbouring lobes, from the leafstalk to where their borders part.
const COMMON: usize = 4;
/// Between these and a main vein: more than side veins have, so that corners are not too sharp.
const ROW_RAD: f64 = 1.1;

fn numbers() -> LeafNumbers {
    LeafNumbers {
        lobes: 5,
        nodes: 7,
        nodes_kept: 0.85,
        lobe_deg: 46.0,
        secondary_deg: 44.0,
        length: Length::Logarithmic { a_cm: 0.7, b_cm: 0.15 },
        secondary_scale: 1.75,
        base: 1.0,
        tip: 0.1,
        border: Border::Polygon,
        irregularity: 0.08,
        ..LeafNumbers::default()
    }
}

pub fn grow() -> PolygonMesh {
    let mut sketch = Sketch::default();
    let leaves = LEAVES.map(Leaf::new);
    for (k, leaf) in leaves.iter().enumerate() {
        leaf.lay(&mut sketch, k);
    }
    sketch.group("veins", "bare:vein");
    leaves.iter().for_each(|leaf| leaf.ribs(&mut sketch));
    sketch.group("petioles", "bare:petiole");
    for Leaf { held, .. } in &leaves {
        let sag = Vec3::Y * (-0.05 * held.foot.distance(held.base));
        let middle = held.foot.lerp(held.base, 0.5) + sag;
        let end = held.base - held.up() * 0.1;
        sketch.tube(5, &[(held.foot, 0.26), (middle, 0.17), (end, 0.16)]);
    }
    sketch.group("twig", "bare:bark");
    let path: Vec<_> = TWIG.into_iter().zip([0.5, 0.45, 0.38, 0.3, 0.16]).collect();
    sketch.tube(6, &path);
    sketch.mesh
}

impl Held {
    fn up(&self) -> Vec3 {
        let along = self.along.normalize();
        (self.up - along * along.dot(self.up)).normalize()
    }
}

struct Leaf {
    held: Held,
    plan: LeafPlan,
    /// The rows of each lobe, those between lobes first.
    rows: Vec<Vec<Row>>,
}

/// A row of polygons from a main vein to the border on either side.
struct Row {
    /// How far from the leafstalk it starts.
    foot: f64,
    /// Where on the border it ends, in nodes from the leafstalk: half-way between two is a notch. Elsewhere
    /// it ends where it comes to.
    tooth: Option<f64>,
}

impl Leaf {
    fn new(held: Held) -> Leaf {
        let plan = LeafPlan::new(&numbers(), held.individual).expect("numbers in their ranges");
        let parting = plan.lobes.windows(2).map(|pair| {
            // Where the borders of both meet the line in the middle.
            let meet = [(&pair[0], 1), (&pair[1], 0)].map(|(lobe, side)| {
                let slope = libm::tan(0.5 * pair[0].axis.angle_to(pair[1].axis).abs());
                let mut ends = along_border(lobe, side);
                ends.find(|end| end.x < slope * end.y).expect("a lobe has a tip").length()
            });
            meet[0].min(meet[1]) / between(&pair[0], &pair[1])
        });
        let parting = parting.fold(f64::INFINITY, f64::min);
        let rows = plan.lobes.iter().map(|lobe| {
            let common = (1..=COMMON).map(|k| parting * k as f64 / COMMON as f64);
            let mut rows: Vec<Row> = common.map(|foot| Row { foot, tooth: None }).collect();
            // Beyond, a row to the point of each tooth and one to the notch before the next.
            let nodes = 1..lobe.feet.len() - 1;
            for at in nodes.flat_map(|k| [k as f64, k as f64 + 0.5]) {
                let feet = [0, 1].map(|side| foot_of(border(lobe, side, at)));
                let foot = 0.5 * (feet[0] + feet[1]);
                let last = rows[rows.len() - 1].foot;
                // The first one not too near to the cleft.
                let apart = if rows.len() == COMMON { 0.7 } else { 0.38 };
                if foot > last + apart && at < lobe.feet.len() as f64 - 2.0 {
                    rows.push(Row { foot, tooth: Some(at) });
                }
            }
            rows
        });
        let rows = rows.collect();
        Leaf { held, plan, rows }
    }

    /// From the flat leaf into space: the midrib bends back, and the blade bulges between its main veins.
    fn place(&self, p: DVec2) -> Vec3 {
        let Held { base, along, size, .. } = &self.held;
        let (along, up) = (along.normalize(), self.held.up());
        let side = along.cross(up);
        let of_axis =
            |axis: DVec2| if axis.dot(p) > 0.0 { axis.perp_dot(p).abs() } else { p.length() };
        let from_vein =
            self.plan.lobes.iter().map(|lobe| of_axis(lobe.axis)).fold(f64::INFINITY, f64::min);
        let (x, y) = (p.x as f32, p.y as f32);
        let bulge = 0.2 * from_vein as f32 - 0.013 * p.length_squared() as f32;
        let radius_cm = 22.0;
        let angle_rad = y / radius_cm;
        let (sin, cos) = (libm::sinf(angle_rad), libm::cosf(angle_rad));
        let flat =
            along * ((radius_cm + bulge) * sin) + up * ((radius_cm + bulge) * cos - radius_cm);
        *base + (flat + side * x) * *size
    }

    /// A row of the right half of a lobe (side 1) or its left half (0) from the main vein to the border.
    fn row(&self, sketch: &mut Sketch, lobe: usize, side: usize, number: usize) -> Vec<u32> {
        let Row { foot, tooth } = self.rows[lobe][number];
        let lobe_plan = &self.plan.lobes[lobe];
        let mut out = match tooth {
            Some(at) => border(lobe_plan, side, at),
            None => along_border(lobe_plan, side)
                .find(|end| foot_of(*end) >= foot)
                .expect("a lobe has a tip"),
        };
        if tooth.is_some_and(|at| at.fract() > 0.0) {
            out.x *= 0.87;
        }
        // Well away from the neighbour, so that there is a cleft between two lobes.
        let neighbour = (lobe + 2 * side).checked_sub(1).and_then(|k| self.plan.lobes.get(k));
        if let (Some(_), Some(neighbour)) = (tooth, neighbour) {
            let slope = libm::tan(0.5 * lobe_plan.axis.angle_to(neighbour.axis).abs());
            out.x = out.x.min(0.76 * slope * out.y);
        }
        let foot = DVec2::new(0.0, foot);
        shares(foot.distance(out))
            .map(|share| self.vertex(sketch, lobe, side, foot.lerp(out, share)))
            .collect()
    }

    /// A point of a half: the distance from the main vein, and that along it.
    fn vertex(&self, sketch: &mut Sketch, lobe: usize, side: usize, p: DVec2) -> u32 {
        let from_vein = if side == 1 { p.x } else { -p.x };
        sketch.vertex(self.place(self.plan.lobes[lobe].point(from_vein, p.y)))
    }

    fn lay(&self, sketch: &mut Sketch, number: usize) {
        sketch.group(&format!("leaf {}", number + 1), "blade");
        // Vertices in which parts meet stay where they are when rims are rounded.
        let stalk = sketch.vertex(self.place(DVec2::ZERO));
        let lobes = self.plan.lobes.len();
        let tips: Vec<u32> = (0..lobes)
            .map(|lobe| {
                let tip = self.plan.lobes[lobe].corners[0].last().expect("a border has corners").y;
                self.vertex(sketch, lobe, 0, DVec2::new(0.0, tip))
            })
            .collect();
        // What is left of the first lobe and right of the last one.
        for (lobe, side) in [(0, 0), (lobes - 1, 1)] {
            self.go_on(sketch, (lobe, side), vec![stalk], 0, tips[lobe]);
        }
        for lobe in 0..lobes - 1 {
            let [a, b] = [&self.plan.lobes[lobe], &self.plan.lobes[lobe + 1]];
            let middle = (a.axis + b.axis).normalize();
            // From either main vein to the line in the middle.
            let mut last = [vec![stalk], vec![stalk]];
            for k in 0..COMMON {
                let foot = self.rows[lobe][k].foot;
                let meet = middle * (between(a, b) * foot);
                let met = sketch.vertex(self.place(meet));
                for (half, axis) in [a.axis, b.axis].into_iter().enumerate() {
                    let foot = axis * foot;
                    let inner = shares(foot.distance(meet)).filter(|share| *share < 1.0);
                    let row: Vec<u32> = inner
                        .map(|share| sketch.vertex(self.place(foot.lerp(meet, share))))
                        .chain([met])
                        .collect();
                    sketch.strip(&last[half], &row, half == 1);
                    last[half] = row;
                }
            }
            let [of_a, of_b] = last;
            self.go_on(sketch, (lobe, 1), of_a, COMMON, tips[lobe]);
            self.go_on(sketch, (lobe + 1, 0), of_b, COMMON, tips[lobe + 1]);
        }
    }

    /// The rows of half a lobe from a number on, behind the last one, up to the tip.
    fn go_on(
        &self,
        sketch: &mut Sketch,
        half: (usize, usize),
        last: Vec<u32>,
        from: usize,
        tip: u32,
    ) {
        let (lobe, side) = half;
        let mut last = last;
        for number in from..self.rows[lobe].len() {
            let row = self.row(sketch, lobe, side, number);
            sketch.strip(&last, &row, side == 0);
            last = row;
        }
        sketch.strip(&last, &[tip], side == 0);
    }

    /// The main veins, over the seams between the parts.
    fn ribs(&self, sketch: &mut Sketch) {
        for lobe in &self.plan.lobes {
            let tip = lobe.feet[lobe.feet.len() - 1];
            let path = [0.0, 0.2, 0.4, 0.6, 0.8, 0.97]
                .map(|share| (self.place(lobe.axis * (tip * share)), 0.1 - 0.07 * share as f32));
            sketch.tube(4, &path);
        }
    }
}

/// Where the vertices of a row of this length stand, from 0 to 1.
fn shares(length_cm: f64) -> impl Iterator<Item = f64> {
    let columns = (length_cm - 0.4).ceil().clamp(1.0, 4.0) as u32;
    (0..=columns).map(move |c| f64::from(c) / f64::from(columns))
}

/// A point of the border of half a lobe, in nodes from the leafstalk; straight between the corners.
fn border(lobe: &Lobe, side: usize, at: f64) -> DVec2 {
    let corners = &lobe.corners[side];
    let k = (at as usize).min(corners.len() - 2);
    corners[k].lerp(corners[k + 1], at - k as f64)
}

fn along_border(lobe: &Lobe, side: usize) -> impl Iterator<Item = DVec2> {
    let nodes = lobe.corners[side].len() - 1;
    (1..=32 * nodes).map(move |k| border(lobe, side, k as f64 / 32.0))
}

/// Where on the main vein a row starts that ends at a point of the border.
fn foot_of(end: DVec2) -> f64 {
    end.y - end.x / libm::tan(ROW_RAD)
}

/// How far from the leafstalk rows of two neighbours meet on the line in the middle, by the distance of
/// their feet.
fn between(a: &Lobe, b: &Lobe) -> f64 {
    let half = 0.5 * a.axis.angle_to(b.axis).abs();
    libm::sin(ROW_RAD) / libm::sin(ROW_RAD - half)
}
