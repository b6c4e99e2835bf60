//! What is seen: the Voronoi tessellation of the cells on the surface.

mod near;
mod polygons;
mod sites;

pub use polygons::{Piece, polygons};
pub use sites::{Head, Site, SiteLists};
