//! The cells in and around one patch, unfolded into its plane and sorted into boxes, so that a cell
//! finds all within the repulsive radius in two rows of them.

use super::forces::{EIGHT, weigh};
use super::lanes::{BinSort, LANES, copy, integers, lanes, lanes_mut, one, whole};
use super::relax::{Row, four};
use crate::surface::Laid;
use glam::Vec2;
use std::ops::Range;
use wide::{f32x4, u32x4};

/// Boxes are twice as high as a cell looks around, so that it sees two rows of them, and this many to
/// that distance wide. Fewer, and more cells are looked at in vain; more, and there are more boxes than
/// cells.
const BOXES_PER_LOOK: usize = 3;

/// Boxes of a row that a cell looks into: its own and those on both sides.
const BOXES_IN_WINDOW: usize = 2 * BOXES_PER_LOOK + 1;

/// Where the look is as long as this many mean spacings, cells leave out the boxes of the farther row that
/// the circle around them does not reach: to find those out is worth it where they hold many cells.
const CROWDED_SPACINGS: f32 = 1.7;

/// Boxes of a patch at most. Only where a triangle is far larger than the look is long does a patch cover so
/// many; then boxes are made for twice the look, or more, and cells look at more others in vain.
const MOST_BOXES: f32 = 65_536.0;

/// The cells in and around one patch. All columns end with spare rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Near {
    /// In the order in which they were unfolded.
    unsorted: Points,
    box_of: Vec<u32>,
    len: usize,
    /// How many are the patch's own, which come first.
    own: usize,
    /// Of the patch's own cells: their triangle as a place in the plan's order, its first bin, and the
    /// first box that they look into.
    slot_of: Vec<u32>,
    first_bin_of: Vec<u32>,
    window_of: Vec<u32>,
    /// Which of the boxes they look into they see, if they are `crowded`.
    seen_of: Vec<u32>,
    crowded: bool,
    /// In the order of their boxes.
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    kind: Vec<f32>,
    /// For each type of the cells in the patch, what its neighbours' pushes are multiplied with.
    pub(super) weights: [Vec<f32>; 3],
    /// Into boxes, row by row.
    sorting: BinSort,
    columns: usize,
    boxes: usize,
    low: Vec2,
    per_cm: Vec2,
}

#[derive(Clone, Debug, Default)]
struct Points {
    x: Vec<f32>,
    y: Vec<f32>,
    kind: Vec<f32>,
}

impl Near {
    /// Room for all cells of a day: no patch sees more, and nearly all see far fewer.
    pub(super) fn reserve(&mut self, cells: usize) {
        // The force loop reads so many from where the last window may begin.
        let rows = cells + EIGHT;
        for column in [
            &mut self.unsorted.x,
            &mut self.unsorted.y,
            &mut self.unsorted.kind,
            &mut self.x,
            &mut self.y,
            &mut self.kind,
        ] {
            make_room(column, rows);
        }
        self.weights.iter_mut().for_each(|column| make_room(column, rows));
        for column in [
            &mut self.box_of,
            &mut self.slot_of,
            &mut self.first_bin_of,
            &mut self.window_of,
            &mut self.seen_of,
        ] {
            make_room(column, rows);
        }
    }

    /// Begins anew, with boxes over the part of the plane from `low` to `high`: it holds all cells
    /// that will be unfolded, and one and a half `look_cm` around each that `windows` will be asked for.
    pub(super) fn begin(&mut self, low: Vec2, high: Vec2, look_cm: f32, spacing_cm: f32) {
        self.len = 0;
        self.crowded = look_cm > CROWDED_SPACINGS * spacing_cm;
        let mut boxed_look_cm = look_cm;
        loop {
            // Boxes for a longer look need as much more room around the cells.
            let margin = Vec2::splat(1.5 * (boxed_look_cm - look_cm));
            self.low = low - margin;
            self.per_cm = Vec2::new(BOXES_PER_LOOK as f32, 0.5) / boxed_look_cm;
            let size = (high + margin - self.low) * self.per_cm;
            if (size.x + 2.0) * (size.y + 2.0) > MOST_BOXES {
                boxed_look_cm *= 2.0;
                continue;
            }
            self.columns = size.x as usize + 2;
            self.boxes = (size.y as usize + 2) * self.columns;
            return;
        }
    }

    /// Adds the cells of some rows, of one triangle. Whole fours are written, one even if there is no
    /// row: to go wrong about a branch would cost more. What is too much is overwritten by the next.
    #[inline]
    pub(super) fn unfold(&mut self, all: &[Row], laid: &Laid, rows: Range<usize>) {
        let mut row = rows.start;
        let mut to = self.len;
        self.len += rows.len();
        loop {
            let [b1, b2, kind, _] = four(all, row);
            let (x, y) = laid.points(b1, b2);
            *lanes_mut(&mut self.unsorted.x, to) = x.to_array();
            *lanes_mut(&mut self.unsorted.y, to) = y.to_array();
            *lanes_mut(&mut self.unsorted.kind, to) = kind.to_array();
            row += LANES;
            to += LANES;
            if row >= rows.end {
                break;
            }
        }
    }

    /// Adds the patch's own cells of some rows, of one triangle.
    #[inline]
    pub(super) fn unfold_own(
        &mut self,
        all: &[Row],
        laid: &Laid,
        rows: Range<usize>,
        slot: usize,
        first_bin: usize,
    ) {
        let mut to = self.len;
        self.unfold(all, laid, rows);
        self.own = self.len;
        let (slot, first_bin) = (u32x4::splat(slot as u32), u32x4::splat(first_bin as u32));
        loop {
            *lanes_mut(&mut self.slot_of, to) = slot.to_array();
            *lanes_mut(&mut self.first_bin_of, to) = first_bin.to_array();
            to += LANES;
            if to >= self.len {
                break;
            }
        }
    }

    /// Finds the boxes of all cells, and where the patch's own look around.
    fn find_boxes(&mut self) {
        let (low_x, low_y) = (f32x4::splat(self.low.x), f32x4::splat(self.low.y));
        let (per_x, per_y) = (f32x4::splat(self.per_cm.x), f32x4::splat(self.per_cm.y));
        let row_length = f32x4::splat(self.columns as f32);
        for k in (0..self.len).step_by(LANES) {
            let columns = (lanes(&self.unsorted.x, k) - low_x) * per_x;
            let column = whole(columns);
            let rows = (lanes(&self.unsorted.y, k) - low_y) * per_y;
            let box_of = integers(whole(rows) * row_length + column);
            *lanes_mut(&mut self.box_of, k) = box_of.to_array();
            if k < self.own {
                let lower_row = whole(rows - f32x4::HALF);
                let left = column - f32x4::splat(BOXES_PER_LOOK as f32);
                let window = integers(lower_row * row_length + left);
                *lanes_mut(&mut self.window_of, k) = window.to_array();
                if self.crowded {
                    let seen = seen_boxes(columns - left, rows - lower_row);
                    *lanes_mut(&mut self.seen_of, k) = seen.to_array();
                }
            }
        }
    }

    /// Sorts the cells into their boxes.
    pub(super) fn sort(&mut self) {
        self.find_boxes();
        // The triangle of the last cell stands behind it, too, where `slots` may look.
        let last = self.slot_of[self.own - 1];
        *lanes_mut(&mut self.slot_of, self.own) = [last; LANES];
        // As slices: where a vector begins would be looked up again after each number that is written.
        let Points { x, y, kind } = &self.unsorted;
        let (x, y, kind) = (&x[..], &y[..], &kind[..]);
        let (to_x, to_y, to_kind) = (&mut self.x[..], &mut self.y[..], &mut self.kind[..]);
        self.sorting.sort(&self.box_of[..self.len], self.boxes, move |k, to| {
            // SAFETY: all columns are of the same length, at least `len`, as `reserve` made them.
            unsafe {
                copy(x, k, to_x, to);
                copy(y, k, to_y, to);
                copy(kind, k, to_kind, to);
            }
        });
    }

    /// Notes how the cells push those of each of the types: `1 - adhesion` by the types of the pushed and the
    /// pushing one.
    pub(super) fn weigh(&mut self, weights: &[[f32; 3]]) {
        let kind = &self.kind[..];
        for (&weights, column) in weights.iter().zip(&mut self.weights) {
            let column = &mut column[..];
            for k in (0..self.len).step_by(LANES) {
                *lanes_mut(column, k) = weigh(weights, lanes(kind, k)).to_array();
            }
        }
    }

    /// Where the `k`-th of the unfolded cells lies.
    #[inline]
    pub(super) fn at(&self, k: usize) -> Vec2 {
        Vec2::new(one(&self.unsorted.x, k), one(&self.unsorted.y, k))
    }

    /// The triangles of four of the patch's own cells, the `k`-th and those that follow.
    #[inline]
    pub(super) fn slots(&self, k: usize) -> [u32; LANES] {
        self.slot_of[k..k + LANES].try_into().expect("four")
    }

    /// The first bins of these triangles.
    #[inline]
    pub(super) fn first_bins(&self, k: usize) -> u32x4 {
        u32x4::new(self.first_bin_of[k..k + LANES].try_into().expect("four"))
    }

    /// The cells that may be within `look_cm` of the patch's own `k`-th cell, in two runs.
    #[inline]
    pub(super) fn windows(&self, k: usize) -> [Range<u32>; 2] {
        let lower = one(&self.window_of, k) as usize;
        let upper = lower + self.columns;
        let start = |bin: usize| one(&self.sorting.starts, bin);
        if !self.crowded {
            return [lower, upper].map(|first| start(first)..start(first + BOXES_IN_WINDOW));
        }
        let seen = one(&self.seen_of, k) as usize;
        let window = |first: usize, seen: usize| {
            let begin = start(first);
            // Only whole fours, so that the others stay in their lanes.
            let left_out = (start(first + seen % 8) - begin) & !(LANES as u32 - 1);
            begin + left_out..start(first + seen / 8 % 8)
        };
        [window(lower, seen), window(upper, seen / 64)]
    }
}

/// Which boxes of the two rows of its window a cell sees: for the lower row the first and the one behind
/// the last, and for the upper row the same, three bits each. `x`, in boxes, and `y`, in rows, are where
/// the cell lies in its window.
#[inline]
fn seen_boxes(x: f32x4, y: f32x4) -> u32x4 {
    // So that no rounding leaves a cell out, in boxes.
    const SPARE: f32 = 0.01;
    let [look, eight] = [BOXES_PER_LOOK as f32, 8.0].map(f32x4::splat);
    // Above the border between the rows, in looks; the border cuts this off the circle of the look.
    let above = (y - f32x4::ONE) * f32x4::splat(2.0);
    let chord = look * (f32x4::ONE - above * above).fast_max(f32x4::ZERO).sqrt();
    let is_lower = above.simd_lt(f32x4::ZERO);
    let seen = |half_width: f32x4| {
        let half_width = half_width + f32x4::splat(SPARE);
        let last = whole(x + half_width).fast_min(look + look);
        whole(x - half_width) + eight * (last + f32x4::ONE)
    };
    let (lower, upper) = (is_lower.select(look, chord), is_lower.select(chord, look));
    integers(seen(lower) + eight * eight * seen(upper))
}

/// A column of so many rows. It is made anew, as the system hands out zeros without writing them: rows that
/// are never used take no memory. From the second time on it has some to spare for the days to come: large
/// columns that are made anew on each take longer than to relax a few of the cells.
fn make_room<T: Copy + Default>(column: &mut Vec<T>, rows: usize) {
    if column.len() < rows {
        let spare = if column.is_empty() { 0 } else { rows / 4 };
        drop(std::mem::take(column));
        *column = vec![T::default(); rows + spare];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_patch_far_larger_than_the_look_cells_still_see_all_within_it() {
        const LOOK_CM: f32 = 0.01;
        // The corners of a square of a hundred metres, and one just within the look of each.
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let inwards = |b: f32| if b == 0.0 { 0.7e-6 } else { 1.0 - 0.7e-6 };
        let rows: Vec<[f32; 4]> = corners
            .iter()
            .flat_map(|&[b1, b2]| [[b1, b2, 0.0, 0.0], [inwards(b1), inwards(b2), 0.0, 0.0]])
            .chain([[0.0; 4]; LANES])
            .collect();
        let side = 1e4;
        let laid = Laid { origin: Vec2::ZERO, edge1: side * Vec2::X, edge2: side * Vec2::Y };
        let mut near = Near::default();
        near.reserve(8);
        let margin = Vec2::splat(1.5 * LOOK_CM);
        near.begin(-margin, Vec2::splat(side) + margin, LOOK_CM, LOOK_CM);
        near.unfold_own(bytemuck::cast_slice(&rows), &laid, 0..8, 0, 0);
        near.sort();
        for k in 0..8 {
            let seen = near.windows(k).into_iter().flatten();
            let at: Vec<Vec2> =
                seen.map(|j| Vec2::new(near.x[j as usize], near.y[j as usize])).collect();
            assert!(at.contains(&near.at(k)) && at.contains(&near.at(k ^ 1)), "cell {k}: {at:?}");
        }
    }

    #[test]
    fn crowded_cells_see_all_within_their_look_in_the_lanes_that_they_had() {
        const CELLS: usize = 3000;
        // Places that look like chance (a Weyl sequence), in a square of one centimetre.
        let place = |k: usize, step: f64| (k as f64 * step).fract() as f32;
        let rows: Vec<[f32; 4]> = (0..CELLS + LANES)
            .map(|k| [place(k, 0.754_877_666), place(k, 0.569_840_291), 0.0, 0.0])
            .collect();
        let laid = Laid { origin: Vec2::ZERO, edge1: Vec2::X, edge2: Vec2::Y };
        let spacing_cm = (CELLS as f32).sqrt().recip();
        for looks in [2.0, 3.0, 4.5, 8.0] {
            let look_cm = looks * spacing_cm;
            let margin = Vec2::splat(1.5 * look_cm);
            let near = |spacing_cm: f32| {
                let mut near = Near::default();
                near.reserve(CELLS);
                near.begin(-margin, Vec2::ONE + margin, look_cm, spacing_cm);
                near.unfold_own(bytemuck::cast_slice(&rows), &laid, 0..CELLS, 0, 0);
                near.sort();
                near
            };
            let (some, all) = (near(spacing_cm), near(look_cm));
            let (mut seen, mut there) = (0, 0);
            for k in 0..CELLS {
                let (at, within) = (some.at(k), some.windows(k));
                for (window, whole) in within.iter().zip(all.windows(k)) {
                    assert!(whole.start <= window.start && window.end <= whole.end);
                    assert_eq!((window.start - whole.start) % LANES as u32, 0);
                    (seen, there) = (seen + window.len(), there + whole.len());
                }
                for other in 0..CELLS {
                    let place = Vec2::new(some.x[other], some.y[other]);
                    let is_near = at.distance(place) <= look_cm;
                    let is_seen = within.iter().any(|window| window.contains(&(other as u32)));
                    assert!(is_seen || !is_near, "cell {other} from cell {k}");
                }
            }
            assert!(seen < there * 98 / 100, "{seen} of {there} pairs are looked at");
        }
    }
}
