//! One relaxation event: patch by patch the cells are pushed and walk, on one thread or on several.

use super::Rules;
use super::course::Course;
use super::forces::{ForceLanes, Push};
use super::ground::Ground;
use super::lanes::{LANES, lanes_mut};
use super::near::Near;
use super::plan::{Neighbourhood, Plan, look_cm};
use super::relax::{Row, four, put_four, rows_of};
use crate::surface::{Mesh, Place, length};
use glam::Vec2;
use std::ops::Range;
use wide::f32x4;

/// All that decides where cells go.
pub(super) struct Event<'a> {
    pub(super) rules: Rules,
    pub(super) mesh: &'a Mesh,
    pub(super) ground: &'a Ground,
    pub(super) course: Option<&'a Course>,
    pub(super) plan: &'a Plan,
    /// The cells before the event.
    pub(super) rows: &'a [Row],
    /// The first row of each bin, and the end of the last.
    pub(super) starts: &'a [u32],
    /// The bins that hold cells, where those may be far fewer than the triangles around a patch.
    pub(super) full_bins: Vec<u32>,
    /// How many of the types there are, from the first on.
    pub(super) types: usize,
    pub(super) cells: usize,
    pub(super) spacing_cm: f32,
}

impl Event<'_> {
    fn rows_of_slots(&self, slots: &Range<usize>) -> Range<usize> {
        rows_of(self.starts, self.plan.bins_of(slots))
    }
}

/// Those who do the work, each on a thread of its own. Every displacement comes from the old places, so
/// that it does not matter who moves which cells.
#[derive(Clone, Debug)]
pub(super) struct Hands {
    hands: Vec<Hand>,
    #[cfg(not(target_arch = "wasm32"))]
    threads: Option<std::sync::Arc<rayon::ThreadPool>>,
}

/// Cells are dealt out to more than one hand from so many each on: to start a thread takes as long as to
/// move some hundred cells.
const CELLS_PER_HAND: usize = 2_000;

/// To search a bin takes as long as to look through so many runs without cells.
const RUNS_PER_SEARCH: usize = 8;

/// One who works.
#[derive(Clone, Debug, Default)]
struct Hand {
    near: Near,
    /// On the cells of the patch that was unfolded last.
    pushes: Vec<Push>,
    caught_walks: u64,
}

/// Where a hand writes: rows from the first of its own on, with spare ones behind the last.
struct Output<'a> {
    moved: &'a mut [Row],
    bins: &'a mut [u32],
    first_row: usize,
}

impl Default for Hands {
    fn default() -> Hands {
        Hands {
            hands: vec![Hand::default()],
            #[cfg(not(target_arch = "wasm32"))]
            threads: None,
        }
    }
}

impl Hands {
    /// # Panics
    /// If the system gives no threads.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn new(threads: usize) -> Hands {
        let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let threads_of_pool =
            (threads > 1).then(|| std::sync::Arc::new(pool().expect("the system gives threads")));
        Hands { hands: vec![Hand::default(); threads.max(1)], threads: threads_of_pool }
    }

    /// The threads of the hands, if so many cells need several: then `relax` is to be called among them.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn threads_for(&self, cells: usize) -> Option<std::sync::Arc<rayon::ThreadPool>> {
        self.threads.clone().filter(|_| self.needed(cells) > 1)
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.hands.len()
    }

    pub(super) fn caught_walks(&self) -> u64 {
        self.hands.iter().map(|hand| hand.caught_walks).sum()
    }

    /// Ranges of so many things, as even as can be, for each hand that there is work for with so many cells.
    pub(super) fn even_shares(&self, things: usize, cells: usize) -> Vec<Range<usize>> {
        let hands = self.needed(cells);
        (0..hands).map(|hand| things * hand / hands..things * (hand + 1) / hands).collect()
    }

    /// How many hands so many cells are dealt out to.
    fn needed(&self, cells: usize) -> usize {
        self.hands.len().min(cells / CELLS_PER_HAND).max(1)
    }

    /// Room for all that a patch may see.
    pub(super) fn reserve(&mut self, cells: usize) {
        for hand in &mut self.hands {
            hand.near.reserve(cells);
        }
    }

    /// Moves all cells. `moved` and `bins` have `LANES` spare rows for each hand; returns those that hold
    /// cells, in the order of the cells.
    pub(super) fn relax(
        &mut self,
        event: &Event,
        moved: &mut [Row],
        bins: &mut [u32],
    ) -> Vec<Range<usize>> {
        let shares = self.shares(event);
        let (mut moved, mut bins) = (moved, bins);
        let (mut works, mut written) = (Vec::new(), Vec::new());
        let mut spare = 0;
        for (hand, patches) in self.hands.iter_mut().zip(shares) {
            let slots = event.plan.slots_of(&patches);
            let rows = event.rows_of_slots(&slots);
            let (own_moved, other_moved) = moved.split_at_mut(rows.len() + LANES);
            let (own_bins, other_bins) = bins.split_at_mut(rows.len() + LANES);
            (moved, bins) = (other_moved, other_bins);
            written.push(rows.start + spare..rows.end + spare);
            spare += LANES;
            let output = Output { moved: own_moved, bins: own_bins, first_row: rows.start };
            works.push(Work { hand, patches, output });
        }
        match works {
            #[cfg(not(target_arch = "wasm32"))]
            works if works.len() > 1 => rayon::scope(|all| {
                for work in works {
                    all.spawn(|_| work.do_it(event));
                }
            }),
            works => works.into_iter().for_each(|work| work.do_it(event)),
        }
        written
    }

    /// The patches of each hand: about as many cells for all, and one hand alone where they are few.
    fn shares(&self, event: &Event) -> Vec<Range<usize>> {
        let patches = event.plan.patches.len();
        let cells = event.rows_of_slots(&(0..event.plan.order.len())).len();
        let hands = self.needed(cells);
        let mut first = 0;
        (1..=hands)
            .map(|number| {
                let begins = |patch: &Neighbourhood| event.rows_of_slots(&patch.own).start;
                let enough = cells * number / hands;
                let end = event.plan.patches.partition_point(|patch| begins(patch) < enough);
                let share = first..if number == hands { patches } else { end.max(first) };
                first = share.end;
                share
            })
            .collect()
    }
}

/// A hand and what it is to do.
struct Work<'a> {
    hand: &'a mut Hand,
    patches: Range<usize>,
    output: Output<'a>,
}

impl Work<'_> {
    fn do_it(mut self, event: &Event) {
        for patch in &event.plan.patches[self.patches] {
            if !event.rows_of_slots(&patch.own).is_empty() {
                self.hand.relax(event, patch, &mut self.output);
            }
        }
    }
}

impl Hand {
    /// Moves the cells of a patch.
    fn relax(&mut self, event: &Event, patch: &Neighbourhood, output: &mut Output) {
        let own = event.rows_of_slots(&patch.own);
        if self.pushes.len() < own.len() + LANES {
            self.pushes.resize(own.len() + LANES, Push::default());
        }
        self.unfold(event, patch);
        self.near.sort();
        // On even ground a whole patch at once.
        let alike = if let Ground::Even(_) = event.ground { patch.own.len() } else { 1 };
        let mut weighed = None;
        for first in patch.own.clone().step_by(alike) {
            let forces = event.ground.at(event.mesh, event.plan.order[first]);
            if weighed != Some(forces.weights) {
                self.near.weigh(&forces.weights[..event.types]);
                weighed = Some(forces.weights);
            }
            let forces = ForceLanes::new(forces);
            let rows = event.rows_of_slots(&(first..first + alike));
            let near_row = rows.start - own.start;
            let pushes = &mut self.pushes[near_row..];
            for ((k, row), push) in event.rows[rows].iter().enumerate().zip(pushes) {
                *push = forces.push(&self.near, near_row + k, row.kind);
            }
        }
        self.step(event, own, output);
    }

    /// Lays the cells in and around a patch down in its plane, its own first.
    fn unfold(&mut self, event: &Event, patch: &Neighbourhood) {
        let Event { mesh, plan, rows, .. } = event;
        let reach_cm = event.ground.reach_around_cm(mesh, plan.order[patch.own.start]);
        let look_cm = look_cm(mesh, event.cells, reach_cm);
        self.near.begin(patch.low, patch.high, look_cm, event.spacing_cm);
        for slot in patch.own.clone() {
            let bins = plan.bins.of(slot);
            let first_bin = bins.start;
            let own = rows_of(event.starts, bins);
            self.near.unfold_own(rows, &plan.own[slot].laid, own, slot, first_bin);
        }
        if plan.is_wide && event.full_bins.len() * RUNS_PER_SEARCH < patch.around.len() {
            for &bin in &event.full_bins {
                if let Some(run) = patch.run_of(bin) {
                    let around = rows_of(event.starts, bin as usize..bin as usize + 1);
                    self.near.unfold(rows, &run.laid, around);
                }
            }
            return;
        }
        for run in &patch.around {
            let around = rows_of(event.starts, run.first_bin as usize..run.end_bin as usize);
            self.near.unfold(rows, &run.laid, around);
        }
    }

    /// Moves the cells of some rows, of the patch that was unfolded last, as they are pushed in its
    /// plane: at most half the repulsive radius far.
    fn step(&mut self, event: &Event, rows: Range<usize>, output: &mut Output) {
        let Event { mesh, plan, .. } = event;
        for row in rows.clone().step_by(LANES) {
            let k = row - rows.start;
            let to = row - output.first_row;
            let slots = self.near.slots(k);
            let (x, y) = Push::totals(self.pushes[k..k + LANES].try_into().expect("four"));
            let triangles = slots.map(|slot| plan.order[slot as usize]);
            let (repulsion, radius) = event.ground.repulsions_and_radii_cm(mesh, triangles);
            let longest = f32x4::HALF * radius;
            let (x, y) = (x * repulsion, y * repulsion);
            let squared = x * x + y * y;
            let capped = squared.simd_gt(longest * longest);
            let share = capped.select(longest / squared.sqrt(), f32x4::ONE);
            let (x, y) = (x * share, y * share);
            let [b1_x, b1_y, b2_x, b2_y] = f32x4::transpose(slots.map(|slot| {
                let [b1, b2] = plan.own[slot as usize].to_barycentric;
                f32x4::new([b1.x, b1.y, b2.x, b2.y])
            }));
            let (change_1, change_2) = (x * b1_x + y * b1_y, x * b2_x + y * b2_y);
            let [b1, b2, kind, cell] = four(event.rows, row);
            let (b1, b2) = (b1 + change_1, b2 + change_2);
            let b0 = f32x4::ONE - b1 - b2;
            put_four(output.moved, to, [b1, b2, kind, cell]);
            let bins = self.near.first_bins(k) + plan.bins.four_within(b1, b2);
            *lanes_mut(output.bins, to) = bins.to_array();
            // Most steps stay in their triangle. Along a course every step is turned first, and what was
            // smoothed is of another size.
            let inside =
                b0.simd_ge(f32x4::ZERO) & b1.simd_ge(f32x4::ZERO) & b2.simd_ge(f32x4::ZERO);
            let stays = event.course.is_none() && !plan.is_wide;
            let inside = if stays { inside.to_bitmask() } else { 0 };
            if inside == (1 << LANES) - 1 {
                continue;
            }
            let (change_1, change_2) = (change_1.to_array(), change_2.to_array());
            let (x, y) = (x.to_array(), y.to_array());
            let count = (rows.end - row).min(LANES);
            for lane in (0..count).filter(|lane| inside & 1 << lane == 0) {
                let triangle = triangles[lane];
                let frame = &mesh.frames[triangle as usize];
                let mut step = frame.point(change_1[lane], change_2[lane]);
                if plan.is_wide {
                    step = as_long_as(step, Vec2::new(x[lane], y[lane]));
                }
                let step = event.course.map_or(step, |course| course.turn(triangle as usize, step));
                let from = event.rows[row + lane].place(triangle);
                let end = event.rules.walk(mesh, from, step);
                self.caught_walks += u64::from(end.caught);
                output.put(to + lane, end.place, plan);
            }
        }
    }
}

/// The first vector with the length of the second.
fn as_long_as(direction: Vec2, other: Vec2) -> Vec2 {
    let now = length(direction);
    if now > 0.0 { direction * (length(other) / now) } else { direction }
}

impl Output<'_> {
    /// Puts the cell of a row in another place.
    fn put(&mut self, row: usize, place: Place, plan: &Plan) {
        let moved = &mut self.moved[row];
        (moved.b1, moved.b2) = (place.b1, place.b2);
        self.bins[row] = plan.bin(place);
    }
}
