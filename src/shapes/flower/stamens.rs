//! Stamens: filaments in a circle, and anthers that swing on their ends.

use super::petal::Drawn;
use super::rod::{Rod, RodNumbers};
use crate::shapes::ShapeError;
use crate::shapes::chance::{Purpose, either_way, part_key};
use crate::shapes::tube::rings;
use crate::shapes::wrong::within;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Stamens in numbers: evenly round the axis.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct StamenNumbers {
    /// 1 to 200.
    pub count: u32,
    /// Where the first one stands, seen from above the flower; -360 to 360.
    pub first_deg: f64,
    /// In the bud and open: outwards from the flower's axis and up along it.
    pub bud_cm: Drawn,
    pub open_cm: Drawn,
    /// Of the filament; 0.01 to 2.
    pub width_cm: f64,
    /// 0.05 to 10.
    pub anther_cm: f64,
    /// 0.02 to 2.
    pub anther_width_cm: f64,
    /// What it turns across its filament while the flower opens; -180 to 180.
    pub anther_deg: f64,
    /// Corners around filaments and anthers, 2 (flat ribbons) to 12, and rings of them along, 2 to 12.
    pub sides: u32,
    pub rings: u32,
}

impl Default for StamenNumbers {
    /// A lily's.
    fn default() -> StamenNumbers {
        StamenNumbers {
            count: 6,
            first_deg: 30.0,
            bud_cm: vec![[0.2, 0.2], [0.25, 2.0], [0.28, 4.6]],
            open_cm: vec![[0.2, 0.2], [0.75, 3.5], [2.4, 7.6]],
            width_cm: 0.17,
            anther_cm: 1.7,
            anther_width_cm: 0.36,
            anther_deg: 75.0,
            sides: 4,
            rings: 4,
        }
    }
}

impl StamenNumbers {
    pub(super) fn check(&self) -> Result<(), ShapeError> {
        within("stamens.count", f64::from(self.count), &(1.0..=200.0))?;
        within("stamens.first_deg", self.first_deg, &(-360.0..=360.0))?;
        within("stamens.width_cm", self.width_cm, &(0.01..=2.0))?;
        within("stamens.anther_cm", self.anther_cm, &(0.05..=10.0))?;
        within("stamens.anther_width_cm", self.anther_width_cm, &(0.02..=2.0))?;
        within("stamens.anther_deg", self.anther_deg, &(-180.0..=180.0))?;
        within("stamens.sides", f64::from(self.sides), &(2.0..=12.0))?;
        within("stamens.rings", f64::from(self.rings), &(2.0..=12.0))?;
        self.filament().check("stamens")
    }

    /// Where its rings are, from foot to end.
    fn shares(&self) -> impl Iterator<Item = f64> {
        let last = f64::from(self.rings - 1);
        (0..self.rings).map(move |ring| f64::from(ring) / last)
    }

    fn filament(&self) -> RodNumbers {
        let foot = self.width_cm / 2.0;
        RodNumbers {
            bud_cm: self.bud_cm.clone(),
            open_cm: self.open_cm.clone(),
            // Thinner towards the anther.
            radii_cm: self.shares().map(|share| foot * (1.0 - 0.4 * share)).collect(),
        }
    }
}

/// All stamens of a flower.
#[derive(Clone, Debug)]
pub struct Stamens {
    filaments: Vec<Rod>,
    numbers: StamenNumbers,
}

impl Stamens {
    /// `key` is that of their chance.
    pub fn new(numbers: &StamenNumbers, irregularity: f64, key: u64) -> Stamens {
        let filament = numbers.filament();
        let rod = |number: u32| {
            let key = part_key(key, number);
            let even = 360.0 * f64::from(number) / f64::from(numbers.count);
            let azimuth = (numbers.first_deg + even).to_radians();
            let turned = irregularity * either_way(key, Purpose::Turn);
            let length = 1.0 + irregularity * either_way(key, Purpose::Length);
            Rod::new(&filament, azimuth + turned, length)
        };
        Stamens { filaments: (0..numbers.count).map(rod).collect(), numbers: numbers.clone() }
    }

    /// The corners of all filaments and those of all anthers at a share of the way.
    pub fn at(&self, share: f64) -> [Vec<DVec3>; 2] {
        let mut corners = [Vec::new(), Vec::new()];
        for rod in &self.filaments {
            let path = rod.path(share);
            corners[0].extend(rod.corners(self.numbers.sides, &path, share));
            let end = path[path.len() - 1];
            let along = (end - path[path.len() - 2]).normalize_or(DVec3::Y);
            let angle = self.numbers.anther_deg.to_radians() * share;
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let way = along * cos + rod.side * sin;
            let size = rod.size(share);
            let anther: Vec<(DVec3, f64)> = self
                .numbers
                .shares()
                .map(|share| {
                    // As an ellipse, cut off before it comes to a point.
                    let from_middle = 2.0 * share - 1.0;
                    let width = (1.0 - 0.85 * from_middle * from_middle).sqrt();
                    let radius = width * self.numbers.anther_width_cm / 2.0 * size;
                    (end + way * (from_middle / 2.0 * self.numbers.anther_cm * size), radius)
                })
                .collect();
            corners[1].extend(rings(self.numbers.sides, &anther, rod.side * cos - along * sin));
        }
        corners
    }
}
