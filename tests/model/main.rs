//! The model against what is known of it from outside: exact expectations, invariants, and a force
//! and a walk written down a second time in the plainest way.

mod clans;
mod controls;
mod expectation;
mod few_cells;
mod field;
mod forces;
mod growth;
mod individuals;
mod meshes;
mod mosaic;
mod moving;
mod original;
mod pattern;
mod population;
mod recipes;
mod scaling;
mod texts;
mod tiling;
mod veins;
mod walking;
mod walls;

use clonal_mosaic::surface::{DirectionField, Mesh};
use clonal_mosaic::tissue::{Diary, Growth, Progress, Recipe};
use std::sync::Arc;

/// All days of an individual.
fn grow(mesh: &Arc<Mesh>, recipe: &Recipe, seed: u32) -> Diary {
    let mut growth = Growth::new(mesh.clone(), recipe.clone(), &[], seed).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    assert_eq!(growth.caught_walks(), 0, "walks were caught among slivers");
    growth.diary
}

/// As `grow`, along a direction field.
fn grow_along(mesh: &Arc<Mesh>, recipe: &Recipe, field: &DirectionField, seed: u32) -> Diary {
    let growth = Growth::new(mesh.clone(), recipe.clone(), &[], seed).unwrap();
    let mut growth = growth.along(field.clone());
    while growth.step() != Progress::Done {}
    growth.diary
}

/// Cells that divide, and neither push nor move.
fn without_relaxation() -> Recipe {
    Recipe { initial_relaxations: 0, relaxations_per_day: 0, ..Recipe::default() }
}

/// The value that a chi-square of so many degrees of freedom passes once in 100,000 times
/// (Wilson and Hilferty 1931).
fn rare_chi_square(degrees: usize) -> f64 {
    const RARE_Z: f64 = 4.265;
    let k = 2.0 / (9.0 * degrees as f64);
    degrees as f64 * (1.0 - k + RARE_Z * k.sqrt()).powi(3)
}

/// Sum of the squared differences from what is expected, over what is expected.
fn chi_square(found: &[f64], expected: &[f64]) -> f64 {
    found.iter().zip(expected).map(|(f, e)| (f - e).powi(2) / e).sum()
}
