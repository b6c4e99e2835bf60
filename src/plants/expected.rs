//! How many cells a plant should have on a day, and how large its clans should be, exactly.

use super::Plant;
use crate::surface::Mesh;
use crate::tissue::{
    CLAN_STEPS, CellType, Control, Diary, Expected, Recipe, Use, clan_sizes, expected_cells,
    expected_individuals,
};
use std::collections::BTreeMap;

/// An individual: what images do to numbers is the same in all.
const ANY: u32 = 0;

impl Plant {
    /// Mean and variance of the cells of a day over all growths of a recipe on the plant's surface that begin with
    /// as many first cells of each type on each part as this diary, each part at its own age. None where no exact
    /// expectation is known: see [`expected_cells`].
    pub fn expected_cells(
        &self,
        surface: &Mesh,
        recipe: &Recipe,
        diary: &Diary,
        day: u32,
    ) -> Option<Expected> {
        let by_age = self.first_cells_by_age(surface, diary, day);
        let controls = self.controls(ANY);
        let mut all = Expected::default();
        for (age, first_cells) in by_age {
            let of_age = expected_cells(recipe, &controls, first_cells, age as usize)?;
            all.mean += of_age.mean;
            all.variance += of_age.variance;
        }
        Some(all)
    }

    /// The cells of each type and all cells of a day over all individuals of a recipe; see [`expected_individuals`].
    /// None too where parts unfold one after the other.
    pub fn expected_individuals(
        &self,
        recipe: &Recipe,
        day: u32,
    ) -> Option<([Expected; 3], Expected)> {
        let at_once = self.motion.unfolding_days.iter().all(|&day| day == 0);
        at_once.then(|| expected_individuals(recipe, &self.controls(ANY), day as usize)).flatten()
    }

    /// How many clans of each step of sizes (see [`clan_sizes`]) to expect on such a day, in the mean. None where
    /// it is not known: cells that mutate into types that divide at another pace, and control images that scale
    /// the days between divisions.
    pub fn expected_clans(
        &self,
        surface: &Mesh,
        recipe: &Recipe,
        diary: &Diary,
        day: u32,
    ) -> Option<[f64; CLAN_STEPS]> {
        let mutates = CellType::ALL.iter().any(|&t| recipe.mutation[t as usize][t as usize] != 1.0);
        let divide_alike = recipe.division_days.iter().all(|&days| days == recipe.division_days[0]);
        let scales =
            |c: &Control| matches!(c.use_as, Use::Scale { number, .. } if number.is_days());
        if (mutates && !divide_alike) || self.controls(ANY).iter().any(scales) {
            return None;
        }
        let mut all = [0.0; CLAN_STEPS];
        for (age, first_cells) in self.first_cells_by_age(surface, diary, day) {
            for (first, division_days) in first_cells.into_iter().zip(recipe.division_days) {
                if first > 0 {
                    let sizes = clan_sizes(recipe.clock, division_days, age);
                    all.iter_mut()
                        .zip(sizes)
                        .for_each(|(n, chance)| *n += f64::from(first) * chance);
                }
            }
        }
        Some(all)
    }

    /// The first cells of each type, by the age on a day of the part that they live on.
    fn first_cells_by_age(
        &self,
        surface: &Mesh,
        diary: &Diary,
        day: u32,
    ) -> BTreeMap<u32, [u32; 3]> {
        let mut by_age = BTreeMap::<u32, [u32; 3]>::new();
        for (place, cell) in diary.days[0].places.iter().zip(&diary.lineage) {
            let part = surface.parts[place.triangle as usize] as usize;
            let unfolded = self.motion.unfolding_days.get(part).copied().unwrap_or(0);
            by_age.entry(day.saturating_sub(unfolded)).or_default()[cell.kind as usize] += 1;
        }
        by_age
    }
}
