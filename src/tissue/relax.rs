//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use super::bins::{Bins, Rim};
use crate::surface::{Charts, Frame, Image, Mesh, Place, walk};
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// Pairs (own cells times candidates) of a triangle from which its candidates are sorted into a grid
/// first. Below, looking at all of them is cheaper than the sort.
const GRID_FROM_PAIRS: usize = 800;

/// Cells that a bin should hold. Fewer, and most of the work is looking into bins; more, and it is
/// looking at cells that are too far away.
const CELLS_PER_BIN: f32 = 3.0;

/// Lies out of every radius: fills the lists up to whole lanes.
const FAR: f32 = 1e18;

/// Lanes of the force loop.
const LANES: usize = 4;

/// What a relaxation event needs to know of the recipe and the day.
#[derive(Clone, Copy, Debug)]
pub struct Forces {
    /// Repulsive radius, in centimetres.
    pub radius: f32,
    pub repulsion: f32,
    /// `1 - adhesion` by the types of the cell and its neighbour.
    pub weights: [[f32; 3]; 3],
}

/// The cells of one day in the order of their bins, so that cells that lie together in space lie
/// together in memory. A bin is a triangle or, where many cells share one, one of the equal
/// triangles that it is cut into. All columns end with `LANES` spare rows.
#[derive(Clone, Debug, Default)]
pub struct Crowd {
    columns: Columns,
    bins: Bins,
    /// The first cell of each bin, and the end of the last.
    starts: Vec<u32>,
    /// Where the cells have moved to, before they are sorted again.
    moved: Vec<Place>,
    bin_of: Vec<u32>,
    scratch: Columns,
    near: Near,
    /// Walks that ended among slivers instead of where they were going.
    pub caught_walks: u64,
}

#[derive(Clone, Debug, Default)]
struct Columns {
    b1: Vec<f32>,
    b2: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    kind: Vec<f32>,
    /// The cell's number.
    cell: Vec<u32>,
}

impl Columns {
    fn resize(&mut self, cells: usize) {
        self.b1.resize(cells + LANES, 0.0);
        self.b2.resize(cells + LANES, 0.0);
        self.kind.resize(cells + LANES, 0.0);
        self.cell.resize(cells + LANES, 0);
    }
}

impl Crowd {
    /// Takes up the cells of a day: their places and types by number.
    pub fn gather(&mut self, mesh: &Mesh, cells: impl ExactSizeIterator<Item = (Place, u8)>) {
        self.bins = Bins::new(mesh, cells.len(), CELLS_PER_BIN);
        self.scratch.resize(cells.len());
        self.columns.resize(cells.len());
        self.near.points.resize(cells.len());
        self.near.sorted.resize(cells.len());
        self.moved.clear();
        for (number, (place, kind)) in cells.enumerate() {
            self.moved.push(place);
            self.columns.cell[number] = number as u32;
            self.columns.kind[number] = f32::from(kind);
        }
        self.sort();
    }

    /// The places of all cells by their numbers.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::default(); self.moved.len()];
        for triangle in 0..self.bins.sizes.len() {
            for i in self.cells_of(triangle) {
                places[self.columns.cell[i] as usize] = self.place(triangle, i);
            }
        }
        places
    }

    /// One event: every displacement is computed from the old places, then all cells move.
    pub fn relax(&mut self, mesh: &Mesh, charts: &mut Charts, forces: &Forces) {
        let lanes = Lanes::new(forces);
        for triangle in 0..mesh.triangles.len() {
            let own = self.cells_of(triangle);
            if own.is_empty() {
                continue;
            }
            let images = charts.around(mesh, triangle as u32, forces.radius);
            let home = &mesh.frames[triangle];
            self.near.unfold(&self.columns, &self.bins, &self.starts, images, home, forces.radius);
            let first = own.start;
            for i in own {
                let push = self.near.push(i - first, &lanes, self.columns.kind[i] as usize);
                let step = cap(push * forces.repulsion, 0.5 * forces.radius);
                let step = walk(mesh, self.place(triangle, i), step);
                self.caught_walks += u64::from(step.caught);
                self.moved[i] = step.place;
            }
        }
        self.sort();
    }

    fn cells_of(&self, triangle: usize) -> Range<usize> {
        let bins = self.bins.of(triangle);
        self.starts[bins.start] as usize..self.starts[bins.end] as usize
    }

    fn place(&self, triangle: usize, row: usize) -> Place {
        let (b1, b2) = (self.columns.b1[row], self.columns.b2[row]);
        Place { triangle: triangle as u32, b1, b2 }
    }

    /// Sorts the moved cells by their bins; those of one bin keep their order.
    fn sort(&mut self) {
        let bins = self.bins.sizes.len() * self.bins.in_triangle();
        self.starts.clear();
        self.starts.resize(bins + 1, 0);
        self.bin_of.clear();
        for &place in &self.moved {
            let bin = self.bins.bin(place);
            self.starts[bin as usize + 1] += 1;
            self.bin_of.push(bin);
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        for (row, (place, &bin)) in self.moved.iter().zip(&self.bin_of).enumerate() {
            let slot = &mut self.starts[bin as usize];
            let to = *slot as usize;
            *slot += 1;
            self.scratch.b1[to] = place.b1;
            self.scratch.b2[to] = place.b2;
            self.scratch.kind[to] = self.columns.kind[row];
            self.scratch.cell[to] = self.columns.cell[row];
        }
        // Each start has moved on to the next bin's.
        self.starts.copy_within(0..bins, 1);
        self.starts[0] = 0;
        std::mem::swap(&mut self.columns, &mut self.scratch);
    }
}

/// Shortens a step to `longest`.
fn cap(step: Vec2, longest: f32) -> Vec2 {
    let squared = step.length_squared();
    if squared > longest * longest { step * (longest / squared.sqrt()) } else { step }
}

/// The cells around one triangle, unfolded into its plane, its own cells first.
#[derive(Clone, Debug, Default)]
struct Near {
    points: Points,
    grid: Grid,
    /// The points in the order of the grid's squares, when it is in use.
    sorted: Points,
    use_grid: bool,
}

#[derive(Clone, Debug, Default)]
struct Points {
    x: Vec<f32>,
    y: Vec<f32>,
    kind: Vec<f32>,
    len: usize,
}

impl Points {
    /// Room for all cells of a day: no triangle sees more.
    fn resize(&mut self, cells: usize) {
        self.x.resize(cells + 2 * LANES, FAR);
        self.y.resize(cells + 2 * LANES, FAR);
        self.kind.resize(cells + 2 * LANES, 0.0);
    }

    /// Unfolds the cells of some rows. Whole lanes are written; what is too much is overwritten by
    /// the next.
    #[inline]
    fn unfold(&mut self, columns: &Columns, image: &Image, rows: Range<usize>) {
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
    fn close(&mut self) {
        self.x[self.len..self.len + LANES].fill(FAR);
    }
}

/// Four numbers from a row of a column on.
#[inline]
fn lanes(column: &[f32], row: usize) -> f32x4 {
    let four: [f32; LANES] = column[row..row + LANES].try_into().expect("four lanes");
    f32x4::new(four)
}

/// Four numbers from a row of a column on, to be written.
#[inline]
fn lanes_mut(column: &mut [f32], row: usize) -> &mut [f32; LANES] {
    (&mut column[row..row + LANES]).try_into().expect("four lanes")
}

impl Near {
    fn unfold(
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
    fn unfold_bins<'a>(
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
    fn push(&self, own: usize, forces: &Lanes, kind: usize) -> Vec2 {
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
struct Lanes {
    radius: f32x4,
    radius_squared: f32x4,
    /// For each type of cell the polynomial that gives the weights of its neighbours' types.
    weights: [[f32x4; 3]; 3],
}

impl Lanes {
    fn new(forces: &Forces) -> Lanes {
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

/// Columns of a grid at least: with three, every row is looked at from end to end.
const MIN_COLUMNS: usize = 4;

/// Squares as wide as the repulsive radius over the plane of one triangle.
#[derive(Clone, Debug, Default)]
struct Grid {
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
    fn sort(&mut self, points: &Points, sorted: &mut Points, radius: f32) -> bool {
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
    fn around(&self, point: usize) -> (Range<usize>, Range<usize>) {
        let square = self.square_of[point] as usize;
        let (row, column) = (square >> self.shift, square & ((1 << self.shift) - 1));
        (
            column.saturating_sub(1)..(column + 2).min(self.columns),
            row.saturating_sub(1)..(row + 2).min(self.rows),
        )
    }

    /// The points in some columns of a row.
    #[inline]
    fn row(&self, row: usize, columns: Range<usize>) -> Range<usize> {
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
