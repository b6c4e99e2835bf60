//! Walls: what begins on one side of one never stands on the other.

use crate::meshes::{flat, icosphere, shaken, sheet};
use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::surface::{
    AlongVeins, Body, ControlImage, Cylinder, Mesh, NO_TWIN, Place, PolygonMesh, Wrap, walk,
};
use clonal_mosaic::tissue::{Control, Diary, Growth, Progress, Recipe, Use};
use glam::{Vec2, Vec3};
use std::fmt::Write;
use std::sync::Arc;

/// All veins up to an order.
fn veins(order: u32) -> Control {
    let image = ControlImage { width: 1, height: 1, grey: vec![255] };
    Control { wrap: Wrap::Veins(AlongVeins { order, reach_cm: 1.0 }), image, use_as: Use::Wall }
}

/// A body with lines through points in space as veins of the first order.
fn with_veins(mesh: &Mesh, lines: &[Vec<Vec3>]) -> Mesh {
    let mut obj = String::new();
    let mut vertex = |p: &Vec3| writeln!(obj, "v {} {} {}", p.x, p.y, p.z).unwrap();
    mesh.positions.iter().for_each(&mut vertex);
    lines.iter().flatten().for_each(&mut vertex);
    for [a, b, c] in &mesh.triangles {
        writeln!(obj, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    obj += "usemtl vein:1\n";
    let mut first = mesh.positions.len() + 1;
    for line in lines {
        obj.push('l');
        (first..first + line.len()).for_each(|v| write!(obj, " {v}").unwrap());
        obj.push('\n');
        first += line.len();
    }
    Body::new(&PolygonMesh::parse(&obj).unwrap()).unwrap().surface
}

fn walled(mut mesh: Mesh, wall: &Control) -> Mesh {
    wall.wall_off(&mut mesh);
    mesh.check().unwrap();
    mesh
}

/// For each triangle the number of the piece of surface that it can be reached in over edges, and how many
/// pieces there are.
fn pieces(mesh: &Mesh) -> (Vec<u32>, u32) {
    let mut piece_of = vec![u32::MAX; mesh.triangles.len()];
    let mut pieces = 0;
    for first in 0..piece_of.len() {
        let mut waiting = vec![first];
        while let Some(t) = waiting.pop() {
            if piece_of[t] == u32::MAX {
                piece_of[t] = pieces;
                let twins = mesh.twins[3 * t..3 * t + 3].iter().filter(|twin| **twin != NO_TWIN);
                waiting.extend(twins.map(|twin| *twin as usize / 3));
            }
        }
        pieces += u32::from(piece_of[first] == pieces);
    }
    (piece_of, pieces)
}

/// Cells that divide and push hard.
fn restless(days: u32) -> Recipe {
    Recipe {
        initial_cells: 600,
        division_days: [3.0; 3],
        repulsion: 0.8,
        radius_scale: 2.0,
        days,
        ..Recipe::default()
    }
}

fn grow(mesh: &Mesh, recipe: Recipe) -> Diary {
    let mut growth = Growth::new(Arc::new(mesh.clone()), recipe, &[], 3).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary
}

/// How many clans have cells in more than one piece, on any day.
fn strays(diary: &Diary, piece_of: &[u32]) -> usize {
    let home = |founder: u32| diary.days[0].places[founder as usize].triangle;
    let mut stray = vec![false; diary.days[0].places.len()];
    for day in &diary.days {
        for (cell, place) in diary.lineage.iter().zip(&day.places) {
            let at_home =
                piece_of[home(cell.founder) as usize] == piece_of[place.triangle as usize];
            stray[cell.founder as usize] |= !at_home;
        }
    }
    stray.iter().filter(|stray| **stray).count()
}

#[test]
fn a_border_of_an_image_is_a_wall_that_no_clan_crosses() {
    let cylinder = Cylinder { base: Vec3::Y * -10.0, axis: Vec3::Y, zero: Vec3::X, height: 20.0 };
    // A band around the sphere, and white caps.
    let image = ControlImage { width: 1, height: 5, grey: vec![255, 255, 0, 0, 255] };
    let control = |use_as| Control { wrap: Wrap::Cylinder(cylinder), image: image.clone(), use_as };
    let plain = icosphere(4, 10.0);
    let mesh = walled(plain.clone(), &control(Use::Wall));
    let is_band = |t: usize| (-2.0..6.0).contains(&mesh.centroid(t as u32).y);
    for (h, (&twin, &before)) in mesh.twins.iter().zip(&plain.twins).enumerate() {
        let is_border = is_band(h / 3) != is_band(before as usize / 3);
        assert_eq!(twin, if is_border { NO_TWIN } else { before });
    }
    let (piece_of, count) = pieces(&mesh);
    assert_eq!(count, 3);
    assert_eq!(strays(&grow(&mesh, restless(12)), &piece_of), 0);
    // Without the wall many go.
    assert!(strays(&grow(&plain, restless(12)), &piece_of) > 50);
    // Other uses are no walls.
    let unchanged = walled(plain.clone(), &control(Use::FOREGROUND));
    assert_eq!(unchanged.twins, plain.twins);
}

#[test]
fn veins_that_close_are_walls_that_no_clan_crosses() {
    let sphere = icosphere(4, 10.0);
    // Three great circles part a ball into eight pieces; none of them lies on edges of the mesh.
    let axes = [Vec3::new(0.9, 0.3, 0.2), Vec3::new(-0.3, 0.9, 0.4), Vec3::new(0.1, -0.4, 0.9)];
    let circle = |axis: &Vec3| {
        let (u, v) = axis.normalize().any_orthonormal_pair();
        let at = |k: i32| {
            let (sin, cos) = libm::sincosf(std::f32::consts::TAU * (k % 97) as f32 / 97.0);
            10.0 * (u * cos + v * sin)
        };
        (0..=97).map(at).collect::<Vec<_>>()
    };
    let sphere = with_veins(&sphere, &axes.each_ref().map(circle));
    let mesh = walled(sphere.clone(), &veins(1));
    let (piece_of, count) = pieces(&mesh);
    assert_eq!(count, 8);
    // The pieces are the octants, but for triangles whose centres are a hair from a circle.
    let octant = |p: Vec3| axes.map(|axis| p.dot(axis) > 0.0);
    let mut octants = [None; 8];
    for (t, &piece) in piece_of.iter().enumerate() {
        let centre = mesh.centroid(t as u32);
        if axes.iter().all(|axis| centre.dot(axis.normalize()).abs() > 0.02) {
            let known = octants[piece as usize].get_or_insert(octant(centre));
            assert_eq!(*known, octant(centre), "{centre}");
        }
    }
    let diary = grow(&mesh, restless(12));
    assert_eq!(strays(&diary, &piece_of), 0);
    assert!(strays(&grow(&sphere, restless(12)), &piece_of) > 50);
    // Nor is a cell seen on the other side.
    let mut finder = SiteFinder::new(&mesh);
    let lists = finder.find(&mesh, &diary, 12);
    let places = &diary.days[12].places;
    for (t, head) in lists.heads.iter().enumerate() {
        let count = lists.of(t).len();
        for &cell in &finder.cell_of[head.first as usize..][..count] {
            assert_eq!(piece_of[places[cell as usize].triangle as usize], piece_of[t]);
        }
    }
}

#[test]
fn what_leads_around_the_end_of_a_vein_is_open() {
    // From the lower side to a little over the middle.
    let line = [-0.5, 7.3].map(|y| Vec3::new(6.1, y, 0.0)).to_vec();
    let slit = with_veins(&sheet(24, 12.0, shaken(12.0, 0.1)), &[line]);
    let mesh = walled(slit.clone(), &veins(1));
    assert_eq!(pieces(&mesh).1, 1);
    let is_left = |t: usize| mesh.centroid(t as u32).x < 6.1;
    for (h, (&twin, &before)) in mesh.twins.iter().zip(&slit.twins).enumerate() {
        if before == NO_TWIN {
            continue;
        }
        let [a, b] = [h / 3, before as usize / 3].map(|t| mesh.centroid(t as u32));
        // Where the straight way between the centres comes to the line.
        let y = a.y + (b.y - a.y) * (6.1 - a.x) / (b.x - a.x);
        let is_wall = is_left(h / 3) != is_left(before as usize / 3) && y < 7.3;
        assert_eq!(twin, if is_wall { NO_TWIN } else { before }, "from {a} to {b}");
    }
}

#[test]
fn a_walk_slides_along_a_wall() {
    let across = [-1.0, 13.0].map(|y| Vec3::new(6.0, y, 0.0)).to_vec();
    let mesh = walled(with_veins(&sheet(24, 12.0, flat), &[across]), &veins(1));
    assert_eq!(pieces(&mesh).1, 2);
    for triangle in 0..mesh.triangles.len() as u32 {
        let from = Place { triangle, b1: 0.3, b2: 0.3 };
        let is_left = mesh.point(from).x < 6.0;
        let [x, y] = mesh.axes(triangle);
        for step in [Vec3::new(9.0, 1.0, 0.0), Vec3::new(-9.0, 1.0, 0.0)] {
            let flat = Vec2::new(step.dot(x), step.dot(y));
            let end = mesh.point(walk(&mesh, from, flat).place);
            if is_left == (step.x > 0.0) {
                assert!((end.x - 6.0).abs() < 1e-4, "{end}");
            }
            assert!(if is_left { end.x < 6.0 + 1e-4 } else { end.x > 6.0 - 1e-4 });
        }
    }
}

#[test]
fn walls_stay_on_a_body_that_moves() {
    let mut plant: Plant = plants::find("goeppertia").unwrap().clone();
    let open = plant.embedded_body().surface;
    let json = plant.to_json();
    let wall = r#""paint": [{"wrap": {"veins": {"order": 1, "reach_cm": 5}}, "image": {"width": 1,
        "height": 1, "rule": {"pixels": {"rows": ["f"]}}}, "use": "wall"}],
        "motion": {"growth": [{"day": 0, "factors": [0.5, 1, 1]}, {"day": 9, "factors": [1, 1, 1]}]}"#;
    let [start, end] = ["\"paint\"", "\"recipe\""].map(|word| json.find(word).unwrap());
    let text = json[..start].to_string() + wall + ", " + &json[end..];
    let last = text.rfind("\"motion\"").unwrap();
    let end = last + text[last..].find("\"look\"").unwrap();
    let text = text[..last].to_string() + &text[end..];
    plant = Plant::from_json(&text).unwrap();
    assert_eq!(Plant::from_json(&plant.to_json()).unwrap(), plant);
    let body = plant.embedded_body();
    plant.check_on(&Arc::new(body.surface.clone())).unwrap();
    // A midrib that ends before the tip leaves a way around it.
    let walls = body.surface.twins.iter().zip(&open.twins).filter(|(a, b)| a != b).count();
    assert!(walls > 2 * 6 * 20, "{walls} half-edges on six midribs");
    assert_eq!(body.surface.parts, open.parts);
    let young = body.surface.on(3);
    assert_eq!(young.twins, body.surface.twins);
    assert_ne!(young.positions, body.surface.positions);
}
