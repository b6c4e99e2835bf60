//! Columns of numbers that are read and written four at a time, and how they are sorted.

#[cfg(not(target_arch = "wasm32"))]
use std::ops::Range;
use wide::{f32x4, u32x4, u64x2};

/// Numbers that are worked on side by side.
pub(crate) const LANES: usize = 4;

#[cfg(not(target_feature = "avx2"))]
pub(super) use wide::{f32x4 as Wide, i32x4 as WideInt};
/// As many numbers as the processors that this is compiled for work on side by side.
#[cfg(target_feature = "avx2")]
pub(super) use wide::{f32x8 as Wide, i32x8 as WideInt};

/// How many these are.
pub(super) const WIDTH: usize = size_of::<Wide>() / size_of::<f32>();

/// A number of a column.
#[inline]
pub(super) fn one<T: Copy>(column: &[T], row: usize) -> T {
    debug_assert!(row < column.len());
    // SAFETY: every column ends with spare rows; rows come from `starts` and `len`, which count rows that
    // are there, and bins and boxes are numbered by those who made room for them. Checked loads cost a cell
    // of `radius_scale` 1 a fiftieth of its time, and the gather, which loads four, a fifth.
    unsafe { *column.as_ptr().add(row) }
}

/// Four numbers from a row of a column on.
#[inline]
pub(crate) fn lanes(column: &[f32], row: usize) -> f32x4 {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: as above.
    f32x4::new(unsafe { *column.as_ptr().add(row).cast::<[f32; LANES]>() })
}

/// The numbers from a row of a column on.
#[inline]
pub(super) fn wide(column: &[f32], row: usize) -> Wide {
    debug_assert!(row + WIDTH <= column.len());
    // SAFETY: as above.
    Wide::new(unsafe { *column.as_ptr().add(row).cast::<[f32; WIDTH]>() })
}

/// Four numbers from a row of a column on, to be written.
#[inline]
pub(crate) fn lanes_mut<T>(column: &mut [T], row: usize) -> &mut [T; LANES] {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: as above; a patch sees each cell at most once, so `Near` has room for all.
    unsafe { &mut *column.as_mut_ptr().add(row).cast::<[T; LANES]>() }
}

/// The whole parts of numbers from 0 up to 2^23, or from a hair below 0 by rounding.
#[inline]
pub(super) fn whole(numbers: f32x4) -> f32x4 {
    // To convert them takes wasm several instructions: it has to look out for all other numbers.
    if cfg!(target_feature = "simd128") {
        numbers.floor().fast_max(f32x4::ZERO)
    } else {
        numbers.fast_trunc_int().round_float()
    }
}

/// Whole numbers from 0 up to 2^23 as integers.
#[inline]
pub(super) fn integers(whole: f32x4) -> u32x4 {
    const SHIFT: f32 = (1 << 23) as f32;
    let shifted: u32x4 = bytemuck::cast(whole + f32x4::splat(SHIFT));
    shifted & u32x4::splat((1 << 23) - 1)
}

/// Sorts rows by their bins (counting sort).
#[derive(Clone, Debug, Default)]
pub(super) struct BinSort {
    /// The first row of each bin, and the end of the last.
    pub(super) starts: Vec<u32>,
    /// How many rows of each bin have been counted, by those who count: none between two sorts.
    counts: Vec<Vec<u32>>,
    /// How many rows of its bin stood before each row.
    ranks: Vec<u32>,
}

impl BinSort {
    /// Sorts rows, given by their bins. Those of one bin keep their order. `place` is called with each row's
    /// number before and after.
    #[inline]
    pub(super) fn sort(
        &mut self,
        bins: &[u32],
        bins_in_all: usize,
        mut place: impl FnMut(usize, usize),
    ) {
        let room = self.make_room(bins.len(), 1, bins_in_all);
        let (counts, ranks) = (&mut self.counts[0][..room], &mut self.ranks[..]);
        count(bins, ranks, counts);
        sum_up(counts, &mut self.starts[..room]);
        for ((row, &bin), &rank) in bins.iter().enumerate().zip(&*ranks) {
            place(row, (one(&self.starts, bin as usize) + rank) as usize);
        }
    }

    /// The same in several shares, whose rows follow each other: first each is to `count`, on whatever thread,
    /// then this is to `join` them, and then each hands out where its rows go.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn shares<'a>(
        &'a mut self,
        bins: &'a [u32],
        rows: &[Range<usize>],
        bins_in_all: usize,
    ) -> (&'a mut [u32], Vec<Share<'a>>) {
        let room = self.make_room(bins.len(), rows.len(), bins_in_all);
        let (mut ranks, mut behind) = (&mut self.ranks[..], 0);
        let shares = rows.iter().zip(&mut self.counts).map(|(rows, counts)| {
            let (own, others) =
                std::mem::take(&mut ranks)[rows.start - behind..].split_at_mut(rows.len());
            (ranks, behind) = (others, rows.end);
            let counts = &mut counts[..room];
            Share { bins: &bins[rows.clone()], first_row: rows.start, ranks: own, counts }
        });
        let shares = shares.collect();
        (&mut self.starts[..room], shares)
    }

    /// Room for so many bins and more, in fours.
    fn make_room(&mut self, rows: usize, shares: usize, bins_in_all: usize) -> usize {
        let room = (bins_in_all + 1).next_multiple_of(LANES);
        if self.counts.len() < shares {
            self.counts.resize(shares, Vec::new());
        }
        for column in self.counts[..shares].iter_mut().chain([&mut self.starts]) {
            if column.len() < room {
                column.resize(room, 0);
            }
        }
        if self.ranks.len() < rows {
            self.ranks.resize(rows, 0);
        }
        room
    }
}

/// Counts rows by their bins, and what of its bin stood before each row. Rows of one bin follow each other
/// closely: to count on in memory has to be waited for, and is done once.
#[inline]
fn count(bins: &[u32], ranks: &mut [u32], counts: &mut [u32]) {
    for (&bin, rank) in bins.iter().zip(ranks) {
        let count = &mut counts[bin as usize];
        *rank = *count;
        *count += 1;
    }
}

/// Rows that one hand sorts beside others.
#[cfg(not(target_arch = "wasm32"))]
pub(super) struct Share<'a> {
    bins: &'a [u32],
    first_row: usize,
    ranks: &'a mut [u32],
    /// Rows of each bin; once joined, where the first of them goes.
    counts: &'a mut [u32],
}

#[cfg(not(target_arch = "wasm32"))]
impl Share<'_> {
    pub(super) fn count(&mut self) {
        count(self.bins, self.ranks, self.counts);
    }

    /// Starts each bin where those before it end, and the rows of a share behind those of the shares before.
    pub(super) fn join(shares: &mut [Share], starts: &mut [u32]) {
        let mut before = u32x4::ZERO;
        for (four, starts) in starts.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
            let row = LANES * four;
            let mut all = u32x4::ZERO;
            for share in &mut *shares {
                all += u32x4::new(*lanes_mut(share.counts, row));
            }
            let mut first = starts_of(all, &mut before);
            *starts = first.to_array();
            for share in &mut *shares {
                let counts = lanes_mut(share.counts, row);
                let own = u32x4::new(*counts);
                *counts = first.to_array();
                first += own;
            }
        }
    }

    /// Calls `place` with each row's number before and after.
    pub(super) fn place(&mut self, mut place: impl FnMut(usize, usize)) {
        for ((k, &bin), &rank) in self.bins.iter().enumerate().zip(&*self.ranks) {
            place(self.first_row + k, (one(self.counts, bin as usize) + rank) as usize);
        }
        self.counts.fill(0);
    }
}

/// Starts each bin where those before it end, four at a time, and leaves no counts.
#[inline]
fn sum_up(counts: &mut [u32], starts: &mut [u32]) {
    let mut before = u32x4::ZERO;
    let (counts, starts) = (counts.as_chunks_mut::<LANES>().0, starts.as_chunks_mut::<LANES>().0);
    for (counts, starts) in counts.iter_mut().zip(starts) {
        let four = u32x4::new(*counts);
        *counts = u32x4::ZERO.to_array();
        *starts = starts_of(four, &mut before).to_array();
    }
}

/// Where four bins start that hold so many rows; `before`, the rows before them in all lanes, moves on behind
/// them.
#[inline]
fn starts_of(four: u32x4, before: &mut u32x4) -> u32x4 {
    const UPPER: u32x4 = u32x4::new([0, 0, u32::MAX, u32::MAX]);
    // Each with the one before it: 0 and 1, 2 and 3, and then the first sum with the other two.
    let shifted: u64x2 = bytemuck::cast::<_, u64x2>(four) << 32_u32;
    let pairs: f32x4 = bytemuck::cast(four + bytemuck::cast::<_, u32x4>(shifted));
    let first: u32x4 = bytemuck::cast(pairs.unpack_lo(pairs));
    let sums = bytemuck::cast::<_, u32x4>(pairs) + (first & UPPER);
    let starts = *before + sums - four;
    let last: f32x4 = bytemuck::cast(sums);
    let last = last.unpack_hi(last);
    *before += bytemuck::cast::<_, u32x4>(last.unpack_hi(last));
    starts
}

/// Copies a number of a column to a row of another.
///
/// # Safety
/// Both columns hold these rows.
#[inline]
pub(super) unsafe fn copy<T: Copy>(from: &[T], row: usize, to: &mut [T], to_row: usize) {
    debug_assert!(row < from.len() && to_row < to.len());
    // SAFETY: as the caller says.
    unsafe { *to.get_unchecked_mut(to_row) = *from.get_unchecked(row) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_sorted_by_their_bins_and_keep_their_order_however_often() {
        let mut sorting = BinSort::default();
        // With more bins than before, fewer, and a number that is no whole fours.
        for (bins_in_all, count) in [(5, 12), (64, 1000), (7, 300), (1, 3), (64, 40)] {
            let bins: Vec<u32> = (0..count).map(|row| row * row * 31 % 101 % bins_in_all).collect();
            let mut sorted = vec![u32::MAX; bins.len()];
            sorting.sort(&bins, bins_in_all as usize, |row, to| sorted[to] = row as u32);
            let mut expected: Vec<u32> = (0..count).collect();
            expected.sort_by_key(|&row| bins[row as usize]);
            assert_eq!(sorted, expected);
            sorted.fill(u32::MAX);
            let third = bins.len() / 3;
            let parts = [0..third, third..2 * third, 2 * third..bins.len()];
            let (starts, mut shares) = sorting.shares(&bins, &parts, bins_in_all as usize);
            shares.iter_mut().rev().for_each(Share::count);
            Share::join(&mut shares, starts);
            shares.iter_mut().for_each(|s| s.place(|row, to| sorted[to] = row as u32));
            assert_eq!(sorted, expected);
            for bin in 0..=bins_in_all {
                let before = bins.iter().filter(|&&other| other < bin).count();
                assert_eq!(sorting.starts[bin as usize], before as u32);
            }
        }
    }
}
