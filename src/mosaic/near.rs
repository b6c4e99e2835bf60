//! The sites around one triangle, unfolded into its plane, now and the day before.

use crate::surface::{Charts, Frame, Image, Mesh, Place};
use crate::tissue::{Bins, Diary, Rim};
use glam::Vec2;
use wide::f32x4;

/// Cells that a bin should hold: few, so that the distance to a bin's own site is a good bound.
const CELLS_PER_BIN: f32 = 1.5;

/// Rows behind the last, for whole lanes.
const LANES: usize = 4;

/// The type stands in the two high bits of a cell's number.
const TYPE_SHIFT: u32 = 30;

/// The cells of a day sorted by bins, each with where it was the day before.
#[derive(Clone, Debug, Default)]
pub struct SortedCells {
    /// `b1` and `b2` now and before, in the triangle of now; those of before may lie outside it.
    columns: [Vec<f32>; 4],
    tags: Vec<u32>,
    bins: Bins,
    starts: Vec<u32>,
    /// Longest way that a cell has gone since the day before, at most two spacings, in centimetres.
    pub longest_motion: f32,
}

impl SortedCells {
    pub fn gather(
        &mut self,
        mesh: &Mesh,
        charts: &mut Charts,
        diary: &Diary,
        day: usize,
        spacing: f32,
    ) {
        let now = &diary.days[day].places;
        let before = &diary.days[day.saturating_sub(1)].places;
        for column in &mut self.columns {
            column.resize(now.len() + LANES, 0.0);
        }
        self.tags.resize(now.len() + LANES, 0);
        self.bins = Bins::new(mesh, now.len(), CELLS_PER_BIN);
        let bins = mesh.triangles.len() * self.bins.in_triangle();
        self.starts.clear();
        self.starts.resize(bins + 1, 0);
        for &place in now {
            self.starts[self.bins.bin(place) as usize + 1] += 1;
        }
        for b in 0..bins {
            self.starts[b + 1] += self.starts[b];
        }
        let mut longest = 0.0f32;
        for (cell, &place) in now.iter().enumerate() {
            let mut ancestor = cell;
            while ancestor >= before.len() {
                ancestor = diary.lineage[ancestor].parent as usize;
            }
            let was = seen_from(mesh, charts, place, before[ancestor], 2.0 * spacing);
            let frame = &mesh.frames[place.triangle as usize];
            let motion = frame.point(place.b1 - was.x, place.b2 - was.y).length_squared();
            longest = if motion > longest { motion } else { longest };
            let slot = &mut self.starts[self.bins.bin(place) as usize];
            let to = *slot as usize;
            *slot += 1;
            self.columns[0][to] = place.b1;
            self.columns[1][to] = place.b2;
            self.columns[2][to] = was.x;
            self.columns[3][to] = was.y;
            self.tags[to] = cell as u32 | (diary.lineage[cell].kind as u32) << TYPE_SHIFT;
        }
        self.longest_motion = longest.sqrt().min(2.0 * spacing);
        self.starts.copy_within(0..bins, 1);
        self.starts[0] = 0;
    }

    fn rows(&self, first_bin: usize, end_bin: usize) -> std::ops::Range<usize> {
        self.starts[first_bin] as usize..self.starts[end_bin] as usize
    }
}

/// The barycentric coordinates of `before` in the triangle of `now`, unfolded into its plane; `now`
/// itself where that is too far away to be unfolded.
fn seen_from(mesh: &Mesh, charts: &mut Charts, now: Place, before: Place, radius: f32) -> Vec2 {
    if now.triangle == before.triangle {
        return Vec2::new(before.b1, before.b2);
    }
    let images = charts.around(mesh, now.triangle, radius);
    match images.iter().find(|image| image.triangle == before.triangle) {
        None => Vec2::new(now.b1, now.b2),
        Some(image) => {
            let point = image.origin + image.edge1 * before.b1 + image.edge2 * before.b2;
            mesh.frames[now.triangle as usize].barycentric(point)
        }
    }
}

/// The sites around one triangle, unfolded into its plane, its own first.
#[derive(Clone, Debug, Default)]
pub struct Near {
    /// x and y now, x and y before, in centimetres.
    columns: [Vec<f32>; 4],
    tags: Vec<u32>,
    len: usize,
}

/// Four sites side by side.
pub struct Lanes<'a> {
    pub now: (f32x4, f32x4),
    pub before: (f32x4, f32x4),
    /// How many of the four there are.
    pub count: usize,
    tags: &'a [u32],
}

impl Lanes<'_> {
    /// The number and the type of the cell in a lane.
    pub fn tag(&self, lane: usize) -> (u32, u32) {
        let tag = self.tags[lane];
        (tag & ((1 << TYPE_SHIFT) - 1), tag >> TYPE_SHIFT)
    }
}

impl Near {
    /// Takes up the sites in all bins that come within `radius` of the triangle.
    pub fn gather(&mut self, cells: &SortedCells, images: &[Image], rim: &Rim, radius: f32) {
        self.len = 0;
        let bins = &cells.bins;
        for (k, image) in images.iter().enumerate() {
            if image.distance > radius {
                break;
            }
            let of = bins.of(image.triangle as usize);
            if k == 0 || bins.cuts == 1 {
                self.unfold(cells, image, cells.rows(of.start, of.end));
                continue;
            }
            let reach = radius + bins.sizes[image.triangle as usize];
            let mut first = of.start;
            while first < of.end {
                let (b1, b2) = bins.centroids(first - of.start);
                let (x, y) = image.points(b1, b2);
                let mut near = rim.within(x, y, reach) & ((1 << (of.end - first).min(LANES)) - 1);
                while near != 0 {
                    let bin = first + near.trailing_zeros() as usize;
                    near &= near - 1;
                    self.unfold(cells, image, cells.rows(bin, bin + 1));
                }
                first += LANES;
            }
        }
    }

    /// Unfolds the cells of some rows. Whole lanes are written; what is too much is overwritten by
    /// the next.
    #[inline]
    fn unfold(&mut self, cells: &SortedCells, image: &Image, rows: std::ops::Range<usize>) {
        let wanted = self.len + rows.len() + LANES;
        if self.tags.len() < wanted {
            self.grow(wanted);
        }
        let [now_b1, now_b2, before_b1, before_b2] = &cells.columns;
        let [now_x, now_y, before_x, before_y] = &mut self.columns;
        let (mut row, mut to) = (rows.start, self.len);
        while row < rows.end {
            let (x, y) = image.points(lanes(now_b1, row), lanes(now_b2, row));
            now_x[to..to + LANES].copy_from_slice(&x.to_array());
            now_y[to..to + LANES].copy_from_slice(&y.to_array());
            let (x, y) = image.points(lanes(before_b1, row), lanes(before_b2, row));
            before_x[to..to + LANES].copy_from_slice(&x.to_array());
            before_y[to..to + LANES].copy_from_slice(&y.to_array());
            self.tags[to..to + LANES].copy_from_slice(&cells.tags[row..row + LANES]);
            row += LANES;
            to += LANES;
        }
        self.len += rows.len();
    }

    #[cold]
    fn grow(&mut self, wanted: usize) {
        let wanted = wanted.next_power_of_two();
        for column in &mut self.columns {
            column.resize(wanted, 0.0);
        }
        self.tags.resize(wanted, 0);
    }

    /// A distance within which every point of the triangle has its nearest site at every moment:
    /// for each of its bins the distance of the centroid to a site, and from there to any point.
    pub fn bound(&self, cells: &SortedCells, triangle: usize, frame: &Frame) -> f32 {
        let of = cells.bins.of(triangle);
        let first_row = cells.starts[of.start] as usize;
        let mut worst = 0.0f32;
        for bin in of.clone() {
            let centroid = cells.bins.centroid(bin - of.start);
            let centroid = frame.point(centroid.x, centroid.y);
            let own = cells.rows(bin, bin + 1);
            let nearest = if own.is_empty() {
                self.nearest_squared(centroid, 0..self.len)
            } else {
                self.nearest_squared(centroid, own.start - first_row..own.end - first_row)
            };
            worst = worst.max(nearest);
        }
        worst.sqrt() + cells.bins.sizes[triangle]
    }

    /// Squared distance from a point to the nearest of some sites, each taken at the end of its
    /// motion that is farther away.
    fn nearest_squared(&self, p: Vec2, sites: std::ops::Range<usize>) -> f32 {
        let [now_x, now_y, before_x, before_y] = &self.columns;
        let squared = |x: f32, y: f32| (x - p.x) * (x - p.x) + (y - p.y) * (y - p.y);
        let mut nearest = f32::INFINITY;
        for k in sites {
            let (now, before) = (squared(now_x[k], now_y[k]), squared(before_x[k], before_y[k]));
            let farther = if now > before { now } else { before };
            nearest = if farther < nearest { farther } else { nearest };
        }
        nearest
    }

    /// The farthest that a coordinate of a site lies from that of a point.
    pub fn farthest(&self, centre: Vec2) -> f32 {
        let (x, y) = (f32x4::splat(centre.x), f32x4::splat(centre.y));
        let mut most = f32x4::ZERO;
        for lanes in self.lanes() {
            for v in [lanes.now.0 - x, lanes.before.0 - x, lanes.now.1 - y, lanes.before.1 - y] {
                most = most.fast_max(v.abs());
            }
        }
        most.to_array().into_iter().fold(0.0, f32::max)
    }

    /// All sites, four at a time. Lanes behind the last site repeat old ones.
    pub fn lanes(&self) -> impl Iterator<Item = Lanes<'_>> {
        (0..self.len).step_by(LANES).map(|k| {
            let four = |column: usize| lanes(&self.columns[column], k);
            Lanes {
                now: (four(0), four(1)),
                before: (four(2), four(3)),
                count: (self.len - k).min(LANES),
                tags: &self.tags[k..k + LANES],
            }
        })
    }
}

/// Four numbers from a row of a column on.
#[inline]
fn lanes(column: &[f32], row: usize) -> f32x4 {
    let four: [f32; LANES] = column[row..row + LANES].try_into().expect("four lanes");
    f32x4::new(four)
}
