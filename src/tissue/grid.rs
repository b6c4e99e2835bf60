//! Candidates of one triangle sorted into squares, so that a cell looks only at those around it.

use super::near::{LANES, Points, lanes};
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// Columns of a grid at least: with three, every row is looked at from end to end.
const MIN_COLUMNS: usize = 4;

/// Squares as wide as the repulsive radius over the plane of one triangle.
#[derive(Clone, Debug, Default)]
pub(super) struct Grid {
    /// Rows start at multiples of `1 << shift` squares.
    shift: u32,
    columns: usize,
    rows: usize,
    /// First point of each square, row by row, and the end of the last.
    starts: Vec<u32>,
    /// The square of each point.
    square_of: Vec<i32>,
}

impl Grid {
    /// Sorts the points into squares. False, with nothing done, where that does not help: among
    /// fewer than `MIN_COLUMNS` columns.
    pub(super) fn sort(&mut self, points: &Points, sorted: &mut Points, radius: f32) -> bool {
        let (low, high) = bounds(points);
        let per_cm = 1.0 / radius;
        let size = (high - low) * per_cm;
        (self.columns, self.rows) = (size.x as usize + 1, size.y as usize + 1);
        if self.columns < MIN_COLUMNS {
            return false;
        }
        self.shift = self.columns.next_power_of_two().trailing_zeros();
        let squares = self.rows << self.shift;
        self.starts.clear();
        self.starts.resize(squares + 1, 0);
        self.square_of.resize(points.x.len(), 0);
        let (low_x, low_y, per_cm) =
            (f32x4::splat(low.x), f32x4::splat(low.y), f32x4::splat(per_cm));
        let mut k = 0;
        while k < points.len {
            let column = ((lanes(&points.x, k) - low_x) * per_cm).fast_trunc_int();
            let row = ((lanes(&points.y, k) - low_y) * per_cm).fast_trunc_int();
            let square = (row << self.shift) + column;
            self.square_of[k..k + LANES].copy_from_slice(&square.to_array());
            k += LANES;
        }
        let square_of = &self.square_of[..points.len];
        for &square in square_of {
            self.starts[square as usize + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        let (x, y, kind) =
            (&points.x[..points.len], &points.y[..points.len], &points.kind[..points.len]);
        for (k, &square) in square_of.iter().enumerate() {
            let slot = &mut self.starts[square as usize];
            let to = *slot as usize;
            *slot += 1;
            sorted.x[to] = x[k];
            sorted.y[to] = y[k];
            sorted.kind[to] = kind[k];
        }
        sorted.len = points.len;
        sorted.close();
        self.starts.copy_within(0..squares, 1);
        self.starts[0] = 0;
        true
    }

    /// The columns and rows of the squares around a point's own.
    #[inline]
    pub(super) fn around(&self, point: usize) -> (Range<usize>, Range<usize>) {
        let square = self.square_of[point] as usize;
        let (row, column) = (square >> self.shift, square & ((1 << self.shift) - 1));
        (
            column.saturating_sub(1)..(column + 2).min(self.columns),
            row.saturating_sub(1)..(row + 2).min(self.rows),
        )
    }

    /// The points in some columns of a row.
    #[inline]
    pub(super) fn row(&self, row: usize, columns: Range<usize>) -> Range<usize> {
        let first = row << self.shift;
        self.starts[first + columns.start] as usize..self.starts[first + columns.end] as usize
    }
}

/// The corners of the box around all points.
fn bounds(points: &Points) -> (Vec2, Vec2) {
    let (x, y) = (f32x4::splat(points.x[0]), f32x4::splat(points.y[0]));
    let (mut low, mut high) = ((x, y), (x, y));
    // Whole lanes only, and the last points once more: the lanes behind them are not points.
    for k in (0..points.len / LANES).map(|k| k * LANES).chain([points.len - LANES]) {
        let (x, y) = (lanes(&points.x, k), lanes(&points.y, k));
        low = (low.0.fast_min(x), low.1.fast_min(y));
        high = (high.0.fast_max(x), high.1.fast_max(y));
    }
    let least = |v: f32x4| v.to_array().into_iter().fold(f32::INFINITY, f32::min);
    let most = |v: f32x4| v.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max);
    (Vec2::new(least(low.0), least(low.1)), Vec2::new(most(high.0), most(high.1)))
}
