//! The engine by number of cells: one relaxation event, one day's divisions, one day's site lists; a leaf
//! from its numbers, an opening flower by its corners, and fine veins by their sources.
//!
//! Cells grow on the body that the figures of the original program were measured on: an icosahedron of radius
//! 10 cm, subdivided to 5,120 triangles.

#[path = "../src/bin/mosaic/states.rs"]
mod states;

use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants::original::sphere;
use clonal_mosaic::shapes::flower::{Flower, FlowerNumbers};
use clonal_mosaic::shapes::leaf::{Leaf, LeafNumbers};
use clonal_mosaic::shapes::veins::{VeinNumbers, grow, scatter};
use clonal_mosaic::surface::{Mesh, Moment, Motion};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec2, Vec3};
use states::{settled, still};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

const CELLS: [u32; 3] = [10_000, 100_000, 1_000_000];

fn relax(c: &mut Criterion) {
    let mesh = Arc::new(sphere());
    let mut group = c.benchmark_group("relax, one event");
    for radius_scale in [1.0, 2.0] {
        for cells in CELLS {
            let mut growth = settled(&mesh, still(cells, radius_scale));
            group.throughput(Throughput::Elements(cells.into()));
            let name = BenchmarkId::new(format!("radius scale {radius_scale}"), cells);
            group.bench_function(name, |b| b.iter(|| black_box(growth.step())));
        }
    }
    group.finish();
}

fn divide(c: &mut Criterion) {
    let mesh = Arc::new(sphere());
    let mut group = c.benchmark_group("divide, one day without relaxation");
    for cells in CELLS {
        let recipe = Recipe {
            initial_cells: cells,
            division_days: [10.0; 3],
            initial_relaxations: 0,
            relaxations_per_day: 0,
            days: 11,
            max_cells: 10_000_000,
            ..Recipe::default()
        };
        // Nearly an eighth of the cells divide in the tenth day.
        let nine_days_old = || {
            let mut growth = settled(&mesh, recipe.clone());
            while growth.step() != Progress::Day(9) {}
            growth
        };
        group.throughput(Throughput::Elements(cells.into()));
        group.bench_function(BenchmarkId::from_parameter(cells), |b| {
            b.iter_batched(
                nine_days_old,
                |mut growth| {
                    growth.step();
                    growth
                },
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

/// Five days of a body that stands still, of one that grows evenly and of one that grows longer.
fn moving(c: &mut Criterion) {
    let still = sphere();
    let to = |scale: Vec3| {
        let moment = |day, scale: Vec3| Moment {
            day,
            positions: still.positions.iter().map(|&p| p * scale).collect(),
        };
        let motion = Motion::new(vec![moment(0.0, Vec3::ONE), moment(5.0, scale)]);
        Arc::new(Mesh { motion, ..still.clone() })
    };
    let mut group = c.benchmark_group("five days of 20,000 first cells on a body");
    for (name, mesh) in [
        ("that stands still", Arc::new(still.clone())),
        ("that grows", to(Vec3::splat(2.0))),
        ("that grows longer", to(Vec3::new(1.0, 1.6, 1.0))),
    ] {
        let recipe = Recipe { initial_cells: 20_000, days: 5, ..Recipe::default() };
        group.bench_function(name, |b| {
            b.iter(|| {
                let growth = Growth::new(mesh.clone(), recipe.clone(), &[], 1);
                let mut growth = growth.expect("a recipe in its ranges");
                while growth.step() != Progress::Done {}
                black_box(growth.diary.lineage.len())
            });
        });
    }
    group.finish();
}

fn site_lists(c: &mut Criterion) {
    let mesh = Arc::new(sphere());
    let mut group = c.benchmark_group("site lists, one day");
    for cells in CELLS {
        let recipe =
            Recipe { initial_relaxations: 20, relaxations_per_day: 5, ..still(cells, 1.0) };
        let mut growth = settled(&mesh, recipe);
        while growth.step() == Progress::Event {}
        let mut finder = SiteFinder::new(&mesh);
        group.throughput(Throughput::Elements(cells.into()));
        group.bench_function(BenchmarkId::from_parameter(cells), |b| {
            b.iter(|| black_box(finder.find(&mesh, &growth.diary, 1)));
        });
    }
    group.finish();
}

fn leaf(c: &mut Criterion) {
    let mut group = c.benchmark_group("leaf from its numbers, by triangles");
    for triangles in [2_000, 10_000] {
        let numbers = LeafNumbers { triangles, ..LeafNumbers::default() };
        group.throughput(Throughput::Elements(triangles.into()));
        group.bench_function(BenchmarkId::from_parameter(triangles), |b| {
            b.iter(|| black_box(Leaf::new(&numbers, 1).map(|leaf| leaf.mesh())));
        });
    }
    group.finish();
}

fn flower(c: &mut Criterion) {
    let mut group = c.benchmark_group("a moment of a flower, by corners");
    for [rows, columns] in [[10, 2], [90, 18]] {
        let mut numbers = FlowerNumbers::default();
        (numbers.petals.rows, numbers.petals.columns) = (rows, columns);
        let flower = Flower::new(&numbers, 1).unwrap();
        let corners = flower.at(0.5).len();
        group.throughput(Throughput::Elements(corners as u64));
        group.bench_function(BenchmarkId::from_parameter(corners), |b| {
            b.iter(|| black_box(flower.at(black_box(0.5))));
        });
    }
    group.finish();
}

fn veins(c: &mut Criterion) {
    let side = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from).to_vec();
    let numbers = VeinNumbers { spacing_cm: 0.0186, ..VeinNumbers::default() };
    let sources = scatter(&[side], numbers.spacing_cm, 1);
    let mut group = c.benchmark_group("fine veins of a square leaf from sources");
    group.throughput(Throughput::Elements(sources.len() as u64));
    group.bench_function(BenchmarkId::from_parameter(sources.len()), |b| {
        b.iter(|| black_box(grow(&[DVec2::new(0.5, 0.0)], &sources, &numbers)));
    });
    group.finish();
}

criterion_group! {
    name = engine;
    config = Criterion::default().sample_size(10).measurement_time(Duration::from_secs(3));
    targets = relax, divide, moving, site_lists, leaf, flower, veins
}
criterion_main!(engine);
