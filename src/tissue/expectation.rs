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

/// The cells of each type, and all cells, of a day over all individuals of a recipe: their first cells are of the
/// types that chance gives them. Nothing where `expected_cells` knows nothing, or where a control image decides
/// what first cells are.
///
/// A first cell is of type t with chance p, and its clan then has the mean m and the variance v: so one first cell
/// comes to `sum p m` cells in the mean, with the variance `sum p (v + m^2) - (sum p m)^2`, and first cells are
/// independent of each other.
pub fn expected_individuals(
    recipe: &Recipe,
    controls: &[Control],
    day: usize,
) -> Option<([Expected; 3], Expected)> {
    if controls.iter().any(|control| matches!(control.use_as, Use::FirstCells { .. })) {
        return None;
    }
    let of_one = |types: &[CellType]| {
        let [mut mean, mut square] = [0.0; 2];
        for &kind in types {
            let mut first_cells = [0; 3];
            first_cells[kind as usize] = 1;
            let clan = expected_cells(recipe, controls, first_cells, day)?;
            let chance = recipe.initial_probability[kind as usize];
            mean += chance * clan.mean;
            square += chance * (clan.variance + clan.mean * clan.mean);
        }
        let first_cells = f64::from(recipe.initial_cells);
        let variance = first_cells * (square - mean * mean);
        Some(Expected { mean: first_cells * mean, variance })
    };
    let mut of_types = [Expected::default(); 3];
    for kind in CellType::ALL {
        of_types[kind as usize] = of_one(&[kind])?;
    }
    Some((of_types, of_one(&CellType::ALL)?))
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

/// Sizes of clans in steps of twice as many cells: 1, 2, 3 to 4, 5 to 8, 9 to 16, 17 to 32, 33 to 64, and more.
pub const CLAN_STEPS: usize = 8;

/// The step of a clan of so many cells, one at least.
pub fn clan_step(cells: u32) -> usize {
    (cells.next_power_of_two().trailing_zeros() as usize).min(CLAN_STEPS - 1)
}

/// The chance of each step of sizes for the clan of a cell of age 0 on a day of its life, exactly; its cells may
/// mutate, as long as all types divide alike.
///
/// With an exponential clock sizes are geometric: `P(n) = x (1 - x)^(n-1)` with `x = e^(-days / division_days)`.
/// With a Poisson clock, where `q_k` is the chance that the first division is on day k and day 0 is the
/// first, `P_t(1) = 1 - sum_{k<=t} q_k` and `P_t(n) = sum_{k<=t} q_k sum_i P_{t-k}(i) P_{t-k}(n-i)`.
pub fn clan_sizes(clock: Clock, division_days: f64, days: u32) -> [f64; CLAN_STEPS] {
    const MOST: usize = 1 << (CLAN_STEPS - 2);
    let by_size = match clock {
        _ if days == 0 => vec![0.0, 1.0],
        Clock::Exponential => {
            let x = libm::exp(-f64::from(days) / division_days);
            let mut chance = x;
            let mut by_size = vec![0.0];
            for _ in 1..=MOST {
                by_size.push(chance);
                chance *= 1.0 - x;
            }
            by_size
        }
        Clock::Poisson => poisson_clan_sizes(division_days, days as usize - 1, MOST),
    };
    let mut steps = [0.0; CLAN_STEPS];
    for (cells, chance) in (0..).zip(&by_size).skip(1) {
        steps[clan_step(cells)] += chance;
    }
    steps[CLAN_STEPS - 1] = (1.0 - steps.iter().sum::<f64>()).max(0.0);
    steps
}

/// The chances of the sizes `0..=most` when the divisions up to day `t` are done.
fn poisson_clan_sizes(division_days: f64, t: usize, most: usize) -> Vec<f64> {
    let mut q = vec![libm::exp(-division_days)];
    for k in 1..=t {
        q.push(q[k - 1] * division_days / k as f64);
    }
    // Two clans of a day together.
    let mut pairs: Vec<Vec<f64>> = Vec::new();
    let mut sizes = Vec::new();
    for t in 0..=t {
        sizes = vec![0.0; most + 1];
        sizes[1] = 1.0 - q[..=t].iter().sum::<f64>();
        let mut pair = vec![0.0; most + 1];
        for n in 2..=most {
            pair[n] = (1..n).map(|i| sizes[i] * sizes[n - i]).sum();
            let later: f64 = (1..=t).map(|k| q[k] * pairs[t - k][n]).sum();
            sizes[n] = q[0] * pair[n] + later;
        }
        pairs.push(pair);
    }
    sizes
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
    fn individuals_vary_by_their_first_cells_and_by_their_clans() {
        let recipe =
            Recipe { initial_cells: 1000, initial_probability: [0.3, 0.7, 0.0], ..Recipe::DEFAULT };
        // On day 0 there are none but first cells: a binomial law.
        let (of_types, all) = expected_individuals(&recipe, &[], 0).unwrap();
        assert!((of_types[0].mean - 300.0).abs() < 1e-9);
        assert!((of_types[0].variance - 210.0).abs() < 1e-9);
        assert!((all.mean - 1000.0).abs() < 1e-9 && all.variance.abs() < 1e-9);
        // Where all first cells are of one type, only their clans vary.
        let alike = Recipe { initial_probability: [1.0, 0.0, 0.0], ..recipe.clone() };
        let (of_types, _) = expected_individuals(&alike, &[], 9).unwrap();
        let clans = expected_cells(&alike, &[], [1000, 0, 0], 9).unwrap();
        assert!((of_types[0].mean - clans.mean).abs() < 1e-9 * clans.mean);
        assert!((of_types[0].variance - clans.variance).abs() < 1e-9 * clans.variance);
        // And with children of other types nothing is known here.
        let mutation = [[0.9, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(expected_individuals(&Recipe { mutation, ..recipe }, &[], 9), None);
    }

    #[test]
    fn chances_of_sizes_have_the_mean_of_clans_and_are_one_together() {
        for (division_days, days) in [(10.0, 1), (10.0, 12), (4.0, 9), (2.0, 5)] {
            let sizes = poisson_clan_sizes(division_days, days, 4096);
            let expected = clans(division_days, days)[days];
            let sum = |f: &dyn Fn(f64) -> f64| {
                sizes.iter().enumerate().map(|(n, p)| f(n as f64) * p).sum::<f64>()
            };
            assert!((sum(&|_| 1.0) - 1.0).abs() < 1e-9);
            assert!((sum(&|n| n) - expected.mean).abs() < 1e-6 * expected.mean);
            let variance = sum(&|n| n * n) - expected.mean * expected.mean;
            assert!((variance - expected.variance).abs() < 1e-4 * expected.variance.max(1e-3));
        }
    }

    #[test]
    fn steps_of_sizes_are_powers_of_two() {
        let steps = [1, 2, 3, 4, 5, 8, 9, 64, 65, 1_000_000].map(clan_step);
        assert_eq!(steps, [0, 1, 2, 2, 3, 3, 4, 6, 7, 7]);
        // Half of all have not divided after one half-life.
        let sizes = clan_sizes(Clock::Exponential, 1.0 / std::f64::consts::LN_2, 1);
        assert!((sizes[0] - 0.5).abs() < 1e-12 && (sizes[1] - 0.25).abs() < 1e-12);
        assert!((sizes.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert_eq!(clan_sizes(Clock::Poisson, 5.0, 0)[0], 1.0);
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
