//! What a growth may take: every plant at the ends of all sliders in pairs, few cells and many, wide and
//! narrow reaches, and fine rough meshes. Memory is counted, time is printed (`--nocapture`).

use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::play::parameters::{PARAMETERS, Parameter};
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::Mesh;
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use glam::Vec3;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The system's memory, counted.
struct Counted;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: all is left to the system.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        MOST.fetch_max(HELD.fetch_add(layout.size(), Relaxed) + layout.size(), Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static MEMORY: Counted = Counted;

const MB: usize = 1_000_000;

/// The process counts its memory as a whole, so tests that count take turns.
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Does something, and returns the most megabytes that it held at a time.
fn megabytes_of(name: &str, what: impl FnOnce()) -> usize {
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    let started = Instant::now();
    what();
    let megabytes = (MOST.load(Relaxed) - before) / MB;
    println!("{megabytes:4} MB {:6.2} s  {name}", started.elapsed().as_secs_f64());
    megabytes
}

/// Grows the first five days of a scene, with the lists of the first and the last, as the page needs them.
fn grow_five_days(scene: &Scene) {
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut finder = SiteFinder::new(&mesh);
    let mut growth = match scene.sow(mesh.clone()) {
        Ok((growth, _)) => growth,
        // What an image scales beyond all bounds is refused in words before it begins.
        Err(why) if why.to_string().starts_with("under a control image") => return,
        Err(why) => panic!("{why}"),
    };
    loop {
        match growth.step() {
            Progress::Day(day @ (0 | 5)) => drop(finder.find(&mesh, &growth.diary, day as usize)),
            Progress::Full | Progress::Done => return,
            Progress::Day(_) | Progress::Event => {}
        }
    }
}

fn set(scene: &mut Scene, key: &str, value: f64) {
    let parameter = Parameter::of_key(key).unwrap();
    parameter.set(scene, value).unwrap_or_else(|why| panic!("{key}={value}: {why}"));
}

/// The plant with the number that rules how long this takes set to five days.
fn preset(plant: &'static Plant) -> Scene {
    let mut scene = Scene::preset(plant, 1);
    set(&mut scene, "days", 5.0);
    scene
}

/// Eight choices of an end for each number, so that every two numbers meet at all four pairs of ends: words
/// of eight bits with four ones, the first of which is one (G. O. H. Katona, Two applications of Sperner
/// type theorems, Periodica Mathematica Hungarica 3, 1973).
fn pairs_of_ends(plant: &'static Plant) -> Vec<Scene> {
    let numbers: Vec<&Parameter> =
        PARAMETERS.iter().filter(|p| p.regrows && p.key != "days" && p.is_for(plant)).collect();
    let words: Vec<u8> = (128..=255u8).filter(|word| word.count_ones() == 4).collect();
    assert!(numbers.len() <= words.len());
    let scene = |row: usize| {
        let mut scene = preset(plant);
        for (number, word) in numbers.iter().zip(&words) {
            set(&mut scene, number.key, number.range[usize::from(word >> row & 1 == 1)]);
        }
        scene
    };
    (0..8).map(scene).collect()
}

fn few_and_many_cells(plant: &'static Plant) -> impl Iterator<Item = Scene> {
    let cells = [1.0, 2.0, 20.0, 200.0, 2_000.0, 20_000.0];
    let pairs = cells.into_iter().flat_map(|n| [0.1, 2.0, 6.0].map(|rs| (n, rs)));
    pairs.map(move |(n, rs)| {
        let mut scene = preset(plant);
        set(&mut scene, "n", n);
        set(&mut scene, "rs", rs);
        scene
    })
}

#[test]
fn every_plant_grows_within_400_megabytes_at_all_ends_of_its_sliders() {
    let _alone = alone();
    let mut over = Vec::new();
    for plant in plants::all() {
        for scene in pairs_of_ends(plant).into_iter().chain(few_and_many_cells(plant)) {
            let link = link::write(&scene);
            let megabytes = megabytes_of(&link, || grow_five_days(&scene));
            if megabytes > 400 {
                over.push(format!("{link}: {megabytes} MB"));
            }
        }
    }
    assert!(over.is_empty(), "{}", over.join("\n"));
}

/// A closed body of 125,000 triangles with noise in it, as scanners write them; `noise` as a share of
/// its radius.
fn scan(noise: f32) -> Mesh {
    const RINGS: u32 = 250;
    const SIDES: u32 = 250;
    let at = |ring: u32, side: u32| ring * SIDES + side % SIDES;
    let positions = (0..=RINGS)
        .flat_map(|ring| (0..SIDES).map(move |side| (ring, side)))
        .map(|(ring, side)| {
            let turn = std::f32::consts::TAU * side as f32 / SIDES as f32;
            let height = std::f32::consts::PI * (ring as f32 + 0.5) / (RINGS + 1) as f32;
            let chance = ((ring * SIDES + side) as f32 * 0.618_034).fract() - 0.5;
            let radius_cm = 10.0 * (1.0 + noise * chance);
            let (sin, cos) = height.sin_cos();
            Vec3::new(sin * turn.cos(), sin * turn.sin(), 1.5 * cos) * radius_cm
        })
        .collect();
    let triangles = (0..RINGS)
        .flat_map(|ring| (0..SIDES).map(move |side| (ring, side)))
        .flat_map(|(ring, side)| {
            let [a, b] = [at(ring, side), at(ring, side + 1)];
            let [c, d] = [at(ring + 1, side), at(ring + 1, side + 1)];
            [[a, c, b], [b, c, d]]
        })
        .collect();
    Mesh::new(positions, Vec::new(), triangles).unwrap()
}

#[test]
fn fine_rough_meshes_grow_within_a_gigabyte() {
    let _alone = alone();
    for noise in [0.0, 0.004, 0.03] {
        let mesh = Arc::new(scan(noise));
        assert_eq!(mesh.triangles.len(), 125_000);
        for (cells, radius_scale) in [(200, 6.0), (2_000, 1.0), (200, 1.0), (2_000, 6.0)] {
            let name = format!("{cells} cells, radius_scale {radius_scale}, noise {noise}");
            let recipe =
                Recipe { initial_cells: cells, radius_scale, days: 5, ..Recipe::default() };
            let megabytes = megabytes_of(&name, || {
                let mut growth = Growth::new(mesh.clone(), recipe, &[], 1).unwrap();
                while growth.step() != Progress::Done {}
            });
            assert!(megabytes < 1_000, "{name}: {megabytes} MB");
        }
    }
}
