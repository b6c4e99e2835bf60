//! The convex polygon around a patch, to tell what lies near it.

use super::lengths::normalized;
use glam::Vec2;

/// A convex polygon around points of a plane.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// The lowest and the highest coordinates.
    pub low: Vec2,
    pub high: Vec2,
    /// For each edge its unit normal, outwards, and how far out it lies along it.
    edges: Vec<(Vec2, f32)>,
}

impl Outline {
    /// The convex hull (A. M. Andrew, Another efficient algorithm for convex hulls in two
    /// dimensions, Information Processing Letters 9, 1979).
    pub(super) fn around(mut points: Vec<Vec2>) -> Outline {
        points.sort_unstable_by_key(|p| u64::from(ordinal(p.x)) << 32 | u64::from(ordinal(p.y)));
        points.dedup();
        let mut hull: Vec<Vec2> = Vec::new();
        for pass in 0..2 {
            let done = hull.len() + 1 - pass;
            for k in 0..points.len() {
                let p = points[if pass == 0 { k } else { points.len() - 1 - k }];
                while hull.len() > done
                    && (hull[hull.len() - 1] - hull[hull.len() - 2])
                        .perp_dot(p - hull[hull.len() - 1])
                        <= 0.0
                {
                    hull.pop();
                }
                hull.push(p);
            }
        }
        let edges = hull.windows(2).filter(|pair| pair[0] != pair[1]).map(|pair| {
            let normal = -normalized((pair[1] - pair[0]).perp());
            (normal, normal.dot(pair[0]))
        });
        Outline {
            edges: edges.collect(),
            low: points.iter().copied().fold(Vec2::INFINITY, Vec2::min),
            high: points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max),
        }
    }

    /// Whether the convex hull of some points comes within `reach` of each edge's line: true for all
    /// that come within reach of the polygon, and for some beyond its corners.
    #[inline]
    pub fn is_within(&self, reach: f32, points: &[Vec2]) -> bool {
        self.edges.iter().all(|&(normal, out)| points.iter().any(|&p| normal.dot(p) - out <= reach))
    }
}

/// An integer that orders as the number does.
fn ordinal(number: f32) -> u32 {
    let bits = number.to_bits();
    if number.is_sign_negative() { !bits } else { bits | 1 << 31 }
}
