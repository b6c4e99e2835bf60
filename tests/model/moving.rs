//! Bodies that move: what growth and bending do to a pattern, and what they leave alone.

use crate::meshes::{flat, icosphere, sheet};
use crate::{grow, grow_along, without_relaxation};
use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants;
use clonal_mosaic::surface::{Body, DirectionField, Guide, Mesh, Moment, Motion, PolygonMesh};
use clonal_mosaic::tissue::{Diary, Recipe};
use glam::{Vec2, Vec3};
use std::sync::Arc;

const DAYS: u32 = 8;

fn recipe() -> Recipe {
    Recipe { initial_cells: 600, division_days: [4.0, 6.0, 5.0], days: DAYS, ..Recipe::default() }
}

/// A mesh whose corners are moved so on these days.
fn moving(mesh: &Mesh, moments: &[(f32, &dyn Fn(Vec3) -> Vec3)]) -> Arc<Mesh> {
    let moment = |&(day, to): &(f32, &dyn Fn(Vec3) -> Vec3)| Moment {
        day,
        positions: mesh.positions.iter().map(|&p| to(p)).collect(),
    };
    Arc::new(Mesh { motion: Motion::new(moments.iter().map(moment).collect()), ..mesh.clone() })
}

fn fingerprints(diary: &Diary) -> Vec<String> {
    (0..diary.days.len()).map(|day| diary.fingerprint(day)).collect()
}

fn by_type(diary: &Diary) -> Vec<[u32; 3]> {
    (0..diary.days.len()).map(|day| diary.count(day).by_type).collect()
}

#[test]
fn a_body_that_doubles_has_the_same_pattern_bit_for_bit() {
    let still = Arc::new(icosphere(3, 8.0));
    // Between the moments nothing is a power of two: they follow each other from one day to the next.
    let doubling = moving(
        &still,
        &[
            (0.0, &|p| p * 0.25),
            (2.0, &|p| p * 0.25),
            (3.0, &|p| p * 0.5),
            (5.0, &|p| p * 0.5),
            (6.0, &|p| p * 4.0),
        ],
    );
    let field = DirectionField::new(&still, &[Guide { triangle: 5, direction: Vec3::Y }], 0.1);
    let (field, recipe) = (field.unwrap(), Recipe { anisotropy: 0.5, ..recipe() });
    let grown = |mesh| fingerprints(&grow_along(mesh, &recipe, &field, 3));
    assert_eq!(grown(&still), grown(&doubling));
    let (of_still, of_moving) = (grow(&still, &recipe, 3), grow(&doubling, &recipe, 3));
    let radius = |diary: &Diary, day: usize| diary.days[day].repulsive_radius;
    for (day, scale) in [(0, 0.25), (2, 0.25), (3, 0.5), (5, 0.5), (6, 4.0), (8, 4.0)] {
        assert_eq!(radius(&of_moving, day), radius(&of_still, day) * scale, "on day {day}");
    }
}

#[test]
fn the_number_of_cells_does_not_depend_on_the_shape() {
    let still = Arc::new(icosphere(3, 8.0));
    let long = moving(&still, &[(0.0, &|p| p), (8.0, &|p| p * Vec3::new(0.4, 3.0, 0.7))]);
    let (of_still, of_long) = (grow(&still, &recipe(), 4), grow(&long, &recipe(), 4));
    assert_eq!(by_type(&of_still), by_type(&of_long));
    assert_ne!(of_still.fingerprint(8), of_long.fingerprint(8), "but the places do");
}

#[test]
fn bending_alone_leaves_the_pattern_as_it_is() {
    // A strip of 24 columns is rolled up along their borders, each of which stays as wide as it was.
    let (columns, side) = (24, 6.0);
    let still = Arc::new(sheet(columns, side, flat));
    let width = f64::from(side) / columns as f64;
    let rolled = |turn: f64| {
        move |p: Vec3| {
            let column = (f64::from(p.x) / width).round() as usize;
            let (mut x, mut z) = (0.0, 0.0);
            for k in 0..column {
                let angle = turn * k as f64 / columns as f64;
                (x, z) = (x + width * angle.cos(), z + width * angle.sin());
            }
            Vec3::new(x as f32, p.y, z as f32)
        }
    };
    let bending = moving(&still, &[(0.0, &rolled(0.0)), (1.0, &rolled(2.0)), (2.0, &rolled(5.0))]);
    let moments = bending.motion.moments();
    let ends = |moment: &Moment| moment.positions[0].distance(moment.positions[columns as usize]);
    assert!(ends(&moments[2]) < 0.5 * ends(&moments[0]), "it is bent");
    assert!((bending.on(2).area / still.area - 1.0).abs() < 1e-5);
    let recipe = Recipe { days: 2, ..recipe() };
    let (of_still, of_bent) = (grow(&still, &recipe, 5), grow(&bending, &recipe, 5));
    assert_eq!(by_type(&of_still), by_type(&of_bent));
    let spacing = (still.area / of_still.days[2].places.len() as f32).sqrt();
    let places = of_still.days[2].places.iter().zip(&of_bent.days[2].places);
    let far = places.filter(|(a, b)| still.point(**a).distance(still.point(**b)) > 0.01 * spacing);
    assert_eq!(far.count(), 0, "rounding alone parts them");
}

#[test]
fn a_marked_disc_becomes_the_ellipse_that_the_growth_says() {
    let still = Arc::new(sheet(16, 4.0, flat));
    let stretch = Vec3::new(2.5, 0.5, 1.0);
    let growing = moving(&still, &[(0.0, &|p| p), (4.0, &move |p| p * stretch)]);
    let recipe = Recipe { days: 4, initial_cells: 3_000, ..without_relaxation() };
    let diary = grow(&growing, &recipe, 6);
    let (before, after) = (growing.on(0), growing.on(4));
    let centre = Vec3::new(2.0, 2.0, 0.0);
    let mut marked = 0;
    for (&first, &last) in diary.days[0].places.iter().zip(&diary.days[4].places) {
        let from = (before.point(first) - centre).truncate();
        let to = (after.point(last) - centre * stretch).truncate();
        if from.length() < 1.0 {
            marked += 1;
            let axes = to / stretch.truncate();
            assert!(axes.length() < 1.0 + 1e-5 && axes.distance(from) < 1e-5, "{from} to {to}");
        }
    }
    assert!((400..800).contains(&marked), "{marked} of 3,000 cells in a fifth of the sheet");
}

#[test]
fn a_field_goes_with_the_skin() {
    let still = sheet(6, 3.0, flat);
    let along = Vec3::new(1.0, 1.0, 0.0);
    let guides = [Guide { triangle: 0, direction: along }];
    let field = DirectionField::new(&still, &guides, 0.5).unwrap();
    let sheared = |p: Vec3| Vec3::new(p.x + p.y, 2.0 * p.y, 0.5 * p.x);
    let moved = moving(&still, &[(0.0, &sheared)]).on(0).into_owned();
    let carried = field.carried(&still, &moved);
    let wanted = sheared(along).normalize();
    for triangle in 0..moved.triangles.len() as u32 {
        let [x, y] = moved.axes(triangle);
        let direction = carried.at(triangle);
        assert!((x * direction.x + y * direction.y).distance(wanted) < 1e-5);
    }
}

#[test]
fn sites_lie_where_the_cells_of_the_day_are() {
    let still = icosphere(2, 5.0);
    let long = moving(&still, &[(0.0, &|p| p), (8.0, &|p| p * Vec3::new(1.0, 2.0, 1.0))]);
    let diary = grow(&long, &recipe(), 7);
    let mut finder = SiteFinder::new(&long);
    for day in [0, 1, 8] {
        let (lists, mesh) = (finder.find(&long, &diary, day), long.on(day as u32));
        let mut found = 0;
        for triangle in 0..mesh.triangles.len() {
            let corners = mesh.frames[triangle].corners();
            let centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
            let head = &lists.heads[triangle];
            for (site, cell) in
                lists.of(triangle).iter().zip(&finder.cell_of[head.first as usize..])
            {
                let place = diary.days[day].places[*cell as usize];
                if place.triangle as usize == triangle {
                    found += 1;
                    let at: Vec2 = mesh.frames[triangle].point(place.b1, place.b2) - centroid;
                    assert!(site.now(head).distance(at) < 2.0 * head.scale_cm);
                }
            }
        }
        assert_eq!(found, diary.days[day].places.len(), "each cell in its own triangle's list");
        let areas = lists.areas(&mesh).iter().sum::<u32>();
        assert!((9_990..=10_010).contains(&areas), "{areas}");
    }
}

#[test]
fn refined_moments_are_those_of_the_refined_mesh() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 3\nv 1 1 3\ng leaf\nf 1 2 3 4\n\
                g stalk\nusemtl bare:stalk\nf 1 5 6\n#moment 0\n#v 0 0 0\n#v 1 0 0\n#v 1 1 1\n#v 0 1 1\n\
                #v 0 0 1\n#v 1 0 1\n#moment 4\n";
    let mesh = PolygonMesh::parse(text).unwrap();
    let levels =
        |mesh: &PolygonMesh| mesh.refined_by(&|group| if group.part == "leaf" { 2 } else { 1 });
    let refined = levels(&mesh);
    for moment in &mesh.moments {
        let alone = PolygonMesh { positions: moment.positions.clone(), ..mesh.clone() };
        let same = refined.moments.iter().find(|same| same.day == moment.day).unwrap();
        assert_eq!(levels(&alone).positions, same.positions);
    }
    let body = Body::new(&refined).unwrap();
    assert_eq!(body.on(4).surface.positions, body.surface.positions);
    let first = body.on(0);
    let folded = |part: &[Vec3]| part.iter().map(|p| p.z).fold(0.0, f32::max);
    assert!(folded(&first.surface.positions) > 0.5 && folded(&body.surface.positions) == 0.0);
    assert_eq!(folded(&first.ornaments[0].positions), 1.0);
    // Around all of both moments: the stalk that is 3 cm high at last, the leaf that is flat then.
    let (centre, radius, lowest) = body.ball();
    let ever: Vec<Vec3> = [&first, &body.on(4)]
        .iter()
        .flat_map(|body| body.surface.positions.iter().chain(&body.ornaments[0].positions))
        .copied()
        .collect();
    let farthest = ever.iter().map(|p| p.distance(centre)).fold(0.0, f32::max);
    assert_eq!((centre.z, lowest), (1.5, ever.iter().map(|p| p.y).fold(9.0, f32::min)));
    assert!((radius - farthest).abs() < 1e-5, "{radius} cm, and a corner is {farthest} cm away");
}

#[test]
fn moments_that_are_none_of_the_mesh_are_refused() {
    let mesh = "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n";
    let told = |moments: &str| {
        let mesh = PolygonMesh::parse(&format!("{mesh}{moments}")).map_err(|e| e.to_string())?;
        Body::new(&mesh).map(|_| ()).map_err(|e| e.to_string())
    };
    assert_eq!(told("#v 1 2 3\n#moment 0\n#moment 1\n"), Ok(()), "the first is a comment");
    assert_eq!(told("#moment of inertia\n#v of old\n"), Ok(()), "so are those of others");
    for (moments, why) in [
        ("#moment 1\n#v 0 0 0\n", "line 5 of the OBJ file: there are 3 vertices, but 1 on day 1"),
        ("#moment 3\n#moment 3\n", "the moment of day 3 does not come after the one before it"),
        ("#moment 7\n#v 0 0 0\n#v 1 0 0\n#v 2 0 0\n", "on day 7 a triangle has no area"),
        ("#moment 0\n#v 0 0 0\n#v 1 0 0\n#v 0 inf 0\n", "vertex 3 is not a finite number"),
    ] {
        assert_eq!(told(moments), Err(why.to_string()));
    }
}

#[test]
fn a_still_plant_is_borrowed_and_not_copied() {
    let mesh = plants::find("mushroom").unwrap().embedded_body().surface;
    assert!(matches!(mesh.on(5), std::borrow::Cow::Borrowed(_)));
}
