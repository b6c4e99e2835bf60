//! The catalogue: what each plant is made of, how its cells live, and how it looks.

#[cfg(all(test, not(target_arch = "wasm32")))]
mod bodies;
mod cactus;
mod croton;
mod mushroom;
mod watermelon;

use crate::surface::{Body, Control, Group, PolygonMesh};
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
#[derive(Clone, Debug, PartialEq)]
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
    static ALL: [Plant; 4] = [croton::PLANT, cactus::PLANT, watermelon::PLANT, mushroom::PLANT];
    &ALL
}

/// The plant of a key, as it stands in links.
pub fn find(key: &str) -> Option<&'static Plant> {
    all().iter().find(|plant| plant.key == key)
}

/// The body in one of our own mesh files, each group refined so many times.
fn body(obj: &str, levels: impl Fn(&Group) -> u32) -> Body {
    smooth(&PolygonMesh::parse(obj).expect("our own meshes are well formed"), levels)
}

fn smooth(control: &PolygonMesh, levels: impl Fn(&Group) -> u32) -> Body {
    Body::new(&control.refined_by(levels)).expect("our own meshes have a surface")
}

/// A number from 0 to 1 that is always the same for the same place: irregularity that belongs to
/// the plant and not to the individual. (The finaliser of MurmurHash3, Appleby 2011.)
fn scatter(item: u32, purpose: u32) -> f32 {
    let mut bits = item.wrapping_mul(0x9e37_79b9) ^ purpose.wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ (bits >> 16)).wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ (bits >> 13)).wrapping_mul(0xc2b2_ae35);
    bits ^= bits >> 16;
    // 24 bits are what an f32 between 0 and 1 holds.
    (bits >> 8) as f32 / (1 << 24) as f32
}
