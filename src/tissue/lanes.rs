//! Columns of numbers that are read and written four at a time.

use wide::f32x4;

/// Numbers that are worked on side by side.
pub(crate) const LANES: usize = 4;

/// Four numbers from a row of a column on.
#[inline]
pub(crate) fn lanes(column: &[f32], row: usize) -> f32x4 {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: every column ends with `LANES` spare rows, and rows come from `starts` and `len`,
    // which count rows that are there. A checked load costs the gather a fifth of its time.
    f32x4::new(unsafe { *column.as_ptr().add(row).cast::<[f32; LANES]>() })
}

/// Four numbers from a row of a column on, to be written.
#[inline]
pub(crate) fn lanes_mut(column: &mut [f32], row: usize) -> &mut [f32; LANES] {
    debug_assert!(row + LANES <= column.len());
    // SAFETY: as above; a patch sees each cell at most once, so `Near` has room for all.
    unsafe { &mut *column.as_mut_ptr().add(row).cast::<[f32; LANES]>() }
}
