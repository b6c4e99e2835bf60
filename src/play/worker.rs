//! The worker's brain: grows what the page wishes, a slice at a time, and answers day by day. A newer
//! wish interrupts the older one.

use super::link;
use super::protocol::{BUILD, DayNews, ToPage, ToWorker};
use crate::plants::Plant;
use crate::surface::Mesh;
use crate::tissue::{Growth, Progress, RecipeError};
use std::sync::Arc;

/// Grows one plant at a time.
pub struct Worker {
    plants: &'static [Plant],
    /// Surfaces by plant, made once and kept: to refine one takes longer than its first days.
    surfaces: Vec<(&'static str, Arc<Mesh>)>,
    run: Option<Run>,
}

struct Run {
    generation: u32,
    growth: Growth,
}

impl Worker {
    pub fn new(plants: &'static [Plant]) -> Worker {
        Worker { plants, surfaces: Vec::new(), run: None }
    }

    /// What a worker says first.
    pub fn hello() -> ToPage {
        ToPage::Hello { build: BUILD.to_string() }
    }

    /// Takes a wish; what grew before stops. An answer comes at once only if it cannot be grown.
    pub fn hear(&mut self, wish: ToWorker) -> Option<ToPage> {
        let ToWorker::Grow { generation, link } = wish;
        self.run = None;
        match self.sow(&link) {
            Ok(growth) => {
                self.run = Some(Run { generation, growth });
                None
            }
            Err(why) => Some(ToPage::Failed { generation, text: why.to_string() }),
        }
    }

    /// Whether something is growing.
    pub fn is_busy(&self) -> bool {
        self.run.is_some()
    }

    /// Grows until the slice of time is over or the growth ends. `slice_is_over` is asked after each
    /// relaxation event.
    pub fn work(&mut self, slice_is_over: impl Fn() -> bool, mut post: impl FnMut(ToPage)) {
        while let Some(Run { generation, growth }) = &mut self.run {
            let generation = *generation;
            match growth.step() {
                Progress::Event => {}
                Progress::Day(day) => post(ToPage::Day(news(growth, generation, day))),
                Progress::Full => {
                    post(ToPage::Full { generation });
                    self.run = None;
                }
                Progress::Done => {
                    post(ToPage::Done { generation });
                    self.run = None;
                }
            }
            if slice_is_over() {
                return;
            }
        }
    }

    fn sow(&mut self, link: &str) -> Result<Growth, RecipeError> {
        let scene = link::read(link, self.plants).scene;
        let plant = scene.plant;
        let known = self.surfaces.iter().position(|(key, _)| *key == plant.key);
        let known = known.unwrap_or_else(|| {
            self.surfaces.push((plant.key, Arc::new((plant.body)().surface)));
            self.surfaces.len() - 1
        });
        let surface = Arc::clone(&self.surfaces[known].1);
        plant.sow(surface, scene.recipe, scene.individual)
    }
}

fn news(growth: &Growth, generation: u32, day: u32) -> DayNews {
    let diary = &growth.diary;
    let index = day as usize;
    let today = &diary.days[index];
    let before = index.checked_sub(1).map_or(0, |k| diary.days[k].places.len());
    DayNews {
        generation,
        day,
        repulsive_radius: today.repulsive_radius,
        fingerprint: diary.fingerprint(index),
        places: today.places.clone(),
        newborn: diary.lineage[before..today.places.len()].to_vec(),
    }
}
