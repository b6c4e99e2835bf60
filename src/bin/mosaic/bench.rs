//! `mosaic bench`: how fast the engine is on this machine, in one thread, and how fast the original program
//! was beside ours on another.

use super::output::say;
use super::states::{settled, still};
use super::{Refusal, cores};
use clonal_mosaic::plants::original::{MACHINE, RUNS, Run, sphere, times_as_fast};
use clonal_mosaic::surface::Mesh;
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};
// As wide as the force loop.
#[cfg(not(target_feature = "avx2"))]
use wide::f32x4 as Wide;
#[cfg(target_feature = "avx2")]
use wide::f32x8 as Wide;

const CELLS: [u32; 3] = [10_000, 100_000, 1_000_000];
const RADIUS_SCALES: [f32; 2] = [1.0, 4.0];

/// Cells that are moved in one timed stretch: enough for the clock to tell.
const CELLS_TIMED: u32 = 1_000_000;

/// Prints the best of so many runs of everything.
pub fn bench(runs: u32) -> Result<(), Refusal> {
    let mesh = Arc::new(sphere());
    say(&format!(
        "{}\nOne thread, wall-clock time, best of {runs}; a sphere of {} triangles.\n\n\
         {:10}{:>6}{:>10}{:>9}\n",
        machine(),
        mesh.triangles.len(),
        "",
        "row",
        "cells",
        "here"
    ))?;
    for run in &RUNS {
        let grown: Vec<(Duration, usize)> = (0..runs).map(|_| grow(&mesh, run)).collect();
        let (time, cells) = *grown.iter().min().expect("at least one run");
        let (key, row, seconds) = (run.key, run.figure, time.as_secs_f64());
        say(&format!("{key:10}{row:>6}{cells:>10}{seconds:>7.3} s\n"))?;
    }
    say(&beside_the_original())?;
    let giga_pairs = (0..runs).map(|_| bare_pairs_per_second() / 1e9).fold(0.0, f64::max);
    say(&format!(
        "\nCeiling of the force loop: {giga_pairs:.2} G pairs of cells a second, each a square root and a \
         division.\n"
    ))?;
    say("\nOne cell in one relaxation event:\n")?;
    for radius_scale in RADIUS_SCALES {
        for cells in CELLS {
            let mut growth = settled(&mesh, still(cells, radius_scale));
            let time = (0..runs).map(|_| event(&mut growth, cells)).min().expect("at least one");
            let ns = time.as_secs_f64() * 1e9 / f64::from(cells);
            say(&format!("radius_scale {radius_scale}, {cells:>9} cells {ns:>7.0} ns\n"))?;
        }
    }
    say(&format!("\nFive days of 100,000 first cells on one thread and on {}:\n", cores()))?;
    for radius_scale in RADIUS_SCALES {
        let recipe = Recipe { initial_cells: 100_000, radius_scale, days: 5, ..Recipe::default() };
        let [alone, together] = [1, cores()].map(|threads| {
            let time = (0..runs).map(|_| whole(&mesh, &recipe, threads).0).min();
            time.expect("at least one").as_secs_f64()
        });
        say(&format!(
            "radius_scale {radius_scale} {alone:>11.3} s {together:>7.3} s, {:.2} times as fast\n",
            alone / together
        ))?;
    }
    Ok(())
}

/// The table of both programs on one machine, which is not this one: their times have nothing to do with
/// those above.
fn beside_the_original() -> String {
    let mut text = format!(
        "\nBoth programs on one machine, {MACHINE}.\n\n{:10}{:>6}{:>14}{:>10}{:>15}\n",
        "", "row", "the original", "ours", "times as fast"
    );
    for run in &RUNS {
        let (key, row, ours, times) = (run.key, run.figure, run.our_seconds, run.times_as_fast());
        let original = run.mean_seconds();
        text += &format!("{key:10}{row:>6}{original:>12.1} s{ours:>8.3} s{times:>15.0}\n");
    }
    text + &format!("{:42}{:>13.0}\n", "in the geometric mean", times_as_fast())
}

/// Grows all days of a run of the original; how long it takes, and how many cells there are then.
fn grow(mesh: &Arc<Mesh>, run: &Run) -> (Duration, usize) {
    whole(mesh, &run.recipe, 1)
}

/// The same of any recipe, on so many threads.
fn whole(mesh: &Arc<Mesh>, recipe: &Recipe, threads: usize) -> (Duration, usize) {
    let started = Instant::now();
    let growth = Growth::new(mesh.clone(), recipe.clone(), &[], 1).expect("a sound recipe");
    let mut growth = growth.on_threads(threads);
    while growth.step() != Progress::Done {}
    (started.elapsed(), growth.diary.lineage.len())
}

/// The mean time of an event, of as many as it takes to move `CELLS_TIMED` cells.
fn event(growth: &mut Growth, cells: u32) -> Duration {
    let events = (CELLS_TIMED / cells).max(1);
    let started = Instant::now();
    for _ in 0..events {
        growth.step();
    }
    started.elapsed() / events
}

/// Pairs of points in a second of which only the forces are computed: what the force loop would reach if it
/// did nothing else.
fn bare_pairs_per_second() -> f64 {
    const POINTS: usize = 1024;
    const ROUNDS: usize = 20_000;
    let points: Vec<f32> = (0..POINTS).map(|k| k as f32).collect();
    let (mut sum_x, mut sum_y) = (Wide::ZERO, Wide::ZERO);
    let started = Instant::now();
    for round in 0..ROUNDS {
        let x = Wide::splat(black_box(round as f32 + 0.5));
        for &some in points.as_chunks().0 {
            let dx = x - Wide::new(some);
            let dy = dx + Wide::ONE;
            let scale = Wide::ONE / (dx * dx + dy * dy).sqrt() - Wide::ONE;
            sum_x += dx * scale;
            sum_y += dy * scale;
        }
    }
    black_box((sum_x, sum_y));
    (ROUNDS * POINTS) as f64 / started.elapsed().as_secs_f64()
}

/// The processor by its name, where the system tells it, and how many of its cores there are.
fn machine() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or("a processor without a name", |(_, name)| name);
    format!("{name}, {} cores, {} {}", cores(), std::env::consts::OS, std::env::consts::ARCH)
}
