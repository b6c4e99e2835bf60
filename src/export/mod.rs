//! Files out: tables, and the plant of a day as other programs read it.

mod cells;
mod clones;
mod convex;
mod flat;
mod glb;
mod joints;
mod obj;
mod ply;
mod specimen;
mod svg;
mod tile;
mod tiling;

pub use cells::write_cells;
pub use clones::write_clones;
pub use glb::write_glb;
pub use obj::{write_mtl, write_obj};
pub use ply::write_ply;
pub use specimen::{Bare, Coloured, Specimen};
pub use svg::Pattern;
pub use tile::Tile;
pub use tiling::{Facet, Point, Tiling};
