//! What holds for every plant of the catalogue, and what each of the old ones must show.

use super::*;
use crate::surface::{Cylinder, NO_TWIN, Place, Wrap};
use crate::tissue::CellType;
use crate::tissue::CellType::Foreground;
use crate::tissue::Progress;
use glam::Vec3;

fn surface(key: &str) -> Mesh {
    find(key).unwrap().embedded_body().surface
}

/// What becomes of a first F cell in the middle of a triangle.
fn first_type(mesh: &Mesh, controls: &[Control], triangle: u32) -> CellType {
    let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
    controls.iter().fold(Foreground, |kind, c| c.first_type(mesh, centre, kind))
}

#[test]
fn every_plant_is_sound() {
    for plant in all() {
        assert!(std::ptr::eq(find(plant.key).unwrap(), plant));
        plant.recipe.check().unwrap();
        assert_eq!(plant.guides.is_some(), plant.recipe.anisotropy > 0.0, "{}", plant.key);
        assert!(plant.first_day <= plant.recipe.days, "{}", plant.key);
        let body = plant.embedded_body();
        body.surface.check().unwrap();
        let triangles = body.surface.triangles.len();
        assert!((3_000..=16_000).contains(&triangles), "{}: {triangles}", plant.key);
        for part in &body.ornaments {
            let named = plant.look.bare.iter().any(|&(name, ..)| name == part.material);
            assert!(named, "{} has no colour for {}", plant.key, part.material);
        }
    }
    assert!(find("nettle").is_none());
    assert_eq!(kinds().map(|(_, plants)| plants.len()).sum::<usize>(), all().len());
}

#[test]
fn triangles_are_of_like_size_and_no_slivers() {
    let mut wrong = Vec::new();
    for plant in all() {
        let mesh = plant.embedded_body().surface;
        let mut areas = mesh.areas.clone();
        areas.sort_by(f32::total_cmp);
        let at = |share: f32| areas[(share * (areas.len() - 1) as f32) as usize];
        let sizes = [0.05, 0.95].map(|share| at(share) / at(0.5));
        // 1 for an equilateral triangle, 0 for a line.
        let quality = |t: u32| {
            let [a, b, c] = mesh.corners(t);
            let squares = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
            4.0 * 3_f32.sqrt() * mesh.areas[t as usize] / squares
        };
        let all = (0..mesh.triangles.len() as u32).map(|t| (quality(t), t));
        let (worst, t) = all.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        if !(sizes[0] > 0.25 && sizes[1] < 2.0 && worst > 0.35) {
            let place = mesh.centroid(t);
            wrong.push(format!("{}: {sizes:?}, {worst} at {place}", plant.key));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_plant_stands_on_the_ground() {
    for plant in all() {
        let body = plant.embedded_body();
        let bare = body.ornaments.iter().flat_map(|part| &part.positions);
        let lowest = body.surface.positions.iter().chain(bare).map(|p| p.y).fold(9.0, f32::min);
        assert!((-0.15..0.1).contains(&lowest), "{}: {lowest}", plant.key);
    }
}

#[test]
fn melons_are_closed_and_caps_and_leaves_are_open() {
    for (key, parts, closed) in [
        ("croton", 18, false),
        ("cactus", 2, false),
        ("mushroom", 2, false),
        ("philodendron", 6, false),
        ("sansevieria", 6, false),
        ("watermelon", 1, true),
        ("square-watermelon", 1, true),
        ("long-watermelon", 1, true),
        ("winter-squash", 1, true),
        // One between each two main veins of its three leaves, which no clone can leave.
        ("palmate", 18, false),
    ] {
        let mesh = surface(key);
        assert_eq!(mesh.part_count(), parts, "{key}");
        assert_eq!(!mesh.twins.contains(&NO_TWIN), closed, "{key}");
    }
}

#[test]
fn the_leaves_of_a_shoot_are_of_the_ages_of_the_figure() {
    let shoot = find("philodendron-shoot").unwrap();
    let unfolding_days = shoot.motion.unfolding_days;
    assert_eq!(unfolding_days.len(), surface(shoot.key).part_count());
    let ages = unfolding_days.iter().map(|unfolded| shoot.first_day - unfolded);
    assert!(ages.eq([32, 30, 27, 25, 23, 20]));
}

#[test]
fn stripes_of_lying_fruits_begin_level_with_their_axes() {
    for key in ["watermelon", "long-watermelon"] {
        let Wrap::Cylinder(Cylinder { axis, zero, .. }) = find(key).unwrap().paint[0].wrap else {
            panic!("{key} has a cylinder");
        };
        assert_eq!(zero, axis.cross(Vec3::Y).normalize(), "{key}");
    }
}

#[test]
fn a_square_melon_is_a_cube() {
    let mesh = surface("square-watermelon");
    let far = |axis: Vec3| mesh.positions.iter().map(|p| p.dot(axis)).fold(0.0, f32::max);
    for width in [far(Vec3::X) + far(-Vec3::X), far(Vec3::Z) + far(-Vec3::Z), far(Vec3::Y)] {
        assert!((18.0..19.2).contains(&width), "{width} cm");
    }
    // To the middle of an upright edge that is rounded by 3 cm.
    let edge = far(Vec3::new(1.0, 0.0, 1.0).normalize());
    assert!((edge - (6.0 * 2_f32.sqrt() + 3.0)).abs() < 0.3, "{edge} cm");
}

#[test]
fn a_snake_plant_has_clean_margins_and_bands_within() {
    let mesh = surface("sansevieria");
    let controls = find("sansevieria").unwrap().controls(1);
    let mut shares = [0.0; 3];
    for triangle in 0..mesh.triangles.len() as u32 {
        let kind = first_type(&mesh, &controls, triangle);
        shares[kind as usize] += mesh.areas[triangle as usize] / mesh.area;
        // No leaf coordinate of one leaf lies on another's place in the image.
        let corners = mesh.triangles[triangle as usize].map(|v| mesh.uvs[v as usize].x);
        let place = mesh.parts[triangle as usize] as f32;
        assert!(corners.iter().all(|x| (-1e-4..1.0001).contains(&(5.0 * (x + 1.0) - place))));
    }
    let expected = [0.21, 0.47, 0.31];
    assert!(shares.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.04), "{shares:?}");
}

#[test]
fn leaves_know_their_midrib_and_rims() {
    for key in ["croton", "philodendron"] {
        let mesh = surface(key);
        assert_eq!(mesh.uvs.len(), mesh.positions.len());
        assert!(mesh.uvs.iter().all(|uv| uv.x.abs() <= 1.0 && (0.0..=1.0).contains(&uv.y)));
        // On the upper side of a blade the texture is not mirrored.
        let along = |t: usize| {
            let [a, b, c] = mesh.triangles[t].map(|v| mesh.uvs[v as usize]);
            (b - a).perp_dot(c - a) > 0.0
        };
        assert!((0..mesh.triangles.len()).all(along), "{key}");
    }
}

#[test]
fn control_images_leave_both_types_their_share() {
    for (key, white) in [
        ("croton", 0.7),
        ("watermelon", 0.36),
        ("mushroom", 0.9),
        ("philodendron", 0.4),
        ("square-watermelon", 0.36),
        ("long-watermelon", 0.36),
        ("banded-cactus", 0.4),
        ("amanita", 0.7),
    ] {
        let mesh = surface(key);
        let plant = find(key).unwrap();
        for paint in plant.paint {
            let Wrap::Cylinder(Cylinder { axis, zero, .. }) = paint.wrap else { continue };
            assert!((axis.length() - 1.0).abs() < 1e-6);
            assert!((zero.length() - 1.0).abs() < 1e-6);
            assert!(axis.dot(zero).abs() < 1e-6);
        }
        let share = |individual| {
            let controls = plant.controls(individual);
            let allowed: f32 = (0..mesh.triangles.len() as u32)
                .filter(|&t| first_type(&mesh, &controls, t) == Foreground)
                .map(|t| mesh.areas[t as usize])
                .sum();
            allowed / mesh.area
        };
        let share = (1..=6).map(share).sum::<f32>() / 6.0;
        assert!((share - white).abs() < 0.06, "{key}: {share}");
    }
}

#[test]
fn walks_on_our_meshes_are_never_caught() {
    for plant in all() {
        let recipe = Recipe { days: 1, ..plant.recipe.clone() };
        let mesh = Arc::new(plant.embedded_body().surface);
        let mut growth = plant.sow(mesh, recipe, 1).unwrap();
        while growth.step() != Progress::Done {}
        assert_eq!(growth.caught_walks(), 0, "{}", plant.key);
    }
}
