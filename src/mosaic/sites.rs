//! For each triangle the short list of sites whose Voronoi polygons may reach into it: what a
//! fragment shader needs to find the nearest one.

use super::near::{Near, SortedCells};
use crate::surface::{Charts, Frame, Mesh};
use crate::tissue::{Diary, Rim};
use glam::Vec2;
use wide::{f32x4, i32x4};

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
    cells: SortedCells,
    near: Near,
    /// How far from each triangle the sites had to be looked for the last time, in mean spacings.
    reach: Vec<f32>,
}

/// Sites are kept this much farther out than the nearest-site bound asks for, in mean spacings:
/// room for the drawn border between two cells.
const BORDER_ROOM: f32 = 0.15;

/// First guess of the distance in which a triangle finds all its sites, in mean spacings.
const FIRST_REACH: f32 = 1.8;

impl SiteLists {
    /// Builds the lists of a day, exact for every moment between the day before and this one.
    /// `charts` serve all days of a mesh.
    pub fn build(&mut self, mesh: &Mesh, charts: &mut Charts, diary: &Diary, day: usize) {
        let spacing = (mesh.area / diary.days[day].places.len() as f32).sqrt();
        self.cells.gather(mesh, charts, diary, day, spacing);
        self.heads.clear();
        self.sites.clear();
        self.reach.resize(mesh.triangles.len(), FIRST_REACH);
        for (triangle, frame) in mesh.frames.iter().enumerate() {
            let rim = Rim::new(frame);
            let mut reach = self.reach[triangle] * spacing;
            let bound = loop {
                let radius = reach + self.cells.longest_motion;
                let images = charts.around(mesh, triangle as u32, radius);
                self.near.gather(&self.cells, images, &rim, radius);
                let bound =
                    self.near.bound(&self.cells, triangle, frame, spacing) + BORDER_ROOM * spacing;
                // On a part without cells no reach is enough.
                if bound <= reach || reach > mesh.area {
                    break bound;
                }
                reach = if bound.is_finite() { bound } else { reach * 2.0 };
            };
            self.reach[triangle] = (bound * 1.05 / spacing).min(8.0);
            let head = pack(&self.near, frame, &rim, bound, &mut self.sites);
            self.heads.push(head);
        }
    }
}

/// Appends the sites that come within `bound` of a triangle, packed, to a list.
fn pack(near: &Near, frame: &Frame, rim: &Rim, bound: f32, sites: &mut Vec<Site>) -> Head {
    let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
    let first = sites.len();
    let scale_cm = near.farthest(centroid) / 32767.0 + f32::MIN_POSITIVE;
    let per_cm = f32x4::splat(1.0 / scale_cm);
    let (centre_x, centre_y) = (f32x4::splat(centroid.x), f32x4::splat(centroid.y));
    let words = |x: f32x4, y: f32x4| {
        let step = |v: f32x4| (v * per_cm + f32x4::splat(32768.5)).fast_trunc_int();
        let high: i32x4 = step(y - centre_y) << 16_i32;
        (step(x - centre_x) | high).to_array()
    };
    for lanes in near.lanes() {
        let within_now = rim.sides(lanes.now.0, lanes.now.1, bound);
        let within_before = rim.sides(lanes.before.0, lanes.before.1, bound);
        let mut keep = ((within_now[0] | within_before[0])
            & (within_now[1] | within_before[1])
            & (within_now[2] | within_before[2]))
            .to_bitmask()
            & ((1 << lanes.count) - 1);
        let (now, before) =
            (words(lanes.now.0, lanes.now.1), words(lanes.before.0, lanes.before.1));
        while keep != 0 {
            let lane = keep.trailing_zeros() as usize;
            keep &= keep - 1;
            let (cell, kind) = lanes.tag(lane);
            sites.push(Site { now: now[lane] as u32, before: before[lane] as u32, cell, kind });
        }
    }
    Head { first: first as u32, count: (sites.len() - first) as u32, scale_cm, unused: 0 }
}
