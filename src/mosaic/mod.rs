//! What is seen: the Voronoi tessellation of the cells on the surface.

mod near;
mod sites;

pub use sites::{Head, Site, SiteLists};
