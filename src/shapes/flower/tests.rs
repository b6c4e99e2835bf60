//! Flowers against exact sums, ends, turns and gaps, and petals that keep out of each other.

use super::bspline::{Stroke, Weights, control_points, through};
use super::cut::cut_share;
use super::opening::{Opening, joints};
use super::solve::Cholesky;
use super::template::{COLUMNS, ROWS, Template, round};
use super::{Arrangement, Flower, FlowerNumbers, Growth, PetalNumbers, SepalNumbers, Sepals};
use crate::surface::Body;
use glam::{DAffine2, DQuat, DVec2, DVec3, Vec3};

const LOTUS: &str = include_str!("../../../examples/flowers/lotus.json");
const TIGER_LILY: &str = include_str!("../../../examples/flowers/tiger_lily.json");

fn near(found: f64, exact: f64) {
    assert!((found - exact).abs() < 1e-9 * exact.abs().max(1.0), "{found}, not {exact}");
}

fn all_near(found: &[DVec3], exact: &[DVec3]) {
    assert_eq!(found.len(), exact.len());
    for (a, b) in found.iter().zip(exact) {
        assert!(a.distance(*b) < 1e-9, "{a}, not {b}");
    }
}

/// A lily without chance.
fn even() -> FlowerNumbers {
    FlowerNumbers { irregularity: 0.0, ..FlowerNumbers::default() }
}

#[test]
fn weights_of_a_spline_sum_to_one_and_it_begins_and_ends_in_control_points() {
    for count in 4..12 {
        for step in 0..=100 {
            let weights = Weights::at(count, f64::from(step) / 100.0);
            assert!(weights.first + 4 <= count);
            near(weights.of.iter().sum(), 1.0);
        }
        let values = |k: usize| (k * k) as f64;
        near(Weights::at(count, 0.0).sum(values), 0.0);
        near(Weights::at(count, 1.0).sum(values), values(count - 1));
        // At an inner control point: a sixth, two thirds, a sixth.
        let inner = Weights::at(count, 1.0 / (count - 1) as f64).sum(values);
        near(inner, (values(0) + 4.0 * values(1) + values(2)) / 6.0);
    }
}

#[test]
fn a_moved_and_sheared_stroke_is_the_stroke_moved_and_sheared() {
    let line = [[0.0, 0.0], [1.0, 2.0], [-0.5, 3.0], [2.0, 4.5], [2.5, 7.0]];
    let affine =
        DAffine2::from_cols(DVec2::new(1.3, -0.4), DVec2::new(0.6, 0.9), DVec2::new(-7.0, 2.0));
    let moved = line.map(|p| affine.transform_point2(p.into()).to_array());
    for step in 0..=40 {
        let weights = Weights::at(line.len(), f64::from(step) / 40.0);
        let of = |line: &[[f64; 2]]| weights.sum(|k| DVec2::from(line[k]));
        assert!(of(&moved).distance(affine.transform_point2(of(&line))) < 1e-12);
    }
    // A straight one is as long as it is, and evenly timed.
    let straight = Stroke::new(&[[1.0, 1.0], [4.0, 5.0]]);
    near(straight.length_cm(), 5.0);
    let (point, direction) = straight.at(2.0);
    assert!(point.distance(DVec2::new(2.2, 2.6)) < 1e-9);
    assert!(direction.distance(DVec2::new(0.6, 0.8)) < 1e-9);
}

#[test]
fn splines_go_through_their_points() {
    let points: Vec<DVec3> = (0..7).map(|k| DVec3::new(k as f64, (k * k) as f64, 3.0)).collect();
    let mut control = points.clone();
    control_points(&mut control);
    for (k, point) in points.iter().enumerate() {
        let at = Weights::at(7, k as f64 / 6.0).sum(|k| control[k]);
        assert!(at.distance(*point) < 1e-9, "{k}");
    }
    // A cubic with straight ends over two pieces: s(x) = (3 x - x^3) / 2 up to 1, and back.
    let knots = [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)];
    for x in [0.0, 0.3, 0.8, 1.0] {
        near(through(&knots, x), (3.0 * x - x * x * x) / 2.0);
        near(through(&knots, 2.0 - x), (3.0 * x - x * x * x) / 2.0);
    }
}

#[test]
fn strokes_on_the_table_make_a_flat_petal() {
    let numbers = PetalNumbers { cross: Vec::new(), wave_cm: 0.0, ..PetalNumbers::default() };
    let template = Template::new(&numbers);
    assert!(template.flat.iter().all(|p| p.z == 0.0));
    // Rows are in equal steps along, and the points of each in equal steps across.
    for row in 0..ROWS {
        near(template.flat[row * COLUMNS + 2].y, 11.2 * row as f64 / 8.0);
        let points = &template.flat[row * COLUMNS..][..COLUMNS];
        for k in [1, 3] {
            assert!((points[k] * 2.0 - points[k - 1] - points[k + 1]).length() < 1e-12);
        }
    }
}

#[test]
fn a_cross_stroke_lifts_its_row_and_leaves_foot_and_tip() {
    let mut numbers = PetalNumbers { wave_cm: 0.0, ..PetalNumbers::default() };
    numbers.cross[0].at = 0.52;
    numbers.cross[0].lift_cm = vec![[-1.0, 0.8], [0.0, 0.2], [1.0, 0.4]];
    let flat = Template::new(&numbers).flat;
    let heights =
        |row: usize| -> Vec<f64> { flat[row * COLUMNS..][..COLUMNS].iter().map(|p| p.z).collect() };
    for (found, exact) in heights(4).into_iter().zip([0.8, 0.5, 0.2, 0.3, 0.4]) {
        near(found, exact);
    }
    assert!(heights(0).iter().chain(&heights(8)).all(|&z| z == 0.0));
    // A quarter of the way up the spline of the middle stands at 11/16.
    near(heights(2)[0], 0.8 * 11.0 / 16.0);
}

#[test]
fn growth_has_its_closed_forms() {
    for g in [3.0, 6.0, 9.0] {
        let growth = Growth { least: 0.4, change: 2.5, g, days: 8.0 };
        near(growth.at(0.0), 0.4);
        near(growth.at(4.0), 0.4 + g * 2.5 / 12.0);
        near(growth.at(8.0), 0.4 + g * 2.5 / 6.0);
        let slope = |day: f64| (growth.at(day + 1e-5) - growth.at(day - 1e-5)) / 2e-5;
        assert!((slope(4.0) - g * 2.5 / 32.0).abs() < 1e-6, "steepest in the middle");
        assert!(slope(1e-5).abs() < 1e-4 && slope(8.0 - 1e-5).abs() < 1e-4, "flat at both ends");
        for step in 1..=80 {
            assert!(growth.at(f64::from(step) / 10.0) > growth.at(f64::from(step - 1) / 10.0));
        }
    }
    // Only 6 ends with the whole.
    assert_eq!(Growth::share(6.0).at(1.0), 1.0);
}

/// A flat sheet of unit squares with its foot along the x axis.
fn squares() -> Vec<DVec3> {
    (0..ROWS * COLUMNS)
        .map(|k| DVec3::new((k % COLUMNS) as f64, (k / COLUMNS) as f64, 0.0))
        .collect()
}

#[test]
fn cells_turn_evenly_and_grow_evenly() {
    let turned = |angle: f64| -> Vec<DVec3> {
        squares().iter().map(|&p| DQuat::from_rotation_x(angle) * p).collect()
    };
    let joints = joints();
    for theta in [0.3, 1.7, 3.0] {
        let opening = Opening::new(squares(), turned(theta));
        opening.angles().for_each(|angle| near(angle, theta));
        for share in [0.25, 0.5, 0.9] {
            all_near(&opening.at(&joints, &[share; ROWS]), &turned(share * theta));
        }
    }
    let larger: Vec<DVec3> = squares().iter().map(|p| p * 3.0).collect();
    let opening = Opening::new(squares(), larger);
    let half: Vec<DVec3> = squares().iter().map(|p| p * 2.0).collect();
    all_near(&opening.at(&joints, &[0.5; ROWS]), &half);
}

#[test]
fn a_sheet_may_curl_by_more_than_half_a_turn() {
    // A strip round a cylinder: each row of cells is turned by an even angle more than the one below.
    let curled = |step: f64| -> Vec<DVec3> {
        let mut foot = DVec3::ZERO;
        let mut sheet = Vec::new();
        for row in 0..ROWS {
            sheet.extend((0..COLUMNS).map(|c| foot + DVec3::X * c as f64));
            let angle = step * (row as f64 + 0.5);
            foot += DQuat::from_rotation_x(angle) * DVec3::Y;
        }
        sheet
    };
    let step = 0.6;
    let opening = Opening::new(curled(0.0), curled(step));
    for (cell, angle) in opening.angles().enumerate() {
        near(angle, step * ((cell / (COLUMNS - 1)) as f64 + 0.5));
    }
    all_near(&opening.at(&joints(), &[0.5; ROWS]), &curled(0.5 * step));
}

#[test]
fn sums_of_squares_are_solved() {
    let matrix = [4.0, 0.0, 0.0, 0.0, 9.0, 0.0, 2.0, 3.0, 11.0];
    let solved = Cholesky::new(3, matrix.to_vec());
    let exact = [DVec3::new(1.0, -2.0, 0.5), DVec3::new(0.0, 3.0, 7.0), DVec3::ONE];
    let full = [[4.0, 0.0, 2.0], [0.0, 9.0, 3.0], [2.0, 3.0, 11.0]];
    let mut side = full.map(|row| (0..3).map(|k| exact[k] * row[k]).sum::<DVec3>());
    solved.solve(&mut side);
    all_near(&side, &exact);
}

#[test]
fn the_first_and_the_last_moment_are_the_two_that_were_drawn() {
    for text in ["{}", LOTUS, TIGER_LILY] {
        let flower = Flower::new(&FlowerNumbers::from_json(text).unwrap(), 3).unwrap();
        let joints = joints();
        let growth = Growth::share(6.0);
        for (time, shortly) in [(0.0, 1e-6), (1.0, 1.0 - 1e-6)] {
            let exact = flower.petals.sheets(&joints, &growth, time);
            let other = flower.petals.sheets(&joints, &growth, shortly);
            for ((petal, sheet), soon) in flower.petals.petals.iter().zip(exact).zip(other) {
                let drawn = if time == 0.0 { &petal.opening.bud } else { &petal.opening.open };
                assert_eq!(&sheet, drawn);
                assert!(sheet.iter().zip(&soon).all(|(a, b)| a.distance(*b) < 1e-9));
            }
        }
        assert_eq!(flower.at(1.0), flower.mesh().positions);
    }
}

#[test]
fn each_vein_is_the_first_one_turned() {
    let mut numbers = even();
    numbers.petals.arrangement = Arrangement::Spiral { count: 8, divergence_deg: 137.507_764 };
    numbers.petals.nest = 0.0;
    numbers.petals.outer_turn_deg = 0.0;
    numbers.petals.inner_lag = 0.0;
    (numbers.petals.inner_width, numbers.petals.inner_length) = (1.0, 1.0);
    let flower = Flower::new(&numbers, 1).unwrap();
    let joints = joints();
    for time in [0.0, 0.4, 0.7, 1.0] {
        let sheets: Vec<_> = flower.petals.sheets(&joints, &Growth::share(6.0), time).collect();
        for (j, sheet) in sheets.iter().enumerate() {
            // From x to z is a turn to the left of one about y.
            let turn = DQuat::from_rotation_y(-(137.507_764 * j as f64).to_radians());
            let vein = |sheet: &[DVec3]| -> Vec<DVec3> {
                sheet.iter().skip(2).step_by(COLUMNS).copied().collect()
            };
            let first: Vec<DVec3> = vein(&sheets[0]).into_iter().map(|p| turn * p).collect();
            all_near(&vein(sheet), &first);
        }
    }
}

#[test]
fn petals_stand_even_in_circles_and_at_few_gaps_in_spirals() {
    let gaps = |arrangement: Arrangement| -> Vec<f64> {
        let mut places: Vec<f64> =
            arrangement.places().iter().map(|place| place.0.rem_euclid(360.0)).collect();
        places.sort_by(f64::total_cmp);
        let next = places.iter().skip(1).copied().chain([places[0] + 360.0]);
        let mut gaps: Vec<f64> = places.iter().zip(next).map(|(a, b)| b - a).collect();
        gaps.sort_by(f64::total_cmp);
        gaps.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        gaps
    };
    for (count, exact) in [
        (5, &[52.52, 84.98][..]),
        (6, &[32.46, 52.52, 84.98]),
        (8, &[32.46, 52.52]),
        (13, &[20.06, 32.46]),
        (21, &[12.40, 20.06]),
    ] {
        let found = gaps(Arrangement::Spiral { count, divergence_deg: 137.507_764 });
        assert_eq!(found.len(), exact.len(), "{count}: {found:?}");
        assert!(found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 0.006), "{count}: {found:?}");
    }
    assert_eq!(gaps(Arrangement::Whorls(vec![3, 3])), [60.0]);
    let ranks: Vec<f64> =
        Arrangement::Whorls(vec![3, 3]).places().iter().map(|place| place.1).collect();
    assert_eq!(ranks, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
}

#[test]
fn a_flower_is_a_body_with_leaf_coordinates() {
    for text in ["{}", LOTUS, TIGER_LILY] {
        let flower = Flower::new(&FlowerNumbers::from_json(text).unwrap(), 1).unwrap();
        let mesh = flower.mesh();
        assert_eq!(mesh.uvs.len(), mesh.positions.len());
        let lowest = mesh.positions.iter().map(|p| p.y).fold(9.0, f32::min);
        assert!(lowest.abs() < 1e-3, "the pedicel stands on the ground: {lowest}");
        let body = Body::new(&mesh.refined(1)).unwrap();
        body.surface.check().unwrap();
        assert_eq!(body.surface.part_count(), flower.petals.petals.len());
        // The texture is not mirrored on the inner side.
        for t in &body.surface.triangles {
            let [a, b, c] = t.map(|v| body.surface.uvs[v as usize]);
            assert!((b - a).perp_dot(c - a) > 0.0);
        }
        let area = f64::from(Body::new(&mesh).unwrap().surface.area);
        assert!((area / flower.area_cm2(1.0) - 1.0).abs() < 0.02, "{area}");
    }
}

#[test]
fn another_individual_is_another_flower_of_the_same_kind() {
    let numbers = FlowerNumbers::default();
    let of = |individual| Flower::new(&numbers, individual).unwrap().at(0.6);
    assert_eq!(of(7), of(7));
    assert_ne!(of(7), of(8));
    let plain = |individual| Flower::new(&even(), individual).unwrap().at(0.6);
    assert_eq!(plain(7), plain(8));
    for (a, b) in of(7).into_iter().zip(of(8)) {
        assert!(a.distance(b) < 2.0);
    }
}

#[test]
fn petals_do_not_pass_through_each_other() {
    for (text, individual) in [("{}", 1), ("{}", 2), (LOTUS, 1), (LOTUS, 2), (TIGER_LILY, 1)] {
        let mut numbers = FlowerNumbers::from_json(text).unwrap();
        for count in [0, 3, 5] {
            numbers.sepals =
                Some(Sepals::Around(SepalNumbers { count, ..SepalNumbers::default() }));
            let flower = Flower::new(&numbers, individual).unwrap();
            let cuts = (0..=20).map(|moment| cut_at(&flower, f64::from(moment) / 20.0));
            let most = cuts.fold(0.0, f64::max);
            println!("{most:.5} of {count} sepals and the petals of {}", numbers.open_day);
            assert!(most < 0.005, "{most} is cut with {count} sepals, {text}");
        }
    }
}

#[test]
fn sepals_close_around_the_bud_and_open_before_the_petals() {
    let numbers =
        FlowerNumbers::from_json(r#"{"sepals": {"count": 3, "length": 0.5}, "nod_deg": 0}"#)
            .unwrap();
    let flower = Flower::new(&numbers, 1).unwrap();
    let (joints, growth) = (joints(), Growth::share(6.0));
    let sepals = flower.sepals.as_ref().unwrap();
    let out = |sheets: Vec<Vec<DVec3>>, row: usize| {
        let veins = sheets.iter().map(|sheet| sheet[row * COLUMNS + 2]);
        veins.map(|p| p.x.hypot(p.z)).fold(0.0, f64::max)
    };
    // In the bud their middles lie close outside the petals, half-way up.
    let bud = out(sepals.sheets(&joints, &growth, 0.0).collect(), ROWS - 1);
    let petals = out(flower.petals.sheets(&joints, &growth, 0.0).collect(), ROWS / 2);
    assert!(bud > petals && bud < 1.15 * petals, "{bud} around {petals}");
    // They are open before the petals, whose foot is after nine tenths of eight tenths of the time.
    let last: Vec<_> = sepals.sheets(&joints, &growth, 0.72 * 0.8 + 1e-9).collect();
    let open: Vec<_> = sepals.petals.iter().map(|sepal| sepal.opening.open.clone()).collect();
    assert_eq!(last, open);
    // All else is as without them.
    let bare = Flower::new(&FlowerNumbers { sepals: None, ..numbers }, 1).unwrap();
    let (with, without) = (flower.mesh(), bare.mesh());
    let petals = bare.petals.petals.iter().map(|petal| petal.layout.corners.len()).sum::<usize>();
    assert_eq!(with.positions[..petals], without.positions[..petals]);
    let is_sepal = |group: &crate::surface::Group| group.material == "bare:sepal";
    assert_eq!(with.groups.iter().filter(|group| is_sepal(group)).count(), 3);
}

#[test]
fn the_measure_of_cuts_finds_what_is_cut() {
    let mut numbers = even();
    numbers.petals.lean = 0.0;
    numbers.petals.bud_deg = 90.0;
    // Petals of a circle overlap by 60 degrees of their 180, all in one place.
    let cut = cut_at(&Flower::new(&numbers, 1).unwrap(), 0.0);
    assert!(cut > 0.1, "{cut}");
}

/// The share of all petals, in fine triangles, that is cut at a time.
fn cut_at(flower: &Flower, time: f64) -> f64 {
    const ACROSS: usize = 12;
    const ALONG: usize = 24;
    let mut triangles: Vec<([Vec3; 3], u32)> = Vec::new();
    let (joints, growth) = (joints(), Growth::share(6.0));
    let perianths = [Some(&flower.petals), flower.sepals.as_ref()].into_iter().flatten();
    let sheets = perianths.flat_map(|all| all.sheets(&joints, &growth, time)).collect::<Vec<_>>();
    for (petal, sheet) in (0..).zip(&sheets) {
        let at = |column: usize, row: usize| {
            let across = Weights::at(COLUMNS, column as f64 / ACROSS as f64);
            let along = Weights::at(ROWS, row as f64 / ALONG as f64);
            along.sum(|row| across.sum(|column| sheet[row * COLUMNS + column])).as_vec3()
        };
        for (column, row) in (0..ACROSS).flat_map(|c| (0..ALONG).map(move |r| (c, r))) {
            let [a, b, c, d] =
                [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| at(column + x, row + y));
            triangles.extend([([a, b, c], petal), ([b, d, c], petal)]);
        }
    }
    cut_share(triangles)
}

#[test]
fn round_goes_from_x_to_z() {
    let quarter = round(std::f64::consts::FRAC_PI_2, DVec2::new(2.0, 5.0));
    assert!(quarter.distance(DVec3::new(0.0, 5.0, 2.0)) < 1e-12);
}
