//! A plant that has grown, and the renderer that draws it.

use super::super::stage::picture::{Cells, OnStage, Picture};
use super::{post, tell};
use crate::draw::{DrawError, Frame, Renderer};
use crate::plants::{self, Show};
use crate::play::camera::{Camera, Orbit};
use crate::play::clone::{ClanMap, Paint};
use crate::play::handed::Handed;
use crate::play::protocol::{ToPage, ToWorker};
use crate::play::worker::Worker;
use crate::play::{End, Run, Scene, link};
use glam::{Mat4, UVec2};
use web_sys::OffscreenCanvas;

pub struct Easel {
    /// What was drawn last stands here until something else is waited for.
    pub canvas: OffscreenCanvas,
    scene: Scene,
    mesh: String,
    run: Run,
    on_stage: OnStage,
    renderer: Renderer,
    handed: Handed,
    clan_map: ClanMap,
}

/// What is to be drawn.
pub struct Shot {
    pub day: u32,
    /// Between the day before (0) and the day (1).
    pub moment: f32,
    pub orbit: Orbit,
    /// What is seen on the body.
    pub show: Show,
    /// Whether the stage behind it is dark.
    pub dark: bool,
    /// The size of the whole picture.
    pub size_px: UVec2,
    /// A part of it: from its clip space to that of the part, and how large that is.
    pub part: Option<(Mat4, UVec2)>,
}

impl Easel {
    /// Grows a scene up to a day, or as far as it grows, and tells each day.
    pub async fn new(scene: &Scene, mesh: &str, last_day: u32) -> Result<Easel, String> {
        let canvas = OffscreenCanvas::new(1, 1).map_err(|_| NO_GRAPHICS)?;
        let trouble = |why: String| post(&format!("The graphics card failed: {why}").into());
        let renderer = Renderer::new(canvas.clone(), trouble).await;
        let renderer = renderer.map_err(|why| format!("{NO_GRAPHICS} ({why})"))?;
        let on_stage = OnStage::of(scene.plant, mesh).map_err(|why| why.to_string())?;
        Ok(Easel {
            canvas,
            scene: scene.clone(),
            mesh: mesh.to_string(),
            run: grow(scene, mesh, last_day)?,
            on_stage,
            renderer,
            handed: Handed::default(),
            clan_map: ClanMap::default(),
        })
    }

    /// The last day that has grown.
    pub fn last_day(&self) -> u32 {
        self.run.newest().unwrap_or(0)
    }

    pub fn draw(&mut self, shot: &Shot) -> Result<(), String> {
        self.portray(shot).map_err(|why| match why {
            DrawError::TooLarge { .. } => {
                "This graphics card cannot hold so many cells.".to_string()
            }
            why => format!("The graphics card failed: {why}."),
        })
    }

    fn portray(&mut self, shot: &Shot) -> Result<(), DrawError> {
        let (run, day) = (&self.run, shot.day);
        let facts_and_lists = run.facts(day).zip(run.lists(day));
        let cells = facts_and_lists.map(|(facts, lists)| {
            let paint = Paint::of(run, day, self.scene.cell, shot.show == Show::Clans);
            let (generation, count) = (run.generation, facts.count.cells);
            Cells { generation, day, count, lists, painted: Some((run, paint)) }
        });
        let camera = Camera::new(shot.orbit);
        let picture = Picture {
            plant: self.scene.plant,
            individual: self.scene.individual,
            look: &self.scene.look,
            show: shot.show,
            mesh: Some(&self.mesh),
            cells,
            camera: &camera,
            moment: shot.moment,
            size_px: shot.size_px.into(),
            calm: false,
        };
        self.on_stage.stand(picture.shape(&self.on_stage));
        let (on_stage, wanted) = (&self.on_stage, picture.wanted(Some(&self.on_stage)));
        while let Some(part) = self.handed.lacks(&wanted) {
            picture.hand(part, on_stage, &mut self.renderer, &mut self.clan_map)?;
            self.handed.take(part, &wanted);
        }
        let (width, height) = picture.size_px;
        let whole = camera.view_projection(&on_stage.sphere, width, height);
        let (view_projection, size) = match shot.part {
            Some((onto_part, size)) => (onto_part * whole, size),
            None => (whole, shot.size_px),
        };
        let eye = camera.eye(&on_stage.sphere);
        let frame = Frame { view_projection, eye, moment: shot.moment, dark: shot.dark };
        self.renderer.resize(size.x, size.y);
        // As good as it gets, as what rests on the page.
        match self.renderer.still_pictures() {
            0 => self.renderer.draw(&frame, None),
            pictures => (0..pictures).try_for_each(|k| self.renderer.draw(&frame, Some(k))),
        }
    }
}

const NO_GRAPHICS: &str =
    "This browser lets no worker draw with WebGL2, so nothing can be made here.";

/// Grows a scene up to a day, as the page's own worker does.
fn grow(scene: &Scene, mesh: &str, last_day: u32) -> Result<Run, String> {
    let mut worker = Worker::new(plants::all());
    let (generation, link) = (1, link::write(scene));
    let mut run = Run::new(generation, scene.clone());
    let name = scene.plant.body.mesh.name.to_string();
    worker.hear(ToWorker::Mesh { name, text: mesh.to_string() });
    if let Some(ToPage::Failed { text, .. }) =
        worker.hear(ToWorker::Grow { generation, first: 0, link })
    {
        return Err(format!("This cannot be grown: {text}."));
    }
    while worker.is_busy() && run.newest().is_none_or(|day| day < last_day) {
        worker.work(
            || true,
            |answer| match answer {
                ToPage::Born { generation, born } => run.bear(generation, &born),
                ToPage::Day(news) => {
                    tell(news.day);
                    run.add(news);
                }
                ToPage::Full { .. } => run.end = Some(End::Full),
                _ => {}
            },
        );
    }
    Ok(run)
}
