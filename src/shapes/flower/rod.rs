//! Stalks of a flower that bend as it opens: filaments, anthers, styles.

use super::bspline::Stroke;
use super::petal::{Drawn, check_line};
use super::template::round;
use crate::shapes::ShapeError;
use crate::shapes::tube::rings;
use crate::shapes::wrong::within;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// A stalk in numbers.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct RodNumbers {
    /// In the bud and open: outwards from the flower's axis and up along it.
    pub bud_cm: Drawn,
    pub open_cm: Drawn,
    /// At even steps from its foot to its end, open; in the bud they are smaller as the stalk is shorter. 2 to 12
    /// numbers from 0.005 to 5.
    pub radii_cm: Vec<f64>,
}

impl Default for RodNumbers {
    /// A lily's style, with its stigma.
    fn default() -> RodNumbers {
        RodNumbers {
            bud_cm: vec![[0.0, 0.2], [0.0, 5.5]],
            open_cm: vec![[0.0, 0.2], [0.0, 4.0], [0.25, 8.6], [0.3, 9.2]],
            radii_cm: vec![0.2, 0.12, 0.11, 0.11, 0.12, 0.16, 0.36],
        }
    }
}

impl RodNumbers {
    pub(super) fn check(&self, of: &str) -> Result<(), ShapeError> {
        check_line(&format!("{of}.bud_cm"), &self.bud_cm)?;
        check_line(&format!("{of}.open_cm"), &self.open_cm)?;
        if !(2..=12).contains(&self.radii_cm.len()) {
            let count = self.radii_cm.len();
            return Err(ShapeError(format!(
                "{of}.radii_cm has {count} numbers: it must have from 2 to 12"
            )));
        }
        let name = format!("a number in {of}.radii_cm");
        self.radii_cm.iter().try_for_each(|&radius| within(&name, radius, &(0.005..=5.0)))
    }
}

/// A stalk at both ends of its way.
#[derive(Clone, Debug)]
pub struct Rod {
    bud: Vec<DVec3>,
    open: Vec<DVec3>,
    radii_cm: Vec<f64>,
    /// Its length in the bud, as a share.
    size: f64,
    /// Across the plane in which it bends.
    pub side: DVec3,
}

impl Rod {
    /// At an angle round the axis of the flower, and so many times as long as its numbers say.
    pub fn new(numbers: &RodNumbers, azimuth: f64, length: f64) -> Rod {
        let last = (numbers.radii_cm.len() - 1) as f64;
        let strokes = [&numbers.bud_cm, &numbers.open_cm].map(|line| Stroke::new(line));
        let path = |stroke: &Stroke| {
            let place = |k: usize| {
                let at = stroke.share(k as f64 / last);
                round(azimuth, stroke.start() + (at - stroke.start()) * length)
            };
            (0..numbers.radii_cm.len()).map(place).collect()
        };
        Rod {
            bud: path(&strokes[0]),
            open: path(&strokes[1]),
            radii_cm: numbers.radii_cm.clone(),
            size: strokes[0].length_cm() / strokes[1].length_cm(),
            side: DVec3::new(-libm::sin(azimuth), 0.0, libm::cos(azimuth)),
        }
    }

    /// The path at a share of the way: each piece turns at an even angle and grows in a straight line, on from the end
    /// of the one before.
    pub fn path(&self, share: f64) -> Vec<DVec3> {
        if share == 0.0 {
            return self.bud.clone();
        }
        if share == 1.0 {
            return self.open.clone();
        }
        let mut end = self.bud[0].lerp(self.open[0], share);
        let mut path = vec![end];
        for (from, to) in self.bud.windows(2).zip(self.open.windows(2)) {
            end += turned(from[1] - from[0], to[1] - to[0], share);
            path.push(end);
        }
        path
    }

    /// Its thickness at a share of the way, of that when it is open.
    pub fn size(&self, share: f64) -> f64 {
        self.size * (1.0 - share) + share
    }

    /// Its corners, ring by ring, round a path of its own.
    pub fn corners(&self, sides: u32, path: &[DVec3], share: f64) -> Vec<DVec3> {
        let size = self.size(share);
        let path: Vec<(DVec3, f64)> =
            path.iter().zip(&self.radii_cm).map(|(&p, radius)| (p, radius * size)).collect();
        rings(sides, &path, self.side)
    }
}

/// A way between two others: turned by a share of the angle between them, and as long as that share says.
fn turned(from: DVec3, to: DVec3, share: f64) -> DVec3 {
    let (start, end) = (from.normalize_or(DVec3::Y), to.normalize_or(DVec3::Y));
    let normal = start.cross(end);
    let angle = libm::atan2(normal.length(), start.dot(end));
    let axis = normal.try_normalize().unwrap_or_else(|| start.any_orthonormal_vector());
    let length = from.length() * (1.0 - share) + to.length() * share;
    DQuat::from_axis_angle(axis, angle * share) * start * length
}
