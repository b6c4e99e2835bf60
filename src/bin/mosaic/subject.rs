//! What is grown: a body, a recipe and an individual, from the plant, link or files that were named.

use super::Refusal;
use super::options::{FIRST_PLANT, GrowOptions, Source};
use super::output::cannot;
use clonal_mosaic::import::{made_of_words, painted_of_link};
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::play::{FIRST_INDIVIDUAL, Scene, link, origin};
use clonal_mosaic::surface::{Body, Brought, Mesh, quoted};
use clonal_mosaic::tissue::{Growth, Noise, Recipe};
use glam::DVec3;
use std::fs;
use std::path::Path;
use std::sync::Arc;

pub struct Subject {
    /// The plant, or nothing for a recipe on a mesh of the caller's own.
    pub plant: Option<&'static Plant>,
    pub mesh: Arc<Mesh>,
    /// How the caller's own mesh was read.
    pub reading: Option<Reading>,
    /// The control images and the direction field of a preset belong to its own body alone; those of a
    /// document lie on any.
    is_painted: bool,
    /// Its `days` are the days to grow.
    pub recipe: Recipe,
    pub individual: u32,
    /// What the cells show instead of their own types.
    pub noise: Option<Noise>,
}

/// What was done to a mesh of the caller's own.
#[derive(Clone, Copy)]
pub struct Reading {
    pub joined_edges: usize,
    pub left_out_triangles: usize,
    /// Where in the file's coordinates the mesh has its origin, in cm.
    pub origin: DVec3,
    /// What a unit of the file is.
    pub unit_cm: f64,
}

impl Subject {
    pub fn sow(&self) -> Result<Growth, Refusal> {
        let (mesh, recipe) = (self.mesh.clone(), self.recipe.clone());
        let growth = match self.plant {
            Some(plant) if self.is_painted => plant.sow(mesh, recipe, self.individual),
            _ => Growth::new(mesh, recipe, &[], self.individual),
        };
        growth.map_err(|e| e.to_string())
    }
}

/// What a source alone says.
struct Wish {
    plant: Option<&'static Plant>,
    recipe: Recipe,
    individual: u32,
    day: u32,
    noise: bool,
}

/// Gathers what the options name.
pub fn load(options: &GrowOptions) -> Result<Subject, Refusal> {
    let Wish { plant, mut recipe, individual, day, noise } = match options.source() {
        Source::Preset(name) => of_plant(plant(name)?),
        Source::Link(text) => of_link(text)?,
        Source::Recipe(path) => of_recipe(path, options.mesh.is_none())?,
        Source::Plant(path) => of_plant(of_document(path)?),
    };
    let is_document = matches!(options.source(), Source::Plant(_));
    let day = options.day.unwrap_or(day);
    if day > recipe.days {
        return Err(too_late(day, recipe.days));
    }
    recipe.days = day;
    let (mesh, reading) = match (&options.mesh, plant) {
        (None, Some(plant)) => (plant.embedded_body().surface, None),
        (Some(path), _) => {
            let (body, reading) = read_mesh(path)?;
            let grown = match plant.filter(|_| is_document) {
                Some(plant) => plant.growing(body),
                None => body,
            };
            (grown.surface, Some(reading))
        }
        (None, None) => unreachable!("a recipe without a mesh has the first plant's body"),
    };
    let individual = options.individual.unwrap_or(individual);
    let mesh = Arc::new(mesh);
    if let (Some(plant), Source::Plant(path)) = (plant, options.source()) {
        plant.check_on(&mesh).map_err(|e| of_file(path, &e))?;
    }
    Ok(Subject {
        plant,
        noise: noise.then(|| Noise::new(&mesh, individual)),
        mesh,
        reading,
        is_painted: is_document || options.mesh.is_none(),
        recipe,
        individual,
    })
}

fn of_plant(plant: &'static Plant) -> Wish {
    let recipe = plant.recipe.clone();
    let day = recipe.days;
    Wish { plant: Some(plant), recipe, individual: FIRST_INDIVIDUAL, day, noise: false }
}

/// The scene that a link or a preset's name says, on this day if one is named.
pub fn scene(source: Source, day: Option<u32>) -> Result<Scene, Refusal> {
    let mut scene = match source {
        Source::Link(text) => scene_of_link(text)?,
        Source::Preset(name) => {
            let plant = plant(name)?;
            Scene { day: plant.recipe.days, ..Scene::preset(plant, FIRST_INDIVIDUAL) }
        }
        Source::Plant(path) => {
            let plant = of_document(path)?;
            plant
                .check_on(&Arc::new(plant.embedded_body().surface))
                .map_err(|e| of_file(path, &e))?;
            Scene { day: plant.recipe.days, ..Scene::preset(plant, FIRST_INDIVIDUAL) }
        }
        Source::Recipe(_) => unreachable!("a scene is a plant's"),
    };
    scene.day = day.unwrap_or(scene.day);
    if scene.day > scene.recipe.days {
        return Err(too_late(scene.day, scene.recipe.days));
    }
    Ok(scene)
}

fn too_late(day: u32, days: u32) -> Refusal {
    format!("--day is {day}, but this recipe ends at day {days}")
}

/// A whole address is taken for the part after its `#`, which a messenger may have written as `%23`;
/// without one it is the page's own, which shows the first plant. The page loads what it can of a bad
/// link; a script is better served by a refusal.
fn scene_of_link(text: &str) -> Result<Scene, Refusal> {
    let fragment = match text.split_once('#').or_else(|| text.split_once("%23")) {
        Some((_, fragment)) => fragment,
        None if text.contains("://") => "",
        None => text,
    };
    bring_made(fragment)?;
    let opened = link::read(fragment, plants::all());
    if !opened.left_out.is_empty() {
        return Err(format!("the link: {}", opened.left_out.join(" ")));
    }
    Ok(opened.scene)
}

/// Makes the plant of a link that says what it is made of.
fn bring_made(fragment: &str) -> Result<(), Refusal> {
    let link = origin::learn(fragment);
    let words = origin::of_link(link);
    let Some(words) = words.strip_prefix('~') else { return Ok(()) };
    // Of strokes the plant below them.
    let below = painted_of_link(fragment).and_then(Result::ok);
    let own = made_of_words(words, below.map_or("", |painted| painted.base.body.mesh.text));
    let own = own.map_err(|why| format!("the link: {why}"))?;
    plants::bring(&own.text);
    let named = link.split('?').next().unwrap_or_default();
    match named == own.key {
        true => Ok(()),
        false => Err(format!("the link: its words make {}, and not {}", own.key, quoted(named))),
    }
}

fn of_link(text: &str) -> Result<Wish, Refusal> {
    let scene = scene_of_link(text)?;
    Ok(Wish {
        plant: Some(scene.plant),
        recipe: scene.recipe,
        individual: scene.individual,
        day: scene.day,
        noise: scene.noise,
    })
}

fn of_recipe(path: &Path, on_first_plant: bool) -> Result<Wish, Refusal> {
    let recipe = Recipe::from_json(&read(path)?).map_err(|e| of_file(path, &e))?;
    let plant = if on_first_plant { Some(plant(FIRST_PLANT)?) } else { None };
    let day = recipe.days;
    Ok(Wish { plant, recipe, individual: FIRST_INDIVIDUAL, day, noise: false })
}

/// A plant that was read lives as long as the program, as those of the catalogue do.
fn of_document(path: &Path) -> Result<&'static Plant, Refusal> {
    let plant = Plant::from_json(&read(path)?).map_err(|e| of_file(path, &e))?;
    Ok(Box::leak(Box::new(plant)))
}

pub fn plant(name: &str) -> Result<&'static Plant, Refusal> {
    plants::find(name).ok_or_else(|| {
        let known: Vec<&str> = plants::all().iter().map(|plant| plant.key).collect();
        format!("there is no preset {}: there are {}", quoted(name), known.join(", "))
    })
}

fn read_mesh(path: &Path) -> Result<(Body, Reading), Refusal> {
    let bytes = fs::read(path).map_err(|e| cannot("read", path, &e))?;
    let Brought { body, origin, unit_cm, joined_edges, left_out_triangles, .. } =
        Brought::read(&bytes).map_err(|e| of_file(path, &e))?;
    Ok((body, Reading { joined_edges, left_out_triangles, origin, unit_cm }))
}

fn read(path: &Path) -> Result<String, Refusal> {
    fs::read_to_string(path).map_err(|e| cannot("read", path, &e))
}

fn of_file(path: &Path, error: &dyn std::error::Error) -> Refusal {
    format!("{}: {error}", path.display())
}
