//! Veins that steer cells: first types and days between divisions by the distance from them.

use crate::without_relaxation;
use clonal_mosaic::surface::{
    AlongVeins, Body, ControlImage, DirectionField, Mesh, PolygonMesh, Wrap, icosphere,
};
use clonal_mosaic::tissue::CellType::Foreground;
use clonal_mosaic::tissue::{Clock, Control, Growth, Progress, Recipe, Scaled, Use};
use glam::Vec3;
use std::fmt::Write;
use std::sync::Arc;

/// A flat square of 10 cm with three midribs across it, 2.5 cm apart, and a bent vein of order 2 between
/// two of them.
fn square_with_veins() -> Arc<Mesh> {
    let mut obj = String::new();
    for k in 0..121 {
        writeln!(obj, "v {} {} 0", k % 11, k / 11).unwrap();
    }
    for [x, y] in [[0.0, 2.5], [10.0, 2.5], [0.0, 5.0], [10.0, 5.0], [0.0, 7.5], [10.0, 7.5]] {
        writeln!(obj, "v {x} {y} 0").unwrap();
    }
    obj += "v 1 3 0\nv 3 4.5 0\nv 6 3.5 0\n";
    for k in (0..110).filter(|k| k % 11 < 10) {
        writeln!(obj, "f {} {} {} {}", k + 1, k + 2, k + 13, k + 12).unwrap();
    }
    obj += "usemtl vein:1\nl 122 123\nl 124 125\nl 126 127\nusemtl vein:2\nl 128 129 130\n";
    obj += "usemtl wire\nl 1 121\n";
    Arc::new(Body::new(&PolygonMesh::parse(&obj).unwrap()).unwrap().surface)
}

/// From the veins up to an order, written down a second time.
fn distance_cm(point: Vec3, order: u32) -> f64 {
    let (x, y) = (f64::from(point.x), f64::from(point.y));
    let midribs = [2.5, 5.0, 7.5].map(|at: f64| (y - at).abs()).into_iter().fold(10.0, f64::min);
    let to_piece = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2]| {
        let (dx, dy) = (bx - ax, by - ay);
        let share = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        (x - ax - share * dx).hypot(y - ay - share * dy)
    };
    match order {
        1 => midribs,
        _ => midribs.min(to_piece([1.0, 3.0], [3.0, 4.5])).min(to_piece([3.0, 4.5], [6.0, 3.5])),
    }
}

/// White up to half the reach from veins, black beyond.
fn near_veins(order: u32, width_cm: f32, use_as: Use) -> Control {
    let wrap = Wrap::Veins(AlongVeins { order, reach_cm: 2.0 * width_cm });
    Control { wrap, image: ControlImage::paint(1, 2, |_, height| height < 0.5), use_as }
}

#[test]
fn first_cells_near_veins_are_of_the_given_type_and_none_else() {
    let mesh = square_with_veins();
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [1.0, 0.0, 0.0],
        days: 0,
        ..without_relaxation()
    };
    for (order, width_cm) in [(1, 0.2), (2, 0.2), (1, 0.5), (2, 0.05)] {
        let control = near_veins(order, width_cm, Use::FOREGROUND);
        let mut growth = Growth::new(mesh.clone(), recipe.clone(), &[control], 1).unwrap();
        while growth.step() != Progress::Done {}
        let mut near = 0;
        for (cell, place) in growth.diary.lineage.iter().zip(&growth.diary.days[0].places) {
            let over = distance_cm(mesh.point(*place), order) - f64::from(width_cm);
            if over.abs() > 1e-5 {
                assert_eq!(cell.kind == Foreground, over < 0.0, "order {order}: {over} cm");
            }
            near += usize::from(cell.kind == Foreground);
        }
        // Three strips of 10 cm, twice as wide as the distance; 20,000 cells know their share to within
        // four standard errors.
        let share = near as f64 / 20_000.0;
        let strips = 3.0 * 2.0 * f64::from(width_cm) / 10.0;
        let error = (strips * (1.0 - strips) / 20_000.0).sqrt();
        match order {
            1 => assert!((share - strips).abs() < 4.0 * error, "{share} and not {strips}"),
            _ => assert!(share > strips + 4.0 * error, "{share}: the bent vein adds to {strips}"),
        }
    }
}

#[test]
fn cells_divide_sooner_near_veins_where_an_image_says_so() {
    let mesh = square_with_veins();
    let recipe = Recipe {
        initial_cells: 4_000,
        initial_probability: [1.0, 0.0, 0.0],
        clock: Clock::Exponential,
        division_days: [4.0; 3],
        days: 8,
        ..without_relaxation()
    };
    let number = Scaled::DivisionDays(Foreground);
    let slower = Use::Scale { number, black: 10.0, white: 1.0 };
    let mut control = near_veins(1, 0.6, slower);
    // Greys pass from pixel to pixel: 64 of them to 1.2 cm make a sharp border.
    control.image = ControlImage::paint(1, 64, |_, height| height < 0.5);
    let mut growth = Growth::new(mesh.clone(), recipe, &[control], 1).unwrap();
    while growth.step() != Progress::Done {}
    // Children stay where they are born, so that each place has the clans of its first cells.
    let mut cells = [[0.0; 2]; 2];
    for (row, day) in [0, 8].into_iter().enumerate() {
        for place in &growth.diary.days[day].places {
            let distance_cm = distance_cm(mesh.point(*place), 1);
            if (distance_cm - 0.6).abs() > 0.05 {
                cells[row][usize::from(distance_cm > 0.6)] += 1.0;
            }
        }
    }
    // Clans of an exponential clock have exp(days / division_days) cells in the mean, and as standard
    // deviation about as many; some 2,000 clans on each side.
    let grown = [0, 1].map(|side| cells[1][side] / cells[0][side]);
    for (grown, division_days) in grown.into_iter().zip([4.0, 40.0]) {
        let mean = (8.0_f64 / division_days).exp();
        assert!((grown / mean - 1.0).abs() < 5.0 / 1_700_f64.sqrt(), "{grown} for {mean}");
    }
}

#[test]
fn a_field_goes_along_the_nearest_vein() {
    let mesh = square_with_veins();
    for order in [1, 2] {
        let field = DirectionField::along_veins(&mesh, order).unwrap();
        let mut along_the_bend = 0;
        for triangle in 0..mesh.triangles.len() as u32 {
            let [x, y] = mesh.axes(triangle);
            let direction = x * field.at(triangle).x + y * field.at(triangle).y;
            let centre = mesh.centroid(triangle);
            if order == 1 || distance_cm(centre, 1) < distance_cm(centre, 2) + 1e-6 {
                assert!(direction.distance(Vec3::X) < 1e-5, "{direction} at {centre}");
            } else {
                // Up to the corner at x = 3, and down from there; next to it, one of the two.
                let ways = [Vec3::new(2.0, 1.5, 0.0), Vec3::new(3.0, -1.0, 0.0)];
                let off = ways.map(|way| direction.distance(way.normalize()));
                let nearer = if centre.x < 2.5 { off[0] } else { off[0].min(off[1]) };
                assert!(nearer < 1e-5, "{direction} at {centre}");
                along_the_bend += 1;
            }
        }
        assert!(order == 1 || along_the_bend > 10, "{along_the_bend} triangles");
    }
    assert_eq!(DirectionField::along_veins(&icosphere(1, 1.0), 3), None);
}
