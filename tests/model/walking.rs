//! Straight walks over the surface.

use crate::meshes::{flat, icosphere, in_frame, place_at, shaken, sheet};
use clonal_mosaic::surface::{Mesh, Place, walk};
use glam::{Vec2, Vec3};

const SIDE_CM: f32 = 4.0;

/// A few hundred points and steps that stay within the sheet.
fn journeys() -> impl Iterator<Item = (Vec2, Vec2)> {
    let noise = |k: u32, a: f32| (libm::sinf(k as f32 * a + 1.0) * 4375.854).abs().fract();
    (0..400).map(move |k| {
        let from = Vec2::new(noise(k, 12.9898), noise(k, 78.233)) * 3.8 + 0.1;
        let to = Vec2::new(noise(k, 39.346), noise(k, 11.135)) * 3.8 + 0.1;
        (from, to - from)
    })
}

fn walk_on_plane(mesh: &Mesh, from: Place, step: Vec2) -> Place {
    let end = walk(mesh, from, in_frame(mesh, from.triangle, step));
    assert!(!end.caught, "{from:?} {step}");
    let place = end.place;
    assert!(place.b1 >= 0.0 && place.b2 >= 0.0 && place.b1 + place.b2 <= 1.0, "{place:?}");
    place
}

fn point(mesh: &Mesh, place: Place) -> Vec2 {
    mesh.point(place).truncate()
}

#[test]
fn a_walk_on_a_flat_mesh_is_a_straight_line_and_leads_back() {
    let slivers = |p: Vec2| flat(Vec2::new(p.x, p.y * p.y * p.y / 16.0));
    for mesh in [
        sheet(12, SIDE_CM, flat),
        sheet(12, SIDE_CM, shaken(SIDE_CM, 0.08)),
        sheet(12, SIDE_CM, slivers),
    ] {
        for (from, step) in journeys() {
            let start = place_at(&mesh, from);
            let end = walk_on_plane(&mesh, start, step);
            assert!(point(&mesh, end).distance(from + step) < 1e-4, "from {from} by {step}");
            let back = walk_on_plane(&mesh, end, -step);
            assert!(point(&mesh, back).distance(from) < 2e-4, "back to {from} by {step}");
        }
    }
}

#[test]
fn bending_a_sheet_does_not_change_a_walk() {
    let open = sheet(16, SIDE_CM, flat);
    // A right angle along the line x = 1, and the sheet folded back at x = 3.
    let bent = sheet(16, SIDE_CM, |p| match p.x {
        x if x <= 1.0 => Vec3::new(x, p.y, 0.0),
        x if x <= 3.0 => Vec3::new(1.0, p.y, x - 1.0),
        x => Vec3::new(1.0, p.y, 5.0 - x),
    });
    for (from, step) in journeys() {
        let start = place_at(&open, from);
        let step = in_frame(&open, start.triangle, step);
        assert_eq!(walk(&open, start, step).place, walk(&bent, start, step).place);
    }
}

#[test]
fn walks_aimed_at_vertices_and_along_edges_arrive() {
    let mesh = sheet(8, SIDE_CM, flat);
    let vertices: Vec<Vec2> =
        (1..8).flat_map(|x| (1..8).map(move |y| Vec2::new(x as f32, y as f32) * 0.5)).collect();
    for &vertex in &vertices {
        let from = vertex + Vec2::new(0.11, 0.07);
        let start = place_at(&mesh, from);
        // To the vertex, and as far again behind it.
        for way in [1.0, 2.0] {
            let to = from + (vertex - from) * way;
            let end = walk_on_plane(&mesh, start, to - from);
            assert!(point(&mesh, end).distance(to) < 1e-5, "through {vertex}");
        }
        // From the vertex along each kind of edge.
        let start = place_at(&mesh, vertex);
        for along in [Vec2::X, Vec2::Y, Vec2::ONE, -Vec2::X, -Vec2::Y, -Vec2::ONE] {
            let end = walk_on_plane(&mesh, start, along * 0.4);
            assert!(point(&mesh, end).distance(vertex + along * 0.4) < 1e-5, "{vertex} {along}");
        }
    }
}

#[test]
fn at_the_rim_a_walk_slides_along() {
    let mesh = sheet(8, SIDE_CM, shaken(SIDE_CM, 0.12));
    for (from, step) in journeys() {
        let start = place_at(&mesh, from);
        // Far enough to the right to leave the sheet, and not so far along as to reach a corner.
        let step = Vec2::new(10.0, step.y.clamp(-0.05, 0.05));
        let end = point(&mesh, walk_on_plane(&mesh, start, step));
        assert!((end.x - SIDE_CM).abs() < 1e-5, "{end}");
        assert!((end.y - (from.y + step.y)).abs() < 1e-3, "from {from} by {step} to {end}");
    }
    // Into a corner, whichever edge is met first, and not beyond it.
    let start = place_at(&mesh, Vec2::new(3.7, 3.8));
    for step in [Vec2::new(5.0, 4.0), Vec2::new(4.0, 5.0), Vec2::splat(5.0)] {
        let end = point(&mesh, walk_on_plane(&mesh, start, step));
        assert!(end.distance(Vec2::splat(SIDE_CM)) < 1e-4, "{end}");
    }
}

#[test]
fn a_walk_around_a_sphere_comes_home() {
    let radius_cm = 10.0;
    let mesh = icosphere(5, radius_cm);
    let once_around = std::f32::consts::TAU * radius_cm;
    // Short steps, each taken from where the last ended; walking one step at a time loses the
    // direction, so each quarter is one walk that may cross at most 64 edges.
    for (triangle, angle) in [(0, 0.3f32), (77, 1.0), (900, 2.2), (4000, 4.0)] {
        let from = Place { triangle, b1: 0.3, b2: 0.4 };
        let direction = Vec2::new(libm::cosf(angle), libm::sinf(angle));
        let end = walk(&mesh, from, direction * (once_around / 8.0));
        assert!(!end.caught);
        let (a, b) = (mesh.point(from).normalize(), mesh.point(end.place).normalize());
        let angle = libm::acosf(a.dot(b));
        // Straight on the facets is nearly a great circle.
        assert!((angle - std::f32::consts::FRAC_PI_4).abs() < 0.01, "{angle}");
    }
}
