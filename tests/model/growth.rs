//! What holds for every growth: nobody is lost, everybody stands on the surface, and the same wish
//! gives the same cells.

use crate::meshes::{blade, cube, flat, icosphere, shaken, sheet, two_sheets};
use crate::{chi_square, grow, rare_chi_square, without_relaxation};
use clonal_mosaic::surface::{Mesh, Place};
use clonal_mosaic::tissue::{CellType, Clock, Diary, Growth, Progress, Recipe, Rules};
use glam::{Vec2, Vec3};
use std::sync::Arc;

#[test]
fn invariants_hold_on_every_body() {
    let recipe = Recipe {
        initial_cells: 300,
        initial_probability: [0.4, 0.4, 0.2],
        division_days: [5.0, 7.0, 9.0],
        mutation: [[0.9, 0.1, 0.0], [0.0, 1.0, 0.0], [0.1, 0.0, 0.9]],
        days: 12,
        ..Recipe::default()
    };
    let far = Recipe { radius_scale: 4.0, repulsion: 0.02, ..recipe.clone() };
    // Some cells divide several times in a day.
    let at_any_time = Recipe { clock: Clock::Exponential, ..recipe.clone() };
    for mesh in [
        icosphere(4, 10.0),
        icosphere(0, 10.0),
        cube(5, 3.0),
        blade(10, 4.0),
        sheet(10, 4.0, shaken(4.0, 0.1)),
    ] {
        let mesh = Arc::new(mesh);
        for recipe in [&recipe, &far, &at_any_time] {
            check_diary(&mesh, recipe, &grow(&mesh, recipe, 9));
        }
    }
}

fn check_diary(mesh: &Mesh, recipe: &Recipe, diary: &Diary) {
    assert_eq!(diary.days.len(), recipe.days as usize + 1);
    let first = recipe.initial_cells as usize;
    for (id, cell) in diary.lineage.iter().enumerate() {
        let parent = diary.lineage[cell.parent as usize];
        if id < first {
            assert_eq!((cell.parent, cell.founder, cell.born_day), (id as u32, id as u32, 0));
        } else {
            assert!((cell.parent as usize) < id && parent.born_day <= cell.born_day);
            assert_eq!(cell.founder, parent.founder);
            assert!(cell.born_day >= diary.lineage[id - 1].born_day, "numbered by birth");
        }
        assert_eq!(
            mesh.parts[diary.days[cell.born_day as usize].places[id].triangle as usize],
            mesh.parts[diary.days.last().unwrap().places[id].triangle as usize],
            "nobody leaves its part"
        );
    }
    for (number, day) in diary.days.iter().enumerate() {
        let born = diary.lineage[first..].iter().filter(|c| c.born_day as usize <= number).count();
        assert_eq!(day.places.len(), first + born, "first cells and divisions on day {number}");
        let radius = recipe.radius_scale * (mesh.area / day.places.len() as f32).sqrt();
        assert!((day.repulsive_radius / radius - 1.0).abs() < 1e-6);
        for place in &day.places {
            assert!((place.triangle as usize) < mesh.triangles.len());
            assert!(place.b1 >= 0.0 && place.b2 >= 0.0, "{place:?}");
            assert!(1.0 - place.b1 - place.b2 >= -1e-6, "{place:?}");
        }
        let count = diary.count(number);
        assert_eq!(count.cells as usize, day.places.len());
        assert_eq!(count.by_type.iter().sum::<u32>(), count.cells);
    }
}

#[test]
fn the_same_wish_gives_the_same_cells() {
    let mesh = Arc::new(icosphere(3, 10.0));
    let recipe = Recipe { initial_cells: 400, days: 10, ..Recipe::default() };
    let long = grow(&mesh, &recipe, 17);
    assert_eq!(long, grow(&mesh, &recipe, 17));
    // A day does not know how many days will come after it.
    let short = grow(&mesh, &Recipe { days: 4, ..recipe.clone() }, 17);
    assert_eq!(short.days[..], long.days[..5]);
    assert_eq!(short.lineage[..], long.lineage[..short.lineage.len()]);
    let prints: Vec<String> = (0..=10).map(|day| long.fingerprint(day)).collect();
    let other = grow(&mesh, &recipe, 18);
    for (day, print) in prints.iter().enumerate() {
        assert_eq!(print.len(), 6);
        assert_ne!(*print, other.fingerprint(day), "another individual is another");
        assert!(prints.iter().filter(|p| *p == print).count() == 1, "days differ");
    }
}

#[test]
fn growth_ends_at_the_cap_and_keeps_what_has_grown() {
    let mesh = Arc::new(icosphere(2, 10.0));
    let free =
        Recipe { initial_cells: 200, division_days: [4.0; 3], days: 15, ..Recipe::default() };
    let capped = Recipe { max_cells: 900, ..free.clone() };
    let mut growth = Growth::new(mesh.clone(), capped, &[], 3).unwrap();
    let mut progress = growth.step();
    while !matches!(progress, Progress::Full | Progress::Done) {
        progress = growth.step();
    }
    assert_eq!((progress, growth.step()), (Progress::Full, Progress::Full));
    let all = grow(&mesh, &free, 3);
    let days = growth.diary.days.len();
    assert_eq!(growth.diary.days[..], all.days[..days]);
    assert_eq!(growth.diary.lineage.len(), growth.diary.days[days - 1].places.len());
    assert!(all.days[days].places.len() > 900 && growth.diary.lineage.len() <= 900);
}

#[test]
fn first_cells_are_spread_evenly_by_area() {
    // Triangles of very different areas.
    let mesh = Arc::new(sheet(8, 4.0, |p| flat(Vec2::new(p.x * p.x, p.y))));
    let recipe = Recipe { initial_cells: 60_000, days: 0, ..without_relaxation() };
    let diary = grow(&mesh, &recipe, 1);
    let mut found = vec![0.0; mesh.triangles.len()];
    let mut halves = [0.0; 3];
    for place in &diary.days[0].places {
        found[place.triangle as usize] += 1.0;
        // Each corner of a triangle has a quarter of its area nearest in barycentrics.
        let b = [1.0 - place.b1 - place.b2, place.b1, place.b2];
        for k in 0..3 {
            halves[k] += f64::from(b[k] > 0.5);
        }
    }
    let share = |area: f32| f64::from(area / mesh.area) * 60_000.0;
    let expected: Vec<f64> = mesh.areas.iter().map(|&area| share(area)).collect();
    let distance = chi_square(&found, &expected);
    assert!(distance < rare_chi_square(mesh.triangles.len() - 1), "{distance}");
    for half in halves {
        assert!((half - 15_000.0).abs() < 4.417 * (60_000.0f64 * 0.25 * 0.75).sqrt(), "{halves:?}");
    }
}

#[test]
fn first_cells_have_the_types_of_the_recipe() {
    let mesh = Arc::new(icosphere(3, 10.0));
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [0.6, 0.3, 0.1],
        days: 0,
        ..without_relaxation()
    };
    let counts = grow(&mesh, &recipe, 2).count(0).by_type.map(f64::from);
    let distance = chi_square(&counts, &[12_000.0, 6_000.0, 2_000.0]);
    assert!(distance < rare_chi_square(2), "{counts:?}");
}

#[test]
fn a_part_that_unfolds_later_lives_through_the_same_days_later() {
    const LATER: usize = 3;
    let mesh = Arc::new(two_sheets(6, 6.0, 1.0));
    let recipe = Recipe {
        initial_cells: 800,
        initial_probability: [0.5, 0.5, 0.0],
        division_days: [4.0, 6.0, 6.0],
        days: 12,
        ..Recipe::DEFAULT
    };
    let both = |recipe: &Recipe| {
        let sown = || Growth::new(mesh.clone(), recipe.clone(), &[], 5).unwrap();
        [sown(), sown().unfolding(&[0, LATER as u32])].map(|mut growth| {
            while growth.step() != Progress::Done {}
            growth.diary
        })
    };
    let is_late = |place: &&Place| mesh.parts[place.triangle as usize] == 1;

    // Without divisions the repulsive radius stays, and both sheets take the very same ways.
    let [free, late] = both(&Recipe { division_days: [500.0; 3], ..recipe.clone() });
    for (day, of_day) in late.days.iter().enumerate() {
        let own = free.days[day.saturating_sub(LATER)].places.iter();
        for ((place, at_once), at_own) in of_day.places.iter().zip(&free.days[day].places).zip(own)
        {
            assert_eq!(place, if is_late(&place) { at_own } else { at_once });
        }
    }
    assert!(free.days[1].places != free.days[0].places);

    // With them, the clans are the same.
    let [free, late] = both(&recipe);
    let cells = |diary: &Diary, day: usize, part: u32| {
        let places = &diary.days[day].places;
        let here = |cell: &usize| mesh.parts[places[*cell].triangle as usize] == part;
        (0..places.len()).filter(here).fold([0; 3], |mut count: [u32; 3], cell| {
            count[diary.lineage[cell].kind as usize] += 1;
            count
        })
    };
    for day in 0..=12 {
        assert_eq!(cells(&late, day, 0), cells(&free, day, 0));
        assert_eq!(cells(&late, day, 1), cells(&free, day.saturating_sub(LATER), 1));
    }
    assert!(cells(&free, 12, 1)[0] > 2 * cells(&free, 0, 1)[0]);
}

/// Under the second rules its cells go the same ways as those of a part that was there from day 0: those few do
/// not that lie so close to others that rounding decides where they are pushed.
#[test]
fn a_part_that_unfolds_later_lives_as_if_it_were_day_0_cell_for_cell() {
    const LATER: usize = 4;
    let mesh = Arc::new(two_sheets(6, 6.0, 1.0));
    let recipe =
        Recipe { initial_cells: 800, division_days: [3.0, 5.0, 5.0], days: 12, ..Recipe::DEFAULT };
    let grown = |rules: Rules, unfolding_days: &[u32]| {
        let growth = Growth::new(mesh.clone(), recipe.clone(), &[], 5).unwrap();
        let mut growth = growth.under(rules).unfolding(unfolding_days);
        while growth.step() != Progress::Done {}
        growth.diary
    };
    let cells = |diary: &Diary, day: usize, part: u32| -> Vec<(CellType, Vec3)> {
        let cells = diary.days[day].places.iter().zip(&diary.lineage);
        let here = cells.filter(|(place, _)| mesh.parts[place.triangle as usize] == part);
        here.map(|(&place, cell)| (cell.kind, mesh.point(place))).collect()
    };
    // How far nine in ten of the late part's cells are at most from where they would be, in spacings.
    let apart = |rules: Rules, day: usize| {
        let (free, late) = (grown(rules, &[]), grown(rules, &[0, LATER as u32]));
        let (late, free) = (cells(&late, day, 1), cells(&free, day - LATER, 1));
        assert!(late.len() == free.len() && free.len() > 3 * 400);
        assert!(late.iter().zip(&free).all(|(a, b)| a.0 == b.0));
        let spacing = (18.0 / late.len() as f32).sqrt();
        let ways = late.iter().zip(&free).map(|(a, b)| a.1.distance(b.1) / spacing);
        let mut ways: Vec<f32> = ways.collect();
        ways.sort_by(f32::total_cmp);
        ways[ways.len() * 9 / 10]
    };
    assert!(apart(Rules::Second, 12) < 0.002);
    assert!(apart(Rules::First, 12) > 0.1, "its radius is that of all cells");
}

#[test]
fn children_appear_in_a_small_disc_around_their_parent() {
    let mesh = Arc::new(sheet(6, 8.0, shaken(8.0, 0.3)));
    let recipe =
        Recipe { initial_cells: 10_000, division_days: [6.0; 3], days: 8, ..without_relaxation() };
    let diary = grow(&mesh, &recipe, 8);
    let (mut squares, mut births) = (0.0, 0.0);
    for (id, cell) in diary.lineage.iter().enumerate().skip(10_000) {
        let day = cell.born_day as usize;
        let at = |cell: usize| mesh.point(diary.days[day].places[cell]);
        let reach = 0.005 * diary.days[day - 1].repulsive_radius;
        let distance = at(id).distance(at(cell.parent as usize));
        // The sheet's coordinates are rounded to about a millionth.
        assert!(distance <= reach + 2e-6, "{distance} is over {reach}");
        squares += f64::from((distance / reach).powi(2));
        births += 1.0;
    }
    // The square of a uniform point's distance is uniform itself.
    let error = (1.0f64 / 12.0 / births).sqrt();
    assert!((squares / births - 0.5).abs() < 4.417 * error + 2e-3, "{}", squares / births);
}

#[test]
fn any_number_of_threads_grows_the_same_cells() {
    let mesh = Arc::new(icosphere(4, 5.0));
    let recipe =
        Recipe { initial_cells: 9_000, division_days: [3.0; 3], days: 4, ..Recipe::default() };
    let grow = |threads| {
        let growth = Growth::new(mesh.clone(), recipe.clone(), &[], 1).unwrap();
        let mut growth = growth.on_threads(threads);
        while growth.step() != Progress::Done {}
        (0..=4).map(|day| growth.diary.fingerprint(day)).collect::<Vec<_>>()
    };
    let alone = grow(1);
    for threads in [2, 3, 7] {
        assert_eq!(grow(threads), alone, "{threads} threads");
    }
}
