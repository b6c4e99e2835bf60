//! Margins and bands of the leaves of a snake plant, side by side in one image.

use crate::plants::sansevieria::{ATLAS_PLACES, LENGTHS_CM, half_width_cm};
use crate::plants::{Chance, kept};
use serde::{Deserialize, Serialize};

/// White along the rims.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Margins {
    pub margin_cm: f32,
}

/// White in zigzag bands across, each in its own way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bands {
    /// From band to band.
    pub apart_cm: f32,
    /// How much of that is white at least, and how much more at most; 0 to 1.
    pub share: f32,
    pub share_varies: f32,
    /// How far bands go up and down.
    pub zigzag_cm: f32,
    /// How far the bands of an individual's leaf are moved up, all together, as a share of `apart_cm`.
    #[serde(default)]
    pub astray: f32,
}

impl Margins {
    pub(super) fn is_white(&self, turns: f32, up: f32) -> bool {
        let (leaf, across) = place(turns);
        (1.0 - across.abs()) * half_width_cm(LENGTHS_CM[leaf], up) < self.margin_cm
    }
}

impl Bands {
    pub(super) fn is_white(&self, chance: Chance, turns: f32, up: f32) -> bool {
        let (leaf, across) = place(turns);
        let length_cm = LENGTHS_CM[leaf];
        let across_cm = across * half_width_cm(length_cm, up);
        self.is_band(chance, across_cm, up * length_cm, leaf as u32)
    }

    /// Whether a band crosses the blade here: so far across from the midrib and up from the soil.
    fn is_band(&self, chance: Chance, across_cm: f32, up_cm: f32, leaf: u32) -> bool {
        let band = |at: f32| libm::floorf(at) as u32;
        let zigzag = chance.rough(across_cm * 0.9 + 20.0, leaf * 7 + band(up_cm / 5.0), 21);
        let bent = up_cm + self.zigzag_cm * zigzag;
        let at = bent / self.apart_cm + 0.35 * chance.rough(up_cm * 0.5, leaf, 22);
        let at = at - self.astray * chance.scatter(leaf, 29);
        let share = self.share + self.share_varies * chance.scatter(band(at + 8.0), 23 + leaf);
        at - libm::floorf(at) < share
    }

    pub(super) fn check(&self) -> Result<(), String> {
        kept("apart_cm", self.apart_cm, 0.05, 100.0)?;
        kept("share", self.share, 0.0, 1.0)?;
        kept("share_varies", self.share_varies, 0.0, 1.0)?;
        kept("zigzag_cm", self.zigzag_cm, 0.0, 100.0)?;
        kept("astray", self.astray, 0.0, 1.0)
    }
}

/// The leaf that is painted at an angle of the image, and how far across it from -1 at the left rim to 1
/// at the right.
fn place(turns: f32) -> (usize, f32) {
    let place = turns * ATLAS_PLACES as f32;
    let leaf = (place as usize).min(LENGTHS_CM.len() - 1);
    (leaf, 2.0 * (place - leaf as f32) - 1.0)
}
