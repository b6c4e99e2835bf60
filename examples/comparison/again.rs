//! An individual of the engine grown again with its own founders and divisions, which do not depend on where
//! cells are, but by a plain search for neighbours that may be cut off as the original's is.

use clonal_mosaic::plants::original::Run;
use clonal_mosaic::surface::{Charts, Image, Mesh, Place, walk};
use clonal_mosaic::tissue::{Day, Diary, Growth, Progress, Recipe};
use glam::Vec2;
use std::sync::Arc;

/// Where a cell looks for neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Search {
    /// In the whole repulsive radius, as the engine.
    Whole,
    /// There, but in no triangle that has no corner in common with the cell's own, as the original.
    CutOff,
}

impl Search {
    pub fn name(self) -> &'static str {
        match self {
            Search::Whole => "plain, whole radius",
            Search::CutOff => "plain, cut off",
        }
    }
}

/// Grows an individual again, with the founders, types and divisions of the engine's `diary`.
pub fn grow(
    mesh: &Arc<Mesh>,
    charts: &mut Charts,
    run: &Run,
    diary: &Diary,
    individual: u32,
    search: Search,
) -> Diary {
    let recipe = &run.recipe;
    let mut places = sown(mesh, recipe, individual);
    let widest_cm = recipe.repulsive_radius_cm(mesh.area, places.len());
    let around = neighbourhoods(mesh, charts, widest_cm, search);
    let mut days = Vec::new();
    for day in 0..=recipe.days {
        let radius_cm = recipe.repulsive_radius_cm(mesh.area, places.len());
        for (number, cell) in diary.lineage.iter().enumerate().skip(places.len()) {
            if cell.born_day > day {
                break;
            }
            places.push(beside(mesh, places[cell.parent as usize], radius_cm, number));
        }
        let kinds: Vec<usize> =
            diary.lineage[..places.len()].iter().map(|cell| cell.kind as usize).collect();
        let events = if day == 0 { recipe.initial_relaxations } else { recipe.relaxations_per_day };
        // Before day 0 every pair repels as two F cells do.
        let adhesion = if day == 0 { [[recipe.adhesion[0][0]; 3]; 3] } else { recipe.adhesion };
        let weights = adhesion.map(|row| row.map(|a| recipe.repulsion * (1.0 - a)));
        for _ in 0..events {
            places = relax(mesh, &around, &places, &kinds, radius_cm, &weights);
        }
        days.push(Day { places: places.clone(), repulsive_radius: radius_cm });
    }
    Diary { lineage: diary.lineage.clone(), days }
}

/// For each triangle those that are searched for neighbours, in its plane, the nearest first, itself before
/// all others. Of a triangle that is seen on both sides of a corner the nearer image.
fn neighbourhoods(
    mesh: &Mesh,
    charts: &mut Charts,
    radius_cm: f32,
    search: Search,
) -> Vec<Vec<Image>> {
    let around = |home: u32| {
        let corners = mesh.triangles[home as usize];
        let mut kept: Vec<Image> = Vec::new();
        for image in charts.around(mesh, home, radius_cm) {
            let touches =
                mesh.triangles[image.triangle as usize].iter().any(|c| corners.contains(c));
            let is_new = kept.iter().all(|other| other.triangle != image.triangle);
            if is_new && (touches || search == Search::Whole) {
                kept.push(*image);
            }
        }
        kept
    };
    (0..mesh.triangles.len() as u32).map(around).collect()
}

/// Where the engine sows the first cells.
fn sown(mesh: &Arc<Mesh>, recipe: &Recipe, individual: u32) -> Vec<Place> {
    let recipe = Recipe { initial_relaxations: 0, ..recipe.clone() };
    let mut growth = Growth::new(mesh.clone(), recipe, &[], individual).expect("a sound recipe");
    while growth.step() != Progress::Day(0) {}
    growth.diary.days.remove(0).places
}

/// A place for a child, within a hundredth of the radius: in all directions, one after the other.
fn beside(mesh: &Mesh, parent: Place, radius_cm: f32, number: usize) -> Place {
    const GOLDEN_ANGLE_RAD: f32 = 2.399_963;
    let length = 0.005 * radius_cm * ((number % 100 + 1) as f32 / 100.0).sqrt();
    walk(mesh, parent, Vec2::from_angle(GOLDEN_ANGLE_RAD * number as f32) * length).place
}

/// One event (Thesis 3.2.1.1): where all cells go, from where they all are. A step is at most half a radius
/// long.
fn relax(
    mesh: &Mesh,
    around: &[Vec<Image>],
    places: &[Place],
    kinds: &[usize],
    radius_cm: f32,
    weights: &[[f32; 3]; 3],
) -> Vec<Place> {
    let mut cells_of = vec![Vec::new(); mesh.triangles.len()];
    for (cell, place) in places.iter().enumerate() {
        cells_of[place.triangle as usize].push(cell);
    }
    let mut moved = places.to_vec();
    for (own, around) in cells_of.iter().zip(around).filter(|(own, _)| !own.is_empty()) {
        let within = around.iter().take_while(|image| image.distance <= radius_cm);
        let near: Vec<(usize, Vec2)> = within
            .flat_map(|image| {
                cells_of[image.triangle as usize].iter().map(|&cell| {
                    let Place { b1, b2, .. } = places[cell];
                    (cell, image.laid.point(b1, b2))
                })
            })
            .collect();
        // The first of those near are those at home.
        for (&cell, &(_, at)) in own.iter().zip(&near) {
            let mut push = Vec2::ZERO;
            for &(other, place) in &near {
                let (from, distance) = (at - place, at.distance(place));
                if distance > 0.0 && distance < radius_cm {
                    let weight = weights[kinds[cell]][kinds[other]];
                    push += weight * (radius_cm / distance - 1.0) * from;
                }
            }
            let step = push.clamp_length_max(0.5 * radius_cm);
            moved[cell] = walk(mesh, places[cell], step).place;
        }
    }
    moved
}
