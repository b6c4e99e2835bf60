//! Matrices with a name.

use super::Ramification;
use super::ramification::{LEAST_FORK, MOST_ORDER};
use crate::shapes::ShapeError;
use crate::surface::quoted;

/// The names that `Ramification::named` knows.
pub const NAMES: &str = "perfect, uniform, increasing, fern, river and tokunaga:A,C";

/// Random increasing trees (binary search trees), rows of orders 2 to 5 without the fork, which is what is
/// left: the means of eight drawn trees of 60,000 nodes.
const INCREASING: [&[f64]; 4] =
    [&[0.442], &[0.229, 0.348], &[0.094, 0.214, 0.313], &[0.035, 0.093, 0.209, 0.298]];

/// Of all nodes of a fern as many send off a leaflet and go on.
const LEAFLETS: f64 = 0.8;

/// Side branches of the next lower order on a river, and how many times as many of each order below. Rivers
/// have 3 to 5 times as many branches of each order as of the next (Horton's law); this matrix 4.485.
const RIVER: [f64; 2] = [1.1, 2.5];

impl Ramification {
    /// A matrix by its name, with rows up to order 12, or as far as forks are not too rare:
    ///
    /// - `perfect`: every node forks, all leaves are equally far from the root;
    /// - `uniform`: all binary trees with as many leaves are equally likely, rows ½, ¼, …, 2^-(k-1), 2^-(k-1)
    ///   (conjectured by Viennot et al. 1989, proved by Penaud, Discrete Applied Mathematics 31, 1991);
    /// - `increasing`: a random leaf forks, again and again; straighter and less hairy;
    /// - `fern`: side branches of order 1 alone;
    /// - `tokunaga:A,C`: on a branch are A side branches of the next lower order, A·C of the one below, and so
    ///   on, C times as many each time; A from 0 to 100, C from 0 to 20;
    /// - `river`: `tokunaga:1.1,2.5`.
    ///
    /// # Errors
    /// Other names and other numbers.
    pub fn named(name: &str) -> Result<Ramification, ShapeError> {
        let row: &dyn Fn(u32) -> Vec<f64> = match name {
            "perfect" => &|order| with_fork(vec![0.0; order as usize - 1]),
            "uniform" => &|order| with_fork((1..order).map(halved).collect()),
            "increasing" => &increasing,
            "fern" => &|order| {
                with_fork((1..order).map(|i| if i == 1 { LEAFLETS } else { 0.0 }).collect())
            },
            "river" => &|order| tokunaga(order, RIVER),
            _ => {
                let Some(numbers) = name.strip_prefix("tokunaga:") else {
                    return Err(ShapeError(format!(
                        "there is no matrix {}: there are {NAMES}",
                        quoted(name)
                    )));
                };
                return of_tokunaga(name, numbers);
            }
        };
        rows(row)
    }
}

fn of_tokunaga(name: &str, numbers: &str) -> Result<Ramification, ShapeError> {
    let numbers = numbers.split_once(',').map(|(a, c)| (a.trim().parse(), c.trim().parse()));
    match numbers {
        Some((Ok(a), Ok(c))) if (0.0..=100.0).contains(&a) && (0.0..=20.0).contains(&c) => {
            rows(&|order| tokunaga(order, [a, c]))
        }
        _ => Err(ShapeError(format!(
            "the matrix {} must have two numbers, as tokunaga:1,2, the first from 0 to 100 and the \
             second from 0 to 20",
            quoted(name)
        ))),
    }
}

/// As many rows as have forks often enough.
fn rows(row: &dyn Fn(u32) -> Vec<f64>) -> Result<Ramification, ShapeError> {
    let ends = |row: &Vec<f64>| row.last().is_some_and(|&fork| fork >= LEAST_FORK);
    Ramification::new((2..=MOST_ORDER).map(row).take_while(ends).collect())
}

fn halved(order: u32) -> f64 {
    1.0 / f64::from(1u32 << order)
}

/// Rows above those that were measured look like the last one seen from the fork.
fn increasing(order: u32) -> Vec<f64> {
    let known = INCREASING[(order as usize - 2).min(3)];
    let mut row = vec![0.0; order as usize - 1 - known.len()];
    row.extend(known);
    with_fork(row)
}

/// A branch that ends in a fork has in the mean `T(k, i) = a c^(k-i-1)` side branches of order i, so that the
/// chance of one is `T(k, i)` times that of the fork.
fn tokunaga(order: u32, [a, c]: [f64; 2]) -> Vec<f64> {
    let mut branches = vec![0.0; order as usize - 1];
    let mut of_this_order = a;
    for number in branches.iter_mut().rev() {
        *number = of_this_order;
        of_this_order *= c;
    }
    let sum = 1.0 + branches.iter().sum::<f64>();
    with_fork(branches.into_iter().map(|number| number / sum).collect())
}

/// The fork has the chance that is left.
fn with_fork(mut row: Vec<f64>) -> Vec<f64> {
    row.push(1.0 - row.iter().sum::<f64>());
    row
}
