//! The cells in and around one patch, unfolded into its plane and sorted into boxes, so that a cell
//! finds all within the repulsive radius in two rows of them.

use super::forces::EIGHT;
use super::lanes::{BinSort, LANES, copy, integers, lanes, lanes_mut, whole};
use super::relax::{Row, four};
use crate::surface::Image;
use glam::Vec2;
use std::ops::Range;
use wide::{f32x4, u32x4};

/// Boxes are twice as high as a cell looks around, so that it sees two rows of them, and this many to
/// that distance wide. Fewer, and more cells are looked at in vain; more, and there are more boxes than
/// cells.
const BOXES_PER_LOOK: usize = 3;

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
    /// In the order of their boxes.
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    pub(super) kind: Vec<f32>,
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
    /// Room for all cells of a day: no patch sees more.
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
            column.resize(rows, 0.0);
        }
        for column in
            [&mut self.box_of, &mut self.slot_of, &mut self.first_bin_of, &mut self.window_of]
        {
            column.resize(rows, 0);
        }
    }

    /// Begins anew, with boxes over the part of the plane from `low` to `high`: it holds all cells
    /// that will be unfolded, and `look_cm` and more around each that `windows` will be asked for.
    pub(super) fn begin(&mut self, low: Vec2, high: Vec2, look_cm: f32) {
        self.len = 0;
        self.low = low;
        self.per_cm = Vec2::new(BOXES_PER_LOOK as f32, 0.5) / look_cm;
        let size = (high - low) * self.per_cm;
        self.columns = size.x as usize + 2;
        self.boxes = (size.y as usize + 2) * self.columns;
    }

    /// Adds the cells of some rows, of one triangle. Whole fours are written, one even if there is no
    /// row: to go wrong about a branch would cost more. What is too much is overwritten by the next.
    #[inline]
    pub(super) fn unfold(&mut self, all: &[Row], image: &Image, rows: Range<usize>) {
        let mut row = rows.start;
        let mut to = self.len;
        self.len += rows.len();
        loop {
            let [b1, b2, kind, _] = four(all, row);
            let (x, y) = image.points(b1, b2);
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
        image: &Image,
        rows: Range<usize>,
        slot: usize,
        first_bin: usize,
    ) {
        let mut to = self.len;
        self.unfold(all, image, rows);
        self.own = self.len;
        loop {
            *lanes_mut(&mut self.slot_of, to) = [slot as u32; LANES];
            *lanes_mut(&mut self.first_bin_of, to) = [first_bin as u32; LANES];
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
            let column = whole((lanes(&self.unsorted.x, k) - low_x) * per_x);
            let rows = (lanes(&self.unsorted.y, k) - low_y) * per_y;
            let box_of = integers(whole(rows) * row_length + column);
            *lanes_mut(&mut self.box_of, k) = box_of.to_array();
            if k < self.own {
                let lower_row = whole(rows - f32x4::HALF);
                let left = column - f32x4::splat(BOXES_PER_LOOK as f32);
                let window = integers(lower_row * row_length + left);
                *lanes_mut(&mut self.window_of, k) = window.to_array();
            }
        }
    }

    /// Sorts the cells into their boxes.
    pub(super) fn sort(&mut self) {
        self.find_boxes();
        let Points { x, y, kind } = &self.unsorted;
        self.sorting.sort(&self.box_of[..self.len], self.boxes, |k, to| {
            // SAFETY: all columns are of the same length, at least `len`, as `reserve` made them.
            unsafe {
                copy(x, k, &mut self.x, to);
                copy(y, k, &mut self.y, to);
                copy(kind, k, &mut self.kind, to);
            }
        });
    }

    /// Where the `k`-th of the unfolded cells lies.
    #[inline]
    pub(super) fn at(&self, k: usize) -> Vec2 {
        Vec2::new(self.unsorted.x[k], self.unsorted.y[k])
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
        let first = self.window_of[k] as usize;
        let starts = &self.sorting.starts;
        let window = |first: usize| starts[first]..starts[first + 2 * BOXES_PER_LOOK + 1];
        [window(first), window(first + self.columns)]
    }
}
