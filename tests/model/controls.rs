//! Control images: each of their uses, and bodies that are bare under one.

use crate::meshes::{flat, icosphere, sheet};
use crate::without_relaxation;
use clonal_mosaic::surface::{Body, ControlImage, Cylinder, Mesh, Ornament, Wrap};
use clonal_mosaic::tissue::CellType::{self, Background, Foreground, Middle};
use clonal_mosaic::tissue::{Clock, Control, Diary, Growth, Progress, Recipe, Scaled, Use, clans};
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// Around a sphere of radius 10, black in its lower half.
fn upper_half() -> (Wrap, ControlImage) {
    let base = Vec3::new(0.0, -10.0, 0.0);
    let cylinder = Cylinder { base, axis: Vec3::Y, zero: Vec3::X, height: 20.0 };
    (Wrap::Cylinder(cylinder), ControlImage::paint(1, 2, |_, height| height > 0.5))
}

fn grow(mesh: &Arc<Mesh>, recipe: &Recipe, controls: &[Control]) -> Diary {
    let mut growth = Growth::new(mesh.clone(), recipe.clone(), controls, 2).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary
}

#[test]
fn first_cells_of_each_type_stand_only_where_its_image_is_white() {
    let mesh = Arc::new(icosphere(3, 10.0));
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [0.6, 0.3, 0.1],
        days: 0,
        ..without_relaxation()
    };
    let free = grow(&mesh, &recipe, &[]);
    let (wrap, image) = upper_half();
    for of in CellType::ALL {
        for instead in CellType::ALL.into_iter().filter(|&t| t != of) {
            let use_as = Use::FirstCells { of, instead };
            let control = Control { wrap, image: image.clone(), use_as };
            let diary = grow(&mesh, &recipe, &[control]);
            assert_eq!(diary.days, free.days, "nobody stands elsewhere");
            for (cell, place) in diary.days[0].places.iter().enumerate() {
                let (drawn, kind) = (free.lineage[cell].kind, diary.lineage[cell].kind);
                let white = mesh.point(*place).y > 0.0;
                assert_eq!(kind, if drawn == of && !white { instead } else { drawn });
            }
        }
    }
    let control = Control { wrap, image, use_as: Use::FOREGROUND };
    assert_eq!(control.use_as, Use::FirstCells { of: Foreground, instead: Background });
}

#[test]
fn control_images_are_taken_in_their_order() {
    let mesh = Arc::new(icosphere(2, 10.0));
    let recipe = Recipe { initial_probability: [1.0, 0.0, 0.0], days: 0, ..without_relaxation() };
    let (wrap, image) = upper_half();
    let control = |of, instead| {
        let use_as = Use::FirstCells { of, instead };
        Control { wrap, image: image.clone(), use_as }
    };
    let two = [control(Foreground, Middle), control(Middle, Background)];
    let counts = grow(&mesh, &recipe, &two).count(0).by_type;
    assert!(counts[0] > 0 && counts[1] > 0 && counts[2] == 0, "{counts:?}");
}

#[test]
fn days_between_divisions_are_scaled_where_the_cell_is() {
    const DAYS: usize = 14;
    let mesh = Arc::new(icosphere(3, 10.0));
    let recipe = Recipe {
        initial_cells: 60_000,
        initial_probability: [0.5, 0.5, 0.0],
        division_days: [4.0, 6.0, 10.0],
        days: DAYS as u32,
        ..without_relaxation()
    };
    let (wrap, image) = upper_half();
    let number = Scaled::DivisionDays(Foreground);
    let control = Control { wrap, image, use_as: Use::Scale { number, black: 2.0, white: 0.75 } };
    let diary = grow(&mesh, &recipe, &[control]);
    let mut clan_sizes = vec![0.0; 60_000];
    for cell in &diary.lineage {
        clan_sizes[cell.founder as usize] += 1.0;
    }
    // Between the centres of the two pixels the factor goes from one to the other.
    let ends = |y: f32| if y < -5.5 { Some(2.0) } else { (y > 5.5).then_some(0.75) };
    for (kind, end, days) in [
        (Foreground, 2.0, 8.0),
        (Foreground, 0.75, 3.0),
        (Background, 2.0, 6.0),
        (Background, 0.75, 6.0),
    ] {
        let founders = diary.days[0].places.iter().enumerate().filter(|(cell, place)| {
            diary.lineage[*cell].kind == kind && ends(mesh.point(**place).y) == Some(end)
        });
        let sizes: Vec<f64> = founders.map(|(cell, _)| clan_sizes[cell]).collect();
        let n = sizes.len() as f64;
        let mean = sizes.iter().sum::<f64>() / n;
        let variance = sizes.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / n;
        let expected = clans(days, DAYS)[DAYS - 1].mean;
        let error = (variance / n).sqrt();
        assert!(n > 5_000.0);
        assert!((mean - expected).abs() < 4.417 * error, "{kind:?}, {end}: {mean} not {expected}");
    }
}

#[test]
fn what_no_cell_can_have_under_an_image_is_refused() {
    let mesh = Arc::new(icosphere(0, 10.0));
    let (wrap, image) = upper_half();
    let days = Scaled::DivisionDays(Background);
    let adhesion = Scaled::Adhesion(Background, Background);
    for (number, black, white, words) in [
        (days, 0.1, 1.0, "under a control image, division_days of B is 1:"),
        (days, 1.0, 60.0, "under a control image, division_days of B is 600:"),
        (Scaled::RadiusScale, 0.0, 1.0, "under a control image, radius_scale is 0:"),
        (Scaled::RadiusScale, 1.0, 12.0, "under a control image, radius_scale is 12:"),
        (Scaled::Repulsion, 25.0, 0.0, "under a control image, repulsion is 2.25:"),
        (adhesion, 0.0, 1.5, "under a control image, adhesion BB is 1.2"),
        (days, -2.0, 1.0, "has the factors -2 at black and 1 at white: they must be from 0 to"),
        (adhesion, 1.0, -0.1, "has the factors 1 at black and -0.1 at white"),
        (Scaled::Repulsion, f64::NAN, 1.0, "has the factors NaN at black"),
        (Scaled::Repulsion, 1.0, f64::INFINITY, "inf at white"),
    ] {
        let control =
            Control { wrap, image: image.clone(), use_as: Use::Scale { number, black, white } };
        for clock in [Clock::Poisson, Clock::Exponential] {
            let recipe = Recipe { clock, ..Recipe::default() };
            let growth = Growth::new(mesh.clone(), recipe, std::slice::from_ref(&control), 1);
            let error = growth.err().expect("refused").to_string();
            assert!(error.contains(words), "{error}");
        }
    }
    // Two images at one place: only their product counts.
    let twice = |white| {
        let use_as = Use::Scale { number: Scaled::RadiusScale, black: 1.0, white };
        Control { wrap, image: image.clone(), use_as }
    };
    let grows =
        |controls: &[Control]| Growth::new(mesh.clone(), Recipe::default(), controls, 1).is_ok();
    assert!(grows(&[twice(4.0)]) && grows(&[twice(4.0), twice(2.0)]));
    assert!(!grows(&[twice(4.0), twice(4.0)]));
}

#[test]
fn several_cylinders_stand_on_one_body_and_none_has_a_seam() {
    let mesh = Arc::new(icosphere(3, 10.0));
    // One upright, black in its lower half; one that lies along x, of its own size, black where y
    // and z are over 0: a quarter of the angle from its zero on.
    let (upright, lower_half) = upper_half();
    let lying = |zero| {
        let base = Vec3::new(-20.0, 0.0, 0.0);
        Wrap::Cylinder(Cylinder { base, axis: Vec3::X, zero, height: 40.0 })
    };
    let quarter = ControlImage::paint(16, 3, |turns, _| turns > 0.25);
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [1.0, 0.0, 0.0],
        days: 0,
        ..without_relaxation()
    };
    let control = |wrap, image: &ControlImage, instead| {
        let use_as = Use::FirstCells { of: Foreground, instead };
        Control { wrap, image: image.clone(), use_as }
    };
    let both =
        [control(upright, &lower_half, Background), control(lying(Vec3::Y), &quarter, Middle)];
    let diary = grow(&mesh, &recipe, &both);
    let mut counts = [0; 3];
    for (cell, &place) in diary.lineage.iter().zip(&diary.days[0].places) {
        let p = mesh.point(place);
        let expected = match (p.y > 0.0, p.z > 0.0) {
            (false, _) => Background,
            (true, true) => Middle,
            (true, false) => Foreground,
        };
        // Points on the border may round to either side.
        if p.y.abs() > 1e-4 && p.z.abs() > 1e-4 {
            assert_eq!(cell.kind, expected, "at {p}");
            counts[expected as usize] += 1;
        }
    }
    assert!(counts.iter().all(|&n| n > 4_000), "{counts:?}");

    // Wherever the angle begins, the same image lies on the body: types and factors stay.
    let noise = ControlImage {
        width: 16,
        height: 3,
        grey: (0..48u32).map(|k| (k * k * 89 + k * 57) as u8).collect(),
    };
    for by in [1, 5, 12] {
        let (sin, cos) = (std::f32::consts::TAU * by as f32 / 16.0).sin_cos();
        let turned = |image: &ControlImage| {
            let mut image = image.clone();
            image.grey.chunks_mut(16).for_each(|row| row.rotate_left(by));
            image
        };
        let from_there = lying(Vec3::new(0.0, cos, sin));
        let types = control(from_there, &turned(&quarter), Middle);
        let use_as = Use::Scale { number: Scaled::Repulsion, black: 0.0, white: 1.0 };
        let before = Control { wrap: lying(Vec3::Y), image: noise.clone(), use_as };
        let after = Control { wrap: from_there, image: turned(&noise), use_as };
        for &place in &diary.days[0].places {
            let p = mesh.point(place);
            let factor = |c: &Control| c.factor(&mesh, place, Scaled::Repulsion);
            assert!((factor(&before) - factor(&after)).abs() < 1e-4, "{by} columns, at {p}");
            if p.y.abs() > 1e-3 && p.z.abs() > 1e-3 {
                let kind = |c: &Control| c.first_type(&mesh, place, Foreground);
                assert_eq!(kind(&types), kind(&both[1]), "{by} columns, at {p}");
            }
        }
    }
}

#[test]
fn a_body_is_bare_where_an_image_is_black() {
    let whole = Body { surface: sheet(10, 4.0, flat), ornaments: Vec::<Ornament>::new() };
    let cylinder = Cylinder { base: Vec3::ZERO, axis: Vec3::Y, zero: Vec3::X, height: 4.0 };
    let wrap = Wrap::Cylinder(cylinder);
    let image = ControlImage::paint(1, 4, |_, height| height > 0.25);
    let body = whole.clone().bared(&wrap, &image, "stem").unwrap();
    body.surface.check().unwrap();
    let [stem] = &body.ornaments[..] else { panic!("one bare part") };
    assert_eq!(stem.material, "stem");
    let all = whole.surface.triangles.len();
    assert_eq!(body.surface.triangles.len() + stem.triangles.len(), all);
    for t in 0..body.surface.triangles.len() as u32 {
        assert!(body.surface.centroid(t).y > 1.0);
    }
    for t in &stem.triangles {
        let y = t.iter().map(|&v| stem.positions[v as usize].y).sum::<f32>() / 3.0;
        assert!(y < 1.0);
    }
    assert!((body.surface.area - 12.0).abs() < 0.5, "{}", body.surface.area);
    // All white changes nothing; all black leaves nothing.
    let same = whole.clone().bared(&wrap, &ControlImage::paint(1, 1, |_, _| true), "stem").unwrap();
    assert_eq!((same.surface.triangles.len(), same.ornaments.len()), (all, 0));
    assert!(whole.bared(&wrap, &ControlImage::paint(1, 1, |_, _| false), "stem").is_err());
}

#[test]
fn an_image_spreads_over_a_leaf_from_rim_to_rim() {
    let mut mesh = sheet(8, 4.0, flat);
    let leaf = |p: &Vec3| Vec2::new(p.x / 2.0 - 1.0, p.y / 4.0);
    mesh.uvs = mesh.positions.iter().map(leaf).collect();
    // White in the middle third, and a mark in the last column alone.
    let middle = ControlImage::paint(9, 4, |turns, _| (turns - 0.5).abs() < 1.0 / 6.0);
    let right = ControlImage::paint(9, 4, |turns, height| turns > 0.9 && height < 0.5);
    for triangle in 0..mesh.triangles.len() as u32 {
        for (b1, b2) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.3, 0.3)] {
            let place = clonal_mosaic::surface::Place { triangle, b1, b2 };
            let p = mesh.point(place);
            let looked_up = |image: &ControlImage| {
                let (turns, height) = Wrap::Leaf.coordinates(image, &mesh, place);
                image.is_white(turns, height)
            };
            assert_eq!(looked_up(&middle), (p.x - 2.0).abs() < 2.0 / 3.0, "{p}");
            assert_eq!(looked_up(&right), p.x > 4.0 - 4.0 / 9.0 && p.y < 2.0, "{p}");
        }
    }
}
