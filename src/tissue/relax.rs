//! Relaxation: the cells push each other away, all together (Thesis 3.2.1.1).

use super::bins::Bins;
use super::course::Course;
use super::near::{Columns, Forces, Lanes, Near};
use crate::surface::{Charts, Mesh, Place, walk};
use glam::Vec2;
use std::ops::Range;

/// Cells that a bin should hold. Fewer, and most of the work is looking into bins; more, and it is
/// looking at cells that are too far away.
const CELLS_PER_BIN: f32 = 3.0;

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

impl Crowd {
    /// Takes up the cells of a day: their places and types by number.
    pub fn gather(&mut self, mesh: &Mesh, cells: impl ExactSizeIterator<Item = (Place, u8)>) {
        self.bins = Bins::new(mesh, cells.len(), CELLS_PER_BIN);
        self.scratch.resize(cells.len());
        self.columns.resize(cells.len());
        self.near.reserve(cells.len());
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
    /// With a course, each displacement is turned along its direction field.
    pub fn relax(
        &mut self,
        mesh: &Mesh,
        charts: &mut Charts,
        forces: &Forces,
        course: Option<&Course>,
    ) {
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
                let step = course.map_or(step, |course| course.turn(triangle, step));
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
