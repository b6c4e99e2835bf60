//! The runs of the authors' own program that ours is compared with: rows of Table 4.1 of the thesis
//! on a plain sphere, without control images or a direction field.

use super::{Plant, cactus, croton, mushroom};
use crate::surface::{Mesh, icosphere};
use crate::tissue::Recipe;

/// A recipe that the original program (C++, `g++ -O3`, one thread) has grown, and what was measured
/// of its last day: one number for each of its runs.
#[derive(Clone, Debug)]
pub struct Run {
    /// `croton41`
    pub key: &'static str,
    /// The row of the table: `4.1`.
    pub figure: &'static str,
    /// The plant whose colours it has.
    pub plant: &'static Plant,
    pub recipe: Recipe,
    pub cells: &'static [f64],
    /// Share of the surface in F polygons.
    pub foreground_area: &'static [f64],
    /// Share of the pairs of neighbours that are of unlike type.
    pub mixed_edges: &'static [f64],
    /// Connected sets of F cells.
    pub patches: &'static [f64],
    /// Processor time of a run, in seconds.
    pub seconds: f64,
    /// Whether the numbers can be compared. The original looks for neighbours no further than the
    /// triangles around a cell's own: with a `radius_scale` over 1 it misses some, and the pictures
    /// are alike to the eye only.
    pub has_whole_radius: bool,
}

/// The body of all runs: a sphere of radius 10 in 5,120 triangles.
pub fn sphere() -> Mesh {
    icosphere(4, 10.0)
}

/// The runs. Recipes have ten events before day 0, ten a day, and the repulsion of `Recipe::DEFAULT`.
pub const RUNS: [Run; 4] = [
    Run {
        key: "croton41",
        figure: "4.1",
        plant: &croton::PLANT,
        recipe: Recipe::DEFAULT,
        cells: &[17_785.0, 17_851.0, 17_755.0],
        foreground_area: &[0.560, 0.563, 0.543],
        mixed_edges: &[0.233, 0.232, 0.230],
        patches: &[18.0, 13.0, 24.0],
        seconds: 6.5,
        has_whole_radius: true,
    },
    Run {
        key: "aging43",
        figure: "4.3",
        plant: &croton::PLANT,
        recipe: Recipe {
            initial_cells: 10_000,
            initial_probability: [0.1, 0.9, 0.0],
            division_days: [5.0, 10.0, 10.0],
            days: 30,
            ..Recipe::DEFAULT
        },
        cells: &[120_241.0],
        foreground_area: &[0.364],
        mixed_edges: &[0.138],
        patches: &[364.0],
        seconds: 56.0,
        has_whole_radius: true,
    },
    Run {
        key: "cactus48",
        figure: "4.8",
        plant: &cactus::PLANT,
        recipe: Recipe {
            initial_cells: 5_000,
            initial_probability: [0.002, 0.998, 0.0],
            division_days: [3.0, 60.0, 60.0],
            adhesion: [[0.5, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
            radius_scale: 4.0,
            days: 25,
            ..Recipe::DEFAULT
        },
        cells: &[9_551.0, 10_015.0],
        foreground_area: &[0.47, 0.55],
        mixed_edges: &[0.041, 0.045],
        patches: &[7.0, 7.0],
        seconds: 18.5,
        has_whole_radius: false,
    },
    Run {
        key: "mush415",
        figure: "4.15",
        plant: &mushroom::PLANT,
        recipe: Recipe {
            initial_cells: 6_000,
            division_days: [6.0, 8.0, 8.0],
            adhesion: [[0.7, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
            radius_scale: 3.0,
            days: 20,
            ..Recipe::DEFAULT
        },
        cells: &[38_494.0],
        foreground_area: &[0.747],
        mixed_edges: &[0.151],
        patches: &[3.0],
        seconds: 15.8,
        has_whole_radius: false,
    },
];
