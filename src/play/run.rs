//! The days of one growth that the page holds.

use super::Scene;
use super::protocol::DayNews;
use crate::mosaic::SiteLists;
use crate::tissue::{DayCount, Pedigree};

/// A growth as the page knows it.
#[derive(Debug)]
pub struct Run {
    /// Counts the growths that the page has asked for.
    pub generation: u32,
    /// The scene that grows, as it was asked for.
    pub scene: Scene,
    /// What is told and what is drawn of each day, and the cell of each site; nothing of that where no clones
    /// are asked for.
    days: Vec<(DayFacts, Option<SiteLists>, Vec<u32>)>,
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

    /// Adds the next day. News out of turn are passed over: they cannot come from our own worker.
    pub fn add(&mut self, news: DayNews) {
        if news.generation == self.generation && news.day as usize == self.days.len() {
            let mut cell_of = Vec::new();
            if self.knows_clones {
                cell_of = news.cell_of;
                self.pedigree.add(&news.born);
            }
            self.days.push((news.facts, Some(news.lists), cell_of));
        }
    }

    /// Lets go of what is drawn of a day; what is told of it stays.
    pub fn forget_lists(&mut self, day: u32) {
        if let Some((_, lists, _)) = self.days.get_mut(day as usize) {
            *lists = None;
        }
    }

    /// The newest day that is held.
    pub fn newest(&self) -> Option<u32> {
        self.days.len().checked_sub(1).map(|d| d as u32)
    }

    /// The last day that there is or will be.
    pub fn last_day(&self) -> u32 {
        match (&self.end, self.newest()) {
            (Some(_), Some(newest)) => newest,
            _ => self.scene.recipe.days,
        }
    }

    pub fn facts(&self, day: u32) -> Option<&DayFacts> {
        self.days.get(day as usize).map(|(facts, ..)| facts)
    }

    pub fn lists(&self, day: u32) -> Option<&SiteLists> {
        self.days.get(day as usize).and_then(|(_, lists, _)| lists.as_ref())
    }

    /// The cell of each site of the lists of a day.
    pub fn cell_of(&self, day: u32) -> &[u32] {
        self.days.get(day as usize).map_or(&[], |(.., cell_of)| cell_of)
    }
}
