//! Open rims push back as mirrors under the second rules.

use crate::meshes::{flat, shaken, sheet};
use clonal_mosaic::plants;
use clonal_mosaic::surface::{Mesh, NO_TWIN, Place};
use clonal_mosaic::tissue::{Growth, Progress, Recipe, Rules};
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// The sum over all cells and all that stand behind a side as those stand before it, in the plainest way.
#[test]
fn at_a_straight_rim_cells_are_pushed_by_their_mirror_images() {
    const SIDE: f32 = 8.0;
    let bodies = [sheet(10, SIDE, flat), sheet(10, SIDE, shaken(SIDE, 0.15))];
    for (mesh, radius_scale) in bodies.into_iter().zip([1.5, 2.5]) {
        let mesh = Arc::new(mesh);
        let after = |events: u32| -> Vec<Vec2> {
            let recipe = Recipe {
                initial_cells: 1_600,
                initial_relaxations: events,
                radius_scale,
                days: 0,
                ..Recipe::default()
            };
            let mut growth =
                Growth::new(mesh.clone(), recipe, &[], 3).unwrap().under(Rules::Second);
            while growth.step() != Progress::Done {}
            growth.diary.days[0].places.iter().map(|&p| mesh.point(p).truncate()).collect()
        };
        let (before, moved) = (after(0), after(1));
        let radius = radius_scale * SIDE / 40.0;
        let mirrored = |p: Vec2| {
            let (x, y) = (Vec2::X * (2.0 * p.x), Vec2::Y * (2.0 * p.y));
            let (far_x, far_y) = (Vec2::X * (2.0 * SIDE), Vec2::Y * (2.0 * SIDE));
            [p, p - x, p - x + far_x, p - y, p - y + far_y]
        };
        let others: Vec<Vec2> = before.iter().flat_map(|&p| mirrored(p)).collect();
        let mut at_rims = 0;
        for (&from, &to) in before.iter().zip(&moved) {
            let to_rim = from.min(Vec2::splat(SIDE) - from);
            if to_rim.max_element() < 2.0 * radius + 1.2 {
                // Behind corners are images of images, and each triangle has one side to be mirrored in.
                continue;
            }
            let push = |other: &Vec2| {
                let (arm, distance) = (from - *other, from.distance(*other));
                let is_felt = distance > 0.0 && distance < radius;
                if is_felt {
                    arm * (1.0 - distance / radius) * radius / distance
                } else {
                    Vec2::ZERO
                }
            };
            let sum: Vec2 = others.iter().map(push).sum();
            // No adhesion but that of F before day 0; and at most half the radius.
            let step = (0.09 * 0.5 * sum).clamp_length_max(0.5 * radius);
            let there = mirrored(from + step)
                .into_iter()
                .find(|p| p.cmpge(Vec2::ZERO).all() && p.cmple(Vec2::splat(SIDE)).all());
            let apart = there.unwrap().distance(to);
            assert!(apart < 2e-3 * radius, "{from} to {to}: {apart} of {radius}");
            at_rims += u32::from(to_rim.min_element() < radius);
        }
        assert!(at_rims > 100, "{at_rims}");
    }
}

/// Distance of a point from the nearest of some edges.
fn to_nearest(point: Vec3, edges: &[[Vec3; 2]]) -> f32 {
    let distance = |&[from, to]: &[Vec3; 2]| {
        let (edge, arm) = (to - from, point - from);
        let share = (arm.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        arm.distance(edge * share)
    };
    edges.iter().map(distance).fold(f32::INFINITY, f32::min)
}

/// The edges of all rims, each with its part.
fn rims(mesh: &Mesh) -> Vec<Vec<[Vec3; 2]>> {
    let mut rims = vec![Vec::new(); mesh.part_count()];
    for (h, &twin) in mesh.twins.iter().enumerate() {
        if twin == NO_TWIN {
            let c = mesh.corners((h / 3) as u32);
            rims[mesh.parts[h / 3] as usize].push([c[(h + 1) % 3], c[(h + 2) % 3]]);
        }
    }
    rims
}

/// How many times as many cells as anywhere stand within so many mean spacings of a rim, on a day of individual 1.
fn crowding(key: &str, rules: Rules, day: u32, spacings: &[f32]) -> Vec<f32> {
    let plant = plants::find(key).unwrap().under(rules as u32).unwrap();
    let mesh = Arc::new(plant.embedded_body().surface);
    let recipe = Recipe { days: day, ..plant.recipe.clone() };
    let mut growth = plant.sow(mesh.clone(), recipe, 1).unwrap();
    while growth.step() != Progress::Done {}
    let places = &growth.diary.days[day as usize].places;
    let rims = rims(&mesh);
    let spacing = (mesh.area / places.len() as f32).sqrt();
    let distance = |place: Place| {
        let part = mesh.parts[place.triangle as usize] as usize;
        to_nearest(mesh.point(place), &rims[part])
    };
    let cells: Vec<f32> = places.iter().map(|&place| distance(place)).collect();
    // Even places on each triangle, by its area.
    let mut area = Vec::new();
    const CUTS: u32 = 6;
    for triangle in 0..mesh.triangles.len() as u32 {
        for k in 0..CUTS {
            for l in 0..CUTS - k {
                let share = |n: u32| (n as f32 + 1.0 / 3.0) / CUTS as f32;
                let place = Place { triangle, b1: share(k), b2: share(l) };
                area.push((distance(place), mesh.areas[triangle as usize]));
            }
        }
    }
    let whole: f64 = area.iter().map(|a| f64::from(a.1)).sum();
    spacings
        .iter()
        .map(|&width| {
            let within = |d: f32| d < width * spacing;
            let strip: f64 = area.iter().filter(|a| within(a.0)).map(|a| f64::from(a.1)).sum();
            let there = cells.iter().filter(|&&d| within(d)).count() as f64;
            (there / cells.len() as f64 / (strip / whole)) as f32
        })
        .collect()
}

/// Cells in the first row stand where a strip of half a spacing ends, so that a wider one is measured, too.
#[test]
fn no_more_cells_stand_at_rims_than_anywhere() {
    for (key, day, least, most) in [
        ("croton", 8, 0.9, 1.1),
        ("mushroom", 12, 0.7, 1.1),
        // The direction field leads its cells to the rim.
        ("philodendron", 8, 0.9, 1.4),
    ] {
        let [on_it, half, whole] = crowding(key, Rules::Second, day, &[0.1, 0.5, 1.0])[..] else {
            panic!("three strips")
        };
        assert!(on_it < 0.5 && (least..most).contains(&half), "{key}: {on_it}, {half}");
        assert!((0.9..1.1).contains(&whole), "{key}: {whole}");
    }
    // What they would do without mirrors.
    let [on_it, half] = crowding("mushroom", Rules::First, 12, &[0.1, 0.5])[..] else {
        panic!("two strips")
    };
    assert!(on_it > 5.0 && half > 2.0, "{on_it}, {half}");
}
