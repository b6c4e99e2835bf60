//! A tissue that grows day by day on a body: sowing, and then each day divisions and relaxation.

use super::chance::{Purpose, founder_key, pick, uniform};
use super::course::Course;
use super::divide::{Clocks, Setting};
use super::ground::Ground;
use super::relax::Crowd;
use super::{CellType, Control, Day, Diary, Lineage, Recipe, RecipeError, control};
use crate::surface::{DirectionField, Mesh, Place};
use std::borrow::Cow;
use std::sync::Arc;

/// A run under way: it can be taken one relaxation event at a time, so that whoever drives it
/// decides when to look up.
pub struct Growth {
    pub diary: Diary,
    /// The body as it was made, which images and fields lie on.
    rest: Arc<Mesh>,
    /// The body on the day under way: the same if it stands still.
    mesh: Arc<Mesh>,
    recipe: Recipe,
    controls: Vec<Control>,
    course: Option<Course>,
    /// The day on which each part of the body unfolds; 0 where none is said.
    unfolding_days: Vec<u32>,
    crowd: Crowd,
    clocks: Clocks,
    /// The cells' places at the beginning of the day under way.
    places: Vec<Place>,
    /// The forces of the day under way.
    ground: Ground,
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
    /// Sows the first cells (Thesis 3.2.1.1) under the control images of the body, which are taken
    /// in their order. Where the body moves, cells keep their triangles and barycentric coordinates, and the
    /// repulsive radius goes by the area of each day.
    pub fn new(
        mesh: Arc<Mesh>,
        recipe: Recipe,
        controls: &[Control],
        seed: u32,
    ) -> Result<Growth, RecipeError> {
        recipe.check()?;
        control::check(&recipe, controls)?;
        let (rest, mesh) = (Arc::clone(&mesh), on(&mesh, 0));
        let (lineage, places) = sow(&mesh, &rest, &recipe, controls, seed);
        let setting = Setting { mesh: &mesh, rest: &rest, recipe: &recipe, controls };
        let clocks = Clocks::new(&setting, seed, &lineage, &places);
        Ok(Growth {
            diary: Diary { lineage, days: Vec::new() },
            crowd: Crowd::default(),
            ground: Ground::new(&mesh, &rest, &recipe, controls, places.len(), 0),
            rest,
            mesh,
            recipe,
            controls: controls.to_vec(),
            course: None,
            unfolding_days: Vec::new(),
            clocks,
            places,
            events: 0,
            full: false,
        })
    }

    /// From day 1 on, steps are turned along a direction field of the same mesh as far as the
    /// recipe's anisotropy says. Before day 0 they are not: those events spread the first cells
    /// evenly, and where adhesion plays no part the field plays none.
    pub fn along(mut self, field: DirectionField) -> Growth {
        let anisotropy = self.recipe.anisotropy;
        self.course = (anisotropy > 0.0).then(|| Course::new(field, anisotropy));
        self.lead();
        self
    }

    /// Takes the direction field along with the body.
    fn lead(&mut self) {
        if let Some(course) = &mut self.course
            && self.rest.scale_to(&self.mesh).is_none()
        {
            course.lead(&self.rest, &self.mesh);
        }
    }

    /// The parts of the body, in their order, unfold on these days, and those that are not named on
    /// day 0: leaves of one plant that are of different ages (Thesis, Fig. 4.10). Until then the
    /// first cells of a part stand still and their clocks do not run; from then on it lives as if it
    /// were day 0, so that its age is the plant's less that day. (The repulsive radius is that of the
    /// whole body, as always.)
    pub fn unfolding(mut self, days: &[u32]) -> Growth {
        self.unfolding_days = days.to_vec();
        let first_days: Vec<u32> = self.places.iter().map(|p| self.unfolding_day(p)).collect();
        self.clocks.delay(&first_days);
        self
    }

    fn unfolding_day(&self, place: &Place) -> u32 {
        let part = self.mesh.parts[place.triangle as usize];
        self.unfolding_days.get(part as usize).copied().unwrap_or(0)
    }

    /// So many threads share each relaxation event; one does it alone if nothing is said. The cells are
    /// the same with any number.
    ///
    /// # Panics
    /// If the system gives no threads.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn on_threads(mut self, threads: usize) -> Growth {
        self.crowd.set_threads(threads);
        self
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
        if day > 0 && self.events == 0 && !self.divide(day) {
            return Progress::Full;
        }
        let events = match day {
            0 => self.recipe.initial_relaxations,
            _ => self.recipe.relaxations_per_day,
        };
        if self.events < events {
            if self.events == 0 {
                self.settle();
            }
            let course = self.course.as_ref().filter(|_| day > 0);
            self.crowd.relax(&self.mesh, &self.ground, course);
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
        self.crowd.caught_walks()
    }

    /// What fell due before the day divides. False when the population cap is reached: the
    /// children that were born already are forgotten.
    fn divide(&mut self, day: usize) -> bool {
        let cells = self.places.len();
        let Growth { mesh, rest, recipe, controls, diary, .. } = self;
        let (setting, lineage) = (Setting { mesh, rest, recipe, controls }, &mut diary.lineage);
        let within_cap = self.clocks.divide(&setting, day, &self.ground, lineage, &mut self.places);
        if !within_cap {
            self.places.truncate(cells);
            lineage.truncate(cells);
            self.full = true;
        }
        within_cap
    }

    /// Hands the cells of `places` to the crowd.
    fn settle(&mut self) {
        let lineage = &self.diary.lineage;
        let kind = |cell: usize| lineage[cell].kind as u8;
        self.crowd.gather(&self.mesh, &self.places, kind, self.ground.reach_cm());
    }

    /// Brings the body to where it stands on a day. What was laid flat of it holds until its shape changes:
    /// growth that is everywhere the same leaves a pattern as it is.
    fn move_body(&mut self, day: usize) {
        let moved = on(&self.rest, day);
        if moved.positions == self.mesh.positions {
            return;
        }
        let scale = self.mesh.scale_to(&moved);
        self.mesh = moved;
        match scale {
            Some(scale) => self.crowd.scale_ground(scale),
            None => {
                self.crowd.forget_ground();
                self.lead();
            }
        }
    }

    /// Writes the day down and renews the forces with the repulsive radius.
    fn end_day(&mut self) {
        let day = self.diary.days.len();
        // Where nothing was moved no crowd was gathered.
        let mut places = if self.events > 0 { self.crowd.places() } else { self.places.clone() };
        // Parts do not feel each other: what has not unfolded is simply put back.
        if day > 0 && !self.unfolding_days.is_empty() {
            for (place, before) in places.iter_mut().zip(&self.places) {
                if day as u32 <= self.unfolding_day(before) {
                    *place = *before;
                }
            }
        }
        let cells = places.len();
        let repulsive_radius = self.recipe.repulsive_radius_cm(self.mesh.area, cells);
        self.move_body(day + 1);
        let Growth { mesh, rest, recipe, controls, .. } = &*self;
        self.ground = Ground::new(mesh, rest, recipe, controls, cells, day + 1);
        // Into the memory that is there.
        self.places.clone_from(&places);
        self.diary.days.push(Day { places, repulsive_radius });
        self.events = 0;
    }
}

/// A body as it stands on a day.
fn on(rest: &Arc<Mesh>, day: usize) -> Arc<Mesh> {
    match rest.on(day as u32) {
        Cow::Borrowed(_) => Arc::clone(rest),
        Cow::Owned(moved) => Arc::new(moved),
    }
}

/// The first cells: places uniform by area, types by their probabilities.
fn sow(
    mesh: &Mesh,
    rest: &Mesh,
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
            let kind = controls
                .iter()
                .fold(CellType::from_index(drawn as u8), |k, c| c.first_type(rest, place, k));
            (Lineage { parent: number, founder: number, born_day: 0, kind }, place)
        })
        .unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_full_stays_full() {
        let mesh = Arc::new(crate::surface::icosphere(1, 10.0));
        let recipe = Recipe {
            initial_cells: 20,
            max_cells: 20,
            division_days: [1.5; 3],
            initial_relaxations: 0,
            relaxations_per_day: 0,
            days: 30,
            ..Recipe::default()
        };
        let mut growth = Growth::new(mesh, recipe, &[], 1).unwrap();
        while growth.step() != Progress::Full {}
        let days = growth.diary.days.len();
        assert!((0..200).all(|_| growth.step() == Progress::Full));
        assert_eq!((growth.diary.days.len(), growth.diary.lineage.len()), (days, 20));
    }
}
