//! Files out: tables, and the plant of a day as other programs read it.

mod cells;
mod clones;
mod convex;
mod flat;
mod glb;
mod joints;
mod obj;
mod outlines;
mod ply;
mod solid;
mod specimen;
mod svg;
mod three_mf;
mod tile;
mod tiling;
mod zip;

pub use cells::write_cells;
pub use clones::write_clones;
pub use glb::write_glb;
pub use obj::{write_mtl, write_obj};
pub use ply::write_ply;
pub use specimen::{Bare, Coloured, Specimen};
pub use svg::Pattern;
pub use three_mf::write_3mf;
pub use tile::Tile;
pub use tiling::{Facet, Point, Tiling};
