//! How a plant looks: its colours, and what its surfaces are made of.

use super::document::{Bare, Listed, Tint, by_type};
use super::{List, Text};
use crate::mosaic::MOST_TINT;
use crate::tissue::CellType;
use glam::Vec3;
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

/// Colour and gloss of a bare material that a look does not name.
const PLAIN: ([f32; 3], f32) = ([0.55, 0.53, 0.50], 0.1);

impl Look {
    /// The colour, in linear light, of the cells of a type with this tint, 0 to `MOST_TINT`, and this
    /// lightness, 0 to 15: `colour_of` in `mosaic.wgsl`.
    pub fn of_cell(&self, kind: CellType, tint: u32, lightness: u32) -> Vec3 {
        let share = self.variation * (2.0 / 15.0 * lightness as f32 - 1.0);
        let even = self.even_of_kind(kind, tint) * (1.0 + share);
        even * even
    }

    /// The colour, in linear light, of a part that has no cells: that of B.
    pub fn of_nobody(&self) -> Vec3 {
        let even = self.even_of_kind(CellType::Background, 0);
        even * even
    }

    /// Mixed in the square roots of linear light, which are even to the eye.
    fn even_of_kind(&self, kind: CellType, tint: u32) -> Vec3 {
        let even = |colour| linear(colour).map(f32::sqrt);
        let plain = self.cells[kind as usize];
        let tinted = self.tinted.iter().find(|(of, _)| *of == kind).map_or(plain, |(_, c)| *c);
        even(plain).lerp(even(tinted), tint as f32 / MOST_TINT as f32)
    }

    /// The colour, in sRGB, and the gloss of a bare material.
    pub fn of_bare(&self, material: &str) -> ([f32; 3], f32) {
        let named = self.bare.iter().find(|(name, ..)| *name == material);
        named.map_or(PLAIN, |&(_, colour, gloss)| (colour, gloss))
    }
}

/// sRGB numbers to linear light (IEC 61966-2-1).
pub fn linear(srgb: [f32; 3]) -> Vec3 {
    Vec3::from(
        srgb.map(|c| if c <= 0.04045 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }),
    )
}

/// Linear light to sRGB numbers, 0 to 1.
pub fn srgb(linear: Vec3) -> [f32; 3] {
    linear.to_array().map(|c| {
        let c = c.clamp(0.0, 1.0);
        if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::powf(c, 1.0 / 2.4) - 0.055 }
    })
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::find;

    #[test]
    fn a_cell_has_the_colour_of_its_type_and_its_own_lightness() {
        let croton = &find("croton").unwrap().look;
        let of = |lightness| of_type(croton, CellType::Foreground, 0, lightness);
        // Lightness 7.5 is the colour itself, between these two.
        let [below, above] = [of(7), of(8)];
        for (k, &wanted) in croton.cells[0].iter().enumerate() {
            assert!(below[k] < wanted && wanted < above[k] && above[k] - below[k] < 0.02);
        }
        // sRGB (0.91, 0.784, 0.227) is (0.807, 0.577, 0.042) in linear light; 1.12 squared times that.
        let light = croton.of_cell(CellType::Foreground, 0, 15);
        assert!((light - Vec3::new(1.0127, 0.7239, 0.0529)).abs().max_element() < 1e-3, "{light}");
    }

    #[test]
    fn all_tint_is_the_tinted_colour() {
        let look = Look { variation: 0.0, ..find("croton").unwrap().look.clone() };
        let look = Look { tinted: &[(CellType::Middle, [0.2, 0.4, 0.6])], ..look };
        let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4);
        assert!(near(of_type(&look, CellType::Middle, MOST_TINT, 3), [0.2, 0.4, 0.6]));
        assert!(near(of_type(&look, CellType::Middle, 0, 3), look.cells[2]));
        assert!(near(of_type(&look, CellType::Background, MOST_TINT, 3), look.cells[1]));
        assert!(near(srgb(look.of_nobody()), look.cells[1]));
    }

    fn of_type(look: &Look, kind: CellType, tint: u32, lightness: u32) -> [f32; 3] {
        srgb(look.of_cell(kind, tint, lightness))
    }
}
