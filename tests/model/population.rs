//! How many cells of which type there are, against exact expectation.

use crate::meshes::icosphere;
use crate::{chi_square, grow, rare_chi_square, without_relaxation};
use clonal_mosaic::tissue::{Clock, Diary, Recipe, clans};
use std::sync::Arc;

/// Means over so many independent clans stay within this many standard errors but for one run in
/// 100,000.
pub const RARE_Z: f64 = 4.417;

#[test]
fn populations_without_mutation_are_those_expected() {
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [0.3, 0.5, 0.2],
        division_days: [5.0, 10.0, 3.0],
        days: 18,
        ..without_relaxation()
    };
    check_populations(&recipe, &[1, 2, 3], &[1, 9, 18]);
    // The two ways to the expectation agree.
    for t in [0, 5, 17] {
        let all = expected_clan(&recipe, t);
        for (kind, days) in recipe.division_days.into_iter().enumerate() {
            let one = clans(days, t)[t].mean * recipe.initial_probability[kind];
            assert!((all[kind] / one - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn populations_with_mutation_are_those_expected() {
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [0.1, 0.9, 0.0],
        division_days: [4.0, 6.0, 9.0],
        mutation: [[0.9, 0.05, 0.05], [0.02, 0.98, 0.0], [0.3, 0.3, 0.4]],
        days: 15,
        ..without_relaxation()
    };
    check_populations(&recipe, &[0, u32::MAX, 77], &[5, 9, 15]);
}

#[test]
fn populations_of_exponential_clocks_are_those_expected() {
    let recipe = Recipe {
        initial_cells: 20_000,
        initial_probability: [0.1, 0.8, 0.1],
        division_days: [4.0, 6.0, 9.0],
        clock: Clock::Exponential,
        mutation: [[0.9, 0.05, 0.05], [0.02, 0.98, 0.0], [0.3, 0.3, 0.4]],
        days: 12,
        ..without_relaxation()
    };
    check_populations(&recipe, &[0, 7, 2026], &[1, 5, 12]);
}

#[test]
fn clans_of_exponential_clocks_are_of_geometric_sizes() {
    // A Yule process: a clan has n cells at time t with chance p (1 - p)^(n - 1), p = exp(-t / D).
    // Times are real, and what falls due before day t has divided: nothing is lost to whole days.
    let mesh = Arc::new(icosphere(0, 10.0));
    let founders = 100_000u32;
    for (mean_days, days) in [(1.2, 3), (5.0, 10), (9.0, 4)] {
        let recipe = Recipe {
            initial_cells: founders,
            division_days: [mean_days; 3],
            clock: Clock::Exponential,
            days,
            ..without_relaxation()
        };
        let mut sizes = vec![0usize; founders as usize];
        for cell in &grow(&mesh, &recipe, 6).lineage {
            sizes[cell.founder as usize] += 1;
        }
        let p = libm::exp(-f64::from(days) / mean_days);
        let mut expected = Vec::new();
        let mut rest = f64::from(founders);
        while rest > 50.0 {
            expected.push(rest * p);
            rest *= 1.0 - p;
        }
        let largest = expected.len();
        expected.push(rest);
        let mut found = vec![0.0; largest + 1];
        for size in sizes {
            found[(size - 1).min(largest)] += 1.0;
        }
        let distance = chi_square(&found, &expected);
        assert!(distance < rare_chi_square(largest), "D = {mean_days}: {distance}");
    }
}

#[test]
fn relaxation_does_not_change_who_is_born() {
    let mesh = Arc::new(icosphere(3, 10.0));
    let still = Recipe { initial_cells: 500, days: 12, ..without_relaxation() };
    let moving = Recipe { initial_relaxations: 5, relaxations_per_day: 3, ..still.clone() };
    assert_eq!(grow(&mesh, &still, 4).lineage, grow(&mesh, &moving, 4).lineage);
}

#[test]
fn children_are_of_the_types_of_the_mutation_matrix() {
    let mesh = Arc::new(icosphere(1, 10.0));
    let recipe = Recipe {
        initial_cells: 5_000,
        initial_probability: [0.3, 0.3, 0.4],
        division_days: [5.0; 3],
        mutation: [[0.7, 0.2, 0.1], [0.01, 0.99, 0.0], [0.25, 0.25, 0.5]],
        days: 15,
        ..without_relaxation()
    };
    let diary = grow(&mesh, &recipe, 11);
    let mut births = [[0.0; 3]; 3];
    for cell in &diary.lineage[5_000..] {
        births[diary.lineage[cell.parent as usize].kind as usize][cell.kind as usize] += 1.0;
    }
    for (found, chances) in births.iter().zip(&recipe.mutation) {
        let all: f64 = found.iter().sum();
        assert!(all > 5_000.0);
        for (found, chance) in found.iter().zip(chances) {
            let error = (all * chance * (1.0 - chance)).sqrt();
            assert!((found - all * chance).abs() <= RARE_Z * error, "{births:?}");
        }
    }
}

#[test]
fn first_divisions_come_at_poisson_times() {
    let chance = |k: usize| (1..=k).fold(libm::exp(-MEAN_DAYS), |q, j| q * MEAN_DAYS / j as f64);
    check_first_divisions(Clock::Poisson, chance);
}

#[test]
fn first_divisions_come_at_exponential_times() {
    let waits = |k: usize| libm::exp(-(k as f64) / MEAN_DAYS);
    check_first_divisions(Clock::Exponential, |k| waits(k) - waits(k + 1));
}

const MEAN_DAYS: f64 = 6.0;

/// `chance(k)`: that a first cell divides on day k for the first time.
fn check_first_divisions(clock: Clock, chance: impl Fn(usize) -> f64) {
    let mesh = Arc::new(icosphere(1, 10.0));
    const DAYS: usize = 16;
    let founders = 50_000;
    let recipe = Recipe {
        initial_cells: founders,
        division_days: [MEAN_DAYS; 3],
        clock,
        days: DAYS as u32,
        ..without_relaxation()
    };
    let diary = grow(&mesh, &recipe, 5);
    let mut first = vec![usize::MAX; founders as usize];
    for cell in &diary.lineage[founders as usize..] {
        if cell.parent < founders {
            let day = &mut first[cell.parent as usize];
            *day = (*day).min(cell.born_day as usize - 1);
        }
    }
    // Days 0 to 15, and those who have not divided by then.
    let mut found = vec![0.0; DAYS + 1];
    for day in first {
        found[day.min(DAYS)] += 1.0;
    }
    let mut expected: Vec<f64> = (0..DAYS).map(|k| chance(k) * f64::from(founders)).collect();
    expected.push(f64::from(founders) - expected.iter().sum::<f64>());
    let distance = chi_square(&found, &expected);
    assert!(distance < rare_chi_square(DAYS), "{distance}: {found:?} and not {expected:?}");
}

/// Compares the mean clan of a first cell with what is expected on some days. Clans are
/// independent, so their spread gives the error of their mean.
fn check_populations(recipe: &Recipe, seeds: &[u32], days: &[usize]) {
    let mesh = Arc::new(icosphere(1, 10.0));
    let diaries: Vec<Diary> = seeds.iter().map(|&seed| grow(&mesh, recipe, seed)).collect();
    for &day in days {
        let expected = match recipe.clock {
            Clock::Poisson => expected_clan(recipe, day - 1),
            Clock::Exponential => expected_yule_clan(recipe, day),
        };
        let mut clans = Vec::new();
        for diary in &diaries {
            let mut of_seed = vec![[0.0; 3]; recipe.initial_cells as usize];
            for cell in &diary.lineage[..diary.days[day].places.len()] {
                of_seed[cell.founder as usize][cell.kind as usize] += 1.0;
            }
            clans.extend(of_seed);
        }
        let n = clans.len() as f64;
        for kind in 0..3 {
            assert!(expected[kind] * n > 200.0, "too few for their mean to be normal");
            let mean = clans.iter().map(|clan| clan[kind]).sum::<f64>() / n;
            let variance =
                clans.iter().map(|c: &[f64; 3]| (c[kind] - mean).powi(2)).sum::<f64>() / n;
            let error = (variance / n).sqrt();
            assert!(
                (mean - expected[kind]).abs() <= RARE_Z * error,
                "day {day}, type {kind}: {mean} ± {error} and not {}",
                expected[kind]
            );
        }
    }
}

/// Mean number of cells of each type that descend from one first cell when the divisions of days
/// `0..=t` are done: the renewal equation of all three types at once.
fn expected_clan(recipe: &Recipe, t: usize) -> [f64; 3] {
    let poisson = |mean: f64| {
        let mut q = vec![libm::exp(-mean)];
        for k in 1..=t {
            q.push(q[k - 1] * mean / k as f64);
        }
        q
    };
    let q = recipe.division_days.map(poisson);
    // m[t][s][u]: mean number of cells of type u from one of type s.
    let mut m: Vec<[[f64; 3]; 3]> = Vec::new();
    for t in 0..=t {
        let with_child = |m: &[[f64; 3]; 3], s: usize, u: usize| {
            m[s][u] + (0..3).map(|c| recipe.mutation[s][c] * m[c][u]).sum::<f64>()
        };
        let mut today = [[0.0; 3]; 3];
        // Divisions on the very day refer to the unknown itself; their chance is small, and the
        // equation is solved by putting the last guess in.
        for _ in 0..60 {
            let guess = today;
            for (s, row) in today.iter_mut().enumerate() {
                for (u, mean) in row.iter_mut().enumerate() {
                    let waits = if s == u { 1.0 - q[s][..=t].iter().sum::<f64>() } else { 0.0 };
                    let before: f64 = (1..=t).map(|k| q[s][k] * with_child(&m[t - k], s, u)).sum();
                    *mean = waits + before + q[s][0] * with_child(&guess, s, u);
                }
            }
        }
        m.push(today);
    }
    std::array::from_fn(|u| (0..3).map(|s| recipe.initial_probability[s] * m[t][s][u]).sum())
}

/// Mean number of cells of each type that descend from one first cell at time `day` when clocks have
/// no memory: `m' = m R` with the rates `R = mutation / division_days` of the rows' types, in steps
/// of Taylor series.
fn expected_yule_clan(recipe: &Recipe, day: usize) -> [f64; 3] {
    let rate = |s: usize, u: usize| recipe.mutation[s][u] / recipe.division_days[s];
    let born = |m: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|u| (0..3).map(|s| m[s] * rate(s, u)).sum())
    };
    let mut mean = recipe.initial_probability;
    for _ in 0..day {
        let mut term = mean;
        for k in 1..20 {
            term = born(term).map(|x| x / f64::from(k));
            mean = std::array::from_fn(|u| mean[u] + term[u]);
        }
    }
    mean
}
