//! Lobed belts round columns.

use crate::plants::{Chance, List, kept, kept_list};
use serde::{Deserialize, Serialize};

/// White belts round two columns that share a cylinder: one in the half turn around the angle 0, the
/// other in the half turn behind the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Belts {
    /// That of the image, in centimetres.
    pub height_cm: f32,
    /// Lower and upper border of each belt around the angle 0.
    #[serde(deserialize_with = "kept_list")]
    pub near_cm: List<[f32; 2]>,
    /// The same on the other side.
    #[serde(deserialize_with = "kept_list")]
    pub far_cm: List<[f32; 2]>,
    /// How far broad and narrow lobes of the borders reach up and down.
    pub lobes_cm: [f32; 2],
    /// How far the belts of an individual's column stand up or down from where they are said to: all together
    /// up to so far, and each of their borders up to half as far by itself.
    #[serde(default)]
    pub astray_cm: f32,
}

impl Belts {
    pub(super) fn is_white(&self, chance: Chance, turns: f32, height: f32) -> bool {
        let is_far = (0.25..0.75).contains(&turns);
        let belts = if is_far { self.far_cm } else { self.near_cm };
        let [broad_cm, narrow_cm] = self.lobes_cm;
        let column = u32::from(is_far);
        let moved_cm = |border| {
            broad_cm * chance.rough(turns * 17.0, border, 11)
                + narrow_cm * chance.rough(turns * 41.0, border, 12)
                + 0.5 * self.astray_cm * chance.shaken(2 * border + column, 14)
        };
        let height_cm = height * self.height_cm - self.astray_cm * chance.shaken(column, 13);
        (0..).zip(belts).any(|(k, [lower, upper])| {
            (lower + moved_cm(2 * k)..upper + moved_cm(2 * k + 1)).contains(&height_cm)
        })
    }

    pub(super) fn check(&self) -> Result<(), String> {
        kept("height_cm", self.height_cm, 0.1, 1000.0)?;
        kept("astray_cm", self.astray_cm, 0.0, 100.0)?;
        for &border_cm in self.near_cm.iter().chain(self.far_cm).flatten() {
            kept("a border of a belt", border_cm, -1000.0, 1000.0)?;
        }
        self.lobes_cm.iter().try_for_each(|&lobe_cm| kept("lobes_cm", lobe_cm, 0.0, 100.0))
    }
}
