//! What is to be drawn on the stage, and the body that it is drawn on.

use crate::draw::{DrawError, Geometry, Marks, Renderer};
use crate::mosaic::SiteLists;
use crate::plants::{BodyError, Look, Plant, Show};
use crate::play::Run;
use crate::play::camera::{Camera, Sphere};
use crate::play::clone::{ClanMap, Paint};
use crate::play::handed::{Part, Wanted};
use crate::play::outline::Outline;
use crate::play::page::Page;
use crate::surface::Body;

pub(in crate::browser) struct OnStage {
    /// As it was made.
    body: Body,
    /// As it stands on a day, if it moves.
    standing: Option<(u32, Body)>,
    geometry: Geometry,
    pub(in crate::browser) sphere: Sphere,
}

/// What is to be drawn.
pub(in crate::browser) struct Picture<'a> {
    pub(in crate::browser) plant: &'static Plant,
    pub(in crate::browser) individual: u32,
    pub(in crate::browser) look: &'a Look,
    pub(in crate::browser) show: Show,
    /// The text of the plant's mesh, once it has come.
    pub(in crate::browser) mesh: Option<&'a str>,
    /// None: those that are there stay.
    pub(in crate::browser) cells: Option<Cells<'a>>,
    pub(in crate::browser) camera: &'a Camera,
    pub(in crate::browser) moment: f32,
    pub(in crate::browser) size_px: (u32, u32),
    /// Whether it stays as it is when it rests.
    pub(in crate::browser) calm: bool,
}

/// The cells of a day of a growth.
pub(in crate::browser) struct Cells<'a> {
    pub(in crate::browser) generation: u32,
    pub(in crate::browser) day: u32,
    pub(in crate::browser) count: u32,
    pub(in crate::browser) lists: &'a SiteLists,
    /// The growth, and in which colours it is seen, where those are not the cells' own.
    pub(in crate::browser) painted: Option<(&'a Run, Paint)>,
}

impl<'a> Picture<'a> {
    /// What the page shows.
    pub(in crate::browser) fn of(page: &'a Page, size_px: (u32, u32)) -> Picture<'a> {
        let (shown, run, scene) = (page.shown(), page.run(), page.scene());
        let day = shown.day.as_ref().filter(|_| shown.generation == run.generation);
        let cells = day.and_then(|day| {
            let (count, lists) = (day.facts.count.cells, run.lists(day.day)?);
            let paint = Paint::of(run, day.day, scene.cell, scene.show == Show::Clans);
            let painted = Some((run, paint));
            Some(Cells { generation: run.generation, day: day.day, count, lists, painted })
        });
        Picture {
            plant: scene.plant,
            individual: scene.individual,
            look: &scene.look,
            show: scene.show,
            mesh: page.mesh(),
            cells,
            camera: page.camera(),
            moment: shown.day.as_ref().map_or(1.0, |day| day.moment),
            size_px,
            calm: page.less_motion(),
        }
    }

    /// What is wanted of it, on a stage where the body stands already as on a day.
    pub(in crate::browser) fn wanted(&self, on: Option<&OnStage>) -> Wanted<'_> {
        let cells = self.cells.as_ref().map(|cells| (cells.generation, cells.day));
        let painted = self.cells.as_ref().and_then(|cells| cells.painted);
        let paint = painted.map(|(_, paint)| paint).unwrap_or_default();
        let shape = on.and_then(|on| self.shape(on));
        let Picture { plant, look, show, .. } = *self;
        let individual = (plant.rules, self.individual);
        Wanted { plant: plant.key, shape, individual, look, show, cells, paint }
    }

    /// The day on which a body that moves stands as it is to be drawn. What leads the cells is seen on it as it
    /// was made.
    pub(in crate::browser) fn shape(&self, on: &OnStage) -> Option<u32> {
        if on.body.surface.motion.is_still() || !self.show.is_of_cells() {
            return None;
        }
        let stands = on.standing.as_ref().map(|(day, _)| *day);
        self.cells.as_ref().map(|cells| cells.day).or(stands)
    }

    /// Hands a part of it to the renderer. Errors if it is too large.
    pub(in crate::browser) fn hand(
        &self,
        part: Part,
        on: &OnStage,
        renderer: &mut Renderer,
        map: &mut ClanMap,
    ) -> Result<(), DrawError> {
        match (part, &self.cells) {
            (Part::Body, _) => renderer.set_body(&on.body, &on.geometry),
            (Part::Shape, _) => renderer.set_shape(&on.geometry),
            (Part::Look, _) => renderer.set_look(self.look, &on.geometry),
            (Part::Show, _) => {
                let surface = &on.body.surface;
                renderer.set_diagram(&self.show.diagram(self.plant, self.individual, surface))?;
            }
            (Part::Cells, Some(cells)) => {
                let surface = &on.body().surface;
                let spacing_cm = (surface.area / cells.count.max(1) as f32).sqrt();
                let marked = cells.painted.and_then(|(run, paint)| {
                    let marks = if paint.clans { Marks::Clans } else { Marks::Lit };
                    Some((paint.sites(run, cells.day, surface, map)?, marks))
                });
                let heads = &cells.lists.heads;
                match marked {
                    Some((sites, marks)) => {
                        renderer.set_sites(heads, &sites, Some(marks), spacing_cm)?;
                    }
                    None => renderer.set_sites(heads, &cells.lists.sites, None, spacing_cm)?,
                }
            }
            // None are wanted.
            (Part::Cells, None) => {}
        }
        Ok(())
    }
}

impl OnStage {
    pub(in crate::browser) fn of(plant: &Plant, mesh: &str) -> Result<OnStage, BodyError> {
        let body = plant.grow_body(mesh)?;
        let (geometry, sphere) = (Geometry::new(&body), Sphere::around(&body));
        Ok(OnStage { body, standing: None, geometry, sphere })
    }

    /// Brings a body that moves to where it stands on a day, or as it was made.
    pub(in crate::browser) fn stand(&mut self, day: Option<u32>) {
        if self.standing.as_ref().map(|(day, _)| *day) != day {
            self.standing = day.map(|day| (day, self.body.on(day).into_owned()));
            self.geometry =
                day.map_or_else(|| Geometry::new(&self.body), |day| Geometry::on(&self.body, day));
        }
    }

    /// As it stands.
    pub(in crate::browser) fn body(&self) -> &Body {
        self.standing.as_ref().map_or(&self.body, |(_, body)| body)
    }

    pub(in crate::browser) fn outline<'a>(&'a self, camera: &'a Camera) -> Outline<'a> {
        Outline { body: self.body(), sphere: &self.sphere, camera }
    }
}
