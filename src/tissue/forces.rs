//! The forces between cells, four neighbours at a time (Thesis 3.2.1.1).

use super::Recipe;
use super::lanes::{LANES, lanes};
use super::near::Near;
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// What a relaxation event needs to know of the recipe and the day, in one place of the body.
#[derive(Clone, Copy, Debug)]
pub struct Forces {
    /// Repulsive radius, in centimetres.
    pub radius: f32,
    pub repulsion: f32,
    /// `1 - adhesion` by the types of the cell and its neighbour.
    pub weights: [[f32; 3]; 3],
}

impl Forces {
    /// Those of a recipe for so many cells on so much area. Before day 0 adhesion plays no part: every
    /// pair repels as two F cells do (the original program).
    pub fn new(recipe: &Recipe, area_cm2: f32, cells: usize, day: usize) -> Forces {
        let adhesion = &recipe.adhesion;
        let weights = match day {
            0 => [[1.0 - adhesion[0][0]; 3]; 3],
            _ => adhesion.map(|row| row.map(|a| 1.0 - a)),
        };
        let radius = recipe.repulsive_radius_cm(area_cm2, cells);
        Forces { radius, repulsion: recipe.repulsion, weights }
    }
}

/// The forces of a day, in all lanes.
pub(super) struct ForceLanes {
    radius: f32x4,
    radius_squared: f32x4,
    /// For each type of cell the parabola through the weights of its neighbours' types: cheaper than
    /// to choose among them.
    weights: [[f32x4; 3]; 3],
}

impl ForceLanes {
    pub(super) fn new(forces: &Forces) -> ForceLanes {
        ForceLanes {
            radius: f32x4::splat(forces.radius),
            radius_squared: f32x4::splat(forces.radius * forces.radius),
            weights: forces.weights.map(|[at_0, at_1, at_2]| {
                let bend = 0.5 * (at_2 - at_1) - 0.5 * (at_1 - at_0);
                [at_0, at_1 - at_0 - bend, bend].map(f32x4::splat)
            }),
        }
    }

    /// The forces on a patch's own `k`-th cell, in centimetres:
    /// `sum (1 - adhesion) (1 - d/r) r (x_i - x_j)/d` over the cells within `r`. The cell itself is at
    /// a distance of exactly 0 from itself, and as it has no direction, 0, to push in, it adds nothing;
    /// so does a cell on the very same spot.
    #[inline]
    pub(super) fn push(&self, near: &Near, k: usize, kind: f32) -> Push {
        let at = near.at(k);
        let weights = &self.weights[kind_index(kind)];
        let mut sum = Push::default();
        let [one, other] = near.windows(k);
        self.add_window(&mut sum, near, at, weights, one);
        self.add_window(&mut sum, near, at, weights, other);
        sum
    }

    /// Adds the forces of the cells of a window.
    #[inline(always)]
    fn add_window(
        &self,
        sum: &mut Push,
        near: &Near,
        at: Vec2,
        weights: &[f32x4; 3],
        window: Range<u32>,
    ) {
        let mut k = window.start as usize;
        let mut left = (window.end - window.start) as usize;
        // Most windows hold from five to eight cells: always to do two fours costs less than to go
        // wrong about a branch.
        self.add_four(sum, near, at, weights, k, first(left, 0));
        while left > 2 * LANES {
            k += LANES;
            left -= LANES;
            self.add_four(sum, near, at, weights, k, ALL);
        }
        self.add_four(sum, near, at, weights, k + LANES, first(left, 1));
    }

    /// Adds the forces of four cells, the `k`-th and those that follow, as far as the mask lets them.
    #[inline(always)]
    fn add_four(
        &self,
        sum: &mut Push,
        near: &Near,
        at: Vec2,
        weights: &[f32x4; 3],
        k: usize,
        mask: f32x4,
    ) {
        let dx = f32x4::splat(at.x) - lanes(&near.x, k);
        let dy = f32x4::splat(at.y) - lanes(&near.y, k);
        let other = lanes(&near.kind, k);
        let squared = dx * dx + dy * dy;
        let within = squared.simd_lt(self.radius_squared) & mask;
        // Without a direction no length must be infinite.
        let squared = squared.fast_max(f32x4::splat(f32::MIN_POSITIVE));
        let weight = weights[0] + other * (weights[1] + other * weights[2]);
        // (1 - d/r) r / d = r/d - 1
        let scale = within & (weight * (self.radius / squared.sqrt() - f32x4::ONE));
        sum.x += dx * scale;
        sum.y += dy * scale;
    }
}

/// The forces on a cell: every fourth neighbour's sum in a lane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Push {
    x: f32x4,
    y: f32x4,
}

impl Push {
    /// The whole forces on four cells, as x and y.
    #[inline]
    pub(super) fn totals(four: &[Push; LANES]) -> (f32x4, f32x4) {
        let total = |sums: [f32x4; LANES]| {
            let [a, b, c, d] = f32x4::transpose(sums);
            (a + b) + (c + d)
        };
        (total(four.map(|push| push.x)), total(four.map(|push| push.y)))
    }
}

/// The type of a cell that is 0.0, 1.0 or 2.0, as an index: the first three bits of the number, which
/// is quicker than to convert it.
#[inline]
fn kind_index(kind: f32) -> usize {
    (kind.to_bits() >> 29) as usize
}

const ON: f32 = f32::from_bits(u32::MAX);
const ALL: f32x4 = f32x4::new([ON; LANES]);

/// A mask of those of four numbers, the first four or the second, that are among the first `left`.
#[inline(always)]
fn first(left: usize, four: usize) -> f32x4 {
    const MASKS: [f32; 4 * LANES] =
        [ON, ON, ON, ON, ON, ON, ON, ON, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    lanes(&MASKS, 2 * LANES - left.min(2 * LANES) + four * LANES)
}
