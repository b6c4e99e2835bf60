//! The days of one growth that the page holds.

use super::Scene;
use super::protocol::DayNews;
use crate::tissue::{Day, DayCount, Diary};

/// A growth as the page knows it.
#[derive(Debug)]
pub struct Run {
    /// Counts the growths that the page has asked for.
    pub generation: u32,
    /// The scene that grows, as it was asked for.
    pub scene: Scene,
    pub diary: Diary,
    /// Population and fingerprint of each day.
    facts: Vec<DayFacts>,
    pub end: Option<End>,
}

/// What is told of a day.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DayFacts {
    pub count: DayCount,
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
        Run { generation, scene, diary: Diary::default(), facts: Vec::new(), end: None }
    }

    /// Adds the next day. News out of turn are passed over: they cannot come from our own worker.
    pub fn add(&mut self, news: DayNews) {
        let before = self.diary.lineage.len();
        let in_turn = news.generation == self.generation && news.day as usize == self.facts.len();
        if !in_turn || news.places.len() != before + news.newborn.len() {
            return;
        }
        let mut by_type = self.facts.last().map_or([0; 3], |f| f.count.by_type);
        for cell in &news.newborn {
            by_type[cell.kind as usize] += 1;
        }
        let count = DayCount { cells: news.places.len() as u32, by_type };
        self.facts.push(DayFacts { count, fingerprint: news.fingerprint });
        self.diary.lineage.extend(news.newborn);
        let repulsive_radius = news.repulsive_radius;
        self.diary.days.push(Day { places: news.places, repulsive_radius });
    }

    /// The newest day that is held.
    pub fn newest(&self) -> Option<u32> {
        self.facts.len().checked_sub(1).map(|d| d as u32)
    }

    /// The last day that there is or will be.
    pub fn last_day(&self) -> u32 {
        match (&self.end, self.newest()) {
            (Some(_), Some(newest)) => newest,
            _ => self.scene.recipe.days,
        }
    }

    pub fn facts(&self, day: u32) -> Option<&DayFacts> {
        self.facts.get(day as usize)
    }
}
