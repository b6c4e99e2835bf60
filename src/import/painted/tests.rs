use super::ways::{lines_of, nearest};
use super::*;
use crate::plants::bring;
use crate::surface::{Place, unpack};
use crate::tissue::{CellType, Growth, Progress, Recipe, Scaled};
use glam::Vec3;

fn stroke(brush: Brush, way: Way, radius: u32, points: &[Place]) -> Stroke {
    let points = points.iter().map(|&place| Spot::of(place)).collect();
    Stroke { brush, radius, way, is_mirrored: false, points }
}

fn painted(key: &str, strokes: Vec<Stroke>) -> Painted {
    Painted { base: plants::find(key).unwrap(), strokes }
}

/// The plant of strokes, known to this thread.
fn made(painted: &Painted) -> &'static Plant {
    let own = painted.make(painted.base.body.mesh.text).unwrap();
    let plant = bring(&own.text).unwrap();
    assert_eq!(plant.key, own.key);
    plant
}

/// First cells of a plant, few: where they are, and of which type.
fn first_cells(plant: &Plant) -> (Arc<crate::surface::Mesh>, Vec<(Place, CellType)>) {
    let text = plant.body.mesh.text;
    let obj = if plant.key.starts_with(plants::OWN) { unpack(text) } else { text.to_string() };
    let mesh = Arc::new(plant.grow_body(&obj).unwrap().surface);
    let recipe =
        Recipe { days: 0, initial_cells: 3000, initial_relaxations: 0, ..plant.recipe.clone() };
    let mut growth = plant.sow(mesh.clone(), recipe, 1).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    (mesh, cells(&growth))
}

fn cells(growth: &Growth) -> Vec<(Place, CellType)> {
    let kinds = growth.diary.lineage.iter().map(|cell| cell.kind);
    growth.diary.days[0].places.iter().copied().zip(kinds).collect()
}

#[test]
fn a_dab_puts_a_type_where_it_lies_and_nothing_changes_elsewhere() {
    let melon = plants::find("watermelon").unwrap();
    let mesh = melon.embedded_body().surface;
    let place = nearest(&mesh, Vec3::new(0.0, 20.0, 40.0));
    let at = mesh.point(Spot::of(place).place());
    let dab = stroke(Brush::Put(CellType::Foreground), Way::Free, 4000, &[place]);
    let plant = made(&painted("watermelon", vec![dab]));
    let (_, before) = first_cells(melon);
    let (mesh, after) = first_cells(plant);
    let (mut inside, mut turned) = (0, 0);
    for ((was_at, was), (is_at, is)) in before.iter().zip(&after) {
        let distance_cm = mesh.point(*is_at).distance(at);
        // What is pushed is no other before the first day: only types differ.
        if distance_cm < 2.5 {
            inside += 1;
            turned += usize::from(*was != CellType::Foreground);
            assert_eq!(*is, CellType::Foreground, "{distance_cm} cm away");
        } else if distance_cm > 6.0 {
            assert_eq!((was_at.triangle, was), (is_at.triangle, is));
        }
    }
    assert!(inside > 10 && turned > 3, "{inside} cells, {turned} of them turned");
}

#[test]
fn a_stroke_reaches_no_other_part_and_fills_its_own_if_that_is_wished() {
    let croton = plants::find("croton").unwrap();
    let mesh = croton.embedded_body().surface;
    let place = Place { triangle: 0, b1: 0.3, b2: 0.3 };
    let part = mesh.parts[0];
    // Larger than the plant.
    for way in [Way::Free, Way::Part] {
        let all = stroke(Brush::Put(CellType::Foreground), way, 90_000, &[place]);
        let (mesh, cells) = first_cells(made(&painted("croton", vec![all])));
        let of_part = |(place, _): &&(Place, CellType)| mesh.parts[place.triangle as usize] == part;
        let (own, others): (Vec<_>, Vec<_>) = cells.iter().partition(of_part);
        let share = |cells: &[&(Place, CellType)]| {
            let yellow = cells.iter().filter(|(_, kind)| *kind == CellType::Foreground).count();
            yellow as f64 / cells.len() as f64
        };
        if way == Way::Part {
            assert_eq!(share(&own), 1.0);
        }
        assert!(share(&own) > 0.9 && share(&others) < 0.3, "{} {}", share(&own), share(&others));
    }
}

#[test]
fn the_same_strokes_are_the_same_plant_and_undone_ones_are_as_before() {
    let mesh = plants::find("croton").unwrap().embedded_body().surface;
    let [one, two] = [100, 900].map(|triangle| Place { triangle, b1: 0.2, b2: 0.2 });
    let first = stroke(Brush::Only(CellType::Foreground), Way::Along, 500, &[one]);
    let second = stroke(Brush::Scale(Scaled::RadiusScale, 150), Way::Free, 800, &[two]);
    let key = |strokes: &[&Stroke]| {
        let painted = painted("croton", strokes.iter().map(|&s| s.clone()).collect());
        let own = painted.make(painted.base.body.mesh.text).unwrap();
        let link = format!("{}?v=2&s=1&d=2~{}~ui=play", own.key, painted.write());
        let again = painted_of_link(&link).unwrap().unwrap();
        assert_eq!(again, painted);
        assert_eq!(again.make(painted.base.body.mesh.text).unwrap(), own);
        own.key
    };
    let keys = [key(&[&first]), key(&[&first, &second]), key(&[&second])];
    assert!(keys[0] != keys[1] && keys[1] != keys[2] && keys[0] != keys[2], "{keys:?}");
    // An eraser over all of it.
    let eraser = stroke(Brush::Erase, Way::Part, 100, &[one, two]);
    let other_part = mesh.parts[100] != mesh.parts[900];
    assert!(other_part);
    assert_eq!(key(&[&first, &eraser, &second]), key(&[&second]));
    assert!(painted_of_link("croton?v=2~present").is_none());
    let gone = painted_of_link("own-abc?v=2~painted/own-gone/2/f.5.w.k00").unwrap();
    assert!(gone.unwrap_err().contains("is not here"));
}

#[test]
fn an_eraser_takes_away_what_it_meets() {
    let melon = plants::find("watermelon").unwrap();
    let mesh = melon.embedded_body().surface;
    let place = nearest(&mesh, Vec3::new(0.0, 20.0, 40.0));
    let ring = stroke(Brush::Put(CellType::Foreground), Way::Around, 1000, &[place]);
    let eraser = stroke(Brush::Erase, Way::Free, 2000, &[place]);
    let whole = Layer::of(std::slice::from_ref(&ring), &mesh).unwrap();
    let cut = Layer::of(&[ring, eraser], &mesh).unwrap();
    let at = mesh.point(Spot::of(place).place());
    let nearest_cm = |layers: &[Layer]| {
        let points = layers[0].lines.iter().flat_map(|line| line.points());
        points.map(|p| p.distance(at)).fold(f32::INFINITY, f32::min)
    };
    assert!(nearest_cm(&whole) < 0.1);
    assert!((3.0..4.0).contains(&nearest_cm(&cut)), "{}", nearest_cm(&cut));
}

#[test]
fn every_plant_can_be_led_and_cells_follow() {
    for key in ["croton", "watermelon", "lily", "philodendron", "mushroom"] {
        let base = plants::find(key).unwrap();
        let mesh = base.embedded_body().surface;
        let from = Place { triangle: (mesh.triangles.len() / 3) as u32, b1: 0.3, b2: 0.3 };
        let plant = made(&painted(key, vec![stroke(Brush::Lead, Way::Along, 300, &[from])]));
        assert!(plant.recipe.anisotropy > 0.0);
        let body = plant.grow_body(&unpack(plant.body.mesh.text)).unwrap().surface;
        let field = plant.field(&body).unwrap().unwrap();
        let line = &lines_of(&stroke(Brush::Lead, Way::Along, 300, &[from]), &mesh).unwrap()[0];
        assert!(line.len() > 4, "{key}");
        let here = line[line.len() / 2].triangle;
        let way = (line[line.len() / 2].at - line[line.len() / 2 - 1].at).normalize();
        let [x, y] = body.axes(here);
        let led = x * field.at(here).x + y * field.at(here).y;
        assert!(led.dot(way) > 0.5, "{key}: {led} along {way}");
    }
}

#[test]
fn where_it_is_bare_no_cell_grows() {
    let melon = plants::find("watermelon").unwrap();
    let mesh = melon.embedded_body().surface;
    let place = nearest(&mesh, Vec3::new(0.0, 20.0, 40.0));
    let at = mesh.point(Spot::of(place).place());
    let plant = made(&painted("watermelon", vec![stroke(Brush::Bare, Way::Free, 4000, &[place])]));
    let (mesh, cells) = first_cells(plant);
    assert!(mesh.area < melon.embedded_body().surface.area - 30.0);
    assert!(cells.iter().all(|(place, _)| mesh.point(*place).distance(at) > 2.5));
    assert!(plant.has_bare("painted"));
}
