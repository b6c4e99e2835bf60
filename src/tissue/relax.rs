//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use super::course::Course;
use super::forces::{ForceLanes, Push};
use super::ground::Ground;
use super::lanes::{LANES, copy, lanes, sort_by_bin};
use super::near::Near;
use super::plan::{Neighbourhood, Plan, look_cm};
use crate::surface::{Mesh, Place, walk};
use std::ops::Range;
use wide::f32x4;

/// The cells of one day in the order of their bins, so that cells that lie together in space lie
/// together in memory. A bin is a triangle or, where many cells share one, one of the equal
/// triangles that it is cut into.
#[derive(Clone, Debug, Default)]
pub struct Crowd {
    plan: Plan,
    cells: usize,
    columns: Columns,
    /// The first cell of each bin, and the end of the last.
    starts: Vec<u32>,
    /// Where the cells have moved to, before they are sorted again.
    moved: Moved,
    scratch: Columns,
    near: Near,
    /// On the cells of the patch that was unfolded last.
    pushes: Vec<Push>,
    /// Walks that ended among slivers instead of where they were going.
    pub caught_walks: u64,
}

/// All columns end with `LANES` spare rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    pub(super) b1: Vec<f32>,
    pub(super) b2: Vec<f32>,
    /// The type as a number, 0.0, 1.0 or 2.0.
    pub(super) kind: Vec<f32>,
    /// The cell's number.
    cell: Vec<u32>,
}

#[derive(Clone, Debug, Default)]
struct Moved {
    b1: Vec<f32>,
    b2: Vec<f32>,
    bin: Vec<u32>,
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
        self.scratch.resize(self.cells);
        self.columns.resize(self.cells);
        self.moved.b1.resize(self.cells + LANES, 0.0);
        self.moved.b2.resize(self.cells + LANES, 0.0);
        self.moved.bin.resize(self.cells, 0);
        self.near.reserve(self.cells);
        self.pushes.resize(self.cells + LANES, Push::default());
        for (number, (place, kind)) in cells.enumerate() {
            self.columns.cell[number] = number as u32;
            self.columns.kind[number] = f32::from(kind);
            self.move_to(number, place);
        }
        self.sort();
    }

    /// The places of all cells by their numbers.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::default(); self.cells];
        for (slot, &triangle) in self.plan.order.iter().enumerate() {
            for row in self.rows(self.plan.bins.of(slot)) {
                places[self.columns.cell[row] as usize] = self.place(triangle, row);
            }
        }
        places
    }

    /// One event: every displacement is computed from the old places, then all cells move. The ground
    /// is of the reach that the cells were gathered with. With a course, each displacement is turned
    /// along its direction field.
    pub fn relax(&mut self, mesh: &Mesh, ground: &Ground, course: Option<&Course>) {
        let look_cm = look_cm(mesh, self.cells, ground.reach_cm());
        for p in 0..self.plan.patches.len() {
            let patch = self.plan.patches[p].clone();
            let own = self.rows(self.plan.bins_of(&patch.own));
            if own.is_empty() {
                continue;
            }
            self.unfold(&patch, look_cm);
            self.near.sort();
            // On even ground a whole patch at once.
            let alike = if let Ground::Even(_) = ground { patch.own.len() } else { 1 };
            for first in patch.own.clone().step_by(alike) {
                let forces = ForceLanes::new(ground.at(self.plan.order[first]));
                let rows = self.rows(self.plan.bins_of(&(first..first + alike)));
                let near_row = rows.start - own.start;
                let kinds = &self.columns.kind[rows];
                for ((k, &kind), push) in kinds.iter().enumerate().zip(&mut self.pushes[near_row..])
                {
                    *push = forces.push(&self.near, near_row + k, kind);
                }
            }
            self.step(mesh, own, ground, course);
        }
        self.sort();
    }

    /// Moves the cells of some rows, of the patch that was unfolded last, as they are pushed in its
    /// plane: at most half the repulsive radius far.
    fn step(&mut self, mesh: &Mesh, rows: Range<usize>, ground: &Ground, course: Option<&Course>) {
        let bins_in_triangle = self.plan.bins.in_triangle() as u32;
        for row in rows.clone().step_by(LANES) {
            let count = (rows.end - row).min(LANES);
            let mut slots = self.near.slots(row - rows.start);
            // Behind the last row anything may stand.
            let last = slots[count - 1];
            slots[count..].fill(last);
            let [b1_x, b1_y, b2_x, b2_y] = f32x4::transpose(slots.map(|slot| {
                let [b1, b2] = self.plan.own[slot as usize].to_barycentric;
                f32x4::new([b1.x, b1.y, b2.x, b2.y])
            }));
            let pushes = self.pushes[row - rows.start..][..LANES].try_into().expect("four");
            let (x, y) = Push::totals(pushes);
            let local = slots.map(|slot| ground.at(self.plan.order[slot as usize]));
            let repulsion = f32x4::new(local.map(|forces| forces.repulsion));
            let longest = f32x4::HALF * f32x4::new(local.map(|forces| forces.radius));
            let (x, y) = (x * repulsion, y * repulsion);
            let squared = x * x + y * y;
            let capped = squared.simd_gt(longest * longest);
            let share = capped.select(longest / squared.sqrt(), f32x4::ONE);
            let (x, y) = (x * share, y * share);
            let (change_1, change_2) = (x * b1_x + y * b1_y, x * b2_x + y * b2_y);
            let b1 = lanes(&self.columns.b1, row) + change_1;
            let b2 = lanes(&self.columns.b2, row) + change_2;
            let b0 = f32x4::ONE - b1 - b2;
            let inside =
                b0.simd_ge(f32x4::ZERO) & b1.simd_ge(f32x4::ZERO) & b2.simd_ge(f32x4::ZERO);
            let bins = self.plan.bins.four_within(b1, b2).to_array();
            // Along a course every step is turned first.
            let inside = if course.is_none() { inside.to_bitmask() } else { 0 };
            let (b1, b2) = (b1.to_array(), b2.to_array());
            let (change_1, change_2) = (change_1.to_array(), change_2.to_array());
            for lane in 0..count {
                let slot = slots[lane];
                if inside & 1 << lane != 0 {
                    let bin = slot * bins_in_triangle + bins[lane] as u32;
                    self.put(row + lane, bin, b1[lane], b2[lane]);
                } else {
                    let triangle = self.plan.order[slot as usize];
                    let frame = &mesh.frames[triangle as usize];
                    let step = frame.point(change_1[lane], change_2[lane]);
                    let step = course.map_or(step, |course| course.turn(triangle as usize, step));
                    let end = walk(mesh, self.place(triangle, row + lane), step);
                    self.caught_walks += u64::from(end.caught);
                    self.move_to(row + lane, end.place);
                }
            }
        }
    }

    /// Lays the cells in and around a patch down in its plane, its own first.
    fn unfold(&mut self, patch: &Neighbourhood, look_cm: f32) {
        self.near.begin(patch.low, patch.high, look_cm);
        for slot in patch.own.clone() {
            let rows = self.rows(self.plan.bins.of(slot));
            self.near.unfold_own(&self.columns, &self.plan.own[slot].image, rows, slot);
        }
        for run in &self.plan.runs[patch.around.clone()] {
            let rows = self.starts[run.first_bin as usize] as usize
                ..self.starts[run.end_bin as usize] as usize;
            self.near.unfold(&self.columns, &run.image, rows);
        }
    }

    /// The rows of some bins.
    fn rows(&self, bins: Range<usize>) -> Range<usize> {
        self.starts[bins.start] as usize..self.starts[bins.end] as usize
    }

    fn place(&self, triangle: u32, row: usize) -> Place {
        let (b1, b2) = (self.columns.b1[row], self.columns.b2[row]);
        Place { triangle, b1, b2 }
    }

    fn move_to(&mut self, row: usize, place: Place) {
        self.put(row, self.plan.bin(place), place.b1, place.b2);
    }

    #[inline]
    fn put(&mut self, row: usize, bin: u32, b1: f32, b2: f32) {
        self.moved.b1[row] = b1;
        self.moved.b2[row] = b2;
        self.moved.bin[row] = bin;
    }

    /// Sorts the moved cells by their bins; those of one bin keep their order.
    fn sort(&mut self) {
        let Moved { b1, b2, bin } = &self.moved;
        let Columns { kind, cell, .. } = &self.columns;
        let bins_in_all = self.plan.bins_in_all();
        sort_by_bin(bin, bins_in_all, &mut self.starts, |row, to| {
            // SAFETY: all columns are of the same length, more than there are cells.
            unsafe {
                copy(b1, row, &mut self.scratch.b1, to);
                copy(b2, row, &mut self.scratch.b2, to);
                copy(kind, row, &mut self.scratch.kind, to);
                copy(cell, row, &mut self.scratch.cell, to);
            }
        });
        std::mem::swap(&mut self.columns, &mut self.scratch);
    }
}
