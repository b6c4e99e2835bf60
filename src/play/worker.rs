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
        let (generation, link) = match wish {
            ToWorker::Grow { generation, link } => (generation, link),
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
                self.run = Some(Run { generation, growth, noise });
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
    /// relaxation event.
    pub fn work(&mut self, slice_is_over: impl Fn() -> bool, mut post: impl FnMut(ToPage)) {
        while let (Some(Run { generation, growth, noise }), Some(ground)) =
            (&mut self.run, &mut self.ground)
        {
            let generation = *generation;
            match growth.step() {
                Progress::Event => {}
                Progress::Day(day) => {
                    let diary = &growth.diary;
                    let painted =
                        noise.as_ref().map(|n| n.paint(&ground.surface, diary, day as usize));
                    let diary = painted.as_ref().unwrap_or(diary);
                    post(ToPage::Day(ground.news(diary, generation, day)));
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
    fn news(&mut self, diary: &Diary, generation: u32, day: u32) -> DayNews {
        let index = day as usize;
        let lists = self.finder.find(&self.surface, diary, index);
        let facts = DayFacts {
            count: diary.count(index),
            areas: lists.areas(&self.surface.on(day)),
            fingerprint: diary.fingerprint(index),
        };
        let (cell_of, born) = (self.finder.cell_of.clone(), Pedigree::news(diary, index));
        DayNews { generation, day, facts, lists, cell_of, born }
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
        ToWorker::Grow { generation: 1, link: format!("{plant}?v=1&s=1&d=1") }
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
