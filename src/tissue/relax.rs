//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use crate::surface::{Charts, Frame, Image, Mesh, Place, walk};
use glam::Vec2;
use wide::{CmpGe, CmpGt, CmpLt, f32x4};

/// Candidates of a triangle above which they are sorted into a grid first. Below, looking at all
/// of them is cheaper than the sort.
const GRID_FROM: usize = 40;

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

/// The cells of one day in the order of their triangles, so that the cells of a triangle lie side
/// by side. All columns end with `LANES` spare rows.
#[derive(Clone, Debug, Default)]
pub struct Crowd {
    columns: Columns,
    /// The first cell of each triangle, and the end of the last.
    starts: Vec<u32>,
    /// Where the cells have moved to, before they are sorted again.
    moved: Vec<Place>,
    scratch: Columns,
    near: Near,
    /// Walks that ended among slivers instead of where they were going.
    pub caught_walks: u64,
}

#[derive(Clone, Debug, Default)]
struct Columns {
    b1: Vec<f32>,
    b2: Vec<f32>,
    /// The cell's number, with its type in the two highest bits.
    cell: Vec<u32>,
}

const TYPE_SHIFT: u32 = 30;
const CELL_MASK: u32 = (1 << TYPE_SHIFT) - 1;

impl Columns {
    fn resize(&mut self, cells: usize) {
        self.b1.resize(cells + LANES, 0.0);
        self.b2.resize(cells + LANES, 0.0);
        self.cell.resize(cells + LANES, 0);
    }
}

impl Crowd {
    /// Takes up the cells of a day: their places and types by number.
    pub fn gather(&mut self, mesh: &Mesh, cells: impl ExactSizeIterator<Item = (Place, u8)>) {
        self.scratch.resize(cells.len());
        self.columns.resize(cells.len());
        self.moved.clear();
        for (number, (place, kind)) in cells.enumerate() {
            self.moved.push(place);
            self.columns.cell[number] = number as u32 | u32::from(kind) << TYPE_SHIFT;
        }
        self.sort(mesh.triangles.len());
    }

    /// The places of all cells by their numbers.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::default(); self.moved.len()];
        for triangle in 0..self.starts.len() - 1 {
            for i in self.starts[triangle] as usize..self.starts[triangle + 1] as usize {
                places[(self.columns.cell[i] & CELL_MASK) as usize] = Place {
                    triangle: triangle as u32,
                    b1: self.columns.b1[i],
                    b2: self.columns.b2[i],
                };
            }
        }
        places
    }

    /// One event: every displacement is computed from the old places, then all cells move.
    pub fn relax(&mut self, mesh: &Mesh, charts: &mut Charts, forces: &Forces) {
        for triangle in 0..mesh.triangles.len() {
            let own = self.starts[triangle] as usize..self.starts[triangle + 1] as usize;
            if own.is_empty() {
                continue;
            }
            let images = charts.around(mesh, triangle as u32, forces.radius);
            self.near.unfold(
                &self.columns,
                &self.starts,
                images,
                &mesh.frames[triangle],
                forces.radius,
            );
            for i in own {
                let kind = self.columns.cell[i] >> TYPE_SHIFT;
                let push = self.near.push(i - self.starts[triangle] as usize, forces, kind);
                let from = Place {
                    triangle: triangle as u32,
                    b1: self.columns.b1[i],
                    b2: self.columns.b2[i],
                };
                let step = walk(mesh, from, cap(push * forces.repulsion, 0.5 * forces.radius));
                self.caught_walks += u64::from(step.caught);
                self.moved[i] = step.place;
            }
        }
        self.sort(mesh.triangles.len());
    }

    /// Sorts the moved cells by their triangles; those of one triangle keep their order.
    fn sort(&mut self, triangles: usize) {
        self.starts.clear();
        self.starts.resize(triangles + 1, 0);
        for place in &self.moved {
            self.starts[place.triangle as usize + 1] += 1;
        }
        for t in 0..triangles {
            self.starts[t + 1] += self.starts[t];
        }
        for (place, &cell) in self.moved.iter().zip(&self.columns.cell) {
            let slot = &mut self.starts[place.triangle as usize];
            let to = *slot as usize;
            *slot += 1;
            self.scratch.b1[to] = place.b1;
            self.scratch.b2[to] = place.b2;
            self.scratch.cell[to] = cell;
        }
        // Each start has moved on to the next triangle's.
        self.starts.copy_within(0..triangles, 1);
        self.starts[0] = 0;
        std::mem::swap(&mut self.columns, &mut self.scratch);
    }
}

/// Shortens a step to `longest`.
fn cap(step: Vec2, longest: f32) -> Vec2 {
    let squared = step.length_squared();
    if squared > longest * longest { step * (longest / squared.sqrt()) } else { step }
}

/// The cells within reach of one triangle, unfolded into its plane, its own cells first.
#[derive(Clone, Debug, Default)]
struct Near {
    points: Points,
    grid: Grid,
    /// The points in the order of the grid's bins, when it is in use.
    binned: Points,
    use_grid: bool,
}

#[derive(Clone, Debug, Default)]
struct Points {
    x: Vec<f32>,
    y: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    kind: Vec<f32>,
    len: usize,
}

impl Points {
    fn reserve(&mut self, more: usize) {
        let wanted = self.len + more + LANES;
        if self.x.len() < wanted {
            let wanted = wanted.next_power_of_two();
            self.x.resize(wanted, FAR);
            self.y.resize(wanted, FAR);
            self.kind.resize(wanted, 0.0);
        }
    }

    fn push(&mut self, x: f32, y: f32, kind: u32) {
        self.x[self.len] = x;
        self.y[self.len] = y;
        self.kind[self.len] = kind as f32;
        self.len += 1;
    }

    /// Puts a lane's width of far points behind the last.
    fn close(&mut self) {
        self.x[self.len..self.len + LANES].fill(FAR);
    }
}

/// Four numbers from a place in a column.
fn lanes(column: &[f32], from: usize) -> f32x4 {
    let four: [f32; LANES] = column[from..from + LANES].try_into().expect("four lanes");
    f32x4::new(four)
}

impl Near {
    fn unfold(
        &mut self,
        columns: &Columns,
        starts: &[u32],
        images: &[Image],
        home: &Frame,
        radius: f32,
    ) {
        let edge = |k: usize| {
            let c = home.corners();
            (c[(k + 2) % 3] - c[(k + 1) % 3]).length()
        };
        // A point within the radius of the triangle is at most this far below 0 in each of its
        // barycentric coordinates.
        let margin = |k: usize| f32x4::splat(-radius * edge(k) / (home.length * home.apex.y));
        let margins = [margin(0), margin(1), margin(2)];
        let (per_apex, per_length) =
            (f32x4::splat(1.0 / home.apex.y), f32x4::splat(1.0 / home.length));
        let apex_x = f32x4::splat(home.apex.x);
        self.points.len = 0;
        for (k, image) in images.iter().enumerate() {
            if image.distance > radius {
                break;
            }
            let from = starts[image.triangle as usize] as usize;
            let to = starts[image.triangle as usize + 1] as usize;
            self.points.reserve(to - from);
            let mut i = from;
            while i < to {
                let (b1, b2) = (lanes(&columns.b1, i), lanes(&columns.b2, i));
                let x = f32x4::splat(image.origin.x)
                    + b1 * f32x4::splat(image.edge1.x)
                    + b2 * f32x4::splat(image.edge2.x);
                let y = f32x4::splat(image.origin.y)
                    + b1 * f32x4::splat(image.edge1.y)
                    + b2 * f32x4::splat(image.edge2.y);
                let here = (to - i).min(LANES);
                let mut keep = (1 << here) - 1;
                if k > 0 {
                    let h2 = y * per_apex;
                    let h1 = (x - h2 * apex_x) * per_length;
                    let h0 = f32x4::ONE - h1 - h2;
                    let inside =
                        h0.simd_ge(margins[0]) & h1.simd_ge(margins[1]) & h2.simd_ge(margins[2]);
                    keep &= inside.to_bitmask();
                }
                let (x, y) = (x.to_array(), y.to_array());
                while keep != 0 {
                    let lane = keep.trailing_zeros() as usize;
                    keep &= keep - 1;
                    self.points.push(x[lane], y[lane], columns.cell[i + lane] >> TYPE_SHIFT);
                }
                i += LANES;
            }
        }
        self.points.close();
        self.use_grid = self.points.len >= GRID_FROM;
        if self.use_grid {
            self.grid.sort(&self.points, &mut self.binned, radius);
        }
    }

    /// The sum of the forces on the `own`-th cell of the home triangle, of type `kind`, in
    /// centimetres: `sum (1 - adhesion) (1 - d/r) r (x_i - x_j)/d` over the cells within `r`.
    fn push(&self, own: usize, forces: &Forces, kind: u32) -> Vec2 {
        let (x, y) = (self.points.x[own], self.points.y[own]);
        let mut sum = Sum::new(x, y, forces, kind);
        if self.use_grid {
            for row in self.grid.rows_around(x, y) {
                sum.add(&self.binned, row.0, row.1);
            }
        } else {
            sum.add(&self.points, 0, self.points.len);
        }
        sum.total()
    }
}

/// A sum of forces under way, four neighbours at a time.
struct Sum {
    x: f32x4,
    y: f32x4,
    radius: f32x4,
    radius_squared: f32x4,
    weights: [f32x4; 3],
    sum_x: f32x4,
    sum_y: f32x4,
}

impl Sum {
    fn new(x: f32, y: f32, forces: &Forces, kind: u32) -> Sum {
        Sum {
            x: f32x4::splat(x),
            y: f32x4::splat(y),
            radius: f32x4::splat(forces.radius),
            radius_squared: f32x4::splat(forces.radius * forces.radius),
            weights: forces.weights[kind as usize].map(f32x4::splat),
            sum_x: f32x4::ZERO,
            sum_y: f32x4::ZERO,
        }
    }

    /// Adds the forces of the points `from..to`. The cell itself is at a distance of exactly 0 from
    /// its own unfolded place and drops out, as does a cell on the very same spot: it has no
    /// direction to push in.
    #[inline]
    fn add(&mut self, points: &Points, from: usize, to: usize) {
        let mut k = from;
        while k < to {
            let dx = self.x - lanes(&points.x, k);
            let dy = self.y - lanes(&points.y, k);
            let squared = dx * dx + dy * dy;
            let within = squared.simd_lt(self.radius_squared) & squared.simd_gt(f32x4::ZERO);
            let within = within & FIRST[(to - k).min(LANES)];
            let kind = lanes(&points.kind, k);
            let foreground = kind.simd_lt(f32x4::splat(0.5));
            let middle = kind.simd_gt(f32x4::splat(1.5));
            let weight =
                foreground.blend(self.weights[0], middle.blend(self.weights[2], self.weights[1]));
            // (1 - d/r) r / d = r/d - 1
            let scale = within & (weight * (self.radius / squared.sqrt() - f32x4::ONE));
            self.sum_x += dx * scale;
            self.sum_y += dy * scale;
            k += LANES;
        }
    }

    fn total(self) -> Vec2 {
        let (x, y) = (self.sum_x.to_array(), self.sum_y.to_array());
        Vec2::new((x[0] + x[1]) + (x[2] + x[3]), (y[0] + y[1]) + (y[2] + y[3]))
    }
}

/// Masks of the first lanes.
const FIRST: [f32x4; LANES + 1] = {
    const ON: f32 = f32::from_bits(u32::MAX);
    [
        f32x4::new([0.0; 4]),
        f32x4::new([ON, 0.0, 0.0, 0.0]),
        f32x4::new([ON, ON, 0.0, 0.0]),
        f32x4::new([ON, ON, ON, 0.0]),
        f32x4::new([ON; 4]),
    ]
};

/// Square bins as wide as the repulsive radius over the plane of one triangle.
#[derive(Clone, Debug, Default)]
struct Grid {
    low: Vec2,
    bins_per_cm: f32,
    columns: usize,
    rows: usize,
    /// First point of each bin, row by row, and the end of the last.
    starts: Vec<u32>,
    bin_of: Vec<u32>,
}

impl Grid {
    fn sort(&mut self, points: &Points, binned: &mut Points, radius: f32) {
        let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        for k in 0..points.len {
            let p = Vec2::new(points.x[k], points.y[k]);
            low = low.min(p);
            high = high.max(p);
        }
        self.low = low;
        self.bins_per_cm = 1.0 / radius;
        let size = (high - low) * self.bins_per_cm;
        (self.columns, self.rows) = (size.x as usize + 1, size.y as usize + 1);
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        self.bin_of.clear();
        for k in 0..points.len {
            let (column, row) = self.bin(points.x[k], points.y[k]);
            let bin = row * self.columns + column;
            self.bin_of.push(bin as u32);
            self.starts[bin + 1] += 1;
        }
        for b in 1..self.starts.len() {
            self.starts[b] += self.starts[b - 1];
        }
        binned.len = 0;
        binned.reserve(points.len);
        for k in 0..points.len {
            let slot = &mut self.starts[self.bin_of[k] as usize];
            let to = *slot as usize;
            *slot += 1;
            binned.x[to] = points.x[k];
            binned.y[to] = points.y[k];
            binned.kind[to] = points.kind[k];
        }
        binned.len = points.len;
        binned.close();
        let bins = self.columns * self.rows;
        self.starts.copy_within(0..bins, 1);
        self.starts[0] = 0;
    }

    fn bin(&self, x: f32, y: f32) -> (usize, usize) {
        let column = ((x - self.low.x) * self.bins_per_cm) as usize;
        let row = ((y - self.low.y) * self.bins_per_cm) as usize;
        (column.min(self.columns - 1), row.min(self.rows - 1))
    }

    /// The points of the three bins around a point in each of the three rows around it.
    fn rows_around(&self, x: f32, y: f32) -> impl Iterator<Item = (usize, usize)> {
        let (column, row) = self.bin(x, y);
        let columns = column.saturating_sub(1)..(column + 2).min(self.columns);
        (row.saturating_sub(1)..(row + 2).min(self.rows)).map(move |row| {
            let first = row * self.columns;
            (self.starts[first + columns.start] as usize, self.starts[first + columns.end] as usize)
        })
    }
}
