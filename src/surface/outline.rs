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
    /// The convex hull (A. M. Andrew, Another efficient algorithm for convex hulls in two
    /// dimensions, Information Processing Letters 9, 1979).
    pub(super) fn around(mut points: Vec<Vec2>) -> Outline {
        leave_out_inner(&mut points);
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
            [normal.x, normal.y, normal.dot(pair[0])]
        });
        let fours = edges
            .collect::<Vec<_>>()
            .chunks(4)
            .map(|edges| {
                // Everything lies within the edges that fill the last four up.
                let edge = |k: usize| edges.get(k).copied().unwrap_or([0.0, 0.0, f32::INFINITY]);
                std::array::from_fn(|i| f32x4::new(std::array::from_fn(|k| edge(k)[i])))
            })
            .collect();
        Outline {
            edges: fours,
            low: points.iter().copied().fold(Vec2::INFINITY, Vec2::min),
            high: points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max),
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

/// Leaves most points out that cannot be corners of the convex hull: those well within the polygon of
/// the farthest ones in eight directions (S. G. Akl, G. T. Toussaint, A fast convex hull algorithm,
/// Information Processing Letters 7, 1978).
fn leave_out_inner(points: &mut Vec<Vec2>) {
    let Some(&first) = points.first() else { return };
    // A turn of an eighth apart, and then the four against them.
    let along = |p: Vec2| f32x4::new([p.x, p.x + p.y, p.y, p.y - p.x]);
    let mut farthest = [[f32x4::splat(first.x), f32x4::splat(first.y), along(first)]; 2];
    for &p in &*points {
        let here = [f32x4::splat(p.x), f32x4::splat(p.y), along(p)];
        let is_farther = [here[2].simd_gt(farthest[0][2]), here[2].simd_lt(farthest[1][2])];
        for (known, is_farther) in farthest.iter_mut().zip(is_farther) {
            *known = std::array::from_fn(|k| is_farther.select(here[k], known[k]));
        }
    }
    let [x, y]: [[f32; 8]; 2] = [0, 1].map(|k| bytemuck::cast(farthest.map(|known| known[k])));
    let sides: [[f32; 3]; 8] = std::array::from_fn(|k| {
        let [from, to] = [k, (k + 1) % 8].map(|k| Vec2::new(x[k], y[k]));
        let inwards = (to - from).perp();
        // Rounding must not decide. Where the side is a point, it decides nothing.
        let least = inwards.dot(from) + 1e-3 * inwards.length_squared();
        [inwards.x, inwards.y, if from == to { f32::NEG_INFINITY } else { least }]
    });
    let sides: [[f32x4; 3]; 2] = [0, 4].map(|first| {
        std::array::from_fn(|i| f32x4::new(std::array::from_fn(|k| sides[first + k][i])))
    });
    points.retain(|&p| {
        let out = sides.map(|[x, y, least]| (x * p.x + y * p.y).simd_le(least));
        (out[0] | out[1]).any()
    });
}

/// An integer that orders as the number does.
fn ordinal(number: f32) -> u32 {
    let bits = number.to_bits();
    if number.is_sign_negative() { !bits } else { bits | 1 << 31 }
}
