//! What is left of the veil on the caps of fly agarics, and their rims.

use crate::plants::{Chance, List, kept, kept_list};
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// A dome with black warts, where the veil is thick. The image's cylinder stands on the middle of its
/// rim's plane and is as high as the dome.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Warts {
    pub radius_cm: f32,
    pub height_cm: f32,
    /// 1 to 2000.
    pub count: u32,
    /// Radius of the largest, at the top.
    pub wart_radius_cm: f32,
    /// How far, in turns, an individual's warts are turned around the dome, all together.
    #[serde(default)]
    pub astray: f32,
}

/// From white at the rims of caps to black at their tops, by height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rims {
    /// Heights of the rim and of the top of each cap, the lowest first. The image is shared out evenly
    /// among them.
    #[serde(deserialize_with = "kept_list")]
    pub caps_cm: List<[f32; 2]>,
    /// That of the image.
    pub height_cm: f32,
}

/// Centre, on the dome, and radius.
pub(super) type Wart = (Vec3, f32);

impl Warts {
    /// Each at the golden angle from the last, the first at the top.
    pub(super) fn warts(&self, chance: Chance) -> Vec<Wart> {
        let turned = self.astray * chance.shaken(0, 3);
        let wart = |k: u32| {
            let shaken = |purpose| chance.scatter(k, purpose) - 0.5;
            let down = (k as f32 + 0.5) / self.count as f32;
            let turns = 0.382 * k as f32 + 0.05 * shaken(1) + turned;
            let radius_cm = self.wart_radius_cm * (1.0 - 0.4 * down + 0.35 * shaken(2));
            (self.point(turns, 1.0 - down), radius_cm)
        };
        (0..self.count).map(wart).collect()
    }

    /// Lowest and uppermost row are white: they are repeated over all that lies below and above, other
    /// caps too.
    pub(super) fn is_white(&self, warts: &[Wart], turns: f32, height: f32, rows: u32) -> bool {
        let is_end = height * rows as f32 <= 1.0 || (1.0 - height) * rows as f32 <= 1.0;
        let p = self.point(turns, height);
        is_end || warts.iter().all(|&(centre, radius)| centre.distance(p) > radius)
    }

    /// A point of the dome: angle in turns; height 0 at the rim, 1 at the top.
    fn point(&self, turns: f32, height: f32) -> Vec3 {
        let angle_rad = turns * std::f32::consts::TAU;
        let out = self.radius_cm * libm::sqrtf((1.0 - height * height).max(0.0));
        Vec3::new(out * libm::cosf(angle_rad), height * self.height_cm, out * libm::sinf(angle_rad))
    }

    pub(super) fn check(&self) -> Result<(), String> {
        kept("radius_cm", self.radius_cm, 0.1, 1000.0)?;
        kept("height_cm", self.height_cm, 0.1, 1000.0)?;
        kept("wart_radius_cm", self.wart_radius_cm, 0.0, 1000.0)?;
        kept("astray", self.astray, 0.0, 1.0)?;
        match self.count {
            1..=2000 => Ok(()),
            count => Err(format!("count is {count}: it must be from 1 to 2000")),
        }
    }
}

impl Rims {
    pub(super) fn whiteness(&self, height: f32) -> f32 {
        let count = self.caps_cm.len();
        let cap = ((height * count as f32) as usize).min(count - 1);
        let [rim_cm, top_cm] = self.caps_cm[cap];
        let from_top = ((top_cm - height * self.height_cm) / (top_cm - rim_cm)).clamp(0.0, 1.0);
        from_top * from_top
    }

    pub(super) fn check(&self) -> Result<(), String> {
        kept("height_cm", self.height_cm, 0.1, 1000.0)?;
        if self.caps_cm.is_empty() {
            return Err("caps_cm is empty: it must have a cap".to_string());
        }
        for &[rim_cm, top_cm] in self.caps_cm {
            kept("the rim of a cap", rim_cm, -1000.0, 1000.0)?;
            kept("the top of a cap", top_cm, rim_cm + 0.01, 2000.0)?;
        }
        Ok(())
    }
}
