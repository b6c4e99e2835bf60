//! What several threads do together beside moving the cells, natively.

use super::lanes::{BinSort, Share};
use super::relax::Row;
use super::team::Team;
use crate::surface::Place;
use std::cell::Cell;
use std::ops::Range;

/// Calls `take_up` for the rows and bins of all numbers, which are in shares that follow each other.
pub(super) fn take_up(
    team: &Team,
    shares: &[Range<usize>],
    mut moved: &mut [Row],
    mut bins: &mut [u32],
    take_up: impl Fn(usize, &mut Row, &mut u32) + Sync,
) {
    let mut pieces = Vec::with_capacity(shares.len());
    for share in shares {
        let (own_moved, other_moved) = moved.split_at_mut(share.len());
        let (own_bins, other_bins) = bins.split_at_mut(share.len());
        (moved, bins) = (other_moved, other_bins);
        pieces.push((share.clone(), own_moved.iter_mut().zip(own_bins)));
    }
    team.share(pieces, |_, (numbers, rows)| {
        numbers.zip(rows).for_each(|(number, (row, bin))| take_up(number, row, bin));
    });
}

/// Puts places where `tell` says for each share: each of them to a number of its own.
pub(super) fn scatter(
    team: &Team,
    shares: &[Range<usize>],
    places: &mut [Place],
    tell: impl Fn(Range<usize>, &mut dyn FnMut(usize, Place)) + Sync,
) {
    let places = &Scattered(Cell::from_mut(places).as_slice_of_cells());
    team.share(shares.to_vec(), |_, share| {
        tell(share, &mut |number, place| places.put(number, place));
    });
}

/// Sorts moved rows by their bins, of which there are so many, each range of them on a thread of its own.
/// Those of one bin keep their order.
pub(super) fn sort(
    team: &Team,
    sorting: &mut BinSort,
    (bins, shares, bins_in_all): (&[u32], &[Range<usize>], usize),
    moved: &[Row],
    rows: &mut [Row],
) {
    let (starts, mut shares) = sorting.shares(bins, shares, bins_in_all);
    team.share(shares.iter_mut().collect(), |_, share| share.count());
    Share::join(&mut shares, starts);
    let sorted = &Scattered(Cell::from_mut(rows).as_slice_of_cells());
    team.share(shares, |_, mut share| share.place(|row, to| sorted.put(to, moved[row])));
}

/// What several threads write, each to places of its own.
struct Scattered<'a, T>(&'a [Cell<T>]);

// SAFETY: a sort gives every row a place of its own, and each cell is told once: none is written twice, and
// none is read.
unsafe impl<T: Send> Sync for Scattered<'_, T> {}

impl<T> Scattered<'_, T> {
    fn put(&self, to: usize, one: T) {
        self.0[to].set(one);
    }
}
