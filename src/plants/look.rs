//! How a plant looks: its colours, and what its surfaces are made of.

use super::document::{Bare, Listed, Tint, by_type};
use super::{List, Text};
use crate::tissue::CellType;
use serde::{Deserialize, Serialize};

/// Colours and materials; sRGB, 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Look {
    /// Colours of F, B and M cells.
    #[serde(with = "by_type")]
    pub cells: [[f32; 3]; 3],
    /// The colours of those types that a control image tints, where it is white.
    #[serde(with = "Listed::<Tint>")]
    pub tinted: List<(CellType, [f32; 3])>,
    /// How much the lightness of cells of one type varies, 0 to 1.
    pub variation: f32,
    /// How much darker the cell borders are than the cells, 0 to 1.
    pub border: f32,
    /// 0 matt to 1 waxy.
    pub gloss: f32,
    pub skin: Skin,
    /// Whether the midrib and side veins of the leaf coordinates (`uvs`) are drawn.
    pub veins: bool,
    /// Colour and gloss of each bare material.
    #[serde(with = "Listed::<Bare>")]
    pub bare: List<(Text, [f32; 3], f32)>,
}

/// How the patterned surface takes light, beside its colours and gloss.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Skin {
    /// The gloss of F, B and M cells, as shares of the look's.
    #[serde(with = "by_type")]
    pub gloss: [f32; 3],
    /// How high cells of these types stand above others: the slope at their common border.
    #[serde(with = "by_type")]
    pub raised: [f32; 3],
    /// Share of the light that comes through from the other side, as in thin leaves: 1.
    pub through: f32,
    /// Pale wax on the skin: its optical thickness.
    pub wax: f32,
    /// The slopes of a skin that is not quite even.
    pub unevenness: f32,
}

impl Skin {
    /// Smooth and clean, and all cells alike.
    pub const EVEN: Skin =
        Skin { gloss: [1.0; 3], raised: [0.0; 3], through: 0.0, wax: 0.0, unevenness: 0.0 };
    /// That of a thin leaf.
    pub const LEAF: Skin = Skin { through: 1.0, unevenness: 0.03, ..Skin::EVEN };
}
