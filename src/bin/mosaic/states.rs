//! Tissues to measure the engine on, for `mosaic bench` and for `cargo bench`.

use clonal_mosaic::surface::Mesh;
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use std::sync::Arc;

/// Cells that only move: nobody divides within the days that are looked at.
pub fn still(cells: u32, radius_scale: f32) -> Recipe {
    Recipe {
        initial_cells: cells,
        division_days: [500.0; 3],
        initial_relaxations: 5,
        relaxations_per_day: 1000,
        days: 1000,
        radius_scale,
        // The step grows with the square of the radius.
        repulsion: 0.09 / (radius_scale * radius_scale),
        ..Recipe::default()
    }
}

/// A growth whose first day is done.
pub fn settled(mesh: &Arc<Mesh>, recipe: Recipe) -> Growth {
    let mut growth = Growth::new(mesh.clone(), recipe, &[], 1).expect("a sound recipe");
    while growth.step() == Progress::Event {}
    growth
}
