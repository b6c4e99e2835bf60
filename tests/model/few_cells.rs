//! Few cells, wide reaches, fine and foreign meshes: what a growth costs follows its cells, its triangles
//! and the pairs that push each other, and a scene alone decides what comes out.

use crate::meshes::{icosphere, sheet};
use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::surface::Mesh;
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use glam::Vec3;
use std::sync::Arc;

/// Grows the plant of a link and hands each of its days to `each`.
fn grow(text: &str, mut each: impl FnMut(&Growth, &Mesh, u32)) -> Growth {
    let opened = link::read(text, plants::all());
    assert!(opened.left_out.is_empty(), "{text}: {:?}", opened.left_out);
    let scene = opened.scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh.clone(), scene.recipe, scene.individual).unwrap();
    loop {
        match growth.step() {
            Progress::Day(day) => each(&growth, &mesh, day),
            Progress::Event => {}
            Progress::Full | Progress::Done => return growth,
        }
    }
}

#[test]
fn no_walk_is_caught_however_wide_the_steps() {
    for text in [
        "croton?v=1&n=20&rs=6&days=1",
        "watermelon?v=1&n=20&rs=6&days=1&rep=1",
        "cactus?v=1&n=100&rs=6&days=1&rep=1",
    ] {
        assert_eq!(grow(text, |_, _, _| {}).caught_walks(), 0, "{text}");
    }
}

#[test]
fn lists_are_those_of_a_new_finder_whatever_was_found_before() {
    for plant in ["croton", "philodendron", "cactus"] {
        let mesh = plants::find(plant).unwrap().embedded_body().surface;
        let mut used = SiteFinder::new(&mesh);
        let before = format!("{plant}?v=1&s=2&days=2&rs=4&n=300");
        grow(&before, |growth, mesh, day| {
            used.find(mesh, &growth.diary, day as usize);
        });
        used.begin(Vec::new());
        let mut fresh = SiteFinder::new(&mesh);
        grow(&format!("{plant}?v=1&s=1&days=2"), |growth, mesh, day| {
            let [found, expected] = [&mut used, &mut fresh]
                .map(|finder| finder.find(mesh, &growth.diary, day as usize));
            assert!(found == expected, "{plant}, day {day}");
        });
    }
}

#[test]
fn a_clump_of_thousands_is_a_list_that_the_shader_can_read() {
    for text in ["cactus?v=1&ff=1&df=2&days=15", "cactus?v=1&rd=0&df=1.5&days=12"] {
        let mesh = plants::find("cactus").unwrap().embedded_body().surface;
        let mut finder = SiteFinder::new(&mesh);
        grow(text, |growth, mesh, day| {
            let lists = finder.find(mesh, &growth.diary, day as usize);
            let longest = lists.heads.iter().map(|head| head.count).max().unwrap();
            println!("{text}, day {day}: {longest}");
            assert!(longest <= 1023, "{text}, day {day}: a list of {longest}");
        });
    }
}

/// Two cells on a sphere that both see around it drift to opposite ends.
#[test]
fn two_cells_on_a_fine_sphere_part_as_far_as_they_can() {
    let mesh = Arc::new(icosphere(5, 5.0));
    let recipe = Recipe {
        initial_cells: 2,
        radius_scale: 2.0,
        initial_relaxations: 200,
        days: 0,
        ..Recipe::default()
    };
    for seed in 1..=5 {
        let mut growth = Growth::new(mesh.clone(), recipe.clone(), &[], seed).unwrap();
        while growth.step() != Progress::Done {}
        let [a, b]: [Vec3; 2] =
            std::array::from_fn(|k| mesh.point(growth.diary.days[0].places[k]).normalize());
        assert!(a.dot(b) < -0.9, "individual {seed}: {a} and {b}");
    }
}

/// How far the nearest neighbours of cells on a square of 10 cm by 10 cm are, in mean spacings: half of
/// one by chance, and more where the cells push each other apart.
fn evenness(noise_cm: f32) -> f32 {
    let noisy = |p: glam::Vec2| {
        let chance = (libm::sinf(p.x * 127.1 + p.y * 311.7) * 43_758.547).fract();
        p.extend(noise_cm * chance)
    };
    let mesh = Arc::new(sheet(120, 10.0, noisy));
    let recipe = Recipe { initial_cells: 200, radius_scale: 2.0, days: 3, ..Recipe::default() };
    let mut growth = Growth::new(mesh.clone(), recipe, &[], 3).unwrap();
    while growth.step() != Progress::Done {}
    let places = &growth.diary.days[3].places;
    let points: Vec<Vec3> = places.iter().map(|&place| mesh.point(place)).collect();
    let nearest = |k: usize| {
        let others = points.iter().enumerate().filter(|&(other, _)| other != k);
        others.map(|(_, p)| p.distance(points[k])).fold(f32::INFINITY, f32::min)
    };
    let mean = (0..points.len()).map(nearest).sum::<f32>() / points.len() as f32;
    mean / (100.0 / points.len() as f32).sqrt()
}

/// Edges of a twelfth of a centimetre lead up and down by as much as noise of half a millimetre does: no
/// patch as wide as the reach lies flat there.
#[test]
fn a_noisy_sheet_is_covered_nearly_as_evenly_as_a_smooth_one() {
    let smooth = evenness(0.0);
    for noise_cm in [0.02, 0.05] {
        let noisy = evenness(noise_cm);
        assert!(noisy > 0.9 * smooth, "noise of {noise_cm} cm: {noisy}, smooth: {smooth}");
    }
}
