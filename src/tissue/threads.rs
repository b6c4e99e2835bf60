//! What several threads do together beside moving the cells, natively: each on those of the pool that it is
//! called in.

use super::lanes::{BinSort, Share};
use super::relax::Row;
use crate::surface::Place;
use std::cell::Cell;
use std::ops::Range;

/// Calls `take_up` for the rows and bins of all numbers, which are in shares that follow each other.
pub(super) fn take_up(
    shares: &[Range<usize>],
    mut moved: &mut [Row],
    mut bins: &mut [u32],
    take_up: impl Fn(usize, &mut Row, &mut u32) + Sync,
) {
    let take_up = &take_up;
    rayon::scope(|all| {
        for share in shares {
            let (own_moved, other_moved) = std::mem::take(&mut moved).split_at_mut(share.len());
            let (own_bins, other_bins) = std::mem::take(&mut bins).split_at_mut(share.len());
            (moved, bins) = (other_moved, other_bins);
            all.spawn(move |_| {
                let own = own_moved.iter_mut().zip(own_bins);
                share.clone().zip(own).for_each(|(number, (row, bin))| take_up(number, row, bin));
            });
        }
    });
}

/// Puts places where `tell` says for each share: each of them to a number of its own.
pub(super) fn scatter(
    shares: &[Range<usize>],
    places: &mut [Place],
    tell: impl Fn(Range<usize>, &mut dyn FnMut(usize, Place)) + Sync,
) {
    let (places, tell) = (&Scattered(Cell::from_mut(places).as_slice_of_cells()), &tell);
    rayon::scope(|all| {
        for share in shares {
            all.spawn(move |_| tell(share.clone(), &mut |number, place| places.put(number, place)));
        }
    });
}

/// Sorts moved rows by their bins, of which there are so many, each range of them on a thread of its own.
/// Those of one bin keep their order.
pub(super) fn sort(
    sorting: &mut BinSort,
    (bins, written, bins_in_all): (&[u32], &[Range<usize>], usize),
    moved: &[Row],
    rows: &mut [Row],
) {
    let (starts, mut shares) = sorting.shares(bins, written, bins_in_all);
    rayon::scope(|all| {
        for share in &mut shares {
            all.spawn(|_| share.count());
        }
    });
    Share::join(&mut shares, starts);
    let sorted = &Scattered(Cell::from_mut(rows).as_slice_of_cells());
    rayon::scope(|all| {
        for share in &mut shares {
            all.spawn(move |_| share.place(|row, to| sorted.put(to, moved[row])));
        }
    });
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
