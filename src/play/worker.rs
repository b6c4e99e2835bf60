//! The worker's brain: grows what the page wishes, a slice at a time, and answers day by day. A newer
//! wish interrupts the older one.

use super::link;
use super::protocol::{BUILD, DayNews, ToPage, ToWorker};
use super::run::DayFacts;
use crate::mosaic::SiteFinder;
use crate::plants::Plant;
use crate::surface::Mesh;
use crate::tissue::{Growth, Progress, RecipeError};
use std::sync::Arc;

/// Grows one plant at a time.
pub struct Worker {
    plants: &'static [Plant],
    /// Grounds by plant, made once and kept: to refine one takes longer than its first days.
    grounds: Vec<Ground>,
    run: Option<Run>,
}

/// What a plant's cells live on, and how they are found there.
struct Ground {
    plant: &'static str,
    surface: Arc<Mesh>,
    finder: SiteFinder,
}

struct Run {
    generation: u32,
    growth: Growth,
    /// Its index in `grounds`.
    ground: usize,
}

impl Worker {
    pub fn new(plants: &'static [Plant]) -> Worker {
        Worker { plants, grounds: Vec::new(), run: None }
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
            Ok((growth, ground)) => {
                self.run = Some(Run { generation, growth, ground });
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
        while let Some(Run { generation, growth, ground }) = &mut self.run {
            let generation = *generation;
            match growth.step() {
                Progress::Event => {}
                Progress::Day(day) => {
                    let ground = &mut self.grounds[*ground];
                    post(ToPage::Day(ground.news(growth, generation, day)));
                }
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

    fn sow(&mut self, link: &str) -> Result<(Growth, usize), RecipeError> {
        let scene = link::read(link, self.plants).scene;
        let plant = scene.plant;
        let known = self.grounds.iter().position(|ground| ground.plant == plant.key);
        let known = known.unwrap_or_else(|| {
            let surface = Arc::new((plant.body)().surface);
            let finder = SiteFinder::new(&surface);
            self.grounds.push(Ground { plant: plant.key, surface, finder });
            self.grounds.len() - 1
        });
        let surface = Arc::clone(&self.grounds[known].surface);
        let growth = Growth::new(surface, scene.recipe, &(plant.controls)(), scene.individual)?;
        Ok((growth, known))
    }
}

impl Ground {
    fn news(&mut self, growth: &Growth, generation: u32, day: u32) -> DayNews {
        let diary = &growth.diary;
        let index = day as usize;
        DayNews {
            generation,
            day,
            facts: DayFacts { count: diary.count(index), fingerprint: diary.fingerprint(index) },
            lists: self.finder.find(&self.surface, diary, index),
        }
    }
}
