//! Measures our runs beside those of the original program, and draws one individual of each.
//!
//! `cargo run --release --example comparison [FOLDER]` prints the tables of `docs/comparison.md` and
//! writes `FOLDER/croton41.png` and so on: one hemisphere, each cell's Voronoi polygon in the colour
//! of its type, borders darkened. The second table is of individuals that are grown again with the
//! original's search for neighbours.

mod again;

use again::Search;
use clonal_mosaic::mosaic::{Across, Pattern, Piece, polygons};
use clonal_mosaic::plants::original::{RUNS, Run, sphere};
use clonal_mosaic::surface::{Charts, Mesh};
use clonal_mosaic::tissue::{Diary, Growth, Progress};
use glam::{Vec2, Vec3};
use std::path::Path;
use std::sync::Arc;

const INDIVIDUALS: u32 = 5;
/// Those of the second table.
const GROWN_AGAIN: u32 = 10;

const SIDE_PX: usize = 300;
/// Samples along each side of a pixel.
const SAMPLES: usize = 4;
/// Half the width of a border, in samples, and the share of light that it keeps.
const BORDER_SAMPLES: f32 = 1.6;
const BORDER_LIGHT: f32 = 0.62;

fn main() {
    let folder = std::env::args_os().nth(1);
    let mesh = Arc::new(sphere());
    let mut charts = Charts::new(&mesh);
    println!("| run | | cells | F by area | mixed edges | F patches |\n|---|---|---|---|---|---|");
    for run in &RUNS {
        let diaries: Vec<Diary> = (1..=INDIVIDUALS).map(|n| grow(&mesh, run, n)).collect();
        let patterns: Vec<Pattern> = diaries
            .iter()
            .map(|diary| Pattern::of(&mesh, &mut charts, diary, diary.days.len() - 1))
            .collect();
        let mean = |value: fn(&Pattern) -> f64| {
            patterns.iter().map(value).sum::<f64>() / f64::from(INDIVIDUALS)
        };
        println!(
            "| {} (Fig. {}) | here | {:.0} | {:.3} | {:.3} | {:.0} |",
            run.key,
            run.figure,
            mean(|p| f64::from(p.count.cells)),
            mean(|p| p.area_shares[0]),
            mean(|p| p.mixed_edges),
            mean(|p| f64::from(p.patches[0])),
        );
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        println!(
            "| | the original, {} | {:.0} | {:.3} | {:.3} | {:.0} |",
            if run.cells.len() == 1 { "one run" } else { "mean of its runs" },
            mean(run.cells),
            mean(run.foreground_area),
            mean(run.mixed_edges),
            mean(run.patches),
        );
        if let Some(folder) = &folder {
            let path = Path::new(folder).join(run.key).with_extension("png");
            let picture = draw(&mesh, &mut charts, run, &diaries[0]);
            write(&path, &picture).expect("the folder can be written to");
        }
    }
    println!("\n| run | search | mixed edges | F patches |\n|---|---|---|---|");
    for run in RUNS.iter().filter(|run| !run.has_whole_radius) {
        grow_again(&mesh, &mut charts, run);
    }
}

/// What becomes of the same individuals where neighbours are searched for by the engine, plainly, and as
/// the original does.
fn grow_again(mesh: &Arc<Mesh>, charts: &mut Charts, run: &Run) {
    let last = run.recipe.days as usize;
    for search in [None, Some(Search::Whole), Some(Search::CutOff)] {
        let patterns: Vec<Pattern> = (1..=GROWN_AGAIN)
            .map(|individual| {
                let engine = grow(mesh, run, individual);
                let diary = match search {
                    None => engine,
                    Some(search) => again::grow(mesh, charts, run, &engine, individual, search),
                };
                Pattern::of(mesh, charts, &diary, last)
            })
            .collect();
        let told = |value: fn(&Pattern) -> f64, digits: usize| {
            let n = patterns.len() as f64;
            let mean = patterns.iter().map(value).sum::<f64>() / n;
            let squares = patterns.iter().map(|p| (value(p) - mean).powi(2)).sum::<f64>();
            format!("{mean:.digits$} ± {:.digits$}", (squares / (n - 1.0)).sqrt())
        };
        println!(
            "| {} | {} | {} | {} |",
            run.key,
            search.map_or("the engine", Search::name),
            told(|p| p.mixed_edges, 3),
            told(|p| f64::from(p.patches[0]), 1),
        );
    }
}

fn grow(mesh: &Arc<Mesh>, run: &Run, individual: u32) -> Diary {
    let mut growth = Growth::new(mesh.clone(), run.recipe.clone(), &[], individual)
        .expect("the original's recipes are sound");
    while growth.step() != Progress::Done {}
    growth.diary
}

/// The last day as RGB, row by row from above; white around the sphere.
fn draw(mesh: &Mesh, charts: &mut Charts, run: &Run, diary: &Diary) -> Vec<u8> {
    let day = diary.days.last().expect("a grown day");
    let side = SIDE_PX * SAMPLES;
    let mut samples = vec![Vec3::ONE; side * side];
    for piece in polygons(mesh, charts, &day.places) {
        let kind = diary.lineage[piece.cell as usize].kind;
        let colour = Vec3::from(run.plant.look.cells[kind as usize]);
        fill(&mut samples, side, mesh, &piece, colour);
    }
    let block = (SAMPLES * SAMPLES) as f32;
    let mut bytes = Vec::with_capacity(3 * SIDE_PX * SIDE_PX);
    for (y, x) in (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).map(move |x| (y, x))) {
        let rows = (0..SAMPLES).map(|k| (y * SAMPLES + k) * side + x * SAMPLES);
        let sum: Vec3 = rows.flat_map(|first| &samples[first..first + SAMPLES]).sum();
        bytes.extend((sum / block * 255.0).to_array().map(|value| value.round() as u8));
    }
    bytes
}

/// Fills a piece of a polygon, seen from far off along z.
fn fill(samples: &mut [Vec3], side: usize, mesh: &Mesh, piece: &Piece, colour: Vec3) {
    let [x, y] = mesh.axes(piece.triangle);
    let origin = mesh.corners(piece.triangle)[0];
    let normal = x.cross(y);
    if normal.z <= 0.0 {
        return;
    }
    // The sphere of radius 10 leaves a margin of one part in a hundred.
    let scale = 0.495 * side as f32 / 10.0;
    let seen = |corner: &Vec2| {
        let p = origin + x * corner.x + y * corner.y;
        0.5 * side as f32 + scale * Vec2::new(p.x, -p.y)
    };
    let corners: Vec<Vec2> = piece.corners.iter().map(seen).collect();
    let light = 0.45 + 0.55 * normal.dot(Vec3::new(-0.4, 0.5, 0.77)).max(0.0);
    let (low, high) =
        corners.iter().fold((Vec2::MAX, Vec2::MIN), |(low, high), &c| (low.min(c), high.max(c)));
    let range = |low: f32, high: f32| low.max(0.0) as usize..(high.max(0.0) as usize + 1).min(side);
    for (row, column) in
        range(low.y, high.y).flat_map(|r| range(low.x, high.x).map(move |c| (r, c)))
    {
        let point = Vec2::new(column as f32 + 0.5, row as f32 + 0.5);
        let Some(from_border) = depth(&corners, &piece.across, point) else { continue };
        let border = if from_border < BORDER_SAMPLES { BORDER_LIGHT } else { 1.0 };
        samples[row * side + column] = colour * light * border;
    }
}

/// How far within a polygon a point lies from the nearest side that another cell lies across; nothing
/// outside.
fn depth(corners: &[Vec2], across: &[Across], point: Vec2) -> Option<f32> {
    let mut nearest = f32::INFINITY;
    for (k, &from) in corners.iter().enumerate() {
        let along = corners[(k + 1) % corners.len()] - from;
        // With y downwards corners run clockwise.
        let inside = -along.perp_dot(point - from);
        if inside < 0.0 {
            return None;
        }
        if across[k].cell().is_some() {
            nearest = nearest.min(inside / along.length().max(f32::MIN_POSITIVE));
        }
    }
    Some(nearest)
}

fn write(path: &Path, rgb: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
    let file = std::io::BufWriter::new(std::fs::File::create(path)?);
    let mut encoder = png::Encoder::new(file, SIDE_PX as u32, SIDE_PX as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(rgb)?;
    Ok(())
}
