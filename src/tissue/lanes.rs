//! Columns of numbers that are read and written four at a time, and how they are sorted.

use wide::{f32x4, u32x4};

/// Numbers that are worked on side by side.
pub(crate) const LANES: usize = 4;

/// As many numbers as the processors that this is compiled for work on side by side.
#[cfg(target_feature = "avx2")]
pub(super) type Wide = wide::f32x8;
#[cfg(not(target_feature = "avx2"))]
pub(super) type Wide = f32x4;

/// How many these are.
pub(super) const WIDTH: usize = size_of::<Wide>() / size_of::<f32>();

/// Four numbers from a row of a column on.
#[inline]
pub(crate) fn lanes(column: &[f32], row: usize) -> f32x4 {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: every column ends with spare rows, and rows come from `starts` and `len`, which count
    // rows that are there. A checked load costs the gather a fifth of its time.
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
    /// How many rows of its bin stood before each row.
    ranks: Vec<u32>,
}

impl BinSort {
    /// Those of one bin keep their order. `place` is called with each row's number before and after.
    #[inline]
    pub(super) fn sort(
        &mut self,
        bins: &[u32],
        bins_in_all: usize,
        mut place: impl FnMut(usize, usize),
    ) {
        let starts = &mut self.starts;
        starts.resize(bins_in_all + 1, 0);
        starts.fill(0);
        if self.ranks.len() < bins.len() {
            self.ranks.resize(bins.len(), 0);
        }
        let ranks = &mut self.ranks[..bins.len()];
        // Rows of one bin follow each other closely: to count on in memory has to be waited for, and is
        // done once.
        for (&bin, rank) in bins.iter().zip(&mut *ranks) {
            let count = &mut starts[bin as usize];
            *rank = *count;
            *count += 1;
        }
        let mut sum = 0;
        for start in &mut *starts {
            sum += std::mem::replace(start, sum);
        }
        for (row, (&bin, &rank)) in bins.iter().zip(&*ranks).enumerate() {
            place(row, (starts[bin as usize] + rank) as usize);
        }
    }
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
