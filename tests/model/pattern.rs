//! The numbers of a pattern where they are known exactly.

use crate::meshes::{flat, flat_torus, icosphere, place_at, shaken, sheet};
use crate::{grow, without_relaxation};
use clonal_mosaic::mosaic::{Pattern, SiteFinder, neighbours, polygons};
use clonal_mosaic::plants;
use clonal_mosaic::surface::{Charts, Mesh, Place};
use clonal_mosaic::tissue::CellType::{self, Background, Foreground, Middle};
use clonal_mosaic::tissue::{Day, Diary, Lineage, Recipe};
use glam::{Vec2, Vec3};
use spade::{DelaunayTriangulation, Point2, Triangulation};
use std::sync::Arc;

/// A single day with these cells.
fn diary(cells: Vec<(Place, CellType)>) -> Diary {
    let (places, lineage) = (0..)
        .zip(cells)
        .map(|(n, (place, kind))| (place, Lineage { parent: n, founder: n, born_day: 0, kind }))
        .unzip();
    Diary { lineage, days: vec![Day { places, repulsive_radius: 1.0 }] }
}

fn pattern(mesh: &Mesh, diary: &Diary) -> Pattern {
    Pattern::of(mesh, &mut Charts::new(mesh), diary, diary.days.len() - 1)
}

fn pairs(mesh: &Mesh, places: &[Place]) -> Vec<[u32; 2]> {
    neighbours(&polygons(mesh, &mut Charts::new(mesh), places))
}

/// Random places, and nobody moves.
fn sown(mesh: &Mesh, cells: u32, individual: u32) -> Diary {
    let recipe = Recipe {
        initial_cells: cells,
        initial_probability: [0.3, 0.5, 0.2],
        days: 0,
        ..without_relaxation()
    };
    grow(&Arc::new(mesh.clone()), &recipe, individual)
}

/// Rows of cells on a flat torus, every other one shifted by half a cell, so that each cell has six
/// neighbours; `kind` tells the type of a row and column.
fn rows(kind: impl Fn(u32, u32) -> CellType) -> Pattern {
    const N: u32 = 8;
    let mesh = flat_torus(5, N as f32);
    let cells = (0..N * N).map(|k| {
        let (row, column) = (k / N, k % N);
        let shift = if row % 2 == 0 { 0.1 } else { 0.6 };
        let point = Vec2::new(column as f32 + shift, row as f32 + 0.3);
        (place_at(&mesh, point), kind(row, column))
    });
    pattern(&mesh, &diary(cells.collect()))
}

fn like(found: &Pattern, shares: [f64; 3], patches: [u32; 3], mixed_edges: f64) {
    for (kind, share) in shares.into_iter().enumerate() {
        assert!((found.area_shares[kind] - share).abs() < 1e-5, "{found:?}");
        assert!((found.count_shares()[kind] - share).abs() < 1e-12, "{found:?}");
    }
    assert_eq!(found.patches, patches);
    assert!((found.mixed_edges - mixed_edges).abs() < 1e-12, "{found:?}");
}

#[test]
fn stripes_on_a_torus_have_the_numbers_counted_by_hand() {
    // 64 cells, 192 pairs, 16 of them between any two rows.
    like(&rows(|_, _| Middle), [0.0, 0.0, 1.0], [0, 0, 1], 0.0);
    let halves = rows(|row, _| if row < 4 { Foreground } else { Background });
    like(&halves, [0.5, 0.5, 0.0], [1, 1, 0], 32.0 / 192.0);
    let stripes = rows(|row, _| CellType::ALL[[0, 1, 0, 1, 1, 2, 2, 1][row as usize]]);
    like(&stripes, [0.25, 0.5, 0.25], [2, 3, 1], 96.0 / 192.0);
    // A cell alone has six neighbours of another type.
    let specks = rows(|row, column| match (row, column) {
        (1, 1) | (1, 5) | (5, 3) => Foreground,
        _ => Background,
    });
    like(&specks, [3.0 / 64.0, 61.0 / 64.0, 0.0], [3, 1, 0], 18.0 / 192.0);
}

#[test]
fn closed_surfaces_have_as_many_pairs_as_euler_says() {
    // Three polygons meet in every corner: with V cells, E pairs and F corners, V - E + F is 2 on a
    // sphere and 0 on a torus, and 3 F = 2 E.
    let torus = flat_torus(9, 6.0);
    for individual in 1..=3 {
        let places = &sown(&torus, 500, individual).days[0].places;
        assert_eq!(pairs(&torus, places).len(), 3 * 500);
    }
    // From many triangles to a cell to many cells to a triangle.
    for (levels, cells) in [(4, 800), (3, 2_500), (2, 5_000)] {
        let sphere = icosphere(levels, 10.0);
        let places = &sown(&sphere, cells, 1).days[0].places;
        assert_eq!(pairs(&sphere, places).len() as u32, 3 * cells - 6);
    }
}

#[test]
fn neighbours_on_an_open_sheet_share_a_border_within_it() {
    const SIDE: f32 = 6.0;
    for (mesh, cells) in [
        (sheet(7, SIDE, flat), 300),
        (sheet(12, SIDE, shaken(SIDE, 0.15)), 40),
        (sheet(3, SIDE, flat), 2),
        (sheet(3, SIDE, flat), 3),
    ] {
        let places = &sown(&mesh, cells, 4).days[0].places;
        assert_eq!(pairs(&mesh, places), mirrored_pairs(&mesh, SIDE, places), "{cells} cells");
    }
}

/// The same by a second way: among mirror images of all cells at the four sides, each polygon ends
/// at the sides by itself, and neighbours are those of the plane.
fn mirrored_pairs(mesh: &Mesh, side: f32, places: &[Place]) -> Vec<[u32; 2]> {
    let mut points = Vec::new();
    for p in places.iter().map(|&place| mesh.point(place)) {
        let (x, y, far) = (f64::from(p.x), f64::from(p.y), 2.0 * f64::from(side));
        points.push([(x, y), (-x, y), (far - x, y), (x, -y), (x, far - y)]);
    }
    let mut plane = DelaunayTriangulation::<Point2<f64>>::new();
    let mut own = Vec::new();
    for images in points {
        for (k, (x, y)) in images.into_iter().enumerate() {
            let vertex = plane.insert(Point2::new(x, y)).unwrap();
            if k == 0 {
                own.push(vertex);
            }
        }
    }
    let number = |vertex| own.iter().position(|&v| v == vertex).map(|cell| cell as u32);
    let mut pairs: Vec<[u32; 2]> = plane
        .undirected_edges()
        .filter_map(|edge| {
            let [a, b] = edge.vertices().map(|vertex| number(vertex.fix()));
            Some([a?.min(b?), a?.max(b?)])
        })
        .collect();
    pairs.sort_unstable();
    pairs
}

#[test]
fn parts_that_lie_upon_each_other_have_no_neighbours_in_common() {
    let one = sheet(4, 4.0, flat);
    let count = one.positions.len() as u32;
    let above = one.positions.iter().map(|p| *p + Vec3::Z * 0.01);
    let positions = one.positions.iter().copied().chain(above).collect();
    let upper = one.triangles.iter().map(|t| t.map(|v| v + count));
    let triangles = one.triangles.iter().copied().chain(upper).collect();
    let mesh = Mesh::new(positions, Vec::new(), triangles).unwrap();
    let below = one.triangles.len() as u32;

    let places = sown(&mesh, 200, 3).days[0].places.clone();
    let kind = |place: &Place| if place.triangle < below { Foreground } else { Background };
    let two = pattern(&mesh, &diary(places.iter().map(|p| (*p, kind(p))).collect()));
    assert_eq!((two.patches, two.mixed_edges), ([1, 1, 0], 0.0));
    assert!((two.area_shares[0] - 0.5).abs() < 1e-5 && (two.area_shares[1] - 0.5).abs() < 1e-5);
    let like = pattern(&mesh, &diary(places.iter().map(|p| (*p, Middle)).collect()));
    assert_eq!((like.patches, like.mixed_edges), ([0, 0, 2], 0.0));

    // A part without cells is in no polygon; a cell alone has no neighbour.
    let lone = pattern(&mesh, &diary(vec![(Place { triangle: 3, b1: 0.2, b2: 0.5 }, Foreground)]));
    assert_eq!((lone.patches, lone.mixed_edges), ([1, 0, 0], 0.0));
    assert!((lone.area_shares[0] - 0.5).abs() < 1e-5 && lone.area_shares[1] == 0.0);
}

#[test]
fn random_types_are_mixed_by_chance_alone() {
    // Two cells are unlike with chance 1 - sum of p squared, 0.62. Of some 60,000 pairs each is
    // counted together with the ten that share a cell with it, whose covariance is 0.0156: the
    // standard error is 0.0026.
    let mesh = icosphere(3, 10.0);
    let found = pattern(&mesh, &sown(&mesh, 20_000, 1));
    assert!((found.mixed_edges - 0.62).abs() < 4.5 * 0.0026, "{found:?}");
    let whole: f64 = found.area_shares.iter().sum();
    assert!((whole - 1.0).abs() < 1e-3, "{whole}");
}

/// What the page tells of each day is told from a few points of each triangle.
#[test]
fn the_areas_of_the_lists_are_those_of_the_polygons() {
    let leaf = plants::find("sansevieria").unwrap();
    let leaf_mesh = leaf.embedded_body().surface;
    let recipe = Recipe { days: 0, ..leaf.recipe.clone() };
    let mut leaf_growth = leaf.sow(Arc::new(leaf_mesh.clone()), recipe, 1).unwrap();
    while leaf_growth.diary.days.is_empty() {
        leaf_growth.step();
    }
    let sphere = icosphere(4, 10.0);
    let sphere_diary = sown(&sphere, 3000, 1);
    for (mesh, diary) in [(leaf_mesh, leaf_growth.diary), (sphere, sphere_diary)] {
        let exact = pattern(&mesh, &diary).area_shares;
        let told = SiteFinder::new(&mesh).find(&mesh, &diary, 0).areas(&mesh);
        for (told, exact) in told.into_iter().zip(exact) {
            let told = f64::from(told) / 10_000.0;
            assert!((told - exact).abs() < 0.005, "{told} of {exact}");
        }
        assert_eq!(told.into_iter().sum::<u32>().abs_diff(10_000) / 5, 0, "{told:?}");
    }
}
