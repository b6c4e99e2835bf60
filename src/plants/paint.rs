//! What is painted on a plant: control images by rule, and what each is used for.

mod belts;
mod blaze;
mod caps;
mod leaves;
mod pixels;
mod stripes;

use super::{Chance, List, Text, kept};
use crate::surface::{AlongVeins, ControlImage, Wrap};
use crate::tissue::{Control, Use};
pub use belts::Belts;
pub use blaze::Blaze;
pub use caps::{Rims, Warts};
pub use leaves::{Bands, Margins};
pub use pixels::Pixels;
use serde::{Deserialize, Serialize};
pub use stripes::{Cube, Stripes};

/// A control image: how it lies on the body, what it shows, and what for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Paint {
    pub wrap: Wrap,
    pub image: Image,
    #[serde(rename = "use")]
    pub use_as: Use,
}

/// An image and the rule that paints it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Image {
    /// Pixels around the cylinder, or across a leaf; from 1 on.
    pub width: u32,
    /// Pixels along the cylinder, or along a leaf; from 1 on.
    pub height: u32,
    pub rule: ImageRule,
}

/// What an image shows. Lengths without a unit are shares of the image.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ImageRule {
    Grain(Grain),
    Stripes(Stripes),
    Belts(Belts),
    Blaze(Blaze),
    Warts(Warts),
    Rims(Rims),
    Margins(Margins),
    Bands(Bands),
    Pixels(Pixels),
}

/// Black in a fine random grain: none of it at the bottom, and evenly more of it upwards.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grain {
    /// Share of the pixels that are black at the top, 0 to 1.
    pub black_at_the_top: f32,
}

/// The greatest number of pixels of an image: four million bytes.
const MOST_PIXELS: u64 = 4_000_000;

/// Rows of `along_veins`: white beside the veins alone, or away from them.
pub(super) const NEAR: List<Text> = &["0", "f"];
pub(super) const AWAY: List<Text> = &["f", "0"];

impl Paint {
    /// Greys by the distance from veins up to an order, from `reach_cm`, the first row, to the veins.
    pub(super) const fn along_veins(
        order: u32,
        reach_cm: f32,
        rows: List<Text>,
        use_as: Use,
    ) -> Paint {
        let height = rows.len() as u32;
        Paint {
            wrap: Wrap::Veins(AlongVeins { order, reach_cm }),
            image: Image { width: 1, height, rule: ImageRule::Pixels(Pixels { rows }) },
            use_as,
        }
    }

    /// The control image, painted.
    pub(super) fn control(&self, chance: Chance) -> Control {
        Control { wrap: self.wrap, image: self.image.paint(chance), use_as: self.use_as }
    }

    /// Whether it can be painted; else why not.
    pub fn check(&self) -> Result<(), String> {
        match &self.wrap {
            Wrap::Cylinder(cylinder) => cylinder.check()?,
            Wrap::Veins(along) => along.check()?,
            Wrap::Leaf => {}
        }
        self.image.check()
    }
}

impl Image {
    fn paint(&self, chance: Chance) -> ControlImage {
        let (width, height) = (self.width, self.height);
        let white = |rule: &dyn Fn(f32, f32) -> bool| ControlImage::paint(width, height, rule);
        match &self.rule {
            ImageRule::Grain(rule) => white(&|turns, up| rule.is_white(chance, turns, up)),
            ImageRule::Stripes(rule) => white(&|turns, up| rule.is_white(chance, turns, up)),
            ImageRule::Belts(rule) => white(&|turns, up| rule.is_white(chance, turns, up)),
            ImageRule::Blaze(rule) => white(&|turns, up| rule.is_white(chance, turns, up)),
            ImageRule::Warts(rule) => {
                let warts = rule.warts(chance);
                white(&|turns, up| rule.is_white(&warts, turns, up, height))
            }
            ImageRule::Margins(rule) => white(&|turns, up| rule.is_white(turns, up)),
            ImageRule::Bands(rule) => white(&|turns, up| rule.is_white(chance, turns, up)),
            ImageRule::Rims(rule) => {
                ControlImage::shade(width, height, &|_, up| rule.whiteness(up))
            }
            ImageRule::Pixels(rule) => rule.paint(width, height),
        }
    }

    fn check(&self) -> Result<(), String> {
        let pixels = u64::from(self.width) * u64::from(self.height);
        if !(1..=MOST_PIXELS).contains(&pixels) {
            return Err(format!(
                "the image is {} times {} pixels: it must have from 1 to 4,000,000",
                self.width, self.height
            ));
        }
        match &self.rule {
            ImageRule::Grain(rule) => kept("black_at_the_top", rule.black_at_the_top, 0.0, 1.0),
            ImageRule::Stripes(rule) => rule.check(),
            ImageRule::Belts(rule) => rule.check(),
            ImageRule::Blaze(rule) => rule.check(),
            ImageRule::Warts(rule) => rule.check(),
            ImageRule::Rims(rule) => rule.check(),
            ImageRule::Margins(rule) => kept("margin_cm", rule.margin_cm, 0.0, 100.0),
            ImageRule::Bands(rule) => rule.check(),
            ImageRule::Pixels(rule) => rule.check(self.width, self.height),
        }
    }
}

impl Grain {
    fn is_white(&self, chance: Chance, turns: f32, height: f32) -> bool {
        let grain = chance.scatter((turns * 256.0) as u32 + 256 * (height * 128.0) as u32, 0);
        grain > self.black_at_the_top * height
    }
}
