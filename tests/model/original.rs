//! The patterns against those of the original program (C++, by the authors of the model), measured
//! on the same sphere.

use crate::grow;
use clonal_mosaic::mosaic::Pattern;
use clonal_mosaic::plants::original::{RUNS, Run, sphere};
use clonal_mosaic::surface::Charts;
use std::sync::Arc;

fn run(key: &str) -> &'static Run {
    RUNS.iter().find(|run| run.key == key).unwrap()
}

/// The last days of the first individuals.
fn patterns(run: &Run, individuals: u32) -> Vec<Pattern> {
    let mesh = Arc::new(sphere());
    let mut charts = Charts::new(&mesh);
    (1..=individuals)
        .map(|individual| {
            let diary = grow(&mesh, &run.recipe, individual);
            Pattern::of(&mesh, &mut charts, &diary, diary.days.len() - 1)
        })
        .collect()
}

fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let values: Vec<f64> = values.into_iter().collect();
    values.iter().sum::<f64>() / values.len() as f64
}

fn close(what: &str, found: f64, original: &[f64], tolerance: f64) {
    let original = mean(original.iter().copied());
    assert!((found - original).abs() <= tolerance, "{what}: {found}, the original's {original}");
}

#[test]
fn the_croton_of_figure_4_1_is_as_mixed_as_the_original() {
    // F, which repel each other more, take more than their half.
    let run = run("croton41");
    let patterns = patterns(run, 3);
    for pattern in &patterns {
        close("cells", f64::from(pattern.count.cells), run.cells, 400.0);
    }
    let area = mean(patterns.iter().map(|p| p.area_shares[0]));
    close("F by area", area, run.foreground_area, 0.02);
    let mixed = mean(patterns.iter().map(|p| p.mixed_edges));
    close("mixed edges", mixed, run.mixed_edges, 0.006);
    let patches = mean(patterns.iter().map(|p| f64::from(p.patches[0])));
    close("F patches", patches, run.patches, 8.0);
}

#[test]
fn the_aging_croton_of_figure_4_3_is_as_mixed_as_the_original() {
    let run = run("aging43");
    let pattern = &patterns(run, 1)[0];
    close("cells", f64::from(pattern.count.cells), run.cells, 4_000.0);
    close("F by area", pattern.area_shares[0], run.foreground_area, 0.02);
    close("mixed edges", pattern.mixed_edges, run.mixed_edges, 0.005);
    close("F patches", f64::from(pattern.patches[0]), run.patches, 60.0);
}
