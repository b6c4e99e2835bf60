//! What is drawn against a second method: the site lists against Voronoi polygons by spade.

use crate::meshes::{blade, cube, flat, icosphere, shaken, sheet};
use clonal_mosaic::mosaic::{MOST_TINT, SiteFinder, SiteLists, Tag, polygons};
use clonal_mosaic::plants;
use clonal_mosaic::surface::{Charts, ControlImage, Cylinder, Mesh, Wrap};
use clonal_mosaic::tissue::CellType::{Background, Foreground};
use clonal_mosaic::tissue::{Control, Diary, Growth, Progress, Recipe, Use};
use glam::{Vec2, Vec3};
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
    for (levels, cells) in [(4, 60), (4, 250), (4, 600), (3, 2500), (2, 20_000)] {
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
    // Triangles look for many cells, few cells look out for triangles.
    complete_at_every_moment(&sheet(16, 10.0, flat), 900);
    complete_at_every_moment(&sheet(24, 10.0, flat), 60);
}

fn complete_at_every_moment(mesh: &Mesh, cells: u32) {
    let diary = grown(mesh, cells, 3);
    let mut finder = SiteFinder::new(mesh);
    let lists = finder.find(mesh, &diary, 3);
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
                let step = lists.heads[triangle].scale_cm;
                let close = |k: usize| (listed[k].0 - all[k]).abs() < step.max(2e-3);
                assert!(close(0), "{triangle}: {listed:?} or {}", all[0]);
                // And the second nearest, where its border is near enough to be drawn.
                assert!(close(1) || all[1] - all[0] > 0.1 * spacing, "{triangle}: {listed:?}");
            }
        }
    }
}

#[test]
fn leaves_without_cells_have_empty_lists() {
    let croton = plants::all().iter().find(|plant| plant.key == "croton").unwrap();
    let body = croton.body.grow(croton.body.mesh.text).unwrap();
    let mesh = &body.surface;
    let diary = grown(mesh, 3, 1);
    let lists = SiteFinder::new(mesh).find(mesh, &diary, 1);
    let homes = diary.days[1].places.iter().map(|p| mesh.parts[p.triangle as usize]);
    let homes: Vec<u32> = homes.collect();
    for (head, part) in lists.heads.iter().zip(&mesh.parts) {
        assert_eq!(head.count > 0, homes.contains(part));
    }
}

/// F cells under an image that goes from black on the left to white on the right, B cells under one
/// that is white at the top alone.
#[test]
fn cells_have_the_colours_of_the_images_where_they_are() {
    let mesh = sheet(16, 10.0, flat);
    let up = |axis: Vec3, image: ControlImage, of| Control {
        wrap: Wrap::Cylinder(Cylinder { base: Vec3::ZERO, axis, zero: Vec3::Z, height: 10.0 }),
        image,
        use_as: Use::Colour { of },
    };
    let ramp = ControlImage::shade(1, 50, &|_, height| 2.0 * height - 0.5);
    let top = ControlImage::paint(1, 10, |_, height| height > 0.7);
    let controls = vec![up(Vec3::X, ramp, Foreground), up(Vec3::Y, top, Background)];
    let recipe = Recipe { initial_cells: 6_000, days: 1, ..Recipe::default() };
    let recipe = Recipe { initial_probability: [0.5, 0.4, 0.1], ..recipe };
    let grow = |controls: &[Control]| {
        let mut growth = Growth::new(Arc::new(mesh.clone()), recipe.clone(), controls, 5).unwrap();
        while growth.step() != Progress::Done {}
        growth.diary
    };
    let diary = grow(&controls);
    assert_eq!(diary, grow(&[]), "colours are of no account for the cells' lives");

    let plain = SiteFinder::new(&mesh).find(&mesh, &diary, 1);
    let mut finder = SiteFinder::new(&mesh).coloured(controls);
    let lists = finder.find(&mesh, &diary, 1);
    let mut tint_of = vec![None; diary.days[1].places.len()];
    for triangle in 0..mesh.triangles.len() {
        let first = lists.heads[triangle].first as usize;
        for (k, (site, uncoloured)) in lists.of(triangle).iter().zip(plain.of(triangle)).enumerate()
        {
            let tag = site.tag();
            assert_eq!(uncoloured.tag(), Tag { tint: 0, ..tag });
            let known = tint_of[finder.cell_of[first + k] as usize].get_or_insert(tag.tint);
            assert_eq!(*known, tag.tint, "a cell has one colour");
        }
    }
    let (mut asked, mut given) = (0.0, 0.0);
    for (cell, &place) in diary.days[1].places.iter().enumerate() {
        let (point, tint) = (mesh.point(place), tint_of[cell].expect("every cell is listed"));
        match diary.lineage[cell].kind {
            Foreground => {
                let share = (point.x / 5.0 - 0.5).clamp(0.0, 1.0);
                let step = share * MOST_TINT as f32;
                assert!((tint as f32 - step).abs() < 1.1, "{tint} at {point}");
                (asked, given) = (asked + step, given + tint as f32);
            }
            Background if point.y > 7.6 => assert_eq!(tint, MOST_TINT, "at {point}"),
            Background if point.y > 6.4 => {}
            _ => assert_eq!(tint, 0, "at {point}"),
        }
    }
    assert!((asked / given - 1.0).abs() < 0.02, "{asked} steps asked, {given} given");
}
