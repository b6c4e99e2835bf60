//! The days of one growth that the page holds.

use super::Scene;
use super::protocol::DayNews;
use crate::mosaic::SiteLists;
use crate::tissue::{DayCount, Pedigree};

/// A day that is held.
type Held = (DayFacts, Option<SiteLists>, Vec<u32>);

/// A growth as the page knows it.
#[derive(Debug)]
pub struct Run {
    /// Counts the growths that the page has asked for.
    pub generation: u32,
    /// The scene that grows, as it was asked for.
    pub scene: Scene,
    /// What is told and what is drawn of each day that has come, and the cell of each site; nothing of that where no
    /// clones are asked for.
    days: Vec<Option<Held>>,
    pub pedigree: Pedigree,
    knows_clones: bool,
    pub end: Option<End>,
}

/// What is told of a day.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DayFacts {
    pub count: DayCount,
    /// See `SiteLists::areas`.
    pub areas: [u32; 3],
    pub fingerprint: String,
}

/// How a growth ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    Done,
    /// At the population cap.
    Full,
    Failed,
}

impl Run {
    pub fn new(generation: u32, scene: Scene) -> Run {
        let (days, pedigree) = (Vec::new(), Pedigree::default());
        Run { generation, scene, days, pedigree, knows_clones: true, end: None }
    }

    /// The same for pictures that nobody asks for clones: a third less to hold.
    pub fn without_clones(generation: u32, scene: Scene) -> Run {
        Run { knows_clones: false, ..Run::new(generation, scene) }
    }

    /// Adds who was born on the next day that has grown.
    pub fn bear(&mut self, generation: u32, born: &[u32]) {
        if generation == self.generation && self.knows_clones {
            self.pedigree.add(born);
        }
    }

    /// Adds a day; the wished one may come before those that were before it.
    pub fn add(&mut self, news: DayNews) {
        let day = news.day as usize;
        if news.generation == self.generation && day <= self.scene.recipe.days as usize {
            let cell_of = if self.knows_clones { news.cell_of } else { Vec::new() };
            if day >= self.days.len() {
                self.days.resize_with(day + 1, || None);
            }
            self.days[day] = Some((news.facts, Some(news.lists), cell_of));
        }
    }

    /// Lets go of what is drawn of a day; what is told of it stays.
    pub fn forget_lists(&mut self, day: u32) {
        if let Some(Some((_, lists, _))) = self.days.get_mut(day as usize) {
            *lists = None;
        }
    }

    /// The newest day that is held with all before it.
    pub fn newest(&self) -> Option<u32> {
        self.newest_from(0)
    }

    /// The newest day that is held with all from this one on, or else from the nearest one before it.
    pub fn newest_from(&self, day: u32) -> Option<u32> {
        let mut newest = (0..=day).rev().find(|&day| self.facts(day).is_some())?;
        while self.facts(newest + 1).is_some() {
            newest += 1;
        }
        Some(newest)
    }

    /// The last day that is held.
    pub fn last_held(&self) -> Option<u32> {
        self.days.len().checked_sub(1).map(|day| day as u32)
    }

    /// The newest day that has grown.
    pub fn grown(&self) -> Option<u32> {
        self.pedigree.days().checked_sub(1)
    }

    /// The last day that there is or will be.
    pub fn last_day(&self) -> u32 {
        match (&self.end, self.last_held()) {
            (Some(_), Some(newest)) => newest,
            _ => self.scene.recipe.days,
        }
    }

    pub fn facts(&self, day: u32) -> Option<&DayFacts> {
        self.day(day).map(|(facts, ..)| facts)
    }

    pub fn lists(&self, day: u32) -> Option<&SiteLists> {
        self.day(day).and_then(|(_, lists, _)| lists.as_ref())
    }

    /// The cell of each site of the lists of a day.
    pub fn cell_of(&self, day: u32) -> &[u32] {
        self.day(day).map_or(&[], |(.., cell_of)| cell_of)
    }

    fn day(&self, day: u32) -> Option<&Held> {
        self.days.get(day as usize)?.as_ref()
    }
}
