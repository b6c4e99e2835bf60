//! The clone in hand: which it is, and what is told of it.

use super::super::clone::Told;
use super::super::pick::Picked;
use super::super::{End, Scene, words};
use super::{Effect, Page};
use crate::plants::Show;

/// What is known of the clone in hand.
#[derive(Debug)]
pub(super) struct InHand {
    cell: u32,
    /// The growth that it is of, and how many days of it are known.
    generation: u32,
    days: usize,
    /// How many cells it has on each of those.
    sizes: Vec<u32>,
}

impl Page {
    /// What is told of the clone in hand on the day that is shown.
    pub fn told_of_clone(&self) -> Option<Told> {
        let in_hand = self.in_hand.as_ref()?;
        Some(Told::of(&self.run, in_hand.cell, &in_hand.sizes, self.shown.day.as_ref()))
    }

    /// The cell that is shown at a place of the body, if there is any.
    pub fn cell_at(&self, picked: &Picked) -> Option<u32> {
        let day = self.shown.day.as_ref()?;
        let is_of_run = self.shown.generation == self.run.generation;
        let lists = self.run.lists(day.day).filter(|_| is_of_run)?;
        let site = lists.nearest(picked.triangle, picked.place_cm, day.moment)?;
        self.run.cell_of(day.day).get(site).copied()
    }

    /// Takes the clone of a cell, or the clan that the cell is of; lets go what is in hand.
    pub(super) fn take_clone(&mut self, cell: u32, clan: bool, effects: &mut Vec<Effect>) {
        let Some(&founder) = self.run.pedigree.founders().get(cell as usize) else { return };
        let cell = if clan { founder } else { cell };
        self.hold(Some(cell).filter(|_| self.scene.cell != Some(cell)), effects);
    }

    pub(super) fn take_mother(&mut self, effects: &mut Vec<Effect>) {
        let Some(cell) = self.held() else { return };
        let mother = self.run.pedigree.mothers(cell).next();
        if let Some(mother) = mother {
            self.hold(Some(mother), effects);
        }
    }

    /// The clan so many steps on from the one in hand; the first or the last one where none is.
    pub(super) fn step_clans(&mut self, by: i32, effects: &mut Vec<Effect>) {
        let clans = i64::from(self.run.pedigree.clans());
        let from = match self.held() {
            Some(cell) => i64::from(self.run.pedigree.founders()[cell as usize]),
            None => -i64::from(by > 0),
        };
        if clans > 0 {
            self.hold(Some((from + i64::from(by)).rem_euclid(clans) as u32), effects);
        }
    }

    pub(super) fn hold(&mut self, cell: Option<u32>, effects: &mut Vec<Effect>) {
        if cell != self.scene.cell {
            let mut scene = Scene { cell, ..self.wished_scene() };
            if cell.is_some() && !scene.show.is_of_cells() {
                // A clone is to be seen.
                scene.show = Show::Cells;
            }
            self.adopt(scene, effects);
        }
    }

    /// The cell in hand, if it has been born.
    fn held(&self) -> Option<u32> {
        self.scene.cell.filter(|&cell| cell < self.run.pedigree.cells())
    }

    /// Brings what is known of the clone up to what has grown. A cell that will not be born is let go.
    pub(super) fn know_clone(&mut self, effects: &mut Vec<Effect>) {
        let is_over = matches!(self.run.end, Some(End::Done | End::Full));
        if is_over && self.scene.cell.is_some() && self.held().is_none() {
            let text = words::no_such_cell(self.run.pedigree.cells());
            self.hold(None, effects);
            effects.push(Effect::Tell(vec![text]));
        }
        let days = self.run.pedigree.days() as usize;
        let generation = self.run.generation;
        let is_known = |known: &InHand| {
            Some(known.cell) == self.scene.cell
                && (known.generation, known.days) == (generation, days)
        };
        if !self.in_hand.as_ref().is_some_and(is_known) {
            let pedigree = &self.run.pedigree;
            self.in_hand = self.scene.cell.map(|cell| {
                let sizes = pedigree.clone_sizes(cell);
                InHand { cell, generation, days, sizes }
            });
        }
    }
}
