//! What is grown: a body, a recipe and an individual, from the plant, link or files that were named.

use super::options::{Options, Source};
use super::{Refusal, cannot};
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::surface::{Body, Control, Mesh, PolygonMesh};
use clonal_mosaic::tissue::Recipe;
use std::fs;
use std::path::Path;

/// The plant when none is named.
pub const FIRST_PLANT: &str = "croton";
/// The individual when none is named.
const FIRST_INDIVIDUAL: u32 = 1;

pub struct Subject {
    /// The plant's word in links, or nothing for a recipe on a mesh of the caller's own.
    pub plant: Option<&'static str>,
    pub mesh: Mesh,
    pub controls: Vec<Control>,
    /// Its `days` are the days to grow.
    pub recipe: Recipe,
    pub individual: u32,
}

/// Gathers what the options name.
pub fn load(options: &Options) -> Result<Subject, Refusal> {
    let (plant, mut recipe, individual, day) = match &options.source {
        Source::Preset(name) => {
            let plant = plant(name)?;
            (Some(plant), plant.recipe.clone(), FIRST_INDIVIDUAL, plant.recipe.days)
        }
        Source::Link(_) => return Err("links cannot be read yet".into()),
        Source::Recipe(path) => {
            let recipe = Recipe::from_json(&read(path)?).map_err(|e| of_file(path, &e))?;
            let body = if options.mesh.is_none() { Some(plant(FIRST_PLANT)?) } else { None };
            let days = recipe.days;
            (body, recipe, FIRST_INDIVIDUAL, days)
        }
    };
    let day = options.day.unwrap_or(day);
    if day > recipe.days {
        return Err(format!("--day is {day}, but this recipe ends at day {}", recipe.days));
    }
    recipe.days = day;
    let (mesh, controls) = match (&options.mesh, plant) {
        (None, Some(plant)) => ((plant.body)().surface, (plant.controls)()),
        // The cylinders of a plant stand around its own body, not around the caller's.
        (Some(path), _) => (read_mesh(path)?, Vec::new()),
        (None, None) => unreachable!("a recipe without a mesh has the first plant's body"),
    };
    Ok(Subject {
        plant: plant.map(|plant| plant.key),
        mesh,
        controls,
        recipe,
        individual: options.individual.unwrap_or(individual),
    })
}

fn plant(name: &str) -> Result<&'static Plant, Refusal> {
    plants::all().iter().find(|plant| plant.key == name).ok_or_else(|| {
        let known: Vec<&str> = plants::all().iter().map(|plant| plant.key).collect();
        format!("there is no preset {name:?}: there are {}", known.join(", "))
    })
}

fn read_mesh(path: &Path) -> Result<Mesh, Refusal> {
    let polygons = PolygonMesh::parse(&read(path)?).map_err(|e| of_file(path, &e))?;
    Ok(Body::new(&polygons).map_err(|e| of_file(path, &e))?.surface)
}

fn read(path: &Path) -> Result<String, Refusal> {
    fs::read_to_string(path).map_err(|e| cannot("read", path, &e))
}

fn of_file(path: &Path, error: &dyn std::error::Error) -> Refusal {
    format!("{}: {error}", path.display())
}
