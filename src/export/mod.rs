//! Files out: tables, and the plant of a day as other programs read it.

mod cells;
mod chart;
mod clones;
mod convex;
mod course;
mod days;
mod flat;
mod glb;
mod joints;
mod kind;
mod lesson;
mod measured;
mod obj;
mod order;
mod outlines;
mod picture;
mod ply;
mod solid;
mod specimen;
mod svg;
mod three_mf;
mod tile;
mod tiling;
mod zip;

pub use cells::write_cells;
pub use chart::Chart;
pub use course::{sizes_of_clans, the_course};
pub use days::DayNumbers;
pub use kind::Kind;
pub use lesson::{strip, worksheet};
pub use measured::measured;
pub use order::{Order, Written};
pub use picture::write_picture;
pub use specimen::Specimen;
pub use tiling::{Facet, Point, Tiling};
pub use zip::write_zip;
