//! Every number of a run, with its unit and source. A recipe and a seed decide a tissue.

mod json;

use crate::surface::Shortest;
use serde::{Deserialize, Serialize};

/// The types of cells (CM98; Thesis 3.2.1.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[repr(u8)]
pub enum CellType {
    #[serde(rename = "F")]
    Foreground = 0,
    #[serde(rename = "B")]
    Background = 1,
    #[serde(rename = "M")]
    Middle = 2,
}

impl CellType {
    pub const ALL: [CellType; 3] = [CellType::Foreground, CellType::Background, CellType::Middle];

    /// `F`, `B` or `M`.
    pub fn letter(self) -> char {
        ['F', 'B', 'M'][self as usize]
    }

    /// The type of an index 0, 1 or 2.
    pub fn from_index(index: u8) -> CellType {
        Self::ALL[index as usize]
    }
}

/// A number of a recipe that can be scaled, by a control image, from place to place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scaled {
    /// `division_days` of a type.
    DivisionDays(CellType),
    RadiusScale,
    Repulsion,
    /// `adhesion` of two types, in either order.
    Adhesion(CellType, CellType),
}

impl Scaled {
    /// Whether both name the same number.
    pub fn is(self, other: Scaled) -> bool {
        match (self, other) {
            (Scaled::Adhesion(a, b), Scaled::Adhesion(c, d)) => {
                (a, b) == (c, d) || (a, b) == (d, c)
            }
            _ => self == other,
        }
    }

    /// Whether it says when cells divide and not how they are pushed.
    pub fn is_days(self) -> bool {
        matches!(self, Scaled::DivisionDays(_))
    }
}

/// How the time to a cell's next division is drawn, with the mean of its type's `division_days`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Clock {
    /// Whole days (Thesis 3.2.1.2).
    #[default]
    Poisson,
    /// Any time; without memory, so that a population grows as `exp(t / division_days)`.
    Exponential,
}

/// Every number of a run (Thesis, 3.2.1 and Table 4.1). Arrays are indexed by `CellType`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recipe {
    /// Cells at day 0, at least 1.
    pub initial_cells: u32,
    /// Chance that a first cell is of each type; sum 1.
    #[serde(serialize_with = "json::write_row")]
    pub initial_probability: [f64; 3],
    /// Mean days between divisions of each type, over 1.
    #[serde(serialize_with = "json::write_row")]
    pub division_days: [f64; 3],
    pub clock: Clock,
    /// Chance that the child of a cell of the row's type is of the column's type; rows sum to 1.
    #[serde(serialize_with = "json::write_mutation")]
    pub mutation: [[f64; 3]; 3],
    /// 1: no repulsion between the two types, 0: full. Symmetric.
    #[serde(serialize_with = "json::write_adhesion")]
    pub adhesion: [[f32; 3]; 3],
    /// Scale of the repulsive radius, `r = radius_scale * sqrt(area / cells)`.
    pub radius_scale: f32,
    /// Scalar repulsive force.
    pub repulsion: f32,
    /// Weight of the direction field, 0: none, to 1: steps follow it. Without a field no matter.
    pub anisotropy: f32,
    /// Relaxation events before day 0.
    pub initial_relaxations: u32,
    /// Relaxation events in a day.
    pub relaxations_per_day: u32,
    /// Days to grow.
    pub days: u32,
    /// Population at which growth ends early.
    pub max_cells: u32,
}

impl Default for Recipe {
    fn default() -> Recipe {
        Recipe::DEFAULT
    }
}

/// Why a recipe cannot be grown, in words for whoever wrote it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct RecipeError(pub String);

impl Recipe {
    /// The first croton of the thesis (Fig. 4.1), for all numbers that are not named.
    pub const DEFAULT: Recipe = Recipe {
        initial_cells: 2000,
        initial_probability: [0.5, 0.5, 0.0],
        division_days: [10.0; 3],
        clock: Clock::Poisson,
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.0,
        repulsion: 0.09,
        anisotropy: 0.0,
        initial_relaxations: 10,
        relaxations_per_day: 10,
        days: 35,
        max_cells: 2_000_000,
    };

    /// Reads a recipe in JSON; what is left out has its default. Whole numbers may be written as `2e3`,
    /// and shares that miss the sum 1 because they were rounded are scaled to it. The error says what is
    /// wrong, and where.
    pub fn from_json(text: &str) -> Result<Recipe, RecipeError> {
        let recipe = json::read(text)?;
        recipe.check()?;
        Ok(recipe)
    }

    /// The recipe as JSON, every number named.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).expect("a recipe holds plain numbers")
    }

    /// The recipe with each number that can be scaled times its factor. Nothing is checked.
    #[inline(never)] // Else the page carries it twice.
    pub fn scaled(&self, factor: &dyn Fn(Scaled) -> f64) -> Recipe {
        let mut recipe = self.clone();
        recipe.radius_scale *= factor(Scaled::RadiusScale) as f32;
        recipe.repulsion *= factor(Scaled::Repulsion) as f32;
        for a in CellType::ALL {
            recipe.division_days[a as usize] *= factor(Scaled::DivisionDays(a));
            for b in CellType::ALL {
                recipe.adhesion[a as usize][b as usize] *= factor(Scaled::Adhesion(a, b)) as f32;
            }
        }
        recipe
    }

    /// The repulsive radius of so many cells, `r = radius_scale * sqrt(area / cells)`, in centimetres.
    pub fn repulsive_radius_cm(&self, area_cm2: f32, cells: usize) -> f32 {
        self.radius_scale * (area_cm2 / cells as f32).sqrt()
    }

    /// The greatest `max_cells`. Numbers of cells have thirty bits where they are drawn.
    pub const MOST_CELLS: u32 = 100_000_000;

    /// Refuses what the model cannot grow.
    pub fn check(&self) -> Result<(), RecipeError> {
        let fail = |what: String| Err(RecipeError(what));
        if !(1..=2_000_000).contains(&self.initial_cells) {
            return fail(format!(
                "initial_cells is {}: it must be from 1 to 2,000,000",
                self.initial_cells
            ));
        }
        check_row("initial_probability", &self.initial_probability)?;
        for from in CellType::ALL {
            check_days(from, self.division_days[from as usize])?;
            check_row(&format!("mutation of {}", from.letter()), &self.mutation[from as usize])?;
            for to in CellType::ALL {
                let adhesion = self.adhesion[from as usize][to as usize];
                if !(0.0..=1.0).contains(&adhesion) {
                    return fail(format!(
                        "adhesion {}{} is {}: it must be from 0 to 1",
                        from.letter(),
                        to.letter(),
                        adhesion.shortest()
                    ));
                }
            }
        }
        if !(self.radius_scale > 0.0 && self.radius_scale <= 10.0) {
            return fail(format!(
                "radius_scale is {}: it must be over 0 and at most 10",
                self.radius_scale.shortest()
            ));
        }
        if !(0.0..=2.0).contains(&self.repulsion) {
            return fail(format!(
                "repulsion is {}: it must be from 0 to 2",
                self.repulsion.shortest()
            ));
        }
        if !(0.0..=1.0).contains(&self.anisotropy) {
            return fail(format!(
                "anisotropy is {}: it must be from 0 to 1",
                self.anisotropy.shortest()
            ));
        }
        for (name, value, most) in [
            ("days", self.days, 1000),
            ("relaxations_per_day", self.relaxations_per_day, 1000),
            ("initial_relaxations", self.initial_relaxations, 10_000),
        ] {
            if value > most {
                return fail(format!("{name} is {value}: it must be at most {most}"));
            }
        }
        if self.max_cells > Recipe::MOST_CELLS {
            return fail(format!(
                "max_cells is {}: it must be at most 100,000,000",
                self.max_cells
            ));
        }
        if self.max_cells < self.initial_cells {
            return fail(format!(
                "max_cells is {}: it must be at least initial_cells, {}",
                self.max_cells, self.initial_cells
            ));
        }
        Ok(())
    }
}

/// One rule for both clocks, though the exponential one would not need it: no change of the clock
/// alone makes a recipe that cannot be grown.
fn check_days(kind: CellType, days: f64) -> Result<(), RecipeError> {
    if days > 1.0 && days <= 500.0 {
        return Ok(());
    }
    Err(RecipeError(format!(
        "division_days of {} is {}: it must be over 1 and at most 500 days (at or under ln 2 \
         days the population would be infinite)",
        kind.letter(),
        days.shortest()
    )))
}

fn check_row(name: &str, row: &[f64; 3]) -> Result<(), RecipeError> {
    let sum: f64 = row.iter().sum();
    if row.iter().all(|p| (0.0..=1.0).contains(p)) && (sum - 1.0).abs() < 1e-6 {
        return Ok(());
    }
    Err(RecipeError(format!(
        "{name} is F {}, B {}, M {}: each must be from 0 to 1 and their sum 1",
        row[0].shortest(),
        row[1].shortest(),
        row[2].shortest()
    )))
}
