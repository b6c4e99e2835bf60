//! The plants that only figures show, `meshes/own-figure-*.txt`: leaves by rule, whose words stand in the links of their
//! pictures, and a leaf on which a tile of noise repeats. `cargo test rewrite_plants_of_figures -- --ignored` writes them anew.

use super::Made;
use crate::plants::paint::{Image, ImageRule, Paint, Pixels};
use crate::plants::{OWN, Plant, to_text};
use crate::play::figures;
use crate::surface::Wrap;
use crate::tissue::{CellType, Recipe, Use};
use noise::{NoiseFn, Perlin};
use std::path::PathBuf;

/// The body of the tile: that of the other picture of its figure.
const OVATE: &str = "own-figure-ovate";
const TILE: &str = "own-figure-tile";

/// Pixels along each side of the tile, and how often it stands across a leaf and along it.
const SIDE: u32 = 16;
const TIMES: [u32; 2] = [3, 5];
/// The tile is a torus of this radius, in waves of the noise: about three blotches along each side.
const RADIUS: f64 = 0.7;

/// Each plant of its own that a figure shows, by its key, and what its link says beside it.
fn shown() -> Vec<(&'static str, &'static str)> {
    let mut shown = Vec::new();
    for picture in figures::all().iter().flat_map(|figure| figure.pictures) {
        let key = picture.link.split('?').next().unwrap_or_default();
        let plant = (key, picture.beside());
        if key.starts_with(OWN) && !shown.contains(&plant) {
            shown.push(plant);
        }
    }
    shown
}

fn path(key: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("meshes/{key}.txt"))
}

/// What is to stand in the file of a plant.
fn text(key: &str, beside: &str) -> String {
    let of_words = |words: &str| Made::of_words(words.trim_start_matches('~')).unwrap();
    let (made, plant) = match key {
        TILE => {
            let ovate = shown().into_iter().find(|(key, _)| *key == OVATE).expect("a leaf");
            let made = of_words(ovate.1);
            let plant = tiled(made.plant());
            (made, plant)
        }
        _ => {
            let made = of_words(beside);
            let plant = made.plant();
            (made, plant)
        }
    };
    let (hash, text) = to_text(&plant, &made.mesh().unwrap().to_obj());
    text.replacen(&hash, key, 1)
}

/// A plant whose first cells are of type F where the tile is white, and hardly divide.
fn tiled(plant: Plant) -> Plant {
    let perlin = Perlin::new(7);
    let around = |pixel: u32| {
        let turn = f64::from(pixel % SIDE) / f64::from(SIDE) * std::f64::consts::TAU;
        [RADIUS * libm::cos(turn), RADIUS * libm::sin(turn)]
    };
    let digit = |x: u32, y: u32| {
        let ([a, b], [c, d]) = (around(x), around(y));
        if perlin.get([a, b, c, d]) > 0.0 { 'f' } else { '0' }
    };
    let [width, height] = TIMES.map(|times| SIDE * times);
    let row = |y| -> &'static str { (0..width).map(|x| digit(x, y)).collect::<String>().leak() };
    let rows = (0..height).map(row).collect::<Vec<_>>().leak();
    let image = Image { width, height, rule: ImageRule::Pixels(Pixels { rows }) };
    let (of, instead) = (CellType::Foreground, CellType::Background);
    let paint = Paint { wrap: Wrap::Leaf, image, use_as: Use::FirstCells { of, instead } };
    Plant {
        source: "Thesis, Fig. 4.7",
        paint: vec![paint].leak(),
        recipe: Recipe {
            initial_cells: 5000,
            initial_probability: [1.0, 0.0, 0.0],
            division_days: [200.0, 200.0, 200.0],
            ..plant.recipe
        },
        ..plant
    }
}

#[test]
fn files_of_figures_are_what_their_rules_make() {
    let all = shown();
    assert!(all.len() >= 6, "{all:?}");
    for (key, beside) in &all {
        let committed = std::fs::read_to_string(path(key)).unwrap();
        let told = "run `cargo test rewrite_plants_of_figures -- --ignored`";
        assert!(committed == text(key, beside), "{key}: {told}");
        assert!(committed.len() < 180_000, "{key} has {} bytes", committed.len());
    }
    // No file is there that nobody shows.
    let files = std::fs::read_dir(path(TILE).parent().unwrap()).unwrap();
    let names = files.map(|file| file.unwrap().file_name().to_string_lossy().into_owned());
    let of_figures = names.filter(|name| name.starts_with(OWN)).count();
    assert_eq!(
        of_figures,
        all.iter().map(|(key, _)| key).collect::<std::collections::BTreeSet<_>>().len()
    );
}

#[test]
fn the_tile_repeats_and_is_half_white() {
    let plant = tiled(Made::of_words("leaf").unwrap().plant());
    assert_eq!(plant.check(), Ok(()));
    let ImageRule::Pixels(Pixels { rows }) = plant.paint[0].image.rule else { panic!("pixels") };
    let side = SIDE as usize;
    for (y, row) in rows.iter().enumerate() {
        assert_eq!(row.len(), side * TIMES[0] as usize);
        assert_eq!(row[..side], row[side..2 * side]);
        assert_eq!(*row, rows[y % side]);
    }
    let white = rows[..side].iter().map(|row| row[..side].matches('f').count()).sum::<usize>();
    let share = white as f64 / (side * side) as f64;
    assert!((0.3..0.7).contains(&share), "{share}");
}

#[test]
#[ignore = "writes meshes/own-figure-*.txt"]
fn rewrite_plants_of_figures() {
    for (key, beside) in shown() {
        std::fs::write(path(key), text(key, beside)).unwrap();
    }
}
