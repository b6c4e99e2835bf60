//! Sepals: a circle of green leaves around the petals, which they follow in the bud and lean away from when it opens;
//! in a few numbers, or drawn by strokes of their own.

use super::PetalNumbers;
use crate::shapes::ShapeError;
use crate::shapes::read::read_within;
use crate::shapes::wrong::within;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// How the sepals of a flower are told.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Value", untagged)]
pub enum Sepals {
    Around(SepalNumbers),
    Drawn(Box<PetalNumbers>),
}

/// Sepals in a few numbers: edge to edge around the bud, pointed, and each between two petals.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SepalNumbers {
    /// 0 (none) to 12.
    pub count: u32,
    /// Up to which share of the petals they reach; 0.1 to 1.
    pub length: f64,
    /// The share that they have of the room around the bud where they are the widest; 0.1 to 1.
    pub width: f64,
    /// How much farther out than the outermost petals they lean in the open flower; 0 to 150.
    pub open_deg: f64,
    /// How much earlier than the foot of the outermost petals they are open, as a share of its time; 0 to 0.9.
    pub lead: f64,
}

impl Default for SepalNumbers {
    fn default() -> SepalNumbers {
        SepalNumbers { count: 0, length: 0.3, width: 0.8, open_deg: 30.0, lead: 0.2 }
    }
}

impl Sepals {
    /// How many there are.
    pub fn count(&self) -> u32 {
        match self {
            Sepals::Around(numbers) => numbers.count,
            Sepals::Drawn(numbers) => numbers.arrangement.count(),
        }
    }

    pub(super) fn check(&self) -> Result<(), ShapeError> {
        match self {
            Sepals::Around(numbers) => numbers.check(),
            Sepals::Drawn(numbers) => numbers.check("sepals"),
        }
    }
}

impl SepalNumbers {
    /// Half its width at a share of its length, as a share of the widest.
    pub(super) fn form(along: f64) -> f64 {
        (1.0 - along) * (0.8 + 1.9 * along)
    }

    fn check(&self) -> Result<(), ShapeError> {
        within("sepals.count", f64::from(self.count), &(0.0..=12.0))?;
        within("sepals.length", self.length, &(0.1..=1.0))?;
        within("sepals.width", self.width, &(0.1..=1.0))?;
        within("sepals.open_deg", self.open_deg, &(0.0..=150.0))?;
        within("sepals.lead", self.lead, &(0.0..=0.9))
    }
}

impl TryFrom<Value> for Sepals {
    type Error = ShapeError;

    /// Who names strokes, or anything else of petals, draws them.
    fn try_from(value: Value) -> Result<Sepals, ShapeError> {
        let names = |numbers: Value| numbers.as_object().map(|all| all.keys().cloned().collect());
        let of_petals: Vec<String> =
            serde_json::to_value(PetalNumbers::default()).ok().and_then(names).unwrap_or_default();
        match value.as_object().is_some_and(|told| told.keys().any(|name| of_petals.contains(name)))
        {
            true => read_within("sepals", &value).map(Sepals::Drawn),
            false => read_within("sepals", &value).map(Sepals::Around),
        }
    }
}
