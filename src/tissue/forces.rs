//! The forces between cells, four neighbours at a time (Thesis 3.2.1.1).

use super::Recipe;
use super::ground::Share;
use super::lanes::{LANES, WIDTH, Wide, WideInt, wide};
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
    /// Those of a recipe for the cells that share a radius. Before day 0 adhesion plays no part: every
    /// pair repels as two F cells do (the original program).
    pub fn new(recipe: &Recipe, (area_cm2, cells): Share, day: usize) -> Forces {
        let adhesion = &recipe.adhesion;
        let weights = match day {
            0 => [[1.0 - adhesion[0][0]; 3]; 3],
            _ => adhesion.map(|row| row.map(|a| 1.0 - a)),
        };
        let radius = recipe.repulsive_radius_cm(area_cm2, cells);
        Forces { radius, repulsion: recipe.repulsion, weights }
    }
}

/// What the force loop needs to know, in all lanes.
pub(super) struct ForceLanes {
    radius: Wide,
    /// What `order` makes of the square of the radius.
    reach: WideInt,
}

impl ForceLanes {
    pub(super) fn new(forces: &Forces) -> ForceLanes {
        let radius = Wide::splat(forces.radius);
        ForceLanes { radius, reach: order(radius * radius) }
    }

    /// The forces on a patch's own `k`-th cell, in centimetres:
    /// `sum (1 - adhesion) (1 - d/r) r (x_i - x_j)/d` over the cells within `r`, but for the cell itself and
    /// those on the very same spot.
    #[inline]
    pub(super) fn push(&self, near: &Near, k: usize, kind: f32) -> Push {
        let at = near.at(k);
        let weights = &near.weights[kind_index(kind)];
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
        weights: &[f32],
        window: Range<u32>,
    ) {
        let mut k = window.start as usize;
        let mut left = (window.end - window.start) as usize;
        while left > EIGHT {
            self.add_wide(sum, near, at, weights, k, ALL);
            k += WIDTH;
            left -= WIDTH;
        }
        // Most windows hold from five to eight cells: always to do eight costs less than to go wrong
        // about a branch.
        for done in (0..EIGHT).step_by(WIDTH) {
            self.add_wide(sum, near, at, weights, k + done, first(left, done));
        }
    }

    /// Adds the forces of the cells from the `k`-th on that stand side by side, as far as the mask lets
    /// them.
    #[inline(always)]
    fn add_wide(
        &self,
        sum: &mut Push,
        near: &Near,
        at: Vec2,
        weights: &[f32],
        k: usize,
        mask: Wide,
    ) {
        let dx = Wide::splat(at.x) - wide(&near.x, k);
        let dy = Wide::splat(at.y) - wide(&near.y, k);
        let weight = wide(weights, k);
        let squared = dx * dx + dy * dy;
        let within: Wide = bytemuck::cast(self.reach.simd_gt(order(squared)));
        // (1 - d/r) r / d = r/d - 1
        let scale = (within & mask) & (weight * (self.radius / squared.sqrt() - Wide::ONE));
        sum.add(dx * scale, dy * scale);
    }
}

/// The forces on a cell: every fourth neighbour's sum in a lane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Push {
    x: f32x4,
    y: f32x4,
}

impl Push {
    /// Adds the forces of neighbours side by side: four by four, so that the sums are the same
    /// whatever the width.
    #[inline(always)]
    fn add(&mut self, x: Wide, y: Wide) {
        let (x, y): (Fours, Fours) = (bytemuck::cast(x), bytemuck::cast(y));
        for (x, y) in x.into_iter().zip(y) {
            self.x += x;
            self.y += y;
        }
    }

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

/// Numbers from 0 up as integers that order as they do, but for 0, which comes after all others.
#[inline]
fn order(numbers: Wide) -> WideInt {
    let bits: WideInt = bytemuck::cast(numbers);
    bits + WideInt::splat(i32::MAX)
}

/// Four cells' weights, `1 - adhesion` of their types, which are 0.0, 1.0 or 2.0: the parabola through
/// the weights of the three types is cheaper than to choose among them.
#[inline]
pub(super) fn weigh([at_0, at_1, at_2]: [f32; 3], kinds: f32x4) -> f32x4 {
    let bend = 0.5 * (at_2 - at_1) - 0.5 * (at_1 - at_0);
    let [bend, slope, start] = [bend, at_1 - at_0 - bend, at_0].map(f32x4::splat);
    start + kinds * (slope + kinds * bend)
}

/// The type of a cell that is 0.0, 1.0 or 2.0, as an index: the first three bits of the number, which
/// is quicker than to convert it.
#[inline]
fn kind_index(kind: f32) -> usize {
    (kind.to_bits() >> 29) as usize
}

type Fours = [f32x4; WIDTH / LANES];

/// How many neighbours a window has room for without a branch.
pub(super) const EIGHT: usize = 8;

const ON: f32 = f32::from_bits(u32::MAX);
const ALL: Wide = Wide::new([ON; WIDTH]);

/// A mask of those of the numbers from `done` on that are among the first `left`.
#[inline(always)]
fn first(left: usize, done: usize) -> Wide {
    const MASKS: [f32; 2 * EIGHT] =
        [ON, ON, ON, ON, ON, ON, ON, ON, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    wide(&MASKS, EIGHT - left + done)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_order_as_their_bits_do_and_nothing_is_within_nothing() {
        let squares = [f32::MIN_POSITIVE, 1e-20, 0.25, 0.5, 1.0, 3e10];
        let is_within = |square: f32, reach: f32| {
            order(Wide::splat(reach)).simd_gt(order(Wide::splat(square))).to_array()
        };
        for (k, &square) in squares.iter().enumerate() {
            for (other, &reach) in squares.iter().enumerate() {
                let expected = if k < other { -1 } else { 0 };
                assert!(is_within(square, reach).iter().all(|&mask| mask == expected));
            }
            assert!(is_within(0.0, square).iter().all(|&mask| mask == 0));
        }
    }

    #[test]
    fn each_type_has_its_weight() {
        let weights = [0.7, 0.05, 0.95];
        let weighed = weigh(weights, f32x4::new([0.0, 1.0, 2.0, 1.0])).to_array();
        for (weight, expected) in weighed.into_iter().zip([0.7, 0.05, 0.95, 0.05]) {
            assert!((weight - expected).abs() < 1e-6, "{weight} in place of {expected}");
        }
    }
}
