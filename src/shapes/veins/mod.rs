//! Fine veins on a finished blade: they grow towards sources of a growth hormone until each source is reached
//! (Runions, Fuhrer, Lane, Federl, Rolland-Lagan, Prusinkiewicz, *Modeling and Visualization of Leaf Venation
//! Patterns*, SIGGRAPH 2005), all sources at once and without growth of the blade.

mod open;
mod sources;
#[cfg(test)]
mod tests;

pub use open::{Network, grow};
pub use sources::scatter;

use super::ShapeError;
use super::wrong::within;
use serde::{Deserialize, Serialize};

/// Fine veins in numbers. What is left out of a file is as in `VeinNumbers::default`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VeinNumbers {
    /// Sources are at least so far apart; 0.005 to 10.
    pub spacing_cm: f64,
    /// A vein grows so far in a step, as a share of the spacing; 0.05 to 1.
    pub step: f64,
    /// A vein that comes so near reaches a source, as a share of the spacing: at least the step, at most 2.
    pub reach: f64,
    /// Width of an end.
    pub tip_cm: f64,
    /// Widths raised to this sum up from the ends to the root (Murray: 3; 2 keeps areas); 1 to 5.
    pub exponent: f64,
}

impl Default for VeinNumbers {
    fn default() -> VeinNumbers {
        VeinNumbers {
            spacing_cm: 0.2,
            step: 1.0 / 3.0,
            reach: 2.0 / 3.0,
            tip_cm: 0.008,
            exponent: 3.0,
        }
    }
}

impl VeinNumbers {
    /// Says which number is out of its range.
    pub fn check(&self) -> Result<(), ShapeError> {
        within("spacing_cm", self.spacing_cm, &(0.005..=10.0))?;
        within("step", self.step, &(0.05..=1.0))?;
        within("reach", self.reach, &(self.step..=2.0))?;
        within("tip_cm", self.tip_cm, &(0.0001..=1.0))?;
        within("exponent", self.exponent, &(1.0..=5.0))
    }
}
