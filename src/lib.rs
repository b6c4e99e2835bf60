//! The Clonal Mosaic model of plant patterns: cells live on the surface of a plant, push each
//! other away, divide, and colour their Voronoi polygons.
//!
//! The modules stand in the order in which the data flows: a body (where), a tissue that grows on
//! it (who), the mosaic that is seen (what), and the scene that says all of that in one value.

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(feature = "draw")]
pub mod draw;
pub mod export;
pub mod import;
pub mod mosaic;
pub mod plants;
pub mod play;
pub mod shapes;
pub mod surface;
pub mod tissue;
