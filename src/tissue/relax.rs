//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use super::course::Course;
use super::forces::{ForceLanes, Push};
use super::ground::Ground;
use super::lanes::{BinSort, LANES, copy, lanes, lanes_mut, one};
use super::near::Near;
use super::plan::{Neighbourhood, Plan, look_cm};
use crate::surface::{Mesh, Place, walk};
use bytemuck::{Pod, Zeroable};
use std::ops::Range;
use wide::f32x4;

/// The cells of one day in the order of their bins, so that cells that lie together in space lie
/// together in memory. A bin is a triangle or, where many cells share one, one of the equal
/// triangles that it is cut into.
#[derive(Clone, Debug, Default)]
pub struct Crowd {
    plan: Plan,
    cells: usize,
    /// How many of the types there are, from the first on.
    types: usize,
    /// With `LANES` spare rows, as `moved` and `bins`.
    rows: Vec<Row>,
    sorting: BinSort,
    /// Where the cells have moved to, before they are sorted again, and their bins there.
    moved: Vec<Row>,
    bins: Vec<u32>,
    near: Near,
    /// On the cells of the patch that was unfolded last.
    pushes: Vec<Push>,
    /// Walks that ended among slivers instead of where they were going.
    pub caught_walks: u64,
}

/// A cell in its triangle.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Row {
    b1: f32,
    b2: f32,
    /// The type as a number, 0.0, 1.0 or 2.0.
    kind: f32,
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
fn put_four(rows: &mut [Row], first: usize, columns: [f32x4; 4]) {
    let numbers = bytemuck::cast_slice_mut(rows);
    for (k, row) in f32x4::transpose(columns).into_iter().enumerate() {
        *lanes_mut(numbers, 4 * (first + k)) = row.to_array();
    }
}

impl Crowd {
    /// Takes up the cells of a day: their places and types by number. No cell will look further
    /// than `reach_cm`.
    pub fn gather(
        &mut self,
        mesh: &Mesh,
        cells: impl ExactSizeIterator<Item = (Place, u8)>,
        reach_cm: f32,
    ) {
        self.cells = cells.len();
        self.plan.renew(mesh, self.cells, reach_cm);
        let count = self.cells + LANES;
        self.rows.resize(count, Row::default());
        self.moved.resize(count, Row::default());
        self.bins.resize(count, 0);
        self.pushes.resize(count, Push::default());
        self.near.reserve(self.cells);
        self.types = 1;
        for (number, (place, kind)) in cells.enumerate() {
            self.types = self.types.max(usize::from(kind) + 1);
            self.moved[number] =
                Row { kind: f32::from(kind), cell: number as u32, ..Row::default() };
            self.move_to(number, place);
        }
        self.sort();
    }

    /// The places of all cells by their numbers.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::default(); self.cells];
        for (slot, &triangle) in self.plan.order.iter().enumerate() {
            for row in &self.rows[self.rows_of(self.plan.bins.of(slot))] {
                places[row.cell as usize] = row.place(triangle);
            }
        }
        places
    }

    /// One event: every displacement is computed from the old places, then all cells move. The ground
    /// is of the reach that the cells were gathered with. With a course, each displacement is turned
    /// along its direction field.
    pub fn relax(&mut self, mesh: &Mesh, ground: &Ground, course: Option<&Course>) {
        let spacing_cm = (mesh.area / self.cells as f32).sqrt();
        let look_cm = look_cm(mesh, self.cells, ground.reach_cm());
        for p in 0..self.plan.patches.len() {
            let patch = self.plan.patches[p].clone();
            let own = self.rows_of(self.plan.bins_of(&patch.own));
            if own.is_empty() {
                continue;
            }
            self.unfold(&patch, look_cm, spacing_cm);
            self.near.sort();
            // On even ground a whole patch at once.
            let alike = if let Ground::Even(_) = ground { patch.own.len() } else { 1 };
            let mut weighed = None;
            for first in patch.own.clone().step_by(alike) {
                let forces = ground.at(self.plan.order[first]);
                if weighed != Some(forces.weights) {
                    self.near.weigh(&forces.weights[..self.types]);
                    weighed = Some(forces.weights);
                }
                let forces = ForceLanes::new(forces);
                let rows = self.rows_of(self.plan.bins_of(&(first..first + alike)));
                let near_row = rows.start - own.start;
                let pushes = &mut self.pushes[near_row..];
                for ((k, row), push) in self.rows[rows].iter().enumerate().zip(pushes) {
                    *push = forces.push(&self.near, near_row + k, row.kind);
                }
            }
            self.step(mesh, own, ground, course);
        }
        self.sort();
    }

    /// Moves the cells of some rows, of the patch that was unfolded last, as they are pushed in its
    /// plane: at most half the repulsive radius far.
    fn step(&mut self, mesh: &Mesh, rows: Range<usize>, ground: &Ground, course: Option<&Course>) {
        for row in rows.clone().step_by(LANES) {
            let k = row - rows.start;
            let slots = self.near.slots(k);
            let (x, y) = Push::totals(self.pushes[k..k + LANES].try_into().expect("four"));
            let (repulsion, radius) =
                ground.repulsions_and_radii_cm(|| slots.map(|slot| self.plan.order[slot as usize]));
            let longest = f32x4::HALF * radius;
            let (x, y) = (x * repulsion, y * repulsion);
            let squared = x * x + y * y;
            let capped = squared.simd_gt(longest * longest);
            let share = capped.select(longest / squared.sqrt(), f32x4::ONE);
            let (x, y) = (x * share, y * share);
            let [b1_x, b1_y, b2_x, b2_y] = f32x4::transpose(slots.map(|slot| {
                let [b1, b2] = self.plan.own[slot as usize].to_barycentric;
                f32x4::new([b1.x, b1.y, b2.x, b2.y])
            }));
            let (change_1, change_2) = (x * b1_x + y * b1_y, x * b2_x + y * b2_y);
            let [b1, b2, kind, cell] = four(&self.rows, row);
            let (b1, b2) = (b1 + change_1, b2 + change_2);
            let b0 = f32x4::ONE - b1 - b2;
            put_four(&mut self.moved, row, [b1, b2, kind, cell]);
            let bins = self.near.first_bins(k) + self.plan.bins.four_within(b1, b2);
            *lanes_mut(&mut self.bins, row) = bins.to_array();
            // Most steps stay in their triangle. Along a course every step is turned first.
            let inside =
                b0.simd_ge(f32x4::ZERO) & b1.simd_ge(f32x4::ZERO) & b2.simd_ge(f32x4::ZERO);
            let inside = if course.is_none() { inside.to_bitmask() } else { 0 };
            if inside == (1 << LANES) - 1 {
                continue;
            }
            let (change_1, change_2) = (change_1.to_array(), change_2.to_array());
            let count = (rows.end - row).min(LANES);
            for lane in (0..count).filter(|lane| inside & 1 << lane == 0) {
                let triangle = self.plan.order[slots[lane] as usize];
                let frame = &mesh.frames[triangle as usize];
                let step = frame.point(change_1[lane], change_2[lane]);
                let step = course.map_or(step, |course| course.turn(triangle as usize, step));
                let end = walk(mesh, self.rows[row + lane].place(triangle), step);
                self.caught_walks += u64::from(end.caught);
                self.move_to(row + lane, end.place);
            }
        }
    }

    /// Lays the cells in and around a patch down in its plane, its own first.
    fn unfold(&mut self, patch: &Neighbourhood, look_cm: f32, spacing_cm: f32) {
        self.near.begin(patch.low, patch.high, look_cm, spacing_cm);
        for slot in patch.own.clone() {
            let bins = self.plan.bins.of(slot);
            let (image, rows) = (&self.plan.own[slot].image, self.rows_of(bins.clone()));
            self.near.unfold_own(&self.rows, image, rows, slot, bins.start);
        }
        for run in &self.plan.runs[patch.around.clone()] {
            let rows = self.rows_of(run.first_bin as usize..run.end_bin as usize);
            self.near.unfold(&self.rows, &run.image, rows);
        }
    }

    /// The rows of some bins.
    fn rows_of(&self, bins: Range<usize>) -> Range<usize> {
        let starts = &self.sorting.starts;
        one(starts, bins.start) as usize..one(starts, bins.end) as usize
    }

    /// Puts the cell of a row in another place.
    fn move_to(&mut self, row: usize, place: Place) {
        let moved = &mut self.moved[row];
        (moved.b1, moved.b2) = (place.b1, place.b2);
        self.bins[row] = self.plan.bin(place);
    }

    /// Sorts the moved cells by their bins; those of one bin keep their order.
    fn sort(&mut self) {
        let (moved, bins) = (&self.moved[..], &self.bins[..self.cells]);
        let rows = &mut self.rows[..];
        self.sorting.sort(bins, self.plan.bins_in_all(), move |row, to| {
            // SAFETY: both have as many rows, more than there are cells.
            unsafe { copy(moved, row, rows, to) };
        });
    }
}

impl Row {
    fn place(&self, triangle: u32) -> Place {
        Place { triangle, b1: self.b1, b2: self.b2 }
    }
}
