//! Cells sorted by several threads, natively.

use super::lanes::{BinSort, Share};
use super::relax::Row;
use rayon::ThreadPool;
use std::cell::Cell;
use std::ops::Range;

/// Sorts moved rows by their bins, of which there are so many, each range of them on a thread of its own.
/// Those of one bin keep their order.
pub(super) fn sort(
    threads: &ThreadPool,
    sorting: &mut BinSort,
    (bins, written, bins_in_all): (&[u32], &[Range<usize>], usize),
    moved: &[Row],
    rows: &mut [Row],
) {
    let (starts, mut shares) = sorting.shares(bins, written, bins_in_all);
    threads.scope(|all| {
        for share in &mut shares {
            all.spawn(|_| share.count());
        }
    });
    Share::join(&mut shares, starts);
    let sorted = &Sorted(Cell::from_mut(rows).as_slice_of_cells());
    threads.scope(|all| {
        for share in &mut shares {
            all.spawn(move |_| share.place(|row, to| sorted.put(to, moved[row])));
        }
    });
}

/// Rows that several threads write, each to places of its own.
struct Sorted<'a>(&'a [Cell<Row>]);

// SAFETY: a sort gives every row a place of its own, so that none is written twice, and none is read.
unsafe impl Sync for Sorted<'_> {}

impl Sorted<'_> {
    fn put(&self, to: usize, row: Row) {
        self.0[to].set(row);
    }
}
