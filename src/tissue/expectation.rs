//! Exact means and variances of populations, to test the growth against.

use super::{CellType, Clock, Control, Recipe, Use};

/// How many cells there are in the mean over all individuals, and how far they vary.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Expected {
    pub mean: f64,
    pub variance: f64,
}

/// The cells of a day of a growth that began with so many of each type, by `CellType`. Nothing where
/// no exact expectation is known here: with children of other types than their parents', with
/// clocks that are not Poisson, or under a control image that scales their days.
///
/// The recipe must be sound, and its `max_cells` not reached.
pub fn expected_cells(
    recipe: &Recipe,
    controls: &[Control],
    first_cells: [u32; 3],
    day: usize,
) -> Option<Expected> {
    let mutates = CellType::ALL.iter().any(|&t| recipe.mutation[t as usize][t as usize] != 1.0);
    let scales =
        controls.iter().any(|c| matches!(c.use_as, Use::Scale { number, .. } if number.is_days()));
    if mutates || scales || recipe.clock != Clock::Poisson {
        return None;
    }
    let mut all = Expected::default();
    for (first, division_days) in first_cells.into_iter().zip(recipe.division_days) {
        let clan = match day {
            0 => Expected { mean: 1.0, variance: 0.0 },
            _ => clans(division_days, day - 1)[day - 1],
        };
        all.mean += f64::from(first) * clan.mean;
        all.variance += f64::from(first) * clan.variance;
    }
    Some(all)
}

/// Bytes of a cell in the diary of each day, and of one that grows.
const BYTES_A_DAY: f64 = 12.0;
const BYTES_A_CELL: f64 = 200.0;

/// The memory that a growth needs at least for its cells, in bytes: as many as there are in the mean if all
/// divided as seldom as those that divide most seldom, up to `max_cells`, on all days. The body and what
/// is drawn of it come on top.
pub fn least_memory_bytes(recipe: &Recipe) -> f64 {
    let slowest_days = recipe.division_days.into_iter().fold(0.0, f64::max);
    let clans = match recipe.clock {
        Clock::Poisson => clans(slowest_days, recipe.days as usize),
        Clock::Exponential => Vec::new(),
    };
    let clan = |day: u32| match clans.get(day.saturating_sub(1) as usize) {
        _ if day == 0 => 1.0,
        Some(clan) => clan.mean,
        None => libm::exp(f64::from(day - 1) / slowest_days),
    };
    let cells = |day| (f64::from(recipe.initial_cells) * clan(day)).min(recipe.max_cells.into());
    let all_days: f64 = (0..=recipe.days).map(cells).sum();
    BYTES_A_DAY * all_days + BYTES_A_CELL * cells(recipe.days)
}

/// The clan of a cell of age 0, its descendants and itself, when the divisions up to each day `0..=days` are done, for Poisson
/// clocks of mean `division_days`, over ln 2, and no mutation. A run of `d` days ends with the clans
/// of day `d - 1`, one for each first cell and independent of each other.
///
/// With `q_k` the chance that the first division is on day k, and `m` and `s` the means of the
/// clan's size and of its square:
/// `m(t) = [1 - sum_{k<=t} q_k + 2 sum_{1<=k<=t} q_k m(t-k)] / (1 - 2 q_0)`, and, since mother and
/// child go on independently,
/// `s(t) = [1 - sum_{k<=t} q_k + 2 sum_{k<=t} q_k m(t-k)^2 + 2 sum_{1<=k<=t} q_k s(t-k)] / (1 - 2 q_0)`.
pub fn clans(division_days: f64, days: usize) -> Vec<Expected> {
    let mut q = vec![libm::exp(-division_days)];
    for k in 1..=days {
        q.push(q[k - 1] * division_days / k as f64);
    }
    let (mut means, mut squares): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for t in 0..=days {
        let waiting = 1.0 - q[..=t].iter().sum::<f64>();
        let divided: f64 = (1..=t).map(|k| q[k] * means[t - k]).sum();
        means.push((waiting + 2.0 * divided) / (1.0 - 2.0 * q[0]));
        let together: f64 = (0..=t).map(|k| q[k] * means[t - k] * means[t - k]).sum();
        let divided: f64 = (1..=t).map(|k| q[k] * squares[t - k]).sum();
        squares.push((waiting + 2.0 * together + 2.0 * divided) / (1.0 - 2.0 * q[0]));
    }
    let clan = |(&mean, &square): (&f64, &f64)| Expected { mean, variance: square - mean * mean };
    means.iter().zip(&squares).map(clan).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clans_of_the_first_day_are_as_large_as_binary_trees() {
        // Who divides at once leaves two who do so again: of n cells there are as many trees as the
        // Catalan number of n - 1 says, each of n - 1 divisions and n waits.
        let q = libm::exp(-2.0);
        let (mut chance, mut mean, mut square) = (1.0 - q, 0.0, 0.0);
        for n in (1..=200).map(f64::from) {
            mean += n * chance;
            square += n * n * chance;
            chance *= 2.0 * (2.0 * n - 1.0) / (n + 1.0) * q * (1.0 - q);
        }
        let [clan] = clans(2.0, 0)[..] else { panic!("one day") };
        assert!((clan.mean - mean).abs() < 1e-12, "{clan:?}");
        assert!((clan.variance - (square - mean * mean)).abs() < 1e-12, "{clan:?}");
    }

    #[test]
    fn the_least_memory_is_that_of_all_days_and_of_the_cells_of_the_last() {
        let recipe = Recipe {
            initial_cells: 1000,
            max_cells: 1500,
            division_days: [1.0, 2.0, 4.0],
            clock: Clock::Exponential,
            ..Recipe::default()
        };
        // The last are as many as the cap lets be.
        let (second, third) = (1000.0 * libm::exp(0.25), 1500.0);
        for (days, expected) in [
            (0, 12.0 * 1000.0 + 200.0 * 1000.0),
            (1, 12.0 * 2000.0 + 200.0 * 1000.0),
            (2, 12.0 * (2000.0 + second) + 200.0 * second),
            (3, 12.0 * (2000.0 + second + third) + 200.0 * third),
        ] {
            let found = least_memory_bytes(&Recipe { days, ..recipe.clone() });
            assert!((found - expected).abs() < 1e-6, "{days}: {found} and not {expected}");
        }
    }
}
