//! A tissue that grows day by day on a body: sowing, and then each day divisions and relaxation.

use super::chance::{Purpose, founder_key, pick, uniform};
use super::divide::Clocks;
use super::near::Forces;
use super::relax::Crowd;
use super::{CellType, Day, Diary, Lineage, Recipe, RecipeError};
use crate::surface::{Charts, Control, Images, Mesh, Place, Tone};
use std::sync::Arc;

/// A run under way: it can be taken one relaxation event at a time, so that whoever drives it
/// decides when to look up.
pub struct Growth {
    pub diary: Diary,
    mesh: Arc<Mesh>,
    recipe: Recipe,
    charts: Charts,
    crowd: Crowd,
    clocks: Clocks,
    /// The cells' places at the beginning of the day under way.
    places: Vec<Place>,
    /// Repulsive radius of the day under way, in centimetres.
    radius: f32,
    /// Relaxation events done of the day under way.
    events: u32,
    full: bool,
}

/// What one step of a growth came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// A relaxation event is done, the day is not.
    Event,
    /// The last event of this day is done and the day stands in the diary.
    Day(u32),
    /// The population cap is reached: what has grown is kept, no further day comes.
    Full,
    /// All days of the recipe have grown.
    Done,
}

impl Growth {
    /// Sows the first cells (Thesis 3.2.1.1). Where a control image is black, an F cell becomes B, and
    /// where it is grey, M.
    pub fn new(
        mesh: Arc<Mesh>,
        recipe: Recipe,
        controls: &[Control],
        seed: u32,
    ) -> Result<Growth, RecipeError> {
        recipe.check()?;
        let (lineage, places) = sow(&mesh, &recipe, controls, seed);
        let clocks = Clocks::new(&recipe, seed, &lineage);
        let mut growth = Growth {
            diary: Diary { lineage, days: Vec::new() },
            charts: Charts::new(&mesh, Images::Nearest),
            crowd: Crowd::default(),
            radius: repulsive_radius(&recipe, mesh.area, places.len()),
            mesh,
            recipe,
            clocks,
            places,
            events: 0,
            full: false,
        };
        growth.settle();
        Ok(growth)
    }

    /// Does the next relaxation event; before the first one of a day, its divisions.
    pub fn step(&mut self) -> Progress {
        let day = self.diary.days.len();
        if self.full {
            return Progress::Full;
        }
        if day > self.recipe.days as usize {
            return Progress::Done;
        }
        if day > 0 && self.events == 0 {
            if !self.divide(day) {
                return Progress::Full;
            }
            self.settle();
        }
        let events = match day {
            0 => self.recipe.initial_relaxations,
            _ => self.recipe.relaxations_per_day,
        };
        if self.events < events {
            let forces = self.forces(day);
            self.crowd.relax(&self.mesh, &mut self.charts, &forces);
            self.events += 1;
            if self.events < events {
                return Progress::Event;
            }
        }
        self.end_day();
        Progress::Day(day as u32)
    }

    /// Walks that ended among slivers of the mesh instead of where they were going: 0 on a good
    /// mesh.
    pub fn caught_walks(&self) -> u64 {
        self.crowd.caught_walks
    }

    /// What fell due on the day before divides. False when the population cap is reached: the
    /// children that were born already are forgotten.
    fn divide(&mut self, day: usize) -> bool {
        let cells = self.places.len();
        let lineage = &mut self.diary.lineage;
        let within_cap = self.clocks.divide(
            &self.mesh,
            &self.recipe,
            day - 1,
            self.radius,
            lineage,
            &mut self.places,
        );
        if !within_cap {
            self.places.truncate(cells);
            lineage.truncate(cells);
            self.full = true;
        }
        within_cap
    }

    /// Before day 0 adhesion plays no part: every pair repels as two F cells do (the original
    /// program).
    fn forces(&self, day: usize) -> Forces {
        let adhesion = &self.recipe.adhesion;
        let weights = match day {
            0 => [[1.0 - adhesion[0][0]; 3]; 3],
            _ => adhesion.map(|row| row.map(|a| 1.0 - a)),
        };
        Forces { radius: self.radius, repulsion: self.recipe.repulsion, weights }
    }

    /// Hands the cells of `places` to the crowd.
    fn settle(&mut self) {
        let kinds = self.diary.lineage.iter().map(|cell| cell.kind as u8);
        self.crowd.gather(&self.mesh, self.places.iter().copied().zip(kinds));
    }

    /// Writes the day down and renews the repulsive radius.
    fn end_day(&mut self) {
        self.places = self.crowd.places();
        self.radius = repulsive_radius(&self.recipe, self.mesh.area, self.places.len());
        self.diary.days.push(Day { places: self.places.clone(), repulsive_radius: self.radius });
        self.events = 0;
    }
}

/// `r = radius_scale * sqrt(area / cells)`, in centimetres.
fn repulsive_radius(recipe: &Recipe, area: f32, cells: usize) -> f32 {
    recipe.radius_scale * (area / cells as f32).sqrt()
}

/// The first cells: places uniform by area, types by their probabilities.
fn sow(
    mesh: &Mesh,
    recipe: &Recipe,
    controls: &[Control],
    seed: u32,
) -> (Vec<Lineage>, Vec<Place>) {
    let mut up_to = Vec::with_capacity(mesh.areas.len());
    let mut sum = 0.0;
    for &area in &mesh.areas {
        sum += f64::from(area);
        up_to.push(sum);
    }
    (0..recipe.initial_cells)
        .map(|number| {
            let key = founder_key(seed, number);
            let chance = |purpose| uniform(key, 0, purpose);
            let triangle = up_to.partition_point(|&a| a <= chance(Purpose::Triangle) * sum);
            let along = chance(Purpose::PlaceAlong).sqrt();
            let across = chance(Purpose::PlaceAcross);
            let b1 = (along * (1.0 - across)) as f32;
            let b2 = ((along * across) as f32).min(1.0 - b1);
            let place = Place { triangle: triangle.min(up_to.len() - 1) as u32, b1, b2 };
            let drawn = pick(&recipe.initial_probability, chance(Purpose::FirstType));
            let mut kind = CellType::from_index(drawn as u8);
            if kind == CellType::Foreground {
                let mut tones = controls.iter().map(|control| control.tone(mesh, place));
                kind = match tones.find(|&tone| tone != Tone::White) {
                    None | Some(Tone::White) => CellType::Foreground,
                    Some(Tone::Grey) => CellType::Middle,
                    Some(Tone::Black) => CellType::Background,
                };
            }
            (Lineage { parent: number, founder: number, born_day: 0, kind }, place)
        })
        .unzip()
}
