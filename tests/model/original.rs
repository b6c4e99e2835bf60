//! The patterns against those of the original program (C++, by the authors of the model), measured
//! on the same sphere: icosahedron of radius 10 in 5,120 triangles, no control image.

use crate::grow;
use crate::meshes::icosphere;
use clonal_mosaic::mosaic::{Piece, polygons};
use clonal_mosaic::surface::Charts;
use clonal_mosaic::tissue::{CellType, Recipe};
use glam::Vec2;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What a pattern looks like, in two numbers.
#[derive(Clone, Copy, Debug)]
struct Pattern {
    /// Share of the surface in F polygons.
    foreground_area: f64,
    /// Share of the neighbouring pairs that are of unlike type.
    mixed_edges: f64,
}

fn pattern(recipe: &Recipe, seed: u32) -> (usize, Pattern) {
    let mesh = Arc::new(icosphere(4, 10.0));
    let diary = grow(&mesh, recipe, seed);
    let places = &diary.days.last().unwrap().places;
    let mut charts = Charts::new(&mesh);
    let pieces = polygons(&mesh, &mut charts, places);
    let kind = |cell: u32| diary.lineage[cell as usize].kind;
    let area: f64 = pieces
        .iter()
        .filter(|piece| kind(piece.cell) == CellType::Foreground)
        .map(|piece| f64::from(piece.area()))
        .sum();
    let pairs = neighbours(&pieces);
    let mixed = pairs.iter().filter(|&&(a, b)| kind(a) != kind(b)).count();
    let pattern = Pattern {
        foreground_area: area / f64::from(mesh.area),
        mixed_edges: mixed as f64 / pairs.len() as f64,
    };
    (places.len(), pattern)
}

/// The pairs of cells whose polygons share a border: within a triangle both have an edge with the
/// same middle.
fn neighbours(pieces: &[Piece]) -> BTreeSet<(u32, u32)> {
    const SAME_CM: f32 = 1e-4;
    let mut by_triangle: BTreeMap<u32, Vec<(u32, Vec2)>> = BTreeMap::new();
    for piece in pieces {
        let next = piece.corners.iter().cycle().skip(1);
        let middles = piece.corners.iter().zip(next).map(|(a, b)| (piece.cell, (*a + *b) * 0.5));
        by_triangle.entry(piece.triangle).or_default().extend(middles);
    }
    let mut pairs = BTreeSet::new();
    for middles in by_triangle.values() {
        for (k, &(a, here)) in middles.iter().enumerate() {
            for &(b, there) in &middles[k + 1..] {
                if a != b && here.distance_squared(there) < SAME_CM * SAME_CM {
                    pairs.insert((a.min(b), a.max(b)));
                }
            }
        }
    }
    pairs
}

fn close(what: &str, found: f64, original: f64, tolerance: f64) {
    assert!((found - original).abs() <= tolerance, "{what}: {found}, the original's {original}");
}

#[test]
fn the_croton_of_figure_4_1_is_as_mixed_as_the_original() {
    let recipe = Recipe { days: 35, division_days: [10.0; 3], ..Recipe::default() };
    let runs: Vec<_> = (1..=3).map(|seed| pattern(&recipe, seed)).collect();
    let mean = |value: fn(&Pattern) -> f64| runs.iter().map(|(_, p)| value(p)).sum::<f64>() / 3.0;
    // Three runs of the original: 17,785, 17,851 and 17,755 cells; 0.560, 0.563, 0.543 of the area;
    // 0.233, 0.232, 0.230 of the edges. F, which repel each other more, take more than their half.
    for (cells, _) in &runs {
        close("cells", *cells as f64, 17_800.0, 400.0);
    }
    close("F by area", mean(|p| p.foreground_area), 0.555, 0.02);
    close("mixed edges", mean(|p| p.mixed_edges), 0.232, 0.006);
}

#[test]
fn the_aging_croton_of_figure_4_3_is_as_mixed_as_the_original() {
    let recipe = Recipe {
        initial_cells: 10_000,
        initial_probability: [0.1, 0.9, 0.0],
        division_days: [5.0, 10.0, 10.0],
        days: 30,
        ..Recipe::default()
    };
    let (cells, pattern) = pattern(&recipe, 1);
    close("cells", cells as f64, 120_241.0, 4_000.0);
    close("F by area", pattern.foreground_area, 0.364, 0.02);
    close("mixed edges", pattern.mixed_edges, 0.138, 0.005);
}
