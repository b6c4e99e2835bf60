//! Files out: tables.

mod cells;

pub use cells::write_cells;
