//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use super::course::Course;
use super::event::{Event, Hands};
use super::ground::Ground;
use super::lanes::{BinSort, LANES, copy, lanes, lanes_mut, one};
use super::plan::{Plan, look_cm};
use crate::surface::{Mesh, Place};
use bytemuck::{Pod, Zeroable};
use std::ops::Range;
use wide::f32x4;

/// The cells of one day in the order of their bins, so that cells that lie together in space lie
/// together in memory. A bin is a triangle or, where many cells share one, one of the equal
/// triangles that it is cut into.
#[derive(Debug, Default)]
pub struct Crowd {
    plan: Plan,
    cells: usize,
    /// How many of the types there are, from the first on.
    types: usize,
    /// With `LANES` spare rows.
    rows: Vec<Row>,
    sorting: BinSort,
    /// Where the cells have moved to, before they are sorted again, and their bins there.
    moved: Vec<Row>,
    bins: Vec<u32>,
    hands: Hands,
}

/// A cell in its triangle.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Row {
    pub(super) b1: f32,
    pub(super) b2: f32,
    /// The type as a number, 0.0, 1.0 or 2.0.
    pub(super) kind: f32,
    /// The cell's number.
    cell: u32,
}

/// Four rows from one on: `b1`, `b2`, the types, and the bits of the cells' numbers.
#[inline]
pub(super) fn four(rows: &[Row], first: usize) -> [f32x4; 4] {
    let numbers = bytemuck::cast_slice(rows);
    f32x4::transpose(std::array::from_fn(|k| lanes(numbers, 4 * (first + k))))
}

#[inline]
pub(super) fn put_four(rows: &mut [Row], first: usize, columns: [f32x4; 4]) {
    let numbers = bytemuck::cast_slice_mut(rows);
    for (k, row) in f32x4::transpose(columns).into_iter().enumerate() {
        *lanes_mut(numbers, 4 * (first + k)) = row.to_array();
    }
}

impl Crowd {
    /// So many threads work on an event; the cells come out the same.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn set_threads(&mut self, threads: usize) {
        self.hands = Hands::new(threads);
    }

    /// The body is so many times larger than it was, and of the same shape.
    pub fn scale_ground(&mut self, scale: f32) {
        self.plan.scale(scale);
    }

    /// The body has another shape: nothing of how it was laid flat holds any more.
    pub fn forget_ground(&mut self) {
        self.plan = Plan::default();
    }

    /// Walks that ended among slivers instead of where they were going.
    pub fn caught_walks(&self) -> u64 {
        self.hands.caught_walks()
    }

    /// Takes up the cells of a day: their places, and their types, by number. No cell will look further
    /// than `reach_cm`.
    pub fn gather(
        &mut self,
        mesh: &Mesh,
        places: &[Place],
        kind: impl Fn(usize) -> u8 + Sync,
        reach_cm: f32,
    ) {
        self.cells = places.len();
        self.plan.renew(mesh, self.cells, reach_cm);
        self.rows.resize(self.cells + LANES, Row::default());
        self.moved.resize(self.cells, Row::default());
        self.bins.resize(self.cells, 0);
        self.hands.reserve(self.cells);
        self.types = (0..self.cells).map(&kind).max().map_or(1, |most| usize::from(most) + 1);
        let plan = &self.plan;
        let take_up = |number: usize, row: &mut Row, bin: &mut u32| {
            let Place { b1, b2, .. } = places[number];
            *row = Row { b1, b2, kind: f32::from(kind(number)), cell: number as u32 };
            *bin = plan.bin(places[number]);
        };
        #[cfg(not(target_arch = "wasm32"))]
        if let Some((team, numbers)) = self.hands.together(self.cells, self.cells) {
            let (moved, bins) = (&mut self.moved[..], &mut self.bins[..]);
            super::threads::take_up(team, &numbers, moved, bins, take_up);
            return self.sort();
        }
        let rows = self.moved.iter_mut().zip(&mut self.bins);
        (0..self.cells).zip(rows).for_each(|(number, (row, bin))| take_up(number, row, bin));
        self.sort();
    }

    /// The places of all cells by their numbers.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::default(); self.cells];
        #[cfg(not(target_arch = "wasm32"))]
        if let Some((team, slots)) = self.hands.together(self.plan.order.len(), self.cells) {
            let tell = |slots, tell: &mut dyn FnMut(usize, Place)| self.tell(slots, tell);
            super::threads::scatter(team, &slots, &mut places, tell);
            return places;
        }
        self.tell(0..self.plan.order.len(), |cell, place| places[cell] = place);
        places
    }

    /// Tells the cells in some triangles, by their order in the plan, and their places.
    fn tell(&self, slots: Range<usize>, mut tell: impl FnMut(usize, Place)) {
        for slot in slots {
            let triangle = self.plan.order[slot];
            for row in &self.rows[self.rows_of(self.plan.bins.of(slot))] {
                tell(row.cell as usize, row.place(triangle));
            }
        }
    }

    /// One event: every displacement is computed from the old places, then all cells move. The ground
    /// is of the reach that the cells were gathered with. With a course, each displacement is turned
    /// along its direction field.
    pub fn relax(&mut self, mesh: &Mesh, ground: &Ground, course: Option<&Course>) {
        let event = Event {
            mesh,
            ground,
            course,
            plan: &self.plan,
            rows: &self.rows,
            starts: &self.sorting.starts,
            full_bins: if self.plan.is_wide { self.full_bins() } else { Vec::new() },
            types: self.types,
            spacing_cm: (mesh.area / self.cells as f32).sqrt(),
            look_cm: look_cm(mesh, self.cells, ground.reach_cm()),
        };
        self.hands.relax(&event, &mut self.moved, &mut self.bins);
        self.sort();
    }

    /// The bins that hold cells.
    fn full_bins(&self) -> Vec<u32> {
        let bins = self.sorting.starts[..=self.plan.bins_in_all()].windows(2).zip(0..);
        bins.filter(|(ends, _)| ends[0] < ends[1]).map(|(_, bin)| bin).collect()
    }

    /// The rows of some bins.
    fn rows_of(&self, bins: Range<usize>) -> Range<usize> {
        rows_of(&self.sorting.starts, bins)
    }

    /// Sorts the moved cells by their bins; those of one bin keep their order.
    fn sort(&mut self) {
        let bins_in_all = self.plan.bins_in_all();
        let (moved, rows) = (&self.moved[..], &mut self.rows[..]);
        #[cfg(not(target_arch = "wasm32"))]
        if let Some((team, shares)) = self.hands.together(self.cells, self.cells) {
            let unsorted = (&self.bins[..], &shares[..], bins_in_all);
            return super::threads::sort(team, &mut self.sorting, unsorted, moved, rows);
        }
        self.sorting.sort(&self.bins, bins_in_all, move |row, to| {
            // SAFETY: there is a row for each cell.
            unsafe { copy(moved, row, rows, to) };
        });
    }
}

/// The rows of some bins.
#[inline]
pub(super) fn rows_of(starts: &[u32], bins: Range<usize>) -> Range<usize> {
    one(starts, bins.start) as usize..one(starts, bins.end) as usize
}

impl Row {
    pub(super) fn place(&self, triangle: u32) -> Place {
        Place { triangle, b1: self.b1, b2: self.b2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::NO_TWIN;
    use crate::tissue::Recipe;
    use crate::tissue::chance::{Purpose, uniform};
    use glam::Vec3;

    /// A flat sheet of 16 by 8 cm of which the triangles of the left half come first.
    fn sheet() -> Mesh {
        let positions =
            (0..17 * 33).map(|k| Vec3::new((k % 33) as f32, (k / 33) as f32, 0.0) * 0.5);
        let squares =
            (0..2).flat_map(|half| (0..256).map(move |k| k % 16 + 16 * half + 33 * (k / 16)));
        let triangles = squares.flat_map(|v| [[v, v + 1, v + 34], [v, v + 34, v + 33]]);
        Mesh::new(positions.collect(), Vec::new(), triangles.collect()).unwrap()
    }

    #[test]
    fn on_each_side_of_a_wall_cells_go_the_ways_of_that_side_alone() {
        let mut whole = sheet();
        let per_half = whole.triangles.len() / 2;
        for h in 0..whole.twins.len() {
            let twin = whole.twins[h];
            if twin != NO_TWIN && (h / 3 < per_half) != (twin as usize / 3 < per_half) {
                whole.part(h as u32);
            }
        }
        let share = |k: u32, turn| 0.5 * uniform(k.into(), turn, Purpose::Clock) as f32;
        let cells = 3_000;
        let triangle = |k: u32| k.wrapping_mul(2_654_435_761) >> 16;
        let recipe = Recipe { radius_scale: 2.0, repulsion: 0.6, ..Recipe::default() };
        // Each on one of the two halves, in turn.
        let places: Vec<Place> = (0..cells)
            .map(|k| Place {
                triangle: triangle(k) % per_half as u32 + (k % 2) * per_half as u32,
                b1: share(k, 0),
                b2: share(k, 1),
            })
            .collect();
        let relaxed = |mesh: &Mesh, places: &[Place], kind: &(dyn Fn(usize) -> u8 + Sync)| {
            let ground = Ground::new(mesh, mesh, &recipe, &[], places.len(), 1);
            let mut crowd = Crowd::default();
            crowd.gather(mesh, places, kind, ground.reach_cm());
            (0..30).for_each(|_| crowd.relax(mesh, &ground, None));
            crowd.places()
        };
        let both = relaxed(&whole, &places, &|k| (k / 2 % 2) as u8);
        assert_ne!(both, places);
        for half in [0, 1] {
            let triangles = whole.triangles[half * per_half..][..per_half].to_vec();
            let alone = Mesh::new(whole.positions.clone(), Vec::new(), triangles).unwrap();
            let first = (half * per_half) as u32;
            let of_half = |all: &[Place]| -> Vec<Place> {
                let some = all.iter().skip(half).step_by(2);
                some.map(|&place| Place { triangle: place.triangle - first, ..place }).collect()
            };
            let found = relaxed(&alone, &of_half(&places), &|k| (k % 2) as u8);
            // Bit for bit.
            assert_eq!(found, of_half(&both), "half {half}");
        }
    }

    #[test]
    fn full_bins_are_those_that_cells_lie_in() {
        let mesh = crate::surface::icosphere(2, 10.0);
        let share = |k, turn| 0.5 * uniform(k, turn, Purpose::Clock) as f32;
        let places: Vec<Place> = (0..200)
            .map(|k| Place {
                triangle: k * k % 317,
                b1: share(k.into(), 0),
                b2: share(k.into(), 1),
            })
            .collect();
        let mut crowd = Crowd::default();
        crowd.gather(&mesh, &places, |_| 0, 1.0);
        let mut bins: Vec<u32> = places.iter().map(|&place| crowd.plan.bin(place)).collect();
        bins.sort_unstable();
        bins.dedup();
        assert!(bins.len() < crowd.plan.bins_in_all());
        assert_eq!(crowd.full_bins(), bins);
    }
}
