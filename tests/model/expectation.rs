//! The exact means and variances of populations without mutation: against values worked out by hand,
//! against many clans, and for every plant.

use crate::meshes::icosphere;
use crate::population::RARE_Z;
use crate::{grow, without_relaxation};
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::tissue::{
    CellType, Clock, Control, Growth, Progress, Recipe, Scaled, Use, clans, expected_cells,
};
use std::sync::Arc;

#[test]
fn expectation_has_the_values_worked_out_by_hand() {
    for (division_days, day, mean) in
        [(10.0, 34, 8.916), (5.0, 29, 63.45), (5.0, 19, 14.27), (3.0, 24, 513.7)]
    {
        let found = clans(division_days, day)[day].mean;
        assert!((found / mean - 1.0).abs() < 2e-4, "D = {division_days}: {found} and not {mean}");
    }
}

#[test]
fn clans_vary_as_expected() {
    let founders = 100_000u32;
    for (division_days, days) in [(1.5, 4), (3.0, 8), (10.0, 20)] {
        let recipe = Recipe {
            initial_cells: founders,
            division_days: [division_days; 3],
            days,
            ..without_relaxation()
        };
        let mut sizes = vec![0.0; founders as usize];
        for cell in &grow(&Arc::new(icosphere(1, 10.0)), &recipe, 8).lineage {
            sizes[cell.founder as usize] += 1.0;
        }
        let expected = clans(division_days, days as usize)[days as usize - 1];
        let n = f64::from(founders);
        let squares: Vec<f64> = sizes.iter().map(|s: &f64| (s - expected.mean).powi(2)).collect();
        let variance = squares.iter().sum::<f64>() / n;
        let spread = squares.iter().map(|s| (s - variance).powi(2)).sum::<f64>() / n;
        let error = (spread / n).sqrt();
        assert!(
            (variance - expected.variance).abs() <= RARE_Z * error,
            "D = {division_days}: {variance} ± {error} and not {}",
            expected.variance
        );
    }
}

/// Under control images, given the first cells that they left of each type: what the table of
/// `mosaic figures` compares with. Sums of hundreds of clans are nearly normal, and five standard
/// errors are passed once in 1,700,000 times: all of these comparisons together hold but for one run
/// in 10,000.
#[test]
fn plants_have_the_cells_expected_of_the_first_cells_that_were_drawn() {
    // Of those alone whose expectation is known.
    let is_known =
        |plant: &&Plant| expected_cells(&plant.recipe, &plant.controls(1), [1; 3], 1).is_some();
    let known = plants::all().iter().filter(is_known).count();
    assert!(known >= 11, "{known} of the plants");
    for plant in plants::all().iter().filter(is_known) {
        let mesh = Arc::new(plant.embedded_body().surface);
        let controls = plant.controls(1);
        let recipe = Recipe {
            initial_relaxations: 0,
            relaxations_per_day: 0,
            max_cells: Recipe::MOST_CELLS,
            ..plant.recipe.clone()
        };
        let day = recipe.days as usize;
        let rarest =
            recipe.initial_probability.iter().filter(|&&p| p > 0.0).fold(1.0, |a, &b| b.min(a));
        let individuals = 600.0 / (rarest * f64::from(recipe.initial_cells));
        let mut first_cells = Vec::new();
        let mut found = [0.0; 3];
        for individual in 1..=individuals.clamp(3.0, 40.0) as u32 {
            let mut growth =
                Growth::new(mesh.clone(), recipe.clone(), &controls, individual).unwrap();
            while growth.step() != Progress::Done {}
            first_cells.push(growth.diary.count(0).by_type);
            let last = growth.diary.count(day).by_type;
            (0..3).for_each(|kind| found[kind] += f64::from(last[kind]));
        }
        for (kind, found) in found.into_iter().enumerate() {
            let (mut mean, mut variance) = (0.0, 0.0);
            for first in &first_cells {
                let alone = std::array::from_fn(|k| if k == kind { first[k] } else { 0 });
                let expected = expected_cells(&recipe, &controls, alone, day).expect(plant.key);
                mean += expected.mean;
                variance += expected.variance;
            }
            let error = variance.sqrt();
            assert!(
                (found - mean).abs() <= 5.0 * error,
                "{}, type {kind}: {found} and not {mean} ± {error}",
                plant.key
            );
        }
    }
}

#[test]
fn nothing_is_expected_where_nothing_exact_is_known() {
    let expected =
        |recipe: &Recipe, controls: &[Control]| expected_cells(recipe, controls, [700, 300, 0], 9);
    let recipe = Recipe::default();
    let plain = expected(&recipe, &[]).unwrap();
    let clan = clans(10.0, 8)[8];
    assert!((plain.mean - 1000.0 * clan.mean).abs() < 1e-9 * plain.mean);
    assert!((plain.variance - 1000.0 * clan.variance).abs() < 1e-9 * plain.variance);
    assert_eq!(expected_cells(&recipe, &[], [700, 300, 0], 0).unwrap().mean, 1000.0);
    assert_eq!(expected_cells(&recipe, &[], [700, 300, 0], 0).unwrap().variance, 0.0);

    let mutating =
        Recipe { mutation: [[0.9, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], ..recipe.clone() };
    assert_eq!(expected(&mutating, &[]), None);
    assert_eq!(expected(&Recipe { clock: Clock::Exponential, ..recipe.clone() }, &[]), None);
    let [control] = &plants::find("croton").unwrap().controls(1)[..] else { panic!("one image") };
    assert!(
        expected(&recipe, std::slice::from_ref(control)).is_some(),
        "first cells are counted after it"
    );
    let use_as =
        Use::Scale { number: Scaled::DivisionDays(CellType::Background), black: 1.0, white: 2.0 };
    assert_eq!(expected(&recipe, &[Control { use_as, ..control.clone() }]), None);
}

/// The cells of each type, in the mean, that one cell of age 0 of a type has become when the
/// divisions up to a day are done. As for `clans`, but a child is of another type with the chances of
/// `mutation`; types must be born in the order B, F, M alone, so that they are solved for from the
/// last.
fn mutating_clans(recipe: &Recipe, days: usize) -> Vec<[[f64; 3]; 3]> {
    let first_on = |kind: usize| {
        let mean = recipe.division_days[kind];
        (0..=days).scan((-mean).exp(), move |q, k| {
            let now = *q;
            *q *= mean / (k + 1) as f64;
            Some(now)
        })
    };
    let q: [Vec<f64>; 3] = std::array::from_fn(|kind| first_on(kind).collect());
    let mut clans: Vec<[[f64; 3]; 3]> = Vec::new();
    for t in 0..=days {
        let mut today = [[0.0; 3]; 3];
        for from in [2, 0, 1] {
            let row = recipe.mutation[from];
            for to in 0..3 {
                let mut sum =
                    if from == to { 1.0 - q[from][..=t].iter().sum::<f64>() } else { 0.0 };
                for k in 0..=t {
                    // The parent goes on, and the child begins; of today's own it is solved below.
                    let then = if k == 0 { &today } else { &clans[t - k] };
                    let child: f64 = (0..3).map(|s| row[s] * then[s][to]).sum();
                    sum += q[from][k] * (then[from][to] + child);
                }
                today[from][to] = sum / (1.0 - q[from][0] * (1.0 + row[from]));
            }
        }
        clans.push(today);
    }
    clans
}

#[test]
fn types_that_are_born_of_others_have_the_cells_expected() {
    let plant = plants::find("red-croton").unwrap();
    let mesh = Arc::new(plant.embedded_body().surface);
    let recipe = Recipe { initial_relaxations: 0, relaxations_per_day: 0, ..plant.recipe.clone() };
    let day = recipe.days as usize;
    let clans = mutating_clans(&recipe, day - 1)[day - 1];
    const INDIVIDUALS: u32 = 40;
    let mut found = [[0.0; 2]; 3];
    for individual in 1..=INDIVIDUALS {
        let diary = grow(&mesh, &recipe, individual);
        let (first, last) = (diary.count(0).by_type, diary.count(day).by_type);
        for kind in 0..3 {
            let mean: f64 = (0..3).map(|from| f64::from(first[from]) * clans[from][kind]).sum();
            let off = f64::from(last[kind]) - mean;
            found[kind] = [found[kind][0] + off, found[kind][1] + off * off];
        }
    }
    for (kind, [sum, squares]) in found.into_iter().enumerate() {
        let n = f64::from(INDIVIDUALS);
        let error = (squares / n).sqrt() / n.sqrt();
        assert!((sum / n).abs() < 4.0 * error, "type {kind}: {} ± {error} off", sum / n);
        // The spread itself is small beside the cells, or the test would say nothing.
        let mean: f64 =
            (0..3).map(|from| recipe.initial_probability[from] * clans[from][kind]).sum::<f64>()
                * f64::from(recipe.initial_cells);
        assert!(error < 0.02 * mean, "type {kind}: ± {error} of {mean}");
    }
}
