//! The catalogue: what each plant is made of, how its cells live, and how it looks.

use crate::surface::{Body, Control};
use crate::tissue::Recipe;

/// A plant of the playground.
#[derive(Clone, Debug)]
pub struct Plant {
    /// Its word in links: `croton`.
    pub key: &'static str,
    /// English name: `Croton`.
    pub name: &'static str,
    pub latin: &'static str,
    /// The picture of the thesis that it follows: `Thesis, Fig. 4.3`.
    pub source: &'static str,
    /// What the colours of F, B and M are called: `["yellow", "green", ""]`.
    pub colour_names: [&'static str; 3],
    pub recipe: Recipe,
    /// The day that a visitor sees first.
    pub first_day: u32,
    pub look: Look,
    pub view: View,
    pub body: fn() -> Body,
    pub controls: fn() -> Vec<Control>,
}

/// Colours and materials; sRGB, 0 to 1.
#[derive(Clone, Debug)]
pub struct Look {
    /// Colours of F, B and M cells.
    pub cells: [[f32; 3]; 3],
    /// How much the lightness of cells of one type varies, 0 to 1.
    pub variation: f32,
    /// How much darker the cell borders are than the cells, 0 to 1.
    pub border: f32,
    /// 0 matt to 1 waxy.
    pub gloss: f32,
    /// Whether the midrib and side veins of the leaf coordinates (`uvs`) are drawn.
    pub veins: bool,
    /// Colour and gloss of each bare material.
    pub bare: &'static [(&'static str, [f32; 3], f32)],
}

/// From where the plant is first seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Degrees around the upright axis, and above the horizon.
    pub azimuth_deg: f32,
    pub elevation_deg: f32,
    /// 1: the bounding sphere just fills the shorter side of the picture.
    pub zoom: f32,
}

/// All plants in the order of the chooser.
pub fn all() -> &'static [Plant] {
    &[]
}
