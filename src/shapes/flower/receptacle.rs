//! The receptacle of a lotus: an inverted cone with carpels sunk into its flat top.

use super::template::round;
use crate::shapes::ShapeError;
use crate::shapes::wrong::within;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// A receptacle in numbers.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct ReceptacleNumbers {
    /// Of the flat top; 0.1 to 20.
    pub radius_cm: f64,
    /// At its foot; 0.05 to 20.
    pub foot_cm: f64,
    /// 0.1 to 20.
    pub height_cm: f64,
    /// Its size in the bud, as a share; 0.05 to 1.
    pub bud: f64,
    /// Heads of carpels in the top, each at the golden angle from the last; 0 to 60.
    pub carpels: u32,
}

impl Default for ReceptacleNumbers {
    /// A lotus'.
    fn default() -> ReceptacleNumbers {
        ReceptacleNumbers { radius_cm: 1.6, foot_cm: 0.7, height_cm: 2.0, bud: 0.5, carpels: 17 }
    }
}

/// Corners around it, and rings of them.
pub const SIDES: u32 = 10;
pub const RINGS: u32 = 3;
/// Turns from one carpel to the next.
const DIVERGENCE: f64 = 0.381_966_011_250_105;

impl ReceptacleNumbers {
    pub(super) fn check(&self) -> Result<(), ShapeError> {
        within("receptacle.radius_cm", self.radius_cm, &(0.1..=20.0))?;
        within("receptacle.foot_cm", self.foot_cm, &(0.05..=20.0))?;
        within("receptacle.height_cm", self.height_cm, &(0.1..=20.0))?;
        within("receptacle.bud", self.bud, &(0.05..=1.0))?;
        within("receptacle.carpels", f64::from(self.carpels), &(0.0..=60.0))
    }

    /// Its rings of corners from the foot up, the last one that of the lid.
    pub fn rings(&self) -> Vec<DVec3> {
        let profile = [
            (self.foot_cm, 0.0),
            (self.radius_cm, 0.96 * self.height_cm),
            (0.94 * self.radius_cm, self.height_cm),
        ];
        let ring = |(radius, height): (f64, f64)| {
            (0..SIDES).map(move |k| {
                round(-TAU * f64::from(k) / f64::from(SIDES), DVec2::new(radius, height))
            })
        };
        profile.into_iter().flat_map(ring).collect()
    }

    /// Four corners of each carpel's head, counter-clockwise seen from above.
    pub fn heads(&self) -> Vec<DVec3> {
        let apart = 0.86 * self.radius_cm / f64::from(self.carpels.max(1)).sqrt();
        let head = |k: u32| {
            let out = apart * (f64::from(k) + 0.5).sqrt();
            let centre =
                round(TAU * DIVERGENCE * f64::from(k), DVec2::new(out, 1.03 * self.height_cm));
            let size = 0.5 * apart;
            [0.0, 0.25, 0.5, 0.75]
                .map(|turns: f64| centre + round(-TAU * turns, DVec2::new(size, 0.0)))
        };
        (0..self.carpels).flat_map(head).collect()
    }
}
