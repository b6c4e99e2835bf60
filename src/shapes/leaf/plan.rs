//! A leaf flat on the table: its lobes and veins, in centimetres, the leafstalk in the origin and the lobe
//! in the middle along `y`. Right is `x > 0`.

use super::LeafNumbers;
use super::border::{corners, curve};
use crate::shapes::ShapeError;
use crate::shapes::chance::{Purpose, either_way, part_key, root_key};
use glam::DVec2;

/// Lobes and veins, without the triangles between them.
#[derive(Clone, Debug)]
pub struct LeafPlan {
    /// From the left to the right.
    pub lobes: Vec<Lobe>,
    /// First the main veins, as the lobes stand, then the secondary ones.
    pub veins: Vec<Vein>,
}

/// A main vein and what is around it.
#[derive(Clone, Debug)]
pub struct Lobe {
    /// How many lobes lie between this one and the middle, under 0 on the left: 0 is the middle itself.
    pub place: i32,
    /// Unit vector along the main vein.
    pub axis: DVec2,
    /// Distances from the leafstalk to the nodes of the main vein, the leafstalk itself first and the tip last.
    pub feet: Vec<f64>,
    /// Sine and cosine of the angle between main and secondary veins.
    pub secondary: DVec2,
    /// Corners of the border from the leafstalk to the tip, of the left half and of the right one: as `x` the
    /// distance from the main vein, as `y` that along it.
    pub corners: [Vec<DVec2>; 2],
    /// The same with its sides curved as the border says.
    pub sides: [Vec<DVec2>; 2],
}

/// A vein from where it starts to where it ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Vein {
    pub lobe: u32,
    /// The node of the main vein that a secondary vein starts from; of main veins 0.
    pub node: u32,
    /// Left or right of the main vein; of main veins neither.
    pub right: Option<bool>,
    /// At least two points; of a main vein its nodes.
    pub path: Vec<DVec2>,
}

impl LeafPlan {
    /// The leaf of these numbers, `individual` for the chance in it.
    ///
    /// # Errors
    /// Numbers out of their range.
    pub fn new(numbers: &LeafNumbers, individual: u32) -> Result<LeafPlan, ShapeError> {
        numbers.check()?;
        let middle = numbers.lobes as i32 / 2;
        let mut lobes: Vec<Lobe> =
            (-middle..=middle).map(|place| Lobe::new(numbers, place, individual)).collect();
        // Curves have points as far apart as the corners of the triangles that fill the blade.
        let area: f64 = lobes.iter().map(|lobe| area(&lobe.outline(&lobe.corners))).sum();
        let spacing_cm = spacing(area, numbers.triangles);
        for lobe in &mut lobes {
            lobe.sides =
                lobe.corners.each_ref().map(|half| curve(half, numbers.border, spacing_cm));
        }
        let mut veins: Vec<Vein> = (0..).zip(&lobes).map(|(k, lobe)| lobe.main_vein(k)).collect();
        for (k, lobe) in (0..).zip(&lobes) {
            veins.extend(lobe.secondary_veins(k, numbers.border_factor));
        }
        let mut plan = LeafPlan { lobes, veins };
        plan.cut_crossing_veins();
        Ok(plan)
    }

    /// All veins together.
    pub fn vein_length(&self) -> f64 {
        let of_vein = |vein: &Vein| -> f64 {
            vein.path.windows(2).map(|ends| ends[0].distance(ends[1])).sum()
        };
        self.veins.iter().map(of_vein).sum()
    }

    /// Where two veins cross, an end goes (the source): a main vein is never cut, and of two secondary ones it
    /// is that of the outer lobe, or both where the lobes are equally far out.
    fn cut_crossing_veins(&mut self) {
        let (main, secondary) = self.veins.split_at_mut(self.lobes.len());
        for vein in secondary.iter_mut() {
            let others = main.iter().filter(|other| other.lobe != vein.lobe);
            let pieces = others.flat_map(|other| other.path.windows(2));
            cut(&mut vein.path, pieces.map(|ends| [ends[0], ends[1]]));
        }
        let rank = |vein: &Vein| self.lobes[vein.lobe as usize].place.abs();
        for out in 1..=self.lobes.len() as i32 / 2 {
            let before: Vec<Vein> =
                secondary.iter().filter(|vein| rank(vein) <= out).cloned().collect();
            for vein in secondary.iter_mut().filter(|vein| rank(vein) == out) {
                let others = before.iter().filter(|other| other.lobe != vein.lobe);
                cut(&mut vein.path, others.map(|other| [other.path[0], other.path[1]]));
            }
        }
    }
}

/// What is inside a polygon that runs counter-clockwise.
pub(super) fn area(polygon: &[DVec2]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| 0.5 * a.perp_dot(*b)).sum()
}

/// Side of an even triangle of which so many fill an area.
pub(super) fn spacing(area_cm2: f64, triangles: u32) -> f64 {
    (4.0 / 3f64.sqrt() * area_cm2 / f64::from(triangles)).sqrt()
}

/// A share that grows to 1 half-way, ever slower.
fn rounded(at_end: f64, from_end: f64) -> f64 {
    let share = (2.0 * from_end).min(1.0);
    at_end + (1.0 - at_end) * share * (2.0 - share)
}

/// Ends a straight vein where it first meets one of the pieces.
fn cut(path: &mut [DVec2], pieces: impl Iterator<Item = [DVec2; 2]>) {
    let [from, to] = [path[0], path[1]];
    let share = pieces.filter_map(|piece| crossing([from, to], piece)).fold(1.0, f64::min);
    if share < 1.0 {
        path[1] = from + (to - from) * share;
    }
}

/// How far along the first piece the second one crosses it, as a share over 0; ends count.
fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<f64> {
    let (along, other) = (b - a, d - c);
    let turn = along.perp_dot(other);
    let share = (c - a).perp_dot(other) / turn;
    let of_other = (c - a).perp_dot(along) / turn;
    (share > 1e-9 && share <= 1.0 && (0.0..=1.0).contains(&of_other)).then_some(share)
}

impl Lobe {
    fn new(numbers: &LeafNumbers, place: i32, individual: u32) -> Lobe {
        // The left has the same key whatever the number of lobes.
        let key = part_key(root_key(individual), (place + 100) as u32);
        let irregular = numbers.irregularity;
        let size = 1.0 + 0.5 * irregular * either_way(key, Purpose::Length);
        let out = f64::from(place.abs());
        let nodes = f64::from(numbers.nodes) * libm::pow(numbers.nodes_kept, out);
        let nodes = (nodes.round() as u32).max(2);
        let mut feet = vec![0.0];
        for steps in (1..=nodes).rev() {
            feet.push(feet[feet.len() - 1] + size * numbers.length.of(steps));
        }
        let radians = numbers.secondary_deg.to_radians();
        let secondary = DVec2::new(libm::sin(radians), libm::cos(radians));
        let corners = [0, 1].map(|side| {
            let lengths: Vec<f64> = (1..nodes)
                .map(|node| {
                    let by_chance = either_way(part_key(key, 2 * node + side), Purpose::Length);
                    let height = feet[node as usize] / feet[nodes as usize];
                    let full = rounded(numbers.base, height) * rounded(numbers.tip, 1.0 - height);
                    let length = size * numbers.length.of(nodes - node) * numbers.secondary_scale;
                    length * full * (1.0 + irregular * by_chance)
                })
                .collect();
            corners(&feet, &lengths, secondary, numbers.border_factor)
        });
        let sides = corners.clone();
        let turn = out * numbers.lobe_deg
            + numbers.lobe_deg * 0.25 * irregular * either_way(key, Purpose::Angle);
        // The middle goes astray to either side, the others as they stand.
        let axis = DVec2::new(libm::sin(turn.to_radians()), libm::cos(turn.to_radians()));
        let axis = DVec2::new(if place < 0 { -axis.x } else { axis.x }, axis.y);
        Lobe { place, axis, feet, secondary, corners, sides }
    }

    /// A point at a distance from the main vein, under 0 on its left, and along it.
    pub fn point(&self, from_vein: f64, along: f64) -> DVec2 {
        // The right is a quarter turn clockwise.
        DVec2::new(
            self.axis.x * along + self.axis.y * from_vein,
            self.axis.y * along - self.axis.x * from_vein,
        )
    }

    /// The border of the whole lobe, counter-clockwise from the leafstalk on.
    pub fn outline(&self, [left, right]: &[Vec<DVec2>; 2]) -> Vec<DVec2> {
        let right = right.iter().map(|p| self.point(p.x, p.y));
        let left = left[1..left.len() - 1].iter().rev().map(|p| self.point(-p.x, p.y));
        right.chain(left).collect()
    }

    fn main_vein(&self, lobe: u32) -> Vein {
        let path = self.feet.iter().map(|&along| self.point(0.0, along)).collect();
        Vein { lobe, node: 0, right: None, path }
    }

    /// A left and a right one from each inner node.
    fn secondary_veins(&self, lobe: u32, border_factor: f64) -> Vec<Vein> {
        let mut veins = Vec::new();
        for node in 1..self.feet.len() - 1 {
            for (side, right) in [(0, false), (1, true)] {
                let foot = DVec2::new(0.0, self.feet[node]);
                let end = foot + (self.corners[side][node] - foot) / border_factor;
                let sign = if right { 1.0 } else { -1.0 };
                let path = vec![self.point(0.0, foot.y), self.point(sign * end.x, end.y)];
                veins.push(Vein { lobe, node: node as u32, right: Some(right), path });
            }
        }
        veins
    }
}
