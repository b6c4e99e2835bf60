//! One relaxation event: patch by patch the cells are pushed and walk, on one thread or on several.

use super::course::Course;
use super::forces::{ForceLanes, Push};
use super::ground::Ground;
use super::lanes::{LANES, lanes_mut};
use super::near::Near;
use super::plan::{Neighbourhood, Plan};
use super::relax::{Row, four, put_four, rows_of};
#[cfg(not(target_arch = "wasm32"))]
use super::team::Team;
use crate::surface::{Mesh, Place, length, walk};
use glam::Vec2;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};
use wide::f32x4;

/// All that decides where cells go.
pub(super) struct Event<'a> {
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
    pub(super) spacing_cm: f32,
    pub(super) look_cm: f32,
}

impl Event<'_> {
    fn rows_of_slots(&self, slots: &Range<usize>) -> Range<usize> {
        rows_of(self.starts, self.plan.bins_of(slots))
    }
}

/// Those who do the work, each on a thread of its own. Every displacement comes from the old places, so
/// that it does not matter who moves which cells.
#[derive(Debug)]
pub(super) struct Hands {
    /// Each is taken by one thread alone.
    hands: Vec<Mutex<Hand>>,
    #[cfg(not(target_arch = "wasm32"))]
    team: Team,
}

/// Cells are dealt out to more than one hand from so many each on: to start a thread takes as long as to
/// move some hundred cells.
#[cfg(not(target_arch = "wasm32"))]
const CELLS_PER_HAND: usize = 2_000;

/// Several hands take so many pieces of work each, one after the other: cells that crowd take longer, and
/// threads that others hold up do less.
#[cfg(not(target_arch = "wasm32"))]
const PIECES_PER_HAND: usize = 8;

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

/// Where a hand writes: rows from the first of a piece of work on.
struct Output<'a> {
    moved: &'a mut [Row],
    bins: &'a mut [u32],
    first_row: usize,
}

impl Default for Hands {
    fn default() -> Hands {
        Hands {
            hands: vec![Mutex::default()],
            #[cfg(not(target_arch = "wasm32"))]
            team: Team::new(1),
        }
    }
}

impl Hands {
    /// # Panics
    /// If the system gives no threads.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn new(threads: usize) -> Hands {
        let hands = (0..threads.max(1)).map(|_| Mutex::default()).collect();
        Hands { hands, team: Team::new(threads) }
    }

    /// The threads of the hands, if so many cells need several, and as many even ranges of so many things.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn together(
        &self,
        things: usize,
        cells: usize,
    ) -> Option<(&Team, Vec<Range<usize>>)> {
        let hands = self.needed(cells);
        let share = |hand| things * hand / hands..things * (hand + 1) / hands;
        (hands > 1).then(|| (&self.team, (0..hands).map(share).collect()))
    }

    pub(super) fn caught_walks(&self) -> u64 {
        self.hands.iter().map(|hand| held(hand).caught_walks).sum()
    }

    /// How many hands so many cells are dealt out to.
    #[cfg(not(target_arch = "wasm32"))]
    fn needed(&self, cells: usize) -> usize {
        self.hands.len().min(cells / CELLS_PER_HAND).max(1)
    }

    /// Room for all cells of a day.
    pub(super) fn reserve(&mut self, cells: usize) {
        for hand in &self.hands {
            held(hand).near.reserve(cells);
        }
    }

    /// Moves all cells: writes each row and its bin anew.
    pub(super) fn relax(&self, event: &Event, moved: &mut [Row], bins: &mut [u32]) {
        let patches = &event.plan.patches[..];
        #[cfg(not(target_arch = "wasm32"))]
        if self.needed(moved.len()) > 1 {
            return self.relax_together(event, moved, bins);
        }
        let output = &mut Output { moved, bins, first_row: 0 };
        held(&self.hands[0]).relax_patches(event, patches, output);
    }

    /// The same piece by piece, each by a thread that has nothing else to do.
    #[cfg(not(target_arch = "wasm32"))]
    fn relax_together(&self, event: &Event, mut moved: &mut [Row], mut bins: &mut [u32]) {
        let pieces = self.needed(moved.len()) * PIECES_PER_HAND;
        let most = moved.len().div_ceil(pieces);
        let (mut works, mut first_row) = (Vec::with_capacity(pieces + 1), 0);
        let mut patches = &event.plan.patches[..];
        while !patches.is_empty() {
            let begins = |patch: &Neighbourhood| event.rows_of_slots(&patch.own).start;
            let count = patches.partition_point(|patch| begins(patch) < first_row + most);
            let (piece, others) = patches.split_at(count.max(1));
            let rows = others.first().map_or(moved.len(), |patch| begins(patch) - first_row);
            let (own_moved, other_moved) = moved.split_at_mut(rows);
            let (own_bins, other_bins) = bins.split_at_mut(rows);
            works.push((piece, Output { moved: own_moved, bins: own_bins, first_row }));
            (patches, moved, bins, first_row) = (others, other_moved, other_bins, first_row + rows);
        }
        self.team.share(works, |number, (patches, mut output)| {
            held(&self.hands[number]).relax_patches(event, patches, &mut output);
        });
    }
}

/// A hand, to be worked with. One that was dropped in the middle of its work is as good as any: each piece
/// begins anew.
fn held(hand: &Mutex<Hand>) -> MutexGuard<'_, Hand> {
    hand.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Hand {
    /// Moves the cells of patches that follow each other.
    fn relax_patches(&mut self, event: &Event, patches: &[Neighbourhood], output: &mut Output) {
        for patch in patches {
            if !event.rows_of_slots(&patch.own).is_empty() {
                self.relax(event, patch, output);
            }
        }
    }

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
            let forces = event.ground.at(event.plan.order[first]);
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
        let Event { plan, rows, .. } = event;
        self.near.begin(patch.low, patch.high, event.look_cm, event.spacing_cm);
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
            let (repulsion, radius) = event
                .ground
                .repulsions_and_radii_cm(|| slots.map(|slot| plan.order[slot as usize]));
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
            let bins = self.near.first_bins(k) + plan.bins.four_within(b1, b2);
            let count = (rows.end - row).min(LANES);
            output.put_some(to, count, [b1, b2, kind, cell], bins.to_array());
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
            for lane in (0..count).filter(|lane| inside & 1 << lane == 0) {
                let triangle = plan.order[slots[lane] as usize];
                let frame = &mesh.frames[triangle as usize];
                let mut step = frame.point(change_1[lane], change_2[lane]);
                if plan.is_wide {
                    step = as_long_as(step, Vec2::new(x[lane], y[lane]));
                }
                let step = event.course.map_or(step, |course| course.turn(triangle as usize, step));
                let end = walk(mesh, event.rows[row + lane].place(triangle), step);
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
    /// Puts up to four cells down, from a row on.
    #[inline]
    fn put_some(&mut self, row: usize, count: usize, columns: [f32x4; 4], bins: [u32; LANES]) {
        if count == LANES {
            put_four(self.moved, row, columns);
            *lanes_mut(self.bins, row) = bins;
            return;
        }
        let mut four = [Row::default(); LANES];
        put_four(&mut four, 0, columns);
        self.moved[row..row + count].copy_from_slice(&four[..count]);
        self.bins[row..row + count].copy_from_slice(&bins[..count]);
    }

    /// Puts the cell of a row in another place.
    fn put(&mut self, row: usize, place: Place, plan: &Plan) {
        let moved = &mut self.moved[row];
        (moved.b1, moved.b2) = (place.b1, place.b2);
        self.bins[row] = plan.bin(place);
    }
}
