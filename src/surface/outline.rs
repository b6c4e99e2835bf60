//! The convex polygon around a patch, to tell what lies near it.

use super::lengths::normalized;
use glam::Vec2;
use wide::f32x4;

/// A convex polygon around points of a plane.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// The lowest and the highest coordinates.
    pub low: Vec2,
    pub high: Vec2,
    /// For four edges each x and y of their unit normals, outwards, and how far out they lie along
    /// them.
    edges: Vec<[f32x4; 3]>,
}

impl Outline {
    pub(super) fn around(points: impl Iterator<Item = Vec2>) -> Outline {
        let corners = hull(points);
        let edges = corners.windows(2).filter(|pair| pair[0] != pair[1]).map(|pair| {
            let normal = -normalized((pair[1] - pair[0]).perp());
            [normal.x, normal.y, normal.dot(pair[0])]
        });
        let edges: Vec<[f32; 3]> = edges.collect();
        // Everything lies within the edges that fill the last four up.
        let fours = edges
            .chunks(4)
            .map(|edges| columns(|k| edges.get(k).copied().unwrap_or([0.0, 0.0, f32::INFINITY])));
        Outline {
            edges: fours.collect(),
            low: corners.iter().copied().fold(Vec2::INFINITY, Vec2::min),
            high: corners.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max),
        }
    }

    /// Whether the convex hull of some points comes within `reach` of each edge's line: true for all
    /// that come within reach of the polygon, and for some beyond its corners.
    #[inline]
    pub fn is_within(&self, reach: f32, points: &[Vec2]) -> bool {
        let reach = f32x4::splat(reach);
        self.edges.iter().all(|&[x, y, out]| {
            let near = points
                .iter()
                .fold(f32x4::ZERO, |near, p| near | (x * p.x + y * p.y - out).simd_le(reach));
            near.to_bitmask() == 0b1111
        })
    }
}

/// The corners of the convex hull, the first again at the end (A. M. Andrew, Another efficient algorithm
/// for convex hulls in two dimensions, Information Processing Letters 9, 1979).
fn hull(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let from_left = |p: Vec2| u64::from(ordinal(p.x)) << 32 | u64::from(ordinal(p.y));
    let mut numbers: Vec<u64> = points.map(from_left).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let points: Vec<Vec2> = numbers
        .into_iter()
        .map(|number| Vec2::new(number_of((number >> 32) as u32), number_of(number as u32)))
        .collect();
    let mut hull: Vec<Vec2> = Vec::new();
    for pass in 0..2 {
        let done = hull.len() + 1 - pass;
        for k in 0..points.len() {
            let p = points[if pass == 0 { k } else { points.len() - 1 - k }];
            while hull.len() > done
                && (hull[hull.len() - 1] - hull[hull.len() - 2]).perp_dot(p - hull[hull.len() - 1])
                    <= 0.0
            {
                hull.pop();
            }
            hull.push(p);
        }
    }
    hull
}

/// Three columns of four rows.
fn columns(row: impl Fn(usize) -> [f32; 3]) -> [f32x4; 3] {
    let rows: [[f32; 3]; 4] = std::array::from_fn(row);
    std::array::from_fn(|column| f32x4::new(rows.map(|row| row[column])))
}

/// An integer that orders as the number does.
fn ordinal(number: f32) -> u32 {
    let bits = number.to_bits();
    if number.is_sign_negative() { !bits } else { bits | 1 << 31 }
}

/// The number of an ordinal.
fn number_of(ordinal: u32) -> f32 {
    f32::from_bits(if ordinal >> 31 == 0 { !ordinal } else { ordinal & !(1 << 31) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from 0 to 1 that look like chance (a Weyl sequence).
    fn chance(k: u32, purpose: f64) -> f32 {
        (f64::from(k) * purpose).fract() as f32
    }

    fn clouds() -> Vec<Vec<Vec2>> {
        let square = |k: u32| Vec2::new(chance(k, 0.754_877_666), chance(k, 0.569_840_291));
        let shapes: [fn(Vec2) -> Vec2; 5] = [
            |p| p,
            |p| {
                let (sin, cos) = libm::sincosf(6.3 * p.x);
                Vec2::new(cos, sin) * (0.3 + 0.7 * p.y)
            },
            |p| Vec2::new(p.x, 1e-3 * p.y),
            |p| Vec2::new(p.x - p.y, p.x * p.y),
            // Corners of many triangles, some laid down twice with a rounding between them.
            |p| (p * 8.0).floor() + (p * 64.0).fract().round() * 1e-6,
        ];
        let cloud = |shape: fn(Vec2) -> Vec2, n| (0..n).map(|k| shape(square(k))).collect();
        shapes.iter().flat_map(|&shape| [3, 4, 9, 60, 900].map(|n| cloud(shape, n))).collect()
    }

    #[test]
    fn a_hull_holds_all_points_and_turns_left_at_each_of_its_corners() {
        for cloud in clouds() {
            let corners = hull(cloud.iter().copied());
            assert_eq!(corners.first(), corners.last());
            let leftness = |e: &[Vec2], p: Vec2| (e[1] - e[0]).perp_dot(p - e[1]);
            for edge in corners.windows(2) {
                assert!(cloud.contains(&edge[0]));
                assert!(cloud.iter().all(|&p| leftness(edge, p) > -1e-6), "{corners:?}");
            }
            assert!(corners.windows(3).all(|three| leftness(three, three[2]) > 0.0));
        }
    }

    #[test]
    fn what_lies_within_reach_of_all_edges_is_near() {
        for cloud in clouds() {
            let (corners, outline) =
                (hull(cloud.iter().copied()), Outline::around(cloud.into_iter()));
            for k in 0..400 {
                let p = 3.0 * Vec2::new(chance(k, 0.618_033_989), chance(k, 0.414_213_562)) - 1.0;
                let reach = chance(k, 0.732_050_808) - 0.2;
                let is_near = corners.windows(2).filter(|e| e[0] != e[1]).all(|e| {
                    let normal = -normalized((e[1] - e[0]).perp());
                    normal.dot(p) - normal.dot(e[0]) <= reach
                });
                assert_eq!(outline.is_within(reach, &[p]), is_near);
            }
        }
    }

    #[test]
    fn a_point_is_its_own_outline() {
        let point = Vec2::new(0.3, -2.0);
        let outline = Outline::around([point; 5].into_iter());
        assert_eq!((outline.low, outline.high), (point, point));
    }
}
