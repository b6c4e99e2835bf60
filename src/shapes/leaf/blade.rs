//! The blade in space: folded, waved and bent. The upper side looks at the viewer (`+z`).

use super::{LeafNumbers, LeafPlan};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// How far behind its blade a petiole stands, as a share of its height: it is not to lie in a blade that goes all
/// the way round it.
const BEHIND: f64 = 0.3;

/// A place on the petiole, from its foot in the origin (0) to the blade (1).
pub fn petiole(numbers: &LeafNumbers, share: f64) -> DVec3 {
    let forward = BEHIND * (1.0 - (1.0 - share) * (1.0 - share));
    DVec3::new(0.0, share, forward) * numbers.petiole_cm
}

/// How a flat leaf is laid in space. Without waves, fold alone and curl alone keep all lengths.
#[derive(Clone, Debug)]
pub struct Blade {
    /// Of the main vein in the middle.
    length: f64,
    /// From a main vein to the farthest border.
    width: f64,
    axes: Vec<DVec2>,
    fold: [f64; 2],
    /// Radians a centimetre.
    curl: f64,
    wave_cm: f64,
    /// Radians a centimetre.
    wave: f64,
    foot: DVec3,
}

impl Blade {
    pub fn new(plan: &LeafPlan, numbers: &LeafNumbers) -> Blade {
        let middle = &plan.lobes[plan.lobes.len() / 2];
        let length = middle.feet[middle.feet.len() - 1];
        let borders = plan.lobes.iter().flat_map(|lobe| lobe.corners.iter().flatten());
        let radians = numbers.fold_deg.to_radians();
        Blade {
            length,
            width: borders.map(|p| p.x).fold(0.0, f64::max),
            axes: plan.lobes.iter().map(|lobe| lobe.axis).collect(),
            fold: [libm::cos(radians), libm::sin(radians)],
            curl: numbers.curl_deg.to_radians() / length,
            wave_cm: numbers.wave_cm,
            wave: TAU * numbers.waves / length,
            foot: petiole(numbers, 1.0),
        }
    }

    /// Where a point of the flat leaf goes: the foot of the petiole is the origin, and it stands upright.
    pub fn place(&self, p: DVec2) -> DVec3 {
        let [cos, sin] = self.fold;
        let rim = (self.distance_to_veins(p) / self.width).min(1.0);
        let wave = self.wave_cm * rim * rim * libm::sin(self.wave * p.length());
        let (x, z) = (p.x * cos, p.x.abs() * sin + wave);
        let (y, z) = self.bend(p.y, z);
        DVec3::new(x, y, z) + self.foot
    }

    /// The stretched main vein in the middle, for scale.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Bends a strip along the midrib to an arc, its upper side outwards.
    fn bend(&self, y: f64, z: f64) -> (f64, f64) {
        if self.curl == 0.0 {
            return (y, z);
        }
        let radius = 1.0 / self.curl;
        let angle = self.curl * y;
        ((radius + z) * libm::sin(angle), (radius + z) * libm::cos(angle) - radius)
    }

    /// The distance from the nearest main vein, or what would be one beyond its tip.
    fn distance_to_veins(&self, p: DVec2) -> f64 {
        let of_axis = |axis: &DVec2| match axis.dot(p) {
            behind if behind <= 0.0 => p.length(),
            _ => axis.perp_dot(p).abs(),
        };
        self.axes.iter().map(of_axis).fold(f64::INFINITY, f64::min)
    }
}
