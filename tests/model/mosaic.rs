//! What is drawn against a second method: the site lists against Voronoi polygons by spade.

use crate::meshes::{blade, cube, flat, icosphere, shaken, sheet};
use clonal_mosaic::mosaic::{Head, Site, SiteLists, polygons};
use clonal_mosaic::surface::{Charts, Mesh};
use clonal_mosaic::tissue::{Diary, Growth, Progress, Recipe};
use glam::Vec2;
use std::sync::Arc;

fn grown(mesh: &Mesh, cells: u32, days: u32) -> Diary {
    let recipe = Recipe { initial_cells: cells, days, ..Recipe::default() };
    let recipe = Recipe { division_days: [4.0; 3], ..recipe };
    let mut growth = Growth::new(Arc::new(mesh.clone()), recipe, &[], 5).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary
}

/// A packed coordinate pair in centimetres from the triangle's centroid.
fn unpack(word: u32, head: &Head) -> Vec2 {
    let step = |v: u32| (v as f32 - 32768.0) * head.scale_cm;
    Vec2::new(step(word & 0xffff), step(word >> 16))
}

/// The two nearest cells of a list to a point (around a curved vertex a cell stands there twice), at a moment between the days.
fn nearest_two(sites: &[Site], head: &Head, point: Vec2, moment: f32) -> [(f32, u32); 2] {
    let mut best = [(f32::INFINITY, u32::MAX); 2];
    for site in sites {
        let at = unpack(site.before, head).lerp(unpack(site.now, head), moment);
        let distance = at.distance(point);
        if site.cell == best[0].1 {
            best[0].0 = best[0].0.min(distance);
        } else if distance < best[0].0 {
            best = [(distance, site.cell), best[0]];
        } else if distance < best[1].0 {
            best[1] = (distance, site.cell);
        }
    }
    best
}

/// Compares the lists of a day with the polygons of that day's cells at the centre of every piece.
fn lists_agree_with_polygons(mesh: &Mesh, diary: &Diary, day: usize) {
    let mut charts = Charts::new(mesh);
    let mut lists = SiteLists::default();
    lists.build(mesh, &mut charts, diary, day);
    let places = &diary.days[day].places;
    let pieces = polygons(mesh, &mut charts, places);
    let area: f64 = pieces.iter().map(|piece| f64::from(piece.area())).sum();
    let whole = f64::from(mesh.area);
    assert!((area / whole - 1.0).abs() < 1e-3, "the pieces cover {area} of {whole} cm2");
    let spacing = (mesh.area / places.len() as f32).sqrt();
    let mut compared = 0;
    for piece in &pieces {
        let triangle = piece.triangle as usize;
        let frame = mesh.frames[triangle];
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let middle = piece.corners.iter().sum::<Vec2>() / piece.corners.len() as f32;
        let head = &lists.heads[triangle];
        let sites = &lists.sites[head.first as usize..(head.first + head.count) as usize];
        let [first, second] = nearest_two(sites, head, middle - centroid, 1.0);
        // Nearer to a border than the packed coordinates can tell, either answer is right.
        if second.0 - first.0 > 1e-3 * spacing {
            assert_eq!(first.1, piece.cell, "triangle {triangle} at {middle}");
            compared += 1;
        }
    }
    assert!(compared * 10 > pieces.len() * 9, "{compared} of {}", pieces.len());
}

#[test]
fn a_sphere_shows_its_voronoi_polygons() {
    // From many triangles to a cell to many cells to a triangle.
    for (levels, cells) in [(4, 400), (3, 2500), (2, 20_000)] {
        let mesh = icosphere(levels, 10.0);
        lists_agree_with_polygons(&mesh, &grown(&mesh, cells, 3), 3);
    }
}

#[test]
fn sheets_edges_and_blades_show_their_voronoi_polygons() {
    for mesh in [sheet(20, 10.0, flat), sheet(12, 10.0, shaken(10.0, 0.3)), cube(6, 10.0)] {
        lists_agree_with_polygons(&mesh, &grown(&mesh, 700, 2), 2);
    }
    let mesh = blade(10, 10.0);
    lists_agree_with_polygons(&mesh, &grown(&mesh, 900, 2), 2);
}

/// On a flat sheet the unfolded surface is the plane: at every moment between two days the nearest
/// of all cells must be in the list.
#[test]
fn lists_are_complete_at_every_moment_between_two_days() {
    let mesh = sheet(16, 10.0, flat);
    let diary = grown(&mesh, 900, 3);
    let mut charts = Charts::new(&mesh);
    let mut lists = SiteLists::default();
    lists.build(&mesh, &mut charts, &diary, 3);
    let ends: Vec<_> = (0..diary.days[3].places.len())
        .map(|cell| {
            let mut ancestor = cell;
            while ancestor >= diary.days[2].places.len() {
                ancestor = diary.lineage[ancestor].parent as usize;
            }
            (mesh.point(diary.days[2].places[ancestor]), mesh.point(diary.days[3].places[cell]))
        })
        .collect();
    for triangle in 0..mesh.triangles.len() {
        let frame = mesh.frames[triangle];
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let [a, b, c] = mesh.corners(triangle as u32);
        let head = &lists.heads[triangle];
        let sites = &lists.sites[head.first as usize..(head.first + head.count) as usize];
        for (b1, b2) in [(0.01, 0.01), (0.97, 0.02), (0.02, 0.97), (0.3, 0.4)] {
            let point = a + (b - a) * b1 + (c - a) * b2;
            for moment in [0.0, 0.3, 0.7, 1.0] {
                let listed = nearest_two(sites, head, frame.point(b1, b2) - centroid, moment)[0].0;
                let nearest = ends
                    .iter()
                    .map(|(before, now)| before.lerp(*now, moment).distance(point))
                    .fold(f32::INFINITY, f32::min);
                assert!((listed - nearest).abs() < 2e-3, "{triangle}: {listed} or {nearest}");
            }
        }
    }
}
