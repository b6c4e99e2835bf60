//! What is seen: the Voronoi tessellation of the cells on the surface.

mod finder;
mod near;
mod polygons;
mod sites;

pub use finder::SiteFinder;
pub use polygons::{Piece, polygons};
pub use sites::{Head, Site, SiteLists, Tag};
