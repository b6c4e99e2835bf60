//! Veins: lines on a surface, and how far a place lies from the nearest of them.

use super::{Mesh, Place, Shortest};
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// The veins of a mesh, cut into straight pieces.
#[derive(Clone, Debug, Default)]
pub struct Veins {
    pub(super) pieces: Vec<Piece>,
    /// The pieces that may be nearest to a place of a triangle, one triangle after the other.
    near: Vec<u32>,
    /// Where in `near` those of each triangle end.
    ends: Vec<u32>,
}

/// A straight piece of a vein in space, or of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// 1 for a midrib, 2 for a vein that leaves it, and so on; for strokes see `STROKES`.
    pub order: u32,
    pub ends: [Vec3; 2],
}

/// From this order on lines are no veins but strokes of a brush. `STROKES` times the number of a layer, from 1 on, is
/// the order of the whole layer, and what a line has more is the radius of the brush in thousandths of a centimetre;
/// none stands for the whole part that it lies on. A layer counts without the veins and the layers below it, its
/// distances are in radii, and it reaches no skin but that which it lies on: neither other parts nor the other side
/// of what is thin.
pub const STROKES: u32 = 100_000;
/// Beyond so many radii no stroke is looked for.
const STROKE_REACH: f32 = 2.0;

/// How an image lies by the distance from veins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AlongVeins {
    /// Veins up to this order count, from 1 on.
    pub order: u32,
    /// From the veins, the bottom of the image, to its top.
    pub reach_cm: f32,
}

impl Piece {
    fn distance_cm(&self, point: Vec3) -> f32 {
        let [from, to] = self.ends;
        let (along, way) = (to - from, point - from);
        // A piece without length is a point.
        let share = way.dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
        (way - along * share.clamp(0.0, 1.0)).length()
    }

    /// What distances are measured in: centimetres for veins.
    fn unit_cm(&self) -> f32 {
        match self.order % STROKES {
            _ if self.order < STROKES => 1.0,
            0 => f32::INFINITY,
            thousandths => thousandths as f32 * 0.001,
        }
    }

    /// The triangle of which its middle is nearest, if it is of a stroke.
    fn skin(&self, mesh: &Mesh) -> u32 {
        let middle = (self.ends[0] + self.ends[1]) * 0.5;
        let distance = |t: &u32| mesh.centroid(*t).distance_squared(middle);
        let all = 0..if self.order < STROKES { 0 } else { mesh.triangles.len() as u32 };
        all.min_by(|s, t| distance(s).total_cmp(&distance(t))).unwrap_or(0)
    }

    /// Whether it is one of those that an order asks for.
    fn counts(&self, order: u32) -> bool {
        match order {
            ..STROKES => self.order <= order,
            _ => self.order / STROKES == order / STROKES,
        }
    }
}

impl Veins {
    pub(super) fn new(pieces: Vec<Piece>, mesh: &Mesh) -> Veins {
        let mut veins = Veins { pieces, ..Veins::default() };
        if veins.pieces.is_empty() {
            return veins;
        }
        let all: Vec<u32> = (0..veins.pieces.len() as u32).collect();
        let triangles: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
        let skins: Vec<u32> = veins.pieces.iter().map(|piece| piece.skin(mesh)).collect();
        // Triangles that follow each other mostly lie side by side.
        for block in triangles.chunks(64) {
            let corners: Vec<Vec3> = block.iter().flat_map(|&t| mesh.corners(t)).collect();
            let of_block = veins.close_to(&corners, &all);
            for &triangle in block {
                let mut near = veins.close_to(&mesh.corners(triangle), &of_block);
                near.retain(|&k| veins.is_of(mesh, k as usize, skins[k as usize], triangle));
                veins.near.extend(near);
                veins.ends.push(veins.near.len() as u32);
            }
        }
        veins
    }

    /// Whether a triangle, which is near, is of the skin that a piece lies on, given by the triangle below it.
    fn is_of(&self, mesh: &Mesh, piece: usize, skin: u32, triangle: u32) -> bool {
        let Piece { order, .. } = self.pieces[piece];
        let normal = |of: u32| {
            let [a, b, c] = mesh.corners(of);
            (b - a).cross(c - a)
        };
        order < STROKES
            || mesh.parts[skin as usize] == mesh.parts[triangle as usize]
                && (order % STROKES == 0 || normal(skin).dot(normal(triangle)) > 0.0)
    }

    /// Those of some pieces that may be nearest, of all up to some order, to a place between corners. A place
    /// is at most a radius nearer to one piece than the centre is, and farther from another one; a little
    /// more for rounding.
    fn close_to(&self, corners: &[Vec3], among: &[u32]) -> Vec<u32> {
        let centre = corners.iter().sum::<Vec3>() / corners.len() as f32;
        let radius = corners.iter().map(|p| p.distance(centre)).fold(0.0, f32::max);
        let pieces: Vec<(u32, u32, f32)> = among
            .iter()
            .map(|&k| {
                (k, self.pieces[k as usize].order, self.pieces[k as usize].distance_cm(centre))
            })
            .collect();
        let mut farthest: Vec<(u32, f32)> = Vec::new();
        let mut close = Vec::new();
        for &(k, order, distance) in &pieces {
            let known = farthest.iter().find(|(of, _)| *of == order).map(|(_, cm)| *cm);
            let farthest_cm = known.unwrap_or_else(|| {
                if order >= STROKES {
                    return STROKE_REACH * self.pieces[k as usize].unit_cm() + 1.001 * radius;
                }
                let up_to = pieces.iter().filter(|piece| piece.1 <= order);
                let nearest = up_to.fold(f32::INFINITY, |least, piece| least.min(piece.2));
                farthest.push((order, nearest + 2.001 * radius));
                nearest + 2.001 * radius
            });
            if distance <= farthest_cm {
                close.push(k);
            }
        }
        close
    }

    /// How far a place lies from the nearest vein up to an order, straight through space; infinitely far
    /// where there is none. From the strokes of a layer in radii, and infinitely far beyond `STROKE_REACH`.
    pub fn distance_cm(&self, mesh: &Mesh, place: Place, order: u32) -> f32 {
        let point = mesh.point(place);
        let of = self.near(place.triangle, order);
        of.fold(f32::INFINITY, |least, piece| least.min(piece.distance_cm(point) / piece.unit_cm()))
    }

    /// The way, in space, of the piece up to an order that is nearest to a place; the first of several.
    pub(super) fn way(&self, mesh: &Mesh, place: Place, order: u32) -> Option<Vec3> {
        let point = mesh.point(place);
        let distance_cm = |piece: &&Piece| piece.distance_cm(point);
        let of = self.near(place.triangle, order);
        let nearest = of.min_by(|a, b| distance_cm(a).total_cmp(&distance_cm(b)))?;
        Some(nearest.ends[1] - nearest.ends[0])
    }

    /// Whether a vein up to an order passes between the centres of two triangles beside each other, seen from
    /// above both of them.
    pub fn part(&self, mesh: &Mesh, triangles: [u32; 2], order: u32) -> bool {
        let [a, b] = triangles.map(|triangle| mesh.centroid(triangle));
        let normal = |triangle| {
            let [a, b, c] = mesh.corners(triangle);
            (b - a).cross(c - a)
        };
        let up = normal(triangles[0]) + normal(triangles[1]);
        let is_left = |from: Vec3, to: Vec3, p: Vec3| (to - from).cross(p - from).dot(up) >= 0.0;
        // What runs above or below on another leaf is farther off.
        let (middle, apart_cm) = ((a + b) * 0.5, a.distance(b));
        let mut near = triangles.into_iter().flat_map(|triangle| self.near(triangle, order));
        near.any(|piece| {
            let [from, to] = piece.ends;
            is_left(a, b, from) != is_left(a, b, to)
                && is_left(from, to, a) != is_left(from, to, b)
                && piece.distance_cm(middle) < apart_cm
        })
    }

    /// The pieces up to an order that may be nearest to a place of a triangle.
    fn near(&self, triangle: u32, order: u32) -> impl Iterator<Item = &Piece> {
        let end = self.ends.get(triangle as usize).copied().unwrap_or(0);
        let start = triangle.checked_sub(1).and_then(|t| self.ends.get(t as usize).copied());
        let pieces = self.near[start.unwrap_or(0).min(end) as usize..end as usize].iter();
        pieces.map(|&k| &self.pieces[k as usize]).filter(move |piece| piece.counts(order))
    }

    /// Whether there is a vein up to an order.
    pub fn any(&self, order: u32) -> bool {
        self.pieces.iter().any(|piece| piece.counts(order))
    }
}

impl AlongVeins {
    /// Whether its numbers are in their ranges; else what is wrong, in words.
    pub fn check(&self) -> Result<(), String> {
        match (self.order, self.reach_cm) {
            (0, _) => Err("order is 0: veins are of order 1 and more".into()),
            (_, 0.001..=1000.0) => Ok(()),
            (_, reach) => {
                Err(format!("reach_cm is {}: it must be from 0.001 to 1000", reach.shortest()))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::icosphere;

    /// Numbers from -1 to 1 in no order.
    fn scattered(k: u32) -> f32 {
        (k.wrapping_mul(2_654_435_761) >> 8) as f32 / (1 << 23) as f32 - 1.0
    }

    #[test]
    fn the_nearest_vein_is_found_among_all_of_them() {
        let mesh = icosphere(3, 10.0);
        let point = |k: u32| 10.0 * Vec3::from([0, 1, 2].map(|axis| scattered(3 * k + axis)));
        let pieces: Vec<Piece> = (0..120)
            .map(|k| Piece { order: 1 + k % 3, ends: [point(2 * k), point(2 * k + 1)] })
            .collect();
        let veins = Veins::new(pieces.clone(), &mesh);
        for k in 0..4_000 {
            let b1 = 0.5 + 0.5 * scattered(7 * k);
            let place = Place {
                triangle: k % mesh.triangles.len() as u32,
                b1,
                b2: (1.0 - b1) * (0.5 + 0.5 * scattered(7 * k + 1)),
            };
            for order in 0..=4 {
                let of = pieces.iter().filter(|piece| piece.order <= order);
                let all = of.map(|piece| piece.distance_cm(mesh.point(place)));
                let nearest = all.fold(f32::INFINITY, f32::min);
                assert_eq!(veins.distance_cm(&mesh, place, order), nearest, "{place:?}");
            }
        }
        // Few are looked at.
        assert!(veins.near.len() < pieces.len() * mesh.triangles.len() / 4);
    }

    #[test]
    fn distances_are_those_from_lines_with_ends() {
        let piece = Piece { order: 1, ends: [Vec3::ZERO, 4.0 * Vec3::X] };
        for (point, distance_cm) in
            [([1.0, 3.0, 4.0], 5.0), ([7.0, 0.0, 4.0], 5.0), ([-3.0, 4.0, 0.0], 5.0)]
        {
            assert_eq!(piece.distance_cm(Vec3::from(point)), distance_cm);
        }
        let dot = Piece { order: 1, ends: [Vec3::ONE; 2] };
        assert_eq!(dot.distance_cm(Vec3::new(1.0, 1.0, 3.0)), 2.0);
    }
}
