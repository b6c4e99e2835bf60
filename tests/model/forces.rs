//! Relaxation against the formula of the thesis written down pair by pair, and what must not matter
//! to it.

use crate::meshes::{flat, flat_torus, icosphere, sheet, two_sheets};
use crate::{grow, grow_along};
use clonal_mosaic::surface::{DirectionField, Guide, Mesh};
use clonal_mosaic::tissue::{Day, Recipe};
use glam::{Vec2, Vec3};
use std::sync::Arc;

pub const SIDE_CM: f32 = 8.0;

/// Cells that move but never divide within the days that we look at.
pub fn undivided() -> Recipe {
    Recipe {
        initial_cells: 800,
        initial_probability: [0.4, 0.4, 0.2],
        division_days: [500.0; 3],
        initial_relaxations: 3,
        relaxations_per_day: 1,
        days: 1,
        ..Recipe::default()
    }
}

pub fn points(mesh: &Mesh, day: &Day) -> Vec<Vec2> {
    day.places.iter().map(|&place| mesh.point(place).truncate()).collect()
}

/// A difference of two points of the torus, the short way round.
pub fn short_way(d: Vec2) -> Vec2 {
    d - (d / SIDE_CM).round() * SIDE_CM
}

/// `omega_d sum (1 - alpha) (1 - d / r) r u` over all pairs, capped at half the radius; radius and
/// repulsion are those of the cell that is pushed.
pub fn pushes(
    points: &[Vec2],
    radius: impl Fn(usize) -> f32,
    repulsion: impl Fn(usize) -> f32,
    weight: impl Fn(usize, usize) -> f32,
) -> Vec<Vec2> {
    let push = |i: usize| {
        let mut sum = Vec2::ZERO;
        let radius = radius(i);
        for j in (0..points.len()).filter(|&j| j != i) {
            let apart = short_way(points[i] - points[j]);
            let distance = apart.length();
            if distance < radius {
                sum += weight(i, j) * (1.0 - distance / radius) * radius * apart / distance;
            }
        }
        (sum * repulsion(i)).clamp_length_max(0.5 * radius)
    };
    (0..points.len()).map(push).collect()
}

#[test]
fn a_day_moves_cells_as_the_formula_says() {
    let mut adhesion = [[0.0; 3]; 3];
    for (i, j, alpha) in [(0, 0, 0.5), (1, 1, 0.8), (2, 2, 0.1), (0, 1, 0.3), (1, 2, 1.0)] {
        adhesion[i][j] = alpha;
        adhesion[j][i] = alpha;
    }
    for (triangles_a_side, radius_scale, repulsion) in
        [(24, 1.0, 0.09), (24, 2.5, 0.02), (6, 1.0, 0.3), (48, 1.5, 0.05), (24, 1.0, 2.0)]
    {
        let mesh = Arc::new(flat_torus(triangles_a_side, SIDE_CM));
        let recipe = Recipe { adhesion, radius_scale, repulsion, ..undivided() };
        let diary = grow(&mesh, &recipe, 21);
        let before = points(&mesh, &diary.days[0]);
        let after = points(&mesh, &diary.days[1]);
        let kind = |i: usize| diary.lineage[i].kind as usize;
        let radius = diary.days[0].repulsive_radius;
        let weight = |i, j| 1.0 - adhesion[kind(i)][kind(j)];
        let expected = pushes(&before, |_| radius, |_| repulsion, weight);
        let mut longest = 0.0f32;
        for (i, push) in expected.iter().enumerate() {
            let moved = short_way(after[i] - before[i]);
            assert!((moved - *push).length() < 2e-5, "cell {i} moved {moved} and not {push}");
            longest = longest.max(push.length());
        }
        assert!(longest > 0.01, "somebody moved");
        assert!(repulsion < 1.0 || longest > 0.4999 * radius, "the longest steps are capped");
    }
}

#[test]
fn steps_turn_towards_the_direction_field_and_keep_their_length() {
    let mesh = Arc::new(flat_torus(24, SIDE_CM));
    let along = Vec2::new(0.8, -0.6);
    let guide = Guide { triangle: 100, direction: along.extend(0.0) };
    let field = DirectionField::new(&mesh, &[guide], 0.2).unwrap();
    let free = grow(&mesh, &undivided(), 21);
    let before = points(&mesh, &free.days[0]);
    let pushed: Vec<Vec2> =
        points(&mesh, &free.days[1]).iter().zip(&before).map(|(a, b)| short_way(*a - *b)).collect();
    for anisotropy in [0.0, 0.3, 1.0] {
        let recipe = Recipe { anisotropy, ..undivided() };
        let led = grow_along(&mesh, &recipe, &field, 21);
        assert_eq!(led.days[0], free.days[0], "before day 0 the field plays no part");
        assert_eq!(led == free, anisotropy == 0.0, "with no weight not a bit is changed");
        assert_eq!(grow(&mesh, &recipe, 21), free, "nor without a field");
        for (i, after) in points(&mesh, &led.days[1]).into_iter().enumerate() {
            let d = pushed[i];
            let expected = d * (1.0 - anisotropy) + along * (anisotropy * d.length());
            let moved = short_way(after - before[i]);
            assert!((moved - expected).length() < 2e-5, "cell {i} moved {moved}, not {expected}");
        }
    }
}

#[test]
fn before_day_0_every_pair_repels_like_two_foreground_cells() {
    let mesh = Arc::new(flat_torus(24, SIDE_CM));
    let recipe = Recipe { initial_relaxations: 0, days: 0, ..undivided() };
    let sown = grow(&mesh, &recipe, 5);
    let relaxed = grow(&mesh, &Recipe { initial_relaxations: 1, ..recipe.clone() }, 5);
    let before = points(&mesh, &sown.days[0]);
    let radius = sown.days[0].repulsive_radius;
    let expected = pushes(&before, |_| radius, |_| recipe.repulsion, |_, _| 0.5);
    for (i, after) in points(&mesh, &relaxed.days[0]).into_iter().enumerate() {
        assert!((short_way(after - before[i]) - expected[i]).length() < 2e-5, "cell {i}");
    }
}

#[test]
fn equal_forces_on_a_closed_flat_surface_sum_to_nothing() {
    let mesh = Arc::new(flat_torus(16, SIDE_CM));
    // Weak enough that no step is capped: a capped one has no equal and opposite.
    let weak = Recipe { repulsion: 0.01, adhesion: [[0.5; 3]; 3], ..undivided() };
    for radius_scale in [1.0, 2.0] {
        let diary = grow(&mesh, &Recipe { radius_scale, ..weak.clone() }, 6);
        let (before, after) = (points(&mesh, &diary.days[0]), points(&mesh, &diary.days[1]));
        let moved = before.iter().zip(&after).map(|(b, a)| short_way(*a - *b));
        let (sum, way) = moved.fold((Vec2::ZERO, 0.0), |(s, w), d| (s + d, w + d.length()));
        assert!(way > 0.3, "cells moved {way} cm in all");
        assert!(sum.length() < 1e-4 * way, "{sum} of {way}");
    }
}

#[test]
fn cells_spread_out() {
    let mesh = Arc::new(icosphere(4, 10.0));
    let recipe =
        Recipe { initial_relaxations: 0, days: 0, initial_cells: 1500, ..Recipe::default() };
    let nearest = |relaxations: u32| {
        let recipe = Recipe { initial_relaxations: relaxations, ..recipe.clone() };
        let day = grow(&mesh, &recipe, 1).days.swap_remove(0);
        let at: Vec<Vec3> = day.places.iter().map(|&p| mesh.point(p)).collect();
        let least = (0..at.len()).map(|i| {
            let others = (0..at.len()).filter(|&j| j != i);
            others.map(|j| at[i].distance(at[j])).fold(f32::MAX, f32::min)
        });
        least.fold(f32::MAX, f32::min) / (mesh.area / at.len() as f32).sqrt()
    };
    let (sown, relaxed) = (nearest(0), nearest(60));
    assert!(sown < 0.1 && relaxed > 0.55, "nearest pairs {sown} and then {relaxed} spacings apart");
}

#[test]
fn the_two_faces_of_a_fold_do_not_feel_each_other() {
    // A sheet folded flat onto itself is, seen along the surface, the same sheet: cells that lie on
    // top of each other in space are as far apart as they were.
    let recipe = Recipe { initial_cells: 700, days: 12, radius_scale: 1.5, ..Recipe::default() };
    let open = Arc::new(sheet(16, SIDE_CM, flat));
    let folded = Arc::new(sheet(16, SIDE_CM, |p| {
        Vec3::new(if p.x > 4.0 { 8.0 - p.x } else { p.x }, p.y, 0.0)
    }));
    let (open, folded) = (grow(&open, &recipe, 3), grow(&folded, &recipe, 3));
    for day in [0, 5, 12] {
        assert_eq!(open.fingerprint(day), folded.fingerprint(day), "day {day}");
    }
}

#[test]
fn parts_that_touch_do_not_feel_each_other() {
    let recipe = Recipe { initial_cells: 600, days: 6, ..Recipe::default() };
    let touching = grow(&Arc::new(two_sheets(8, SIDE_CM, 0.0)), &recipe, 2);
    assert_eq!(touching, grow(&Arc::new(two_sheets(8, SIDE_CM, 100.0)), &recipe, 2));
}
