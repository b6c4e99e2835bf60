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
    /// Processor time of each of its runs on one machine, in seconds, and on the same machine within the
    /// same hour the best of 15 growths of ours in one thread (see `MACHINE`).
    pub seconds: &'static [f64],
    pub our_seconds: f64,
    /// Whether the numbers can be compared. The original looks for neighbours no further than the
    /// triangles around a cell's own: with a `radius_scale` over 1 it misses some, and the pictures
    /// are alike to the eye only.
    pub has_whole_radius: bool,
}

/// Where and when both programs were timed. Times of two machines have no quotient that says anything.
pub const MACHINE: &str = "AMD EPYC (family 25, model 17), a virtual machine with 2 cores, on 2026-11-28; \
                           the original by g++ 12.2 -O3";

impl Run {
    /// Mean processor time of the original's runs, in seconds.
    pub fn mean_seconds(&self) -> f64 {
        self.seconds.iter().sum::<f64>() / self.seconds.len() as f64
    }

    /// How many times as fast as the original ours is, both on the same machine.
    pub fn times_as_fast(&self) -> f64 {
        self.mean_seconds() / self.our_seconds
    }
}

/// The geometric mean of `Run::times_as_fast` over all runs.
pub fn times_as_fast() -> f64 {
    let product: f64 = RUNS.iter().map(Run::times_as_fast).product();
    // The fourth root.
    product.sqrt().sqrt()
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
        plant: &croton::FIRST,
        recipe: Recipe::DEFAULT,
        cells: &[17_785.0, 17_851.0, 17_755.0],
        foreground_area: &[0.560, 0.563, 0.543],
        mixed_edges: &[0.233, 0.232, 0.230],
        patches: &[18.0, 13.0, 24.0],
        seconds: &[8.31, 9.77, 8.55],
        our_seconds: 0.103,
        has_whole_radius: true,
    },
    Run {
        key: "aging43",
        figure: "4.3",
        plant: &croton::FIRST,
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
        seconds: &[65.65, 63.98],
        our_seconds: 0.445,
        has_whole_radius: true,
    },
    Run {
        key: "cactus48",
        figure: "4.8",
        plant: &cactus::FIRST,
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
        seconds: &[16.07, 15.48],
        our_seconds: 0.210,
        has_whole_radius: false,
    },
    Run {
        key: "mush415",
        figure: "4.15",
        plant: &mushroom::FIRST,
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
        seconds: &[17.46, 15.72, 17.54],
        our_seconds: 0.346,
        has_whole_radius: false,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_are_those_that_are_told() {
        let times = RUNS.each_ref().map(|run| run.times_as_fast().round());
        assert_eq!(times, [86.0, 146.0, 75.0, 49.0]);
        assert_eq!(times_as_fast().round(), 82.0);
        for text in [include_str!("../../README.md"), include_str!("../../docs/speed.md")] {
            assert!(text.contains("82 times") && text.contains("49") && text.contains("146"));
        }
    }
}
