//! Coordinates that belong to the leaf (Viennot et al. 1989, section 6: how leaves are coloured).

use super::{LeafPlan, Lobe};
use glam::{DVec2, Vec2};

/// Where a point lies in its leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeafPoint {
    /// Index into `LeafPlan::lobes`: the lobe in which the point lies deepest.
    pub lobe: u32,
    /// Whether it lies on the right of that lobe's main vein.
    pub right: bool,
    /// How far from the main vein to the border along the secondary veins, 0 to 1.
    pub affinity: f64,
    /// How far from the leafstalk to the border of the leaf, 0 to 1.
    pub homothety: f64,
}

impl LeafPlan {
    /// The coordinates of a point of the limb. The homothety ratio is continuous all over the leaf, the
    /// affinity ratio in each lobe.
    pub fn coordinates(&self, point: DVec2) -> LeafPoint {
        let mut deepest: Option<(f64, usize, Local)> = None;
        for (k, lobe) in self.lobes.iter().enumerate() {
            let local = lobe.local(point);
            let Some(ratio) = lobe.homothety(local) else { continue };
            let closer = deepest.as_ref().is_none_or(|(least, other, _)| {
                // Halves that mirror each other share their middle in a like way.
                ratio < *least
                    || ratio == *least && lobe.place.abs() < self.lobes[*other].place.abs()
            });
            if closer {
                deepest = Some((ratio, k, local));
            }
        }
        let Some((ratio, k, local)) = deepest else { return self.beside(point) };
        LeafPoint {
            lobe: k as u32,
            right: local.right,
            affinity: self.lobes[k].affinity(local),
            homothety: ratio.min(1.0),
        }
    }

    /// Texture coordinates of a place: `x` the affinity ratio, under 0 on the left of the leaf, `y` the homothety ratio.
    /// The lobe in the middle has a left and a right half, every other lobe lies on one side of the leaf.
    pub(super) fn uv(&self, at: &LeafPoint) -> Vec2 {
        let place = self.lobes[at.lobe as usize].place;
        let is_right = if place == 0 { at.right } else { place > 0 };
        let x = if is_right { at.affinity } else { -at.affinity };
        let short = |share: f64| (share * 1e5).round() / 1e5 + 0.0;
        DVec2::new(short(x), short(at.homothety)).as_vec2()
    }

    /// Of a point that rounding or a round tooth has put beside all lobes: on the rim of the nearest one.
    fn beside(&self, point: DVec2) -> LeafPoint {
        let angle = |lobe: &Lobe| lobe.axis.dot(point);
        let mut nearest = self.lobes.len() / 2;
        for (k, lobe) in self.lobes.iter().enumerate() {
            if angle(lobe) > angle(&self.lobes[nearest]) {
                nearest = k;
            }
        }
        let right = self.lobes[nearest].local(point).right;
        LeafPoint { lobe: nearest as u32, right, affinity: 1.0, homothety: 1.0 }
    }
}

/// A point in a half of a lobe: the distance from the main vein, and that along it.
#[derive(Clone, Copy)]
struct Local {
    right: bool,
    at: DVec2,
}

impl Lobe {
    fn local(&self, point: DVec2) -> Local {
        let from_vein = point.x * self.axis.y - point.y * self.axis.x;
        let along = point.x * self.axis.x + point.y * self.axis.y;
        Local { right: from_vein >= 0.0, at: DVec2::new(from_vein.abs(), along) }
    }

    fn side(&self, local: Local) -> &[DVec2] {
        &self.sides[usize::from(local.right)]
    }

    /// The distance from the leafstalk as a share of that to the border behind the point; nothing where the
    /// ray from the leafstalk through the point does not lie in this half.
    fn homothety(&self, local: Local) -> Option<f64> {
        let ray = local.at;
        let square = ray.length_squared();
        if square == 0.0 {
            return Some(0.0);
        }
        let mut farthest = 0.0f64;
        let side = self.side(local);
        let mut before = ray.perp_dot(side[0]);
        for ends in side.windows(2) {
            let behind = ray.perp_dot(ends[1]);
            if (before <= 0.0 && behind >= 0.0) || (before >= 0.0 && behind <= 0.0) {
                let share = if before == behind { 1.0 } else { before / (before - behind) };
                let crossed = ends[0] + (ends[1] - ends[0]) * share;
                farthest = farthest.max(crossed.dot(ray) / square);
            }
            before = behind;
        }
        (farthest > 0.0).then(|| 1.0 / farthest)
    }

    /// The distance from the main vein along the secondary veins as a share of that to the border.
    fn affinity(&self, local: Local) -> f64 {
        let oblique = |p: DVec2| {
            let out = p.x / self.secondary.x;
            DVec2::new(p.y - out * self.secondary.y, out)
        };
        let at = oblique(local.at);
        let mut widest = 0.0f64;
        let mut before = oblique(self.side(local)[0]);
        for &p in &self.side(local)[1..] {
            let behind = oblique(p);
            let (low, high) = (before.x.min(behind.x), before.x.max(behind.x));
            if low <= at.x && at.x <= high {
                let share =
                    if low == high { 1.0 } else { (at.x - before.x) / (behind.x - before.x) };
                widest = widest.max(before.y + (behind.y - before.y) * share);
            }
            before = behind;
        }
        // Beyond the ends of the main vein there is no width.
        match (at.y > 1e-9, widest > 0.0) {
            (false, _) => 0.0,
            (true, true) => (at.y / widest).min(1.0),
            (true, false) => 1.0,
        }
    }
}
