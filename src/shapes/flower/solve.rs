//! Systems of equations that are symmetric and positive definite, factored once for many right sides.

use glam::DVec3;

/// `L` with `L L^T` the matrix, row by row.
#[derive(Clone, Debug)]
pub struct Cholesky {
    size: usize,
    lower: Vec<f64>,
    /// The first place of each row that is not 0.
    first: Vec<usize>,
}

impl Cholesky {
    /// Of a matrix by its rows, of which only the lower triangle is read.
    pub fn new(size: usize, mut lower: Vec<f64>) -> Cholesky {
        let row_starts = |row: usize, lower: &[f64]| {
            (0..row).find(|&k| lower[row * size + k] != 0.0).unwrap_or(row)
        };
        let first: Vec<usize> = (0..size).map(|row| row_starts(row, &lower)).collect();
        for row in 0..size {
            for column in first[row]..=row {
                let from = first[row].max(first[column]);
                let before: f64 =
                    (from..column).map(|k| lower[row * size + k] * lower[column * size + k]).sum();
                let rest = lower[row * size + column] - before;
                lower[row * size + column] =
                    if column == row { rest.sqrt() } else { rest / lower[column * size + column] };
            }
        }
        Cholesky { size, lower, first }
    }

    /// Turns a right side, of points, into the solution.
    pub fn solve(&self, side: &mut [DVec3]) {
        for row in 0..self.size {
            let at = |k: usize| self.lower[row * self.size + k];
            let before: DVec3 = (self.first[row]..row).map(|k| side[k] * at(k)).sum();
            side[row] = (side[row] - before) / at(row);
        }
        for row in (0..self.size).rev() {
            side[row] /= self.lower[row * self.size + row];
            for k in self.first[row]..row {
                side[k] -= side[row] * self.lower[row * self.size + k];
            }
        }
    }
}
