//! A tissue that grows day by day on a body.

use super::{Diary, Recipe, RecipeError};
use crate::surface::{Control, Mesh};

/// A run under way: it can be taken one relaxation event at a time, so that whoever drives it
/// decides when to look up.
pub struct Growth<'a> {
    pub diary: Diary,
    mesh: &'a Mesh,
    recipe: &'a Recipe,
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

impl<'a> Growth<'a> {
    /// Sows the first cells. `controls` turn first F cells on black into B.
    pub fn new(
        mesh: &'a Mesh,
        recipe: &'a Recipe,
        controls: &'a [Control],
        seed: u32,
    ) -> Result<Growth<'a>, RecipeError> {
        let _ = (controls, seed);
        Ok(Growth { diary: Diary::default(), mesh, recipe })
    }

    /// Does one relaxation event (and, at the first event of a day, its divisions).
    pub fn step(&mut self) -> Progress {
        let _ = (self.mesh, self.recipe);
        todo!()
    }
}
