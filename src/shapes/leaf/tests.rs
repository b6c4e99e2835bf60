//! Leaves against exact lengths, counts, shares and symmetry.

use super::{Border, Leaf, LeafNumbers, LeafPlan, Length, Limb};
use crate::surface::{Body, NO_TWIN, PolygonMesh};
use glam::DVec2;

/// A leaf without chance, flat, with straight sides.
fn plain(lobes: u32, nodes: u32) -> LeafNumbers {
    LeafNumbers {
        lobes,
        nodes,
        nodes_kept: 1.0,
        base: 1.0,
        tip: 1.0,
        secondary_deg: 40.0,
        lobe_deg: 50.0,
        length: Length::Logarithmic { a_cm: 0.75, b_cm: -0.1 },
        secondary_scale: 1.0,
        border: Border::Polygon,
        irregularity: 0.0,
        fold_deg: 0.0,
        curl_deg: 0.0,
        wave_cm: 0.0,
        ..LeafNumbers::default()
    }
}

fn plan(numbers: &LeafNumbers) -> LeafPlan {
    LeafPlan::new(numbers, 1).unwrap()
}

fn near(found: f64, exact: f64) {
    assert!((found - exact).abs() < 1e-9 * exact.abs().max(1.0), "{found}, not {exact}");
}

/// A grid of points over a square around the leafstalk, and the area that each stands for.
fn grid(reach: f64) -> (impl Iterator<Item = DVec2>, f64) {
    const SIDE: i32 = 700;
    let step = reach / f64::from(SIDE);
    let points = (-SIDE..SIDE).flat_map(move |i| {
        // Not on any axis of symmetry.
        (-SIDE..SIDE).map(move |j| DVec2::new(f64::from(i) + 0.37, f64::from(j) + 0.61) * step)
    });
    (points, step * step)
}

#[test]
fn main_veins_are_as_long_as_their_law_says() {
    let factorial: f64 = (1..=13).map(f64::from).product();
    for (length, exact) in [
        (Length::Constant { b_cm: 0.7 }, 12.0 * 0.7),
        (Length::Linear { a_cm: 0.2, b_cm: 0.3 }, 0.2 * 12.0 * 13.0 / 2.0 + 12.0 * 0.3),
        (Length::Logarithmic { a_cm: 0.9, b_cm: -0.1 }, 0.9 * factorial.ln() - 12.0 * 0.1),
    ] {
        let plan = plan(&LeafNumbers { length, ..plain(1, 12) });
        near(*plan.lobes[0].feet.last().unwrap(), exact);
        // Each secondary vein is as long as the piece of the main vein that starts with it.
        let secondary: f64 = (1..12).map(|steps| length.of(steps)).sum();
        near(plan.vein_length(), exact + 2.0 * secondary);
    }
}

#[test]
fn veins_and_corners_are_as_many_as_nodes_say() {
    for (lobes, nodes, nodes_kept) in [(1, 2, 1.0), (1, 9, 1.0), (5, 8, 1.0), (7, 10, 0.7)] {
        let numbers = LeafNumbers { nodes_kept, ..plain(lobes, nodes) };
        let plan = plan(&numbers);
        let mut secondary = 0;
        for lobe in &plan.lobes {
            let exact = f64::from(nodes) * nodes_kept.powi(lobe.place.abs());
            let nodes = (exact.round() as usize).max(2);
            assert_eq!(lobe.feet.len(), nodes + 1);
            assert_eq!(lobe.outline(&lobe.corners).len(), 2 * nodes);
            secondary += 2 * (nodes - 1);
        }
        assert_eq!(plan.lobes.len(), lobes as usize);
        assert_eq!(plan.veins.len(), lobes as usize + secondary);
    }
    assert_eq!(Limb::straight(&plan(&plain(1, 9))).corners(), 18);
}

#[test]
fn lobes_stand_at_even_angles() {
    for (lobes, lobe_deg) in [(5u32, 40.0), (7, 30.0), (9, 40.0)] {
        let plan = plan(&LeafNumbers { lobe_deg, ..plain(lobes, 6) });
        let last = plan.lobes.last().unwrap();
        let exact = (lobe_deg * f64::from(lobes - 1) / 2.0).to_radians();
        near(last.axis.x, exact.sin());
        near(last.axis.y, exact.cos());
        // It closes around the leafstalk where lobes go all the way round.
        let limb = Limb::new(&plan);
        let behind = DVec2::new(0.0, -0.01);
        assert_eq!(contains(&limb, behind), lobe_deg * f64::from(lobes) >= 360.0);
    }
}

fn contains(limb: &Limb, p: DVec2) -> bool {
    let crossed = |outline: &Vec<DVec2>| {
        let next = outline.iter().cycle().skip(1);
        let over = outline.iter().zip(next).filter(|(a, b)| {
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        });
        over.count()
    };
    limb.outlines.iter().map(crossed).sum::<usize>() % 2 == 1
}

#[test]
fn ratios_are_those_of_the_points_that_they_were_made_from() {
    let numbers = plain(1, 7);
    let plan = plan(&numbers);
    let lobe = &plan.lobes[0];
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        // The first side lies on a ray from the leafstalk.
        for ends in lobe.corners[side].windows(2).skip(1) {
            for [share, ratio] in [[0.3, 0.2], [0.7, 0.55], [0.5, 0.999]] {
                let border = ends[0] + (ends[1] - ends[0]) * share;
                // A homothety from the leafstalk.
                let at = plan.coordinates(lobe.point(sign * border.x * ratio, border.y * ratio));
                near(at.homothety, ratio);
                assert_eq!(at.right, side == 1);
                // An affinity whose axis is the main vein, along the secondary veins.
                let out = border.x / lobe.secondary.x;
                let inner = border - lobe.secondary * (out * (1.0 - ratio));
                let at = plan.coordinates(lobe.point(sign * inner.x, inner.y));
                near(at.affinity, ratio);
            }
        }
    }
    assert_eq!(plan.coordinates(DVec2::ZERO).homothety, 0.0);
    assert_eq!(plan.coordinates(DVec2::new(0.0, 1.0)).affinity, 0.0);
}

#[test]
fn bands_have_the_shares_of_the_area_that_affinity_and_homothety_give_them() {
    let one = plain(1, 7);
    let many = LeafNumbers { lobe_deg: 55.0, nodes_kept: 0.8, ..plain(5, 7) };
    for numbers in [one, many] {
        let plan = plan(&numbers);
        let limb = Limb::new(&plan);
        let (points, each) = grid(15.0);
        let (mut all, mut nearer, mut inner) = (0.0, 0.0, 0.0);
        for p in points.filter(|&p| contains(&limb, p)) {
            let at = plan.coordinates(p);
            all += each;
            nearer += if (0.3..0.7).contains(&at.homothety) { each } else { 0.0 };
            inner += if (0.2..0.5).contains(&at.affinity) { each } else { 0.0 };
        }
        // What a grid tells of an area is wrong by less than half a cell for each cell that the border passes.
        let close = |found: f64, exact: f64| {
            assert!((found / exact - 1.0).abs() < 5e-3, "{found}, {exact}")
        };
        close(all, limb.area());
        close(nearer / all, 0.7 * 0.7 - 0.3 * 0.3);
        if numbers.lobes == 1 {
            close(inner / all, 0.5 - 0.2);
        }
    }
}

#[test]
fn a_leaf_without_chance_is_its_own_mirror_image() {
    for border in [Border::Polygon, Border::Smooth, Border::Toothed { tooth_deg: 20.0 }] {
        let numbers = LeafNumbers { border, nodes_kept: 0.8, lobe_deg: 85.0, ..plain(5, 8) };
        let plan = plan(&numbers);
        let mirror = |p: DVec2| DVec2::new(-p.x, p.y);
        for vein in &plan.veins {
            let lobe = 4 - vein.lobe;
            let other = plan
                .veins
                .iter()
                .find(|v| {
                    v.lobe == lobe
                        && v.node == vein.node
                        && v.right == vein.right.map(|right| !right)
                })
                .unwrap();
            let mirrored: Vec<DVec2> = vein.path.iter().copied().map(mirror).collect();
            assert_eq!(other.path, mirrored, "{vein:?}");
        }
        for (lobe, other) in plan.lobes.iter().zip(plan.lobes.iter().rev()) {
            assert_eq!(lobe.sides[0], other.sides[1]);
            for p in lobe.sides[0].iter().chain(&lobe.sides[1]) {
                let p = lobe.point(0.9 * p.x, 0.9 * p.y);
                let [here, there] = [p, mirror(p)].map(|p| plan.coordinates(p));
                assert_eq!((here.affinity, here.homothety), (there.affinity, there.homothety));
            }
        }
        let right: f64 = half_area(&Limb::new(&plan), 1.0);
        let left: f64 = half_area(&Limb::new(&plan), -1.0);
        assert!((right - left).abs() < 1e-5 * right, "{right} {left}");
    }
    let chance = LeafNumbers { irregularity: 0.2, ..plain(3, 6) };
    let plans = [1, 1, 2].map(|individual| LeafPlan::new(&chance, individual).unwrap().veins);
    assert!(plans[0] == plans[1] && plans[0] != plans[2]);
}

/// The integral of `|x|` over one half, from the border alone.
fn half_area(limb: &Limb, sign: f64) -> f64 {
    let mut sum = 0.0;
    for outline in &limb.outlines {
        for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let [p, q] = [a.x * sign, b.x * sign].map(|x| x.max(0.0));
            // A side that crosses the middle is cut there.
            let share = if (a.x > 0.0) == (b.x > 0.0) { 1.0 } else { p.max(q) / (b.x - a.x).abs() };
            sum += sign * (b.y - a.y) * share * (p * p + p * q + q * q) / 6.0;
        }
    }
    sum
}

#[test]
fn veins_of_different_lobes_do_not_cross() {
    for lobe_deg in [20.0, 35.0, 50.0, 75.0, 120.0] {
        let numbers =
            LeafNumbers { lobe_deg, secondary_scale: 1.6, nodes_kept: 0.9, ..plain(5, 8) };
        let plan = plan(&numbers);
        let pieces: Vec<(u32, [DVec2; 2])> = plan
            .veins
            .iter()
            .flat_map(|vein| vein.path.windows(2).map(|ends| (vein.lobe, [ends[0], ends[1]])))
            .collect();
        let is_main = |k: usize| k < 5 * 8;
        for (i, (lobe, [a, b])) in pieces.iter().enumerate() {
            for (j, (other, [c, d])) in pieces.iter().enumerate().skip(i + 1) {
                let sides = |a: DVec2, b: DVec2, c: DVec2, d: DVec2| {
                    (b - a).perp_dot(c - a) * (b - a).perp_dot(d - a)
                };
                let apart = 1e-9;
                let crosses = sides(*a, *b, *c, *d) < -apart && sides(*c, *d, *a, *b) < -apart;
                // Main veins meet behind the leafstalk where lobes go more than all the way round.
                let both_main = is_main(i) && is_main(j);
                assert!(lobe == other || !crosses || both_main, "{lobe_deg}: {i} and {j}");
            }
        }
    }
    // Neighbours far apart lose nothing, those close by do.
    let length = |lobes, lobe_deg| {
        plan(&LeafNumbers { lobe_deg, secondary_scale: 2.0, ..plain(lobes, 8) }).vein_length()
    };
    near(length(3, 110.0), 3.0 * length(1, 110.0));
    assert!(length(3, 20.0) < 0.9 * length(3, 110.0));
}

#[test]
fn triangles_fill_the_limb_and_veins_are_their_sides() {
    for numbers in [
        LeafNumbers { triangles: 3000, ..plain(1, 9) },
        LeafNumbers { triangles: 3000, ..LeafNumbers::default() },
        LeafNumbers { triangles: 2000, lobe_deg: 120.0, nodes: 4, ..plain(3, 4) },
        LeafNumbers { lobes: 9, lobe_deg: 40.0, border: Border::Smooth, ..LeafNumbers::default() },
    ] {
        let leaf = Leaf::new(&numbers, 3).unwrap();
        let corners = |t: &[u32; 3]| t.map(|k| leaf.points[k as usize]);
        let area: f64 = leaf
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = corners(t);
                let area = 0.5 * (b - a).perp_dot(c - a);
                assert!(area > 0.0);
                area
            })
            .sum();
        assert!((area / leaf.limb.area() - 1.0).abs() < 1e-9, "{area}");
        let share = leaf.triangles.len() as f64 / f64::from(numbers.triangles);
        assert!((0.6..1.7).contains(&share), "{} triangles", leaf.triangles.len());
        for at in &leaf.coordinates {
            assert!((0.0..=1.0).contains(&at.affinity) && (0.0..=1.0).contains(&at.homothety));
        }
        let body = Body::new(&leaf.mesh()).unwrap();
        body.surface.check().unwrap();
        assert_eq!(body.surface.part_count(), leaf.limb.outlines.len());
        // The midrib of the middle is a line of corners, joined by sides.
        let along: Vec<u32> = {
            let axis = leaf.plan.lobes[leaf.plan.lobes.len() / 2].axis;
            let tip = leaf.plan.lobes[leaf.plan.lobes.len() / 2].feet.last().unwrap();
            let mut on: Vec<(f64, u32)> = (0..)
                .zip(&leaf.points)
                .filter(|(_, p)| axis.perp_dot(**p).abs() < 1e-9)
                .map(|(k, p)| (axis.dot(*p), k))
                .filter(|(along, _)| (0.0..=*tip).contains(along))
                .collect();
            on.sort_by(|a, b| a.0.total_cmp(&b.0));
            on.into_iter().map(|(_, k)| k).collect()
        };
        assert!(along.len() > numbers.nodes as usize);
        for pair in along.windows(2) {
            let joined = |t: &[u32; 3]| t.contains(&pair[0]) && t.contains(&pair[1]);
            assert!(leaf.triangles.iter().any(joined), "{pair:?} of {along:?}");
        }
    }
}

#[test]
fn folding_and_bending_keep_areas() {
    let area = |numbers: &LeafNumbers| {
        f64::from(Body::new(&Leaf::new(numbers, 1).unwrap().mesh()).unwrap().surface.area)
    };
    let flat = LeafNumbers { triangles: 8000, petiole_cm: 0.0, ..plain(1, 9) };
    let exact = Leaf::new(&flat, 1).unwrap().limb.area();
    assert!((area(&flat) / exact - 1.0).abs() < 1e-5);
    assert!((area(&LeafNumbers { fold_deg: 35.0, ..flat.clone() }) / exact - 1.0).abs() < 1e-5);
    // Chords of an arc of 2.6 radians, about 90 of them: short by (2.6 / 90)^2 / 24.
    let bent = area(&LeafNumbers { curl_deg: 150.0, ..flat.clone() });
    assert!(bent < exact && (bent / exact - 1.0).abs() < 2e-4, "{bent} {exact}");
    assert!(area(&LeafNumbers { wave_cm: 0.5, waves: 6.0, ..flat }) > 1.01 * exact);
}

#[test]
fn an_underside_closes_the_blade() {
    let numbers = LeafNumbers { thickness_cm: 0.05, ..LeafNumbers::default() };
    let mesh = Leaf::new(&numbers, 1).unwrap().mesh();
    assert_eq!(PolygonMesh::parse(&mesh.to_obj()).unwrap(), mesh);
    let materials: Vec<&str> = mesh.groups.iter().map(|group| group.material.as_str()).collect();
    assert_eq!(materials, ["blade", "bare:underside", "bare:vein", "bare:petiole"]);
    let mut both = mesh.clone();
    both.faces.retain(|face| face.group < 2);
    both.groups.truncate(2);
    both.groups[1].material = "blade".into();
    let closed = Body::new(&both).unwrap().surface;
    assert!(closed.twins.iter().all(|&twin| twin != NO_TWIN));
}

#[test]
fn any_numbers_within_their_ranges_make_a_leaf() {
    let mut state = 5u64;
    let mut number = |low: f64, high: f64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        // Ends of ranges more often than by chance.
        match state >> 61 {
            0 => low,
            1 => high,
            _ => low + (high - low) * ((state >> 11) as f64 / (1u64 << 53) as f64),
        }
    };
    for k in 0..300 {
        let mut share = || number(0.0, 1.0);
        let [a, b, pick, kind] = [share(), share(), share(), share()];
        let numbers = LeafNumbers {
            lobes: 2 * number(0.0, 7.0) as u32 + 1,
            nodes: number(2.0, 40.0) as u32,
            nodes_kept: number(0.3, 1.0),
            lobe_deg: number(5.0, 180.0),
            secondary_deg: number(10.0, 150.0),
            length: match (3.0 * pick) as u32 {
                0 => Length::Constant { b_cm: 0.01 + 20.0 * b * 0.999 },
                1 => Length::Linear { a_cm: 20.0 * a, b_cm: 0.01 + b },
                _ => Length::Logarithmic { a_cm: 20.0 * a, b_cm: 0.01 + b },
            },
            secondary_scale: number(0.1, 10.0),
            base: number(0.0, 1.0),
            tip: number(0.0, 1.0),
            border_factor: number(1.0, 2.0),
            border: match (3.0 * kind) as u32 {
                0 => Border::Polygon,
                1 => Border::Smooth,
                _ => Border::Toothed { tooth_deg: number(-45.0, 45.0) },
            },
            irregularity: number(0.0, 0.5),
            triangles: number(50.0, 1500.0) as u32,
            fold_deg: number(0.0, 80.0),
            curl_deg: number(-300.0, 300.0),
            wave_cm: number(0.0, 5.0),
            waves: number(0.0, 20.0),
            thickness_cm: number(0.0, 1.0),
            ..LeafNumbers::default()
        };
        let leaf = Leaf::new(&numbers, k).unwrap();
        let corners = |t: &[u32; 3]| t.map(|k| leaf.points[k as usize]);
        let of_triangle = |[a, b, c]: [DVec2; 3]| 0.5 * (b - a).perp_dot(c - a);
        let area: f64 = leaf.triangles.iter().map(|t| of_triangle(corners(t))).sum();
        assert!(
            (area / leaf.limb.area() - 1.0).abs() < 1e-6,
            "{area}, {}: {numbers:?}",
            leaf.limb.area()
        );
        let mesh = leaf.mesh();
        assert!(mesh.positions.iter().all(|p| p.is_finite()), "{numbers:?}");
        Body::new(&mesh).unwrap().surface.check().unwrap();
    }
}
