//! The worker's brain: grows what the page wishes, a slice at a time, and answers day by day. A newer
//! wish interrupts the older one.

use super::Scene;
use super::link;
use super::protocol::{BUILD, DayNews, ToPage, ToWorker};
use super::run::DayFacts;
use crate::mosaic::SiteFinder;
use crate::plants::{Plant, bring};
use crate::surface::Mesh;
use crate::tissue::{Diary, Growth, Noise, Pedigree, Progress};
use std::sync::Arc;

/// Grows one plant at a time.
pub struct Worker {
    plants: &'static [Plant],
    /// The texts of the mesh files that came, by name.
    meshes: Vec<(String, String)>,
    /// Of the plant grown last. To make one takes as long as the first days of its plant, but it holds
    /// up to 170 MB, most of it charts, and so there is one only.
    ground: Option<Ground>,
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
    noise: Option<Noise>,
    /// The day that is to be told before the others.
    first: usize,
    /// Whether a day was told, of those that have grown.
    told: Vec<bool>,
    /// How it ended, to be said when all days are told.
    end: Option<ToPage>,
}

/// What is to be done next.
enum Next {
    Tell(usize),
    Grow,
    End,
}

impl Run {
    /// The first day comes first: only then, or where it will never grow, the others.
    fn next(&self) -> Next {
        let untold = self.told.iter().position(|told| !told);
        let is_wanted = self.told.get(self.first) == Some(&false);
        match untold {
            Some(_) if is_wanted => Next::Tell(self.first),
            Some(day) if self.first < self.told.len() || self.end.is_some() => Next::Tell(day),
            _ if self.end.is_some() => Next::End,
            _ => Next::Grow,
        }
    }
}

impl Worker {
    pub fn new(plants: &'static [Plant]) -> Worker {
        Worker { plants, meshes: Vec::new(), ground: None, run: None }
    }

    /// What a worker says first.
    pub fn hello() -> ToPage {
        ToPage::Hello { build: BUILD.to_string() }
    }

    /// Takes a wish; what grew before stops. An answer comes at once only if it cannot be grown.
    pub fn hear(&mut self, wish: ToWorker) -> Option<ToPage> {
        let (generation, first, link) = match wish {
            ToWorker::Grow { generation, first, link } => (generation, first, link),
            ToWorker::First { day } => {
                if let Some(run) = &mut self.run {
                    run.first = day as usize;
                }
                return None;
            }
            ToWorker::Mesh { name, text } => {
                // That of a plant of the visitor's own says it.
                bring(&text);
                self.meshes.push((name, text));
                return None;
            }
            ToWorker::Stop => {
                self.run = None;
                return None;
            }
        };
        self.run = None;
        match self.sow(&link) {
            Ok((growth, noise)) => {
                let (first, told, end) = (first as usize, Vec::new(), None);
                self.run = Some(Run { generation, growth, noise, first, told, end });
                None
            }
            Err(why) => Some(ToPage::Failed { generation, text: why }),
        }
    }

    /// Whether something is growing.
    pub fn is_busy(&self) -> bool {
        self.run.is_some()
    }

    /// Grows until the slice of time is over or the growth ends. `slice_is_over` is asked after each
    /// relaxation event and each day that is told.
    pub fn work(&mut self, slice_is_over: impl Fn() -> bool, mut post: impl FnMut(ToPage)) {
        while let (Some(run), Some(ground)) = (&mut self.run, &mut self.ground) {
            let generation = run.generation;
            match run.next() {
                Next::Tell(day) => {
                    let diary = &run.growth.diary;
                    let painted = run.noise.as_ref().map(|n| n.paint(&ground.surface, diary, day));
                    let diary = painted.as_ref().unwrap_or(diary);
                    if day == 0 {
                        // Else its lists would go by what was told first.
                        ground.finder.forget();
                    }
                    post(ToPage::Day(ground.news(diary, generation, day)));
                    run.told[day] = true;
                }
                Next::Grow => match run.growth.step() {
                    Progress::Event => {}
                    Progress::Day(day) => {
                        let born = Pedigree::news(&run.growth.diary, day as usize);
                        post(ToPage::Born { generation, born });
                        run.told.push(false);
                    }
                    Progress::Full => run.end = Some(ToPage::Full { generation }),
                    Progress::Done => run.end = Some(ToPage::Done { generation }),
                },
                Next::End => {
                    self.run.take().and_then(|run| run.end).into_iter().for_each(&mut post);
                }
            }
            if slice_is_over() {
                return;
            }
        }
    }

    fn sow(&mut self, link: &str) -> Result<(Growth, Option<Noise>), String> {
        let scene = link::read(link, self.plants).scene;
        let surface = self.surface(&scene)?;
        scene.sow(surface).map_err(|why| why.to_string())
    }

    /// The surface of a scene's plant, whose ground is there then.
    fn surface(&mut self, scene: &Scene) -> Result<Arc<Mesh>, String> {
        let plant = scene.plant;
        let controls = plant.controls(scene.individual);
        if let Some(known) = self.ground.as_mut().filter(|ground| ground.plant == plant.key) {
            known.finder.begin(controls);
            return Ok(Arc::clone(&known.surface));
        }
        // First, so that the new one finds its room.
        self.ground = None;
        let mesh = self.meshes.iter().find(|(name, _)| name == plant.body.mesh.name);
        let (_, text) = mesh.ok_or_else(|| format!("{} has not come", plant.body.mesh.name))?;
        let body =
            plant.grow_body(text).map_err(|why| format!("{}: {why}", plant.body.mesh.name))?;
        let surface = Arc::new(body.surface);
        let finder = SiteFinder::new(&surface).coloured(controls);
        self.ground = Some(Ground { plant: plant.key, surface: Arc::clone(&surface), finder });
        Ok(surface)
    }
}

impl Ground {
    fn news(&mut self, diary: &Diary, generation: u32, index: usize) -> DayNews {
        let day = index as u32;
        let lists = self.finder.find(&self.surface, diary, index);
        let facts = DayFacts {
            count: diary.count(index),
            areas: lists.areas(&self.surface.on(day)),
            fingerprint: diary.fingerprint(index),
        };
        DayNews { generation, day, facts, lists, cell_of: self.finder.cell_of.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{PLANTS, SHEET};
    use super::*;

    fn mesh(name: &str) -> ToWorker {
        ToWorker::Mesh { name: name.to_string(), text: SHEET.to_string() }
    }

    fn grow(plant: &str) -> ToWorker {
        ToWorker::Grow { generation: 1, first: 1, link: format!("{plant}?v=1&s=1&d=1") }
    }

    #[test]
    fn the_ground_of_the_last_plant_is_kept() {
        let mut worker = Worker::new(PLANTS);
        worker.hear(mesh("leaf"));
        worker.hear(mesh("fruit"));
        let mut surface_of = |plant: &str| {
            assert_eq!(worker.hear(grow(plant)), None);
            worker.work(|| false, |_| {});
            let ground = worker.ground.as_ref().unwrap();
            assert_eq!(ground.plant, plant);
            Arc::clone(&ground.surface)
        };
        let first = surface_of("leaf");
        assert!(Arc::ptr_eq(&first, &surface_of("leaf")));
        surface_of("fruit");
        assert!(!Arc::ptr_eq(&first, &surface_of("leaf")));
        assert_eq!(Arc::strong_count(&first), 1, "no other one is held");
    }

    /// All that a worker says of a leaf, that of one day first.
    fn told(first: u32, link: &str) -> Vec<ToPage> {
        let mut worker = Worker::new(PLANTS);
        worker.hear(mesh("leaf"));
        worker.hear(ToWorker::Grow { generation: 1, first, link: link.to_string() });
        let mut told = Vec::new();
        worker.work(|| false, |answer| told.push(answer));
        told
    }

    /// The days that were told, in the order in which they were.
    fn days(told: &[ToPage]) -> Vec<&DayNews> {
        let days = told.iter().filter_map(|said| match said {
            ToPage::Day(news) => Some(news),
            _ => None,
        });
        days.collect()
    }

    #[test]
    fn one_day_is_told_first_and_all_are_as_they_are_in_their_order() {
        for link in ["leaf?v=1&s=1&d=6", "leaf?v=1&s=1&d=6&noise=1"] {
            let in_order = told(0, link);
            let expected = days(&in_order);
            for first in [1, 4, 6] {
                let all = told(first, link);
                let mut news = days(&all);
                let order: Vec<u32> = news.iter().map(|news| news.day).collect();
                let others = (0..=6).filter(|&day| day != first);
                assert_eq!(order, [first].into_iter().chain(others).collect::<Vec<u32>>());
                news.sort_by_key(|news| news.day);
                for (a, b) in expected.iter().zip(&news) {
                    assert_eq!(a.facts, b.facts);
                    // In the middle of each triangle is the same cell, whatever the order of its list.
                    let cell = |news: &DayNews, t| {
                        news.lists.nearest(t, glam::Vec2::ZERO, 1.0).map(|site| news.cell_of[site])
                    };
                    assert!((0..a.lists.heads.len()).all(|t| cell(a, t) == cell(b, t)));
                    if b.day != first {
                        assert_eq!(a, b, "day {} after day {first}", a.day);
                    }
                }
                assert_eq!(all.last(), Some(&ToPage::Done { generation: 1 }));
                let born = |said: &&ToPage| matches!(said, ToPage::Born { .. });
                assert!(all.iter().filter(born).eq(in_order.iter().filter(born)));
            }
        }
    }

    #[test]
    fn a_newer_wish_is_told_before_the_others() {
        let mut worker = Worker::new(PLANTS);
        worker.hear(mesh("leaf"));
        let link = "leaf?v=1&s=1&d=6".to_string();
        worker.hear(ToWorker::Grow { generation: 1, first: 6, link });
        let mut told = Vec::new();
        while told.len() < 3 {
            worker.work(|| true, |answer| told.push(answer));
        }
        worker.hear(ToWorker::First { day: 1 });
        worker.work(|| false, |answer| told.push(answer));
        let order: Vec<u32> = days(&told).iter().map(|news| news.day).collect();
        assert_eq!(order, [1, 0, 2, 3, 4, 5, 6]);
    }

    #[test]
    fn a_plant_whose_mesh_has_not_come_is_refused() {
        let mut worker = Worker::new(PLANTS);
        worker.hear(mesh("fruit"));
        let text = "leaf has not come".to_string();
        assert_eq!(worker.hear(grow("leaf")), Some(ToPage::Failed { generation: 1, text }));
        assert_eq!(worker.hear(grow("fruit")), None);
        worker.hear(ToWorker::Stop);
        assert!(!worker.is_busy());
    }
}
