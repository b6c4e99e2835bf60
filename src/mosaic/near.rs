//! The sites around one triangle, unfolded into its plane, now and the day before.

use crate::surface::{Charts, Frame, Image, Mesh, Place, length};
use crate::tissue::{Bins, Diary, LANES, Rim, lanes, lanes_mut};
use glam::Vec2;
use wide::f32x4;

/// Cells that a bin should hold, as for the forces.
const CELLS_PER_BIN: f32 = 2.5;

/// Ways longer than this, in mean spacings, are shown from this far off only: sites would have to be
/// looked for that much farther around every triangle, for the sake of a few cells.
const MOST_MOTION: f32 = 0.75;

/// Sites of its own that make a triangle look no further for the bound on its distances.
const ENOUGH_SITES: usize = 4;

/// Sample points of a triangle for that bound, by its size in mean spacings: finer costs more than
/// the shorter lists save.
const SAMPLES_PER_SPACING: f32 = 2.2;
const MAX_SAMPLE_CUTS: usize = 6;

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
    /// Longest way that a cell is shown to go since the day before, in centimetres.
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
        let most = MOST_MOTION * spacing;
        for (cell, &place) in now.iter().enumerate() {
            let mut ancestor = cell;
            while ancestor >= before.len() {
                ancestor = diary.lineage[ancestor].parent as usize;
            }
            let was = seen_from(mesh, charts, place, before[ancestor], 2.0 * spacing);
            let frame = &mesh.frames[place.triangle as usize];
            let way = Vec2::new(was.x - place.b1, was.y - place.b2);
            let motion = length(frame.point(way.x, way.y));
            let share = if motion > most { most / motion } else { 1.0 };
            let was = Vec2::new(place.b1, place.b2) + way * share;
            longest = longest.max(motion * share);
            let slot = &mut self.starts[self.bins.bin(place) as usize];
            let to = *slot as usize;
            *slot += 1;
            self.columns[0][to] = place.b1;
            self.columns[1][to] = place.b2;
            self.columns[2][to] = was.x;
            self.columns[3][to] = was.y;
            self.tags[to] = cell as u32 | (diary.lineage[cell].kind as u32) << TYPE_SHIFT;
        }
        self.longest_motion = longest;
        self.starts.copy_within(0..bins, 1);
        self.starts[0] = 0;
    }

    /// The farthest that a corner of a triangle lies from its centroid, in centimetres.
    pub fn size(&self, triangle: usize) -> f32 {
        self.bins.sizes[triangle] * self.bins.cuts as f32
    }

    /// The rows of a triangle's cells.
    pub fn of(&self, triangle: usize) -> std::ops::Range<usize> {
        let bins = self.bins.of(triangle);
        self.rows(bins.start, bins.end)
    }

    /// The site of a row, in the frame of its triangle.
    pub fn site(&self, frame: &Frame, row: usize) -> NearSite {
        let [now_b1, now_b2, before_b1, before_b2] = self.columns.each_ref().map(|c| c[row]);
        let (now, before) = (frame.point(now_b1, now_b2), frame.point(before_b1, before_b2));
        NearSite::new(now, before, self.tags[row])
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
            let point = image.laid.point(before.b1, before.b2);
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
    pub len: usize,
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
                let (x, y) = image.laid.points(b1, b2);
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

    /// Takes up sites that were found from the cells' side.
    pub fn take(&mut self, sites: &[NearSite]) {
        self.len = sites.len();
        if self.tags.len() < self.len + LANES {
            self.grow(self.len + LANES);
        }
        for (k, site) in sites.iter().enumerate() {
            let places = [site.now.x, site.now.y, site.before.x, site.before.y];
            for (column, place) in self.columns.iter_mut().zip(places) {
                column[k] = place;
            }
            self.tags[k] = site.cell | site.kind << TYPE_SHIFT;
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
            let (x, y) = image.laid.points(lanes(now_b1, row), lanes(now_b2, row));
            *lanes_mut(now_x, to) = x.to_array();
            *lanes_mut(now_y, to) = y.to_array();
            let (x, y) = image.laid.points(lanes(before_b1, row), lanes(before_b2, row));
            *lanes_mut(before_x, to) = x.to_array();
            *lanes_mut(before_y, to) = y.to_array();
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
    /// from each of a grid of points the way to a site, and to that point from any other. `spacing`
    /// is the mean spacing of the cells.
    pub fn bound(&self, cells: &SortedCells, triangle: usize, frame: &Frame, spacing: f32) -> f32 {
        let own = cells.of(triangle).len();
        // The triangle's own sites bound nearly as well as all, where it has some.
        let sites = if own >= ENOUGH_SITES { own } else { self.len };
        let whole_size = cells.size(triangle);
        let cuts =
            ((SAMPLES_PER_SPACING * whole_size / spacing) as usize).clamp(1, MAX_SAMPLE_CUTS);
        let share = 1.0 / cuts as f32;
        let mut worst = 0.0f32;
        for i in 0..cuts {
            for column in 0..2 * (cuts - i) - 1 {
                let third = if column % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                let (b1, b2) = (i as f32 + third, (column / 2) as f32 + third);
                let nearest = self.nearest_squared(frame.point(b1 * share, b2 * share), sites);
                worst = if nearest > worst { nearest } else { worst };
            }
        }
        worst.sqrt() + whole_size * share
    }

    /// Squared distance from a point to the nearest of the first sites, each taken at the end of its
    /// motion that is farther away.
    fn nearest_squared(&self, p: Vec2, sites: usize) -> f32 {
        let (x, y) = (f32x4::splat(p.x), f32x4::splat(p.y));
        let squared = |(site_x, site_y): (f32x4, f32x4)| {
            let (dx, dy) = (site_x - x, site_y - y);
            dx * dx + dy * dy
        };
        let mut nearest = f32x4::splat(f32::INFINITY);
        for first in (0..sites / LANES * LANES).step_by(LANES) {
            let [now, before] = self.four(first);
            nearest = nearest.fast_min(squared(now).fast_max(squared(before)));
        }
        let mut least = nearest.to_array().into_iter().fold(f32::INFINITY, f32::min);
        let [now_x, now_y, before_x, before_y] = &self.columns;
        for k in sites / LANES * LANES..sites {
            let now = p.distance_squared(Vec2::new(now_x[k], now_y[k]));
            let before = p.distance_squared(Vec2::new(before_x[k], before_y[k]));
            least = least.min(now.max(before));
        }
        least
    }

    /// Place now and before of a site, in centimetres, its cell's number and the index of its type.
    pub fn site(&self, k: usize) -> NearSite {
        let [now_x, now_y, before_x, before_y] = self.columns.each_ref().map(|column| column[k]);
        NearSite::new(Vec2::new(now_x, now_y), Vec2::new(before_x, before_y), self.tags[k])
    }

    /// The x and y now and before of four sites. Lanes behind the last site repeat old ones.
    #[inline]
    pub fn four(&self, first: usize) -> [(f32x4, f32x4); 2] {
        let [now_x, now_y, before_x, before_y] =
            self.columns.each_ref().map(|column| lanes(column, first));
        [(now_x, now_y), (before_x, before_y)]
    }
}

/// A site near a triangle.
#[derive(Clone, Copy, Debug)]
pub struct NearSite {
    /// In centimetres, in the triangle's frame.
    pub now: Vec2,
    pub before: Vec2,
    pub cell: u32,
    /// The index of its `CellType`.
    pub kind: u32,
}

impl NearSite {
    fn new(now: Vec2, before: Vec2, tag: u32) -> NearSite {
        let (cell, kind) = (tag & ((1 << TYPE_SHIFT) - 1), tag >> TYPE_SHIFT);
        NearSite { now, before, cell, kind }
    }
}
