//! Jagged stripes from end to end, as those of watermelons.

use crate::plants::{kept, rough};
use serde::{Deserialize, Serialize};

/// White stripes from bottom to top. All widths are shares of the room that a stripe and its gap have.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stripes {
    /// 1 to 200.
    pub count: u32,
    /// Half the width of a stripe.
    pub half_width: f32,
    /// How much half widths differ between stripes, and along a stripe.
    pub varies_between: f32,
    pub varies_along: f32,
    /// How far stripes wander to either side.
    pub wander: f32,
    /// Length of the small teeth at their borders.
    pub teeth: f32,
    /// The cube that they run over, where the body is one.
    #[serde(default)]
    pub cube: Option<Cube>,
}

/// A cube with faces that stand out a little, inside a cylinder that begins at its lower face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cube {
    /// Without the bulge.
    pub half_side_cm: f32,
    /// How far the middles of its faces stand out.
    pub bulge_cm: f32,
}

impl Stripes {
    pub(super) fn is_white(&self, turns: f32, height: f32) -> bool {
        match &self.cube {
            None => self.is_stripe(turns, height),
            Some(cube) => self.is_stripe(around(turns), cube.along(height)),
        }
    }

    fn is_stripe(&self, turns: f32, height: f32) -> bool {
        let count = self.count as f32;
        let stripe = (turns * count) as u32 % self.count;
        let from_middle = turns * count - stripe as f32 - 0.5;
        let side = u32::from(from_middle > 0.0);
        // Stripes wander, are of unlike width, and have teeth of two sizes.
        let wander = self.wander * rough(height * 5.0, stripe, 0);
        let width = self.half_width
            + self.varies_between * rough(0.0, stripe, 1)
            + self.varies_along * rough(height * 9.0, stripe, 2 + side);
        let teeth = self.teeth * rough(height * 34.0, stripe, 4 + side);
        (from_middle - wander).abs() < width + teeth
    }

    pub(super) fn check(&self) -> Result<(), String> {
        if !(1..=200).contains(&self.count) {
            return Err(format!("count is {}: it must be from 1 to 200", self.count));
        }
        kept("half_width", self.half_width, 0.0, 1.0)?;
        kept("varies_between", self.varies_between, 0.0, 1.0)?;
        kept("varies_along", self.varies_along, 0.0, 1.0)?;
        kept("wander", self.wander, 0.0, 1.0)?;
        kept("teeth", self.teeth, 0.0, 1.0)?;
        let Some(cube) = &self.cube else { return Ok(()) };
        kept("half_side_cm", cube.half_side_cm, 0.1, 1000.0)?;
        kept("bulge_cm", cube.bulge_cm, 0.01, 1000.0)
    }
}

/// The share of the way around a square that an angle, in turns, has gone: stripes keep their width
/// towards the upright edges.
fn around(turns: f32) -> f32 {
    let quarters = turns * 4.0 + 0.5;
    let face = libm::floorf(quarters);
    let from_middle_rad = (quarters - face - 0.5) * std::f32::consts::FRAC_PI_2;
    let share = (face + 0.5 + 0.5 * libm::tanf(from_middle_rad)) / 4.0 - 0.125;
    if share < 0.0 { share + 1.0 } else { share }
}

impl Cube {
    /// The share of the way from the lower to the upper end over the middles of the faces: on the upper
    /// face a little height is a long way, since it is a little convex.
    fn along(&self, height: f32) -> f32 {
        let side_cm = 2.0 * self.half_side_cm;
        let height_cm = height * (side_cm + self.bulge_cm);
        let over_the_top = ((height_cm - side_cm) / self.bulge_cm).clamp(0.0, 1.0);
        let inward_cm = self.half_side_cm * (1.0 - libm::sqrtf(1.0 - over_the_top));
        (self.half_side_cm + height_cm.min(side_cm) + inward_cm) / (2.0 * side_cm)
    }
}
