//! The worker's brain: grows what the page wishes, a slice at a time, and answers day by day. A newer
//! wish interrupts the older one.

use super::link;
use super::protocol::{BUILD, DayNews, ToPage, ToWorker};
use crate::plants::Plant;
use crate::surface::Mesh;
use crate::tissue::{Growth, Progress};
use std::sync::Arc;

/// Grows one plant at a time.
pub struct Worker {
    plants: &'static [Plant],
    /// The texts of the mesh files that came, by name.
    meshes: Vec<(String, String)>,
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
        Worker { plants, meshes: Vec::new(), surfaces: Vec::new(), run: None }
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
                self.meshes.push((name, text));
                return None;
            }
        };
        self.run = None;
        match self.sow(&link) {
            Ok(growth) => {
                self.run = Some(Run { generation, growth });
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

    fn sow(&mut self, link: &str) -> Result<Growth, String> {
        let scene = link::read(link, self.plants).scene;
        let surface = self.surface(scene.plant)?;
        Growth::new(surface, scene.recipe, &(scene.plant.controls)(), scene.individual)
            .map_err(|why| why.to_string())
    }

    fn surface(&mut self, plant: &'static Plant) -> Result<Arc<Mesh>, String> {
        if let Some((_, surface)) = self.surfaces.iter().find(|(key, _)| *key == plant.key) {
            return Ok(Arc::clone(surface));
        }
        let mesh = self.meshes.iter().find(|(name, _)| name == plant.mesh.name);
        let (_, text) = mesh.ok_or_else(|| format!("{} has not come", plant.mesh.name))?;
        let body = (plant.body)(text).map_err(|why| format!("{}: {why}", plant.mesh.name))?;
        let surface = Arc::new(body.surface);
        self.surfaces.push((plant.key, Arc::clone(&surface)));
        Ok(surface)
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
