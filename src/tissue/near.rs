//! The cells around one triangle, unfolded into its plane, and the sum of their forces.

use super::bins::{Bins, Rim};
use super::grid::Grid;
use crate::surface::{Frame, Image};
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// Pairs (own cells times candidates) of a triangle from which its candidates are sorted into a grid
/// first. Below, looking at all of them is cheaper than the sort.
const GRID_FROM_PAIRS: usize = 800;

/// Lies out of every radius: fills the lists up to whole lanes.
pub(super) const FAR: f32 = 1e18;

/// Lanes of the force loop.
pub(super) const LANES: usize = 4;

/// What a relaxation event needs to know of the recipe and the day.
#[derive(Clone, Copy, Debug)]
pub struct Forces {
    /// Repulsive radius, in centimetres.
    pub radius: f32,
    pub repulsion: f32,
    /// `1 - adhesion` by the types of the cell and its neighbour.
    pub weights: [[f32; 3]; 3],
}

#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    pub(super) b1: Vec<f32>,
    pub(super) b2: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    pub(super) kind: Vec<f32>,
    /// The cell's number.
    pub(super) cell: Vec<u32>,
}

impl Columns {
    pub(super) fn resize(&mut self, cells: usize) {
        self.b1.resize(cells + LANES, 0.0);
        self.b2.resize(cells + LANES, 0.0);
        self.kind.resize(cells + LANES, 0.0);
        self.cell.resize(cells + LANES, 0);
    }
}

/// The cells around one triangle, unfolded into its plane, its own cells first.
#[derive(Clone, Debug, Default)]
pub(super) struct Near {
    points: Points,
    grid: Grid,
    /// The points in the order of the grid's squares, when it is in use.
    sorted: Points,
    use_grid: bool,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Points {
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    pub(super) kind: Vec<f32>,
    pub(super) len: usize,
}

impl Points {
    pub(super) fn resize(&mut self, cells: usize) {
        self.x.resize(cells + 2 * LANES, FAR);
        self.y.resize(cells + 2 * LANES, FAR);
        self.kind.resize(cells + 2 * LANES, 0.0);
    }

    /// Unfolds the cells of some rows. Whole lanes are written; what is too much is overwritten by
    /// the next.
    #[inline]
    pub(super) fn unfold(&mut self, columns: &Columns, image: &Image, rows: Range<usize>) {
        let mut row = rows.start;
        let mut to = self.len;
        while row < rows.end {
            let (b1, b2) = (lanes(&columns.b1, row), lanes(&columns.b2, row));
            let (x, y) = image.points(b1, b2);
            *lanes_mut(&mut self.x, to) = x.to_array();
            *lanes_mut(&mut self.y, to) = y.to_array();
            *lanes_mut(&mut self.kind, to) = lanes(&columns.kind, row).to_array();
            row += LANES;
            to += LANES;
        }
        self.len += rows.end - rows.start;
    }

    /// Puts a lane's width of far points behind the last.
    pub(super) fn close(&mut self) {
        self.x[self.len..self.len + LANES].fill(FAR);
    }
}

/// Four numbers from a row of a column on.
#[inline]
pub(super) fn lanes(column: &[f32], row: usize) -> f32x4 {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: every column ends with `LANES` spare rows, and rows come from `starts` and `len`,
    // which count rows that are there. A checked load costs the gather a fifth of its time.
    f32x4::new(unsafe { *column.as_ptr().add(row).cast::<[f32; LANES]>() })
}

/// Four numbers from a row of a column on, to be written.
#[inline]
pub(super) fn lanes_mut(column: &mut [f32], row: usize) -> &mut [f32; LANES] {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: as above; a triangle sees each cell at most once, so `Points` has room for all.
    unsafe { &mut *column.as_mut_ptr().add(row).cast::<[f32; LANES]>() }
}

impl Near {
    /// Room for all cells of a day: no triangle sees more.
    pub(super) fn reserve(&mut self, cells: usize) {
        self.points.resize(cells);
        self.sorted.resize(cells);
    }

    pub(super) fn unfold(
        &mut self,
        columns: &Columns,
        bins: &Bins,
        starts: &[u32],
        images: &[Image],
        home: &Frame,
        radius: f32,
    ) {
        let whole = |triangle: u32| {
            let of = bins.of(triangle as usize);
            starts[of.start] as usize..starts[of.end] as usize
        };
        let (own_image, others) = images.split_first().expect("a chart begins with its home");
        self.points.len = 0;
        self.points.unfold(columns, own_image, whole(own_image.triangle));
        let own = self.points.len;
        let others = others.iter().take_while(|image| image.distance <= radius);
        if bins.cuts == 1 {
            for image in others {
                let first = image.triangle as usize;
                let [from, to] = starts[first..first + 2] else { unreachable!() };
                self.points.unfold(columns, image, from as usize..to as usize);
            }
        } else {
            self.unfold_bins(columns, bins, starts, others, &Rim::new(home), radius);
        }
        self.points.close();
        self.use_grid = own * self.points.len >= GRID_FROM_PAIRS
            && self.grid.sort(&self.points, &mut self.sorted, radius);
    }

    /// Unfolds the bins that come within the radius of the home triangle.
    pub(super) fn unfold_bins<'a>(
        &mut self,
        columns: &Columns,
        bins: &Bins,
        starts: &[u32],
        images: impl Iterator<Item = &'a Image>,
        rim: &Rim,
        radius: f32,
    ) {
        for image in images {
            let of = bins.of(image.triangle as usize);
            let reach = radius + bins.sizes[image.triangle as usize];
            let mut first = of.start;
            while first < of.end {
                let (b1, b2) = bins.centroids(first - of.start);
                let (x, y) = image.points(b1, b2);
                let mut near = rim.within(x, y, reach) & ((1 << (of.end - first).min(LANES)) - 1);
                while near != 0 {
                    // Bins that follow each other are one run of rows.
                    let skipped = near.trailing_zeros();
                    let run = (near >> skipped).trailing_ones();
                    near &= !(((1 << run) - 1) << skipped);
                    let bin = first + skipped as usize;
                    let rows = starts[bin] as usize..starts[bin + run as usize] as usize;
                    self.points.unfold(columns, image, rows);
                }
                first += LANES;
            }
        }
    }

    /// The sum of the forces on the `own`-th cell of the home triangle, of type `kind`, in
    /// centimetres: `sum (1 - adhesion) (1 - d/r) r (x_i - x_j)/d` over the cells within `r`.
    #[inline]
    pub(super) fn push(&self, own: usize, forces: &Lanes, kind: usize) -> Vec2 {
        let mut sum = Sum {
            x: f32x4::splat(self.points.x[own]),
            y: f32x4::splat(self.points.y[own]),
            forces,
            weights: &forces.weights[kind],
            sum_x: f32x4::ZERO,
            sum_y: f32x4::ZERO,
        };
        if self.use_grid {
            let (columns, rows) = self.grid.around(own);
            for row in rows {
                sum.add(&self.sorted, self.grid.row(row, columns.clone()));
            }
        } else {
            // Far points fill the last lanes.
            sum.add(&self.points, 0..self.points.len.next_multiple_of(LANES));
        }
        sum.total()
    }
}

/// The forces of a day, in all lanes.
pub(super) struct Lanes {
    radius: f32x4,
    radius_squared: f32x4,
    /// For each type of cell the polynomial that gives the weights of its neighbours' types.
    weights: [[f32x4; 3]; 3],
}

impl Lanes {
    pub(super) fn new(forces: &Forces) -> Lanes {
        Lanes {
            radius: f32x4::splat(forces.radius),
            radius_squared: f32x4::splat(forces.radius * forces.radius),
            weights: forces.weights.map(|[at_0, at_1, at_2]| {
                // The parabola through the three weights: cheaper than to choose among them.
                let bend = 0.5 * (at_2 - at_1) - 0.5 * (at_1 - at_0);
                [at_0, at_1 - at_0 - bend, bend].map(f32x4::splat)
            }),
        }
    }
}

/// A sum of forces on one cell under way, four neighbours at a time.
struct Sum<'a> {
    x: f32x4,
    y: f32x4,
    forces: &'a Lanes,
    weights: &'a [f32x4; 3],
    sum_x: f32x4,
    sum_y: f32x4,
}

impl Sum<'_> {
    /// Adds the forces of some points. The cell itself is at a distance of exactly 0 from its own
    /// unfolded place and drops out, as does a cell on the very same spot: it has no direction to
    /// push in.
    #[inline]
    fn add(&mut self, points: &Points, range: Range<usize>) {
        let (x, _) = points.x[range.clone()].as_chunks::<LANES>();
        let (y, _) = points.y[range.clone()].as_chunks::<LANES>();
        let (kind, _) = points.kind[range.clone()].as_chunks::<LANES>();
        for ((&x, &y), &kind) in x.iter().zip(y).zip(kind) {
            self.add_four(f32x4::new(x), f32x4::new(y), f32x4::new(kind));
        }
        let rest = range.len() % LANES;
        if rest > 0 {
            // The points behind the last may be neighbours of another row: they would count twice.
            let first = range.end - rest;
            let x = FIRST[rest].select(lanes(&points.x, first), f32x4::splat(FAR));
            self.add_four(x, lanes(&points.y, first), lanes(&points.kind, first));
        }
    }

    #[inline]
    fn add_four(&mut self, x: f32x4, y: f32x4, kind: f32x4) {
        let dx = self.x - x;
        let dy = self.y - y;
        let squared = dx * dx + dy * dy;
        let within = squared.simd_lt(self.forces.radius_squared) & squared.simd_gt(f32x4::ZERO);
        let weight = self.weights[0] + kind * (self.weights[1] + kind * self.weights[2]);
        // (1 - d/r) r / d = r/d - 1
        let scale = within & (weight * (self.forces.radius / squared.sqrt() - f32x4::ONE));
        self.sum_x += dx * scale;
        self.sum_y += dy * scale;
    }

    fn total(self) -> Vec2 {
        let (x, y) = (self.sum_x.to_array(), self.sum_y.to_array());
        Vec2::new((x[0] + x[1]) + (x[2] + x[3]), (y[0] + y[1]) + (y[2] + y[3]))
    }
}

/// Masks of the first lanes.
const FIRST: [f32x4; LANES] = {
    const ON: f32 = f32::from_bits(u32::MAX);
    [
        f32x4::new([0.0; LANES]),
        f32x4::new([ON, 0.0, 0.0, 0.0]),
        f32x4::new([ON, ON, 0.0, 0.0]),
        f32x4::new([ON, ON, ON, 0.0]),
    ]
};
