//! The cells in and around one patch, unfolded into its plane and sorted into boxes, so that a cell
//! finds all within the repulsive radius in two rows of them.

use super::lanes::{LANES, lanes, lanes_mut};
use super::relax::Columns;
use crate::surface::Image;
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// Boxes are twice as high as a cell looks around, so that it sees two rows of them, and this many to
/// that distance wide. Fewer, and more cells are looked at in vain; more, and there are more boxes than
/// cells.
const BOXES_PER_LOOK: usize = 3;

/// The cells in and around one patch. All columns end with spare rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Near {
    /// In the order in which they were unfolded.
    unsorted: Points,
    box_of: Vec<i32>,
    pub(super) len: usize,
    /// In the order of their boxes.
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    pub(super) kind: Vec<f32>,
    /// The first cell of each box, row by row, and the end of the last.
    starts: Vec<u32>,
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
        let rows = cells + 2 * LANES;
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
        self.box_of.resize(rows, 0);
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

    /// Adds the cells of some rows. Whole lanes are written; what is too much is overwritten by the
    /// next.
    #[inline]
    pub(super) fn unfold(&mut self, columns: &Columns, image: &Image, rows: Range<usize>) {
        let mut row = rows.start;
        let mut to = self.len;
        let (low_x, low_y) = (f32x4::splat(self.low.x), f32x4::splat(self.low.y));
        let (per_x, per_y) = (f32x4::splat(self.per_cm.x), f32x4::splat(self.per_cm.y));
        let row_length = f32x4::splat(self.columns as f32);
        while row < rows.end {
            let (x, y) = image.points(lanes(&columns.b1, row), lanes(&columns.b2, row));
            let box_column = ((x - low_x) * per_x).fast_trunc_int();
            let box_row = ((y - low_y) * per_y).fast_trunc_int();
            // Whole numbers far below 2^24 are exact as floats.
            let box_of = (box_row.round_float() * row_length).fast_trunc_int() + box_column;
            self.box_of[to..to + LANES].copy_from_slice(&box_of.to_array());
            *lanes_mut(&mut self.unsorted.x, to) = x.to_array();
            *lanes_mut(&mut self.unsorted.y, to) = y.to_array();
            *lanes_mut(&mut self.unsorted.kind, to) = lanes(&columns.kind, row).to_array();
            row += LANES;
            to += LANES;
        }
        self.len += rows.end - rows.start;
    }

    /// Sorts the cells into their boxes.
    pub(super) fn sort(&mut self) {
        let boxes = self.boxes;
        self.starts.clear();
        self.starts.resize(boxes + 1, 0);
        let Points { x, y, kind } = &self.unsorted;
        let box_of = &self.box_of[..self.len];
        for &b in box_of {
            self.starts[b as usize + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        let (x, y, kind) = (&x[..self.len], &y[..self.len], &kind[..self.len]);
        for (k, &b) in box_of.iter().enumerate() {
            let slot = &mut self.starts[b as usize];
            let to = *slot as usize;
            *slot += 1;
            self.x[to] = x[k];
            self.y[to] = y[k];
            self.kind[to] = kind[k];
        }
        // Each start has moved on to the next box's.
        self.starts.copy_within(0..boxes, 1);
        self.starts[0] = 0;
    }

    /// Where the `k`-th of the unfolded cells lies.
    #[inline]
    pub(super) fn at(&self, k: usize) -> Vec2 {
        Vec2::new(self.unsorted.x[k], self.unsorted.y[k])
    }

    /// The cells that may be within `look_cm` of a point, in two runs.
    #[inline]
    pub(super) fn windows(&self, at: Vec2) -> [Range<u32>; 2] {
        let boxes = (at - self.low) * self.per_cm;
        let lower_row = (boxes.y - 0.5) as usize;
        let first = lower_row * self.columns + boxes.x as usize - BOXES_PER_LOOK;
        let window = |first: usize| self.starts[first]..self.starts[first + 2 * BOXES_PER_LOOK + 1];
        [window(first), window(first + self.columns)]
    }
}
