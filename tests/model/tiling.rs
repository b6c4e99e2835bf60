//! The mosaic as triangles: whole, closed, and in the colours of what the shader reads.

use crate::meshes::{cube, icosphere, shaken, sheet};
use clonal_mosaic::export::{Facet, Specimen, Tiling};
use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants;
use clonal_mosaic::surface::Mesh;
use clonal_mosaic::tissue::{CellType, Diary, Growth, Progress, Recipe};
use glam::{Vec2, Vec3};
use std::sync::Arc;

fn grown(mesh: &Mesh, cells: u32, days: u32) -> Diary {
    let recipe = Recipe { initial_cells: cells, days, ..Recipe::default() };
    let recipe = Recipe { division_days: [4.0; 3], ..recipe };
    let mut growth = Growth::new(Arc::new(mesh.clone()), recipe, &[], 5).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary
}

/// How many edges run one way more often than the other.
fn open_edges(tiling: &Tiling) -> usize {
    let edges = tiling
        .facets
        .iter()
        .flat_map(|facet| [0, 1, 2].map(|k| (facet.corners[k], facet.corners[(k + 1) % 3])));
    let mut both: Vec<((u32, u32), i32)> =
        edges.map(|(a, b)| ((a.min(b), a.max(b)), if a < b { 1 } else { -1 })).collect();
    both.sort_unstable();
    let sums =
        both.chunk_by(|a, b| a.0 == b.0).map(|of_one| of_one.iter().map(|e| e.1).sum::<i32>());
    sums.map(|sum| sum.unsigned_abs() as usize).sum()
}

fn area(tiling: &Tiling) -> f64 {
    tiling.facets.iter().map(|facet| tiling.area(facet)).sum()
}

#[test]
fn triangles_cover_the_surface_and_leave_no_crack() {
    for (mesh, cells) in [
        (icosphere(4, 10.0), 60),
        (icosphere(3, 10.0), 2500),
        (icosphere(2, 10.0), 20_000),
        (cube(6, 10.0), 700),
    ] {
        let diary = grown(&mesh, cells, 2);
        let tiling = Tiling::new(&mesh, &diary.days[2].places);
        let share = area(&tiling) / f64::from(mesh.area);
        assert!((share - 1.0).abs() < 1e-4, "{cells} cells cover {share} of the surface");
        let open = open_edges(&tiling);
        assert!(open * 10_000 <= tiling.facets.len(), "{open} with {cells} cells");
    }
    let mesh = sheet(12, 10.0, shaken(10.0, 0.3));
    let diary = grown(&mesh, 700, 2);
    let tiling = Tiling::new(&mesh, &diary.days[2].places);
    assert!((area(&tiling) / f64::from(mesh.area) - 1.0).abs() < 1e-4);
}

/// The colour that the shader gives to a point of a triangle, found from the list that it reads.
fn shaded(
    look: &plants::Look,
    lists: &clonal_mosaic::mosaic::SiteLists,
    triangle: usize,
    point: Vec2,
) -> (Vec3, f32) {
    let head = &lists.heads[triangle];
    let mut near: Vec<_> =
        lists.of(triangle).iter().map(|s| (s.now(head).distance(point), s.tag())).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (nearest, tag) = near[0];
    let other = near.iter().find(|(_, other)| *other != tag);
    let to_border = other.map_or(f32::INFINITY, |(far, _)| (far - nearest) / head.scale_cm);
    let kind = CellType::from_index(tag.kind as u8);
    (look.of_cell(kind, tag.tint, tag.lightness), to_border)
}

#[test]
fn exported_colours_are_those_of_the_nearest_sites_of_the_lists() {
    for (key, day) in [("croton", 4), ("amanita", 6), ("watermelon", 3), ("cactus", 5)] {
        let plant = plants::find(key).unwrap();
        let body = plant.embedded_body();
        let recipe = Recipe { days: day, ..plant.recipe.clone() };
        let mesh = Arc::new(body.surface);
        let mut growth = plant.sow(mesh.clone(), recipe, 1).unwrap();
        while growth.step() != Progress::Done {}
        let (diary, day) = (growth.diary, day as usize);
        let controls = plant.controls(1);
        let lists = SiteFinder::new(&mesh).coloured(plant.controls(1)).find(&mesh, &diary, day);
        let specimen = Specimen::new(
            (&mesh, &mesh, &body.ornaments),
            &plant.look,
            &controls,
            (&diary, day),
            String::new(),
        );
        let tiling = &specimen.tiling;
        let share = area(tiling) / f64::from(mesh.area);
        assert!((share - 1.0).abs() < 1e-4, "{key}: triangles cover {share} of the surface");

        let (mut compared, mut wrong) = (0, Vec::new());
        for facet in &tiling.facets {
            let point = centroid(&mesh, tiling, facet);
            let (wanted, to_border) = shaded(&plant.look, &lists, facet.triangle as usize, point);
            // Nearer to a border than the packed coordinates can tell, either answer is right.
            if to_border > 2.0 {
                compared += 1;
                if specimen.colour(facet) != wanted {
                    wrong.push(facet.triangle);
                }
            }
        }
        assert!(compared * 100 > tiling.facets.len() * 97, "{key}: {compared}");
        // Where the surface bends much, a triangle is seen on two ways or on more, and which of them a chart
        // keeps goes by its radius, which lists and polygons choose each for itself: in one triangle
        // of thousands there are other cells.
        wrong.dedup();
        assert!(wrong.len() <= 1, "{key}: in triangles {wrong:?}");
    }
}

/// The centre of a facet in the plane of its triangle, from that one's centroid.
fn centroid(mesh: &Mesh, tiling: &Tiling, facet: &Facet) -> Vec2 {
    let [a, b, c] = tiling.corners(facet);
    let from = (a + b + c) / 3.0 - mesh.centroid(facet.triangle);
    let [x, y] = mesh.axes(facet.triangle);
    Vec2::new(from.dot(x), from.dot(y))
}
