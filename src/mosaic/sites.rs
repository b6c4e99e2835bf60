//! For each triangle the short list of sites whose Voronoi polygons may reach into it: what a
//! fragment shader needs to find the nearest one.

use crate::surface::{Charts, Frame, Mesh, Place};
use crate::tissue::Diary;
use glam::Vec2;
use wide::f32x4;

/// One candidate site of one triangle, four words as the shader reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Site {
    /// Place on the shown day in the triangle's plane: `x` in the low 16 bits, `y` in the high 16,
    /// each `(value - 32768) * scale` centimetres from the triangle's centroid.
    pub now: u32,
    /// The same for the day before (for a cell born since: its parent's place). Motion between the
    /// days is the straight line from `before` to `now`.
    pub before: u32,
    /// The cell's number.
    pub cell: u32,
    /// The index of its `CellType`.
    pub kind: u32,
}

/// The list of one triangle, four words as the shader reads them.
#[derive(Clone, Copy, Debug, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Head {
    /// Index of the first site of the list, and how many there are.
    pub first: u32,
    pub count: u32,
    /// Centimetres of one step of the packed coordinates.
    pub scale_cm: f32,
    pub unused: u32,
}

/// The lists of all triangles for one day. Reuse it for the next day: it keeps its memory, and
/// what it learnt of the distances.
#[derive(Clone, Debug, Default)]
pub struct SiteLists {
    pub heads: Vec<Head>,
    pub sites: Vec<Site>,
    cells: Cells,
    near: Near,
    /// How far from each triangle the sites had to be looked for the last time, in mean spacings.
    reach: Vec<f32>,
}

/// Sites are kept this much farther out than the nearest-site bound asks for, in mean spacings:
/// room for the drawn border between two cells.
const BORDER_ROOM: f32 = 0.15;

/// First guess of the distance in which a triangle finds all its sites, in mean spacings.
const FIRST_REACH: f32 = 1.6;

impl SiteLists {
    /// Builds the lists of a day, exact for every moment between the day before and this one.
    /// `charts` are those of `Images::Visible` for the mesh and serve all its days.
    pub fn build(&mut self, mesh: &Mesh, charts: &mut Charts, diary: &Diary, day: usize) {
        let spacing = (mesh.area / diary.days[day].places.len() as f32).sqrt();
        self.cells.gather(mesh, charts, diary, day, spacing);
        self.heads.clear();
        self.sites.clear();
        self.reach.resize(mesh.triangles.len(), FIRST_REACH);
        for triangle in 0..mesh.triangles.len() {
            let frame = &mesh.frames[triangle];
            let samples = Samples::of(frame, spacing);
            let mut reach = self.reach[triangle] * spacing;
            let bound = loop {
                let radius = reach + self.cells.longest_motion;
                let images = charts.around(mesh, triangle as u32, radius);
                self.near.gather(&self.cells, images, frame, reach, radius);
                let bound = samples.bound(&self.near) + BORDER_ROOM * spacing;
                // On a part without cells no reach is enough.
                if bound <= reach || reach > mesh.area {
                    break bound;
                }
                reach = if bound.is_finite() { bound * 1.02 } else { reach * 2.0 };
            };
            self.reach[triangle] = (bound * 1.05 / spacing).min(8.0);
            let head = self.near.pack(&self.cells, frame, bound, &mut self.sites);
            self.heads.push(head);
        }
    }
}

/// The cells of a day sorted by triangle, each with where it was the day before.
#[derive(Clone, Debug, Default)]
struct Cells {
    /// `b1` and `b2` now and before, in the triangle of now; those of before may lie outside it.
    now: [Vec<f32>; 2],
    before: [Vec<f32>; 2],
    cell: Vec<u32>,
    kind: Vec<u8>,
    starts: Vec<u32>,
    /// Longest way that a cell has gone since the day before, at most two spacings, in centimetres.
    longest_motion: f32,
}

/// Rows behind the last, for whole lanes.
const SPARE: usize = 4;

impl Cells {
    fn gather(
        &mut self,
        mesh: &Mesh,
        charts: &mut Charts,
        diary: &Diary,
        day: usize,
        spacing: f32,
    ) {
        let now = &diary.days[day].places;
        let before = &diary.days[day.saturating_sub(1)].places;
        self.resize(now.len());
        self.starts.clear();
        self.starts.resize(mesh.triangles.len() + 1, 0);
        for place in now {
            self.starts[place.triangle as usize + 1] += 1;
        }
        for t in 0..mesh.triangles.len() {
            self.starts[t + 1] += self.starts[t];
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
            longest = longest.max(motion);
            let slot = &mut self.starts[place.triangle as usize];
            let to = *slot as usize;
            *slot += 1;
            self.now[0][to] = place.b1;
            self.now[1][to] = place.b2;
            self.before[0][to] = was.x;
            self.before[1][to] = was.y;
            self.cell[to] = cell as u32;
            self.kind[to] = diary.lineage[cell].kind as u8;
        }
        self.longest_motion = longest.sqrt().min(2.0 * spacing);
        self.starts.copy_within(0..mesh.triangles.len(), 1);
        self.starts[0] = 0;
    }

    fn resize(&mut self, cells: usize) {
        for column in self.now.iter_mut().chain(&mut self.before) {
            column.resize(cells + SPARE, 0.0);
        }
        self.cell.resize(cells, 0);
        self.kind.resize(cells, 0);
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

/// The sites around one triangle, unfolded into its plane.
#[derive(Clone, Debug, Default)]
struct Near {
    now_x: Vec<f32>,
    now_y: Vec<f32>,
    before_x: Vec<f32>,
    before_y: Vec<f32>,
    /// Rows of `Cells`.
    row: Vec<u32>,
}

impl Near {
    /// Takes up all sites that come within `reach` of the triangle on their way from before to
    /// now, among the images within `radius`.
    fn gather(
        &mut self,
        cells: &Cells,
        images: &[crate::surface::Image],
        frame: &Frame,
        reach: f32,
        radius: f32,
    ) {
        for column in [&mut self.now_x, &mut self.now_y, &mut self.before_x, &mut self.before_y] {
            column.clear();
        }
        self.row.clear();
        let rim = Rim::new(frame, reach);
        for image in images {
            if image.distance > radius {
                break;
            }
            let from = cells.starts[image.triangle as usize] as usize;
            let to = cells.starts[image.triangle as usize + 1] as usize;
            let mut i = from;
            while i < to {
                let (x0, y0) = unfold(image, &cells.before, i);
                let (x1, y1) = unfold(image, &cells.now, i);
                let mut keep = rim.touches((x0, y0), (x1, y1)) & ((1 << (to - i).min(4)) - 1);
                let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(f32x4::to_array);
                while keep != 0 {
                    let lane = keep.trailing_zeros() as usize;
                    keep &= keep - 1;
                    self.before_x.push(x0[lane]);
                    self.before_y.push(y0[lane]);
                    self.now_x.push(x1[lane]);
                    self.now_y.push(y1[lane]);
                    self.row.push((i + lane) as u32);
                }
                i += 4;
            }
        }
    }

    /// Appends the sites that come within `bound` of the triangle, packed, to a list.
    fn pack(&self, cells: &Cells, frame: &Frame, bound: f32, sites: &mut Vec<Site>) -> Head {
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let first = sites.len();
        let farthest = [&self.now_x, &self.before_x]
            .into_iter()
            .flatten()
            .map(|x| (x - centroid.x).abs())
            .chain(
                [&self.now_y, &self.before_y].into_iter().flatten().map(|y| (y - centroid.y).abs()),
            )
            .fold(0.0f32, f32::max);
        let scale_cm = farthest / 32767.0 + f32::MIN_POSITIVE;
        let per_cm = 1.0 / scale_cm;
        let pack = |x: f32, y: f32| {
            let step = |v: f32| (v * per_cm + 32768.5) as u32 & 0xffff;
            step(x - centroid.x) | step(y - centroid.y) << 16
        };
        let rim = Rim::new(frame, bound);
        for k in 0..self.row.len() {
            let four = |column: &[f32]| f32x4::splat(column[k]);
            let touches = rim.touches(
                (four(&self.before_x), four(&self.before_y)),
                (four(&self.now_x), four(&self.now_y)),
            );
            if touches != 0 {
                let row = self.row[k] as usize;
                sites.push(Site {
                    now: pack(self.now_x[k], self.now_y[k]),
                    before: pack(self.before_x[k], self.before_y[k]),
                    cell: cells.cell[row],
                    kind: u32::from(cells.kind[row]),
                });
            }
        }
        Head { first: first as u32, count: (sites.len() - first) as u32, scale_cm, unused: 0 }
    }
}

/// Four cells of a triangle from a row on, in the plane into which it is unfolded.
fn unfold(image: &crate::surface::Image, place: &[Vec<f32>; 2], row: usize) -> (f32x4, f32x4) {
    let four = |column: &[f32]| {
        let lanes: [f32; 4] = column[row..row + 4].try_into().expect("four lanes");
        f32x4::new(lanes)
    };
    let (b1, b2) = (four(&place[0]), four(&place[1]));
    let along =
        |o: f32, e1: f32, e2: f32| f32x4::splat(o) + b1 * f32x4::splat(e1) + b2 * f32x4::splat(e2);
    (
        along(image.origin.x, image.edge1.x, image.edge2.x),
        along(image.origin.y, image.edge1.y, image.edge2.y),
    )
}

/// A triangle widened on all sides: the lines beyond which a point is farther from it than that.
struct Rim {
    per_apex: f32x4,
    per_length: f32x4,
    apex_x: f32x4,
    lowest: [f32x4; 3],
}

impl Rim {
    fn new(frame: &Frame, width: f32) -> Rim {
        let corners = frame.corners();
        let lowest = [0, 1, 2].map(|k| {
            let edge = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).length();
            f32x4::splat(-width * edge / (frame.length * frame.apex.y))
        });
        Rim {
            per_apex: f32x4::splat(1.0 / frame.apex.y),
            per_length: f32x4::splat(1.0 / frame.length),
            apex_x: f32x4::splat(frame.apex.x),
            lowest,
        }
    }

    /// The lanes in which the way between two points is not wholly beyond one of the lines.
    fn touches(&self, a: (f32x4, f32x4), b: (f32x4, f32x4)) -> u32 {
        let (a, b) = (self.within(a), self.within(b));
        ((a[0] | b[0]) & (a[1] | b[1]) & (a[2] | b[2])).to_bitmask()
    }

    fn within(&self, (x, y): (f32x4, f32x4)) -> [f32x4; 3] {
        let h2 = y * self.per_apex;
        let h1 = (x - h2 * self.apex_x) * self.per_length;
        let h0 = f32x4::ONE - h1 - h2;
        [h0.simd_ge(self.lowest[0]), h1.simd_ge(self.lowest[1]), h2.simd_ge(self.lowest[2])]
    }
}

/// Points of a triangle such that every point of it lies within `radius` of one.
struct Samples {
    points: Vec<Vec2>,
    radius: f32,
}

impl Samples {
    /// The centroids of a subdivision about as fine as the spacing of the cells.
    fn of(frame: &Frame, spacing: f32) -> Samples {
        let corners = frame.corners();
        let centroid = (corners[1] + corners[2]) / 3.0;
        let longest = frame.length.max(frame.apex.length()).max((corners[1] - corners[2]).length());
        let cuts = ((longest / spacing) as u32 + 1).min(8);
        let farthest = corners.iter().map(|c| c.distance(centroid)).fold(0.0, f32::max);
        let share = 1.0 / cuts as f32;
        let mut points = Vec::with_capacity((cuts * cuts) as usize);
        for i in 0..cuts {
            for j in 0..cuts - i {
                let at = |third: f32| {
                    frame.point((i as f32 + third) * share, (j as f32 + third) * share)
                };
                points.push(at(1.0 / 3.0));
                if i + j + 1 < cuts {
                    points.push(at(2.0 / 3.0));
                }
            }
        }
        Samples { points, radius: farthest * share }
    }

    /// A distance within which every point of the triangle has its nearest site at every moment.
    fn bound(&self, near: &Near) -> f32 {
        let mut worst = 0.0f32;
        for p in &self.points {
            let mut nearest = f32::INFINITY;
            for k in 0..near.row.len() {
                let now = (near.now_x[k] - p.x) * (near.now_x[k] - p.x)
                    + (near.now_y[k] - p.y) * (near.now_y[k] - p.y);
                let before = (near.before_x[k] - p.x) * (near.before_x[k] - p.x)
                    + (near.before_y[k] - p.y) * (near.before_y[k] - p.y);
                let farther = if now > before { now } else { before };
                nearest = if farther < nearest { farther } else { nearest };
            }
            worst = worst.max(nearest);
        }
        worst.sqrt() + self.radius
    }
}
