//! Draws a body and its mosaic with wgpu: one set of shaders for WebGPU and WebGL2.
//!
//! The mosaic is found fragment by fragment: the nearest of a short list of sites in the plane of
//! the fragment's triangle. Nothing is triangulated, borders are sharp at every zoom, and a new day
//! is one upload.

// Natively only the tests of what needs no GPU are run: the renderer itself stands unused there.
#![cfg_attr(not(target_arch = "wasm32"), allow(dead_code))]

mod data_texture;
mod diagram;
mod geometry;
mod model;
mod occlusion;
mod pipelines;
mod renderer;
mod scene;
#[cfg(target_arch = "wasm32")]
mod start;
mod still;

pub use geometry::Geometry;
use glam::{Mat4, Vec3};
pub use renderer::Renderer;

/// From where, and at which moment, the scene is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// World to clip space, depth from 0 (near) to 1 (far).
    pub view_projection: Mat4,
    /// The eye, in centimetres.
    pub eye: Vec3,
    /// Between the day before (0) and the day of the site lists (1).
    pub moment: f32,
    /// Whether the stage behind the canvas is dark.
    pub dark: bool,
}

/// What stands in the sites in the place of the lightness of cells: in the highest bit whether a cell is
/// lit, in the three others what is left of its lightness, or the number of its clan's colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marks {
    Lit,
    Clans,
}

/// Why nothing can be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DrawError {
    #[error("the canvas gives no surface to draw on: {0}")]
    NoSurface(String),
    #[error("this browser has no graphics adapter for the canvas: {0}")]
    NoAdapter(String),
    #[error("the graphics adapter gives no device: {0}")]
    NoDevice(String),
    #[error("the surface of the canvas is lost")]
    SurfaceLost,
    #[error("{rows} rows of data are more than a texture of this device holds ({most})")]
    TooLarge { rows: u32, most: u32 },
}
