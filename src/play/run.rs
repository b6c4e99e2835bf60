//! The days of one growth that the page holds.

use super::Scene;
use super::protocol::DayNews;
use crate::mosaic::SiteLists;
use crate::tissue::DayCount;

/// A growth as the page knows it.
#[derive(Debug)]
pub struct Run {
    /// Counts the growths that the page has asked for.
    pub generation: u32,
    /// The scene that grows, as it was asked for.
    pub scene: Scene,
    /// What is told and what is drawn of each day.
    days: Vec<(DayFacts, SiteLists)>,
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
        Run { generation, scene, days: Vec::new(), end: None }
    }

    /// Adds the next day. News out of turn are passed over: they cannot come from our own worker.
    pub fn add(&mut self, news: DayNews) {
        if news.generation == self.generation && news.day as usize == self.days.len() {
            self.days.push((news.facts, news.lists));
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
        self.days.get(day as usize).map(|(facts, _)| facts)
    }

    pub fn lists(&self, day: u32) -> Option<&SiteLists> {
        self.days.get(day as usize).map(|(_, lists)| lists)
    }
}
