//! Jagged stripes from end to end, as those of watermelons.

use crate::plants::{Chance, kept};
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
    /// How far the stripes of an individual stand beside their even places: all together up to so far, and each
    /// up to half as far by itself.
    #[serde(default)]
    pub astray: f32,
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
    pub(super) fn is_white(&self, chance: Chance, turns: f32, height: f32) -> bool {
        let (turns, height) = match &self.cube {
            None => (turns, height),
            Some(cube) => (around(turns), cube.along(height)),
        };
        let at = turns * self.count as f32 + 2.0 * self.astray * chance.scatter(0, 6);
        // Where stripes keep to their room none comes from beside.
        let rooms = if self.astray > 0.0 { -1..=1 } else { 0..=0 };
        let room = at as i32;
        rooms.into_iter().any(|beside| self.is_stripe(chance, room + beside, at, height))
    }

    /// Whether a place, in rooms around the fruit, lies on the stripe of a room.
    fn is_stripe(&self, chance: Chance, room: i32, at: f32, height: f32) -> bool {
        let stripe = room.rem_euclid(self.count as i32) as u32;
        let from_middle = at - room as f32 - 0.5 - 0.5 * self.astray * chance.shaken(stripe, 7);
        let side = u32::from(from_middle > 0.0);
        // Stripes wander, are of unlike width, and have teeth of two sizes.
        let wander = self.wander * chance.rough(height * 5.0, stripe, 0);
        let width = self.half_width
            + self.varies_between * chance.rough(0.0, stripe, 1)
            + self.varies_along * chance.rough(height * 9.0, stripe, 2 + side);
        let teeth = self.teeth * chance.rough(height * 34.0, stripe, 4 + side);
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
        kept("astray", self.astray, 0.0, 1.0)?;
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
