//! What is drawn against a second method: the site lists against Voronoi polygons by spade.

use crate::meshes::{blade, cube, flat, icosphere, shaken, sheet};
use clonal_mosaic::mosaic::{SiteFinder, SiteLists, polygons};
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

/// The two cells of a list that are nearest to a point, from the triangle's centroid, at a moment
/// between the days. Around a curved vertex a cell stands there twice.
fn nearest_two(
    (lists, cell_of): (&SiteLists, &[u32]),
    triangle: usize,
    point: Vec2,
    moment: f32,
) -> [(f32, u32); 2] {
    let head = &lists.heads[triangle];
    let mut best = [(f32::INFINITY, u32::MAX); 2];
    for (site, &cell) in lists.of(triangle).iter().zip(&cell_of[head.first as usize..]) {
        let at = site.before(head).lerp(site.now(head), moment);
        let distance = at.distance(point);
        if cell == best[0].1 {
            best[0].0 = best[0].0.min(distance);
        } else if distance < best[0].0 {
            best = [(distance, cell), best[0]];
        } else if distance < best[1].0 {
            best[1] = (distance, cell);
        }
    }
    best
}

/// Compares the lists of a day with the polygons of that day's cells at the centre of every piece.
fn lists_agree_with_polygons(mesh: &Mesh, diary: &Diary, day: usize) {
    let mut finder = SiteFinder::new(mesh);
    let lists = finder.find(mesh, diary, day);
    let places = &diary.days[day].places;
    let pieces = polygons(mesh, &mut Charts::new(mesh), places);
    let area: f64 = pieces.iter().map(|piece| f64::from(piece.area())).sum();
    let whole = f64::from(mesh.area);
    assert!((area / whole - 1.0).abs() < 1e-3, "the pieces cover {area} of {whole} cm2");
    let mut compared = 0;
    for piece in &pieces {
        let triangle = piece.triangle as usize;
        let frame = mesh.frames[triangle];
        let centroid = (frame.apex + Vec2::new(frame.length, 0.0)) / 3.0;
        let middle = piece.corners.iter().sum::<Vec2>() / piece.corners.len() as f32;
        let sites = (&lists, &finder.cell_of[..]);
        let [first, second] = nearest_two(sites, triangle, middle - centroid, 1.0);
        // Nearer to a border than the packed coordinates can tell, either answer is right.
        if second.0 - first.0 > 2.0 * lists.heads[triangle].scale_cm {
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
    let mut finder = SiteFinder::new(&mesh);
    let lists = finder.find(&mesh, &diary, 3);
    let spacing = (mesh.area / diary.days[3].places.len() as f32).sqrt();
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
        let sites = (&lists, &finder.cell_of[..]);
        for (b1, b2) in [(0.01, 0.01), (0.97, 0.02), (0.02, 0.97), (0.3, 0.4)] {
            let point = a + (b - a) * b1 + (c - a) * b2;
            for moment in [0.0, 0.3, 0.7, 1.0] {
                let listed = nearest_two(sites, triangle, frame.point(b1, b2) - centroid, moment);
                let mut all: Vec<f32> = ends
                    .iter()
                    .map(|(before, now)| before.lerp(*now, moment).distance(point))
                    .collect();
                all.sort_by(f32::total_cmp);
                let close = |k: usize| (listed[k].0 - all[k]).abs() < 2e-3;
                assert!(close(0), "{triangle}: {listed:?} or {}", all[0]);
                // And the second nearest, where its border is near enough to be drawn.
                assert!(close(1) || all[1] - all[0] > 0.1 * spacing, "{triangle}: {listed:?}");
            }
        }
    }
}
