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

    /// The sum of the forces on a cell at a place, in centimetres:
    /// `sum (1 - adhesion) (1 - d/r) r (x_i - x_j)/d` over the cells within `r`. `windows` hold all
    /// of these cells, each once. The cell itself is at a distance of exactly 0 from itself and drops
    /// out, as does a cell on the very same spot: it has no direction to push in.
    #[inline]
    pub(super) fn push(
        &self,
        near: &Near,
        windows: [Range<u32>; 2],
        at: Vec2,
        kind: usize,
    ) -> Vec2 {
        let (x, y) = (f32x4::splat(at.x), f32x4::splat(at.y));
        let [weight_0, weight_1, weight_2] = self.weights[kind];
        let (mut sum_x, mut sum_y) = (f32x4::ZERO, f32x4::ZERO);
        for window in windows {
            let mut k = window.start as usize;
            let end = window.end as usize;
            while k < end {
                let dx = x - lanes(&near.x, k);
                let dy = y - lanes(&near.y, k);
                let other = lanes(&near.kind, k);
                let squared = dx * dx + dy * dy;
                let within = squared.simd_lt(self.radius_squared)
                    & squared.simd_gt(f32x4::ZERO)
                    & FIRST[(end - k).min(LANES)];
                let weight = weight_0 + other * (weight_1 + other * weight_2);
                // (1 - d/r) r / d = r/d - 1
                let scale = within & (weight * (self.radius / squared.sqrt() - f32x4::ONE));
                sum_x += dx * scale;
                sum_y += dy * scale;
                k += LANES;
            }
        }
        Vec2::new(total(sum_x), total(sum_y))
    }
}

fn total(lanes: f32x4) -> f32 {
    let [a, b, c, d] = lanes.to_array();
    (a + b) + (c + d)
}

/// Masks of the first lanes.
const FIRST: [f32x4; LANES + 1] = {
    const ON: f32 = f32::from_bits(u32::MAX);
    [
        f32x4::new([0.0; LANES]),
        f32x4::new([ON, 0.0, 0.0, 0.0]),
        f32x4::new([ON, ON, 0.0, 0.0]),
        f32x4::new([ON, ON, ON, 0.0]),
        f32x4::new([ON; LANES]),
    ]
};
