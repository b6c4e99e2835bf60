//! A blaze along the midrib of a leaf.

use crate::plants::{Chance, kept};
use serde::{Deserialize, Serialize};

/// White along the middle of a leaf, fading out towards the rim in a fine random grain, sooner along one
/// side vein and later along another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Blaze {
    /// From the midrib, 0, to the rim, 1: up to where all is white.
    pub all: f32,
    /// And from where nothing is, give or take `uneven`.
    pub none: f32,
    pub uneven: f32,
    /// Strokes that could be told apart along the midrib, 1 to 1000.
    pub strokes: f32,
    /// Up to here along the midrib, 0 to 1, the blaze grows broader: in the notch the rim is near.
    pub broad: f32,
    /// How far a side vein goes along the leaf on its way from midrib to rim.
    pub lean: f32,
    /// How far the middle of an individual's blaze lies beside the midrib, as a share of the way to the rim:
    /// here and there up to so far, and all along up to half as far again.
    #[serde(default)]
    pub astray: f32,
}

impl Blaze {
    pub(super) fn is_white(&self, chance: Chance, turns: f32, along: f32) -> bool {
        let beside = chance.rough(along * 3.0, 0, 3) + 0.5 * chance.shaken(0, 4);
        let across = 2.0 * turns - 1.0 - self.astray * beside;
        let side = u32::from(across < 0.0);
        let across = across.abs();
        let from_midrib = across / (along / self.broad).min(1.0);
        // From the side vein at whose end the notch is, so that it is not below 0.
        let stroke = (along - self.lean * across + self.lean) * self.strokes;
        let none = self.none + self.uneven * chance.rough(stroke, 0, side);
        let grain = chance.scatter((turns * 256.0) as u32 + 256 * (along * 256.0) as u32, 2);
        grain > (from_midrib - self.all) / (none - self.all)
    }

    pub(super) fn check(&self) -> Result<(), String> {
        kept("all", self.all, 0.0, 1.0)?;
        kept("none", self.none, 0.0, 2.0)?;
        kept("uneven", self.uneven, 0.0, 1.0)?;
        kept("strokes", self.strokes, 1.0, 1000.0)?;
        kept("broad", self.broad, 0.01, 1.0)?;
        kept("lean", self.lean, 0.0, 1.0)?;
        kept("astray", self.astray, 0.0, 1.0)
    }
}
