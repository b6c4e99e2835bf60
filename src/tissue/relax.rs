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
    use crate::tissue::chance::{Purpose, uniform};

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
