//! Who lives on the surface: the recipe, the cells, their relaxation and division, and the diary of
//! the days that have grown.

mod bins;
mod chance;
mod control;
mod course;
mod diary;
mod divide;
mod event;
mod expectation;
mod forces;
mod ground;
mod growth;
mod lanes;
mod near;
mod noise;
mod pedigree;
mod plan;
mod recipe;
mod relax;
#[cfg(not(target_arch = "wasm32"))]
mod team;
#[cfg(not(target_arch = "wasm32"))]
mod threads;

pub(crate) use bins::{Bins, Rim};
pub use chance::{mix, name_of};
pub use control::{Control, Use};
pub use diary::{Day, DayCount, Diary, Lineage};
pub use expectation::{
    CLAN_STEPS, Expected, clan_sizes, clan_step, clans, expected_cells, expected_individuals,
    least_memory_bytes,
};
pub use growth::{Growth, Progress};
pub(crate) use lanes::{LANES, lanes, lanes_mut};
pub use noise::Noise;
pub use pedigree::Pedigree;
pub use recipe::{CellType, Clock, Recipe, RecipeError, Scaled};
