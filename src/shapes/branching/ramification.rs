//! The ramification matrix: for a node of each order the chances of how it branches.

use crate::shapes::ShapeError;
use crate::shapes::read::read;

/// How far the chances of a row may miss the sum 1 and be scaled to it: as far as three that were
/// rounded to three digits after the point.
const ROUNDING: f64 = 0.001_5;

/// Under this chance of a fork a branch would have more than ten thousand side branches in the mean.
pub(super) const LEAST_FORK: f64 = 0.000_1;

/// Rows at most: trees of higher orders have more leaves than can be drawn.
pub(super) const MOST_ORDER: u32 = 12;

/// A stochastic lower triangle (Viennot et al. 1989). The row of order k has k chances: that a node of
/// order k sends off a side branch of order 1, 2, …, k-1 and goes on, and, the last, that it forks into
/// two of order k-1. The first row is that of order 2.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramification {
    rows: Vec<Vec<f64>>,
}

impl Ramification {
    /// Takes rows whose sums are 1 but for rounding, and scales each to exactly that.
    ///
    /// # Errors
    /// In plain words: no row or more than eleven, a row of another length, what is no chance, a sum that is not
    /// 1, or forks so rare that branches hardly end.
    pub fn new(mut rows: Vec<Vec<f64>>) -> Result<Ramification, ShapeError> {
        let most = MOST_ORDER as usize - 1;
        if rows.is_empty() || rows.len() > most {
            return fail(format!("the matrix has {} rows: it must have 1 to {most}", rows.len()));
        }
        for (order, row) in (2..).zip(&mut rows) {
            check_row(order, row)?;
            let sum: f64 = row.iter().sum();
            row.iter_mut().for_each(|chance| *chance /= sum);
        }
        Ok(Ramification { rows })
    }

    /// Reads a JSON list of rows, as `[[0.5, 0.5], [0.25, 0.25, 0.5]]`.
    ///
    /// # Errors
    /// What is no such list, and what `new` refuses.
    pub fn from_json(text: &str) -> Result<Ramification, ShapeError> {
        Ramification::new(read(text)?)
    }

    /// The highest order that has a row.
    pub fn most_order(&self) -> u32 {
        self.rows.len() as u32 + 1
    }

    /// The chances of a node of order 2 or higher.
    pub fn row(&self, order: u32) -> &[f64] {
        &self.rows[order as usize - 2]
    }

    /// The column, from 1 to the order itself, whose share of `0..1` holds `u`.
    pub(super) fn pick(&self, order: u32, u: f64) -> u32 {
        let mut up_to = 0.0;
        for (column, chance) in (1..order).zip(self.row(order)) {
            up_to += chance;
            if u < up_to {
                return column;
            }
        }
        order
    }
}

fn check_row(order: usize, row: &[f64]) -> Result<(), ShapeError> {
    if row.len() != order {
        return fail(format!(
            "the matrix' row of order {order} has {} numbers: it must have {order}, one for a side \
             branch of each lower order and the last for a fork",
            row.len()
        ));
    }
    if let Some(wrong) = row.iter().find(|chance| !(0.0..=1.0).contains(*chance)) {
        return fail(format!(
            "the matrix' row of order {order} has the chance {wrong}: each must be from 0 to 1"
        ));
    }
    let sum: f64 = row.iter().sum();
    if (sum - 1.0).abs() > ROUNDING {
        return fail(format!(
            "the matrix' row of order {order} sums to {}: its chances must sum to 1",
            // Sums of decimals end in digits that nobody wrote.
            (sum * 1e6).round() / 1e6
        ));
    }
    let fork = row[order - 1];
    if fork < LEAST_FORK {
        return fail(format!(
            "the matrix' row of order {order} ends with the chance of a fork {fork}: it must be from \
             {LEAST_FORK} to 1, or branches would never end"
        ));
    }
    Ok(())
}

fn fail<T>(what: String) -> Result<T, ShapeError> {
    Err(ShapeError(what))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_stochastic_is_refused_in_words() {
        for (rows, words) in [
            ("[]", "0 rows"),
            ("[[1]]", "order 2 has 1 numbers: it must have 2"),
            ("[[0.5, 0.5], [1, 0.0]]", "order 3 has 2 numbers"),
            ("[[1.5, -0.5]]", "the chance 1.5"),
            ("[[0.5, 0.4]]", "order 2 sums to 0.9"),
            ("[[0.1, 0.9], [0.3, 0.7, 0]]", "order 3 ends with the chance of a fork 0"),
            ("{\"rows\": 3}", "it must be a list of numbers"),
            ("[[0.5, \"x\"]]", "0.1 is \"x\": it must be a number"),
            ("[[0.5", "it is no JSON"),
        ] {
            let wrong = Ramification::from_json(rows).unwrap_err().to_string();
            assert!(wrong.contains(words) && wrong.lines().count() == 1, "{rows}: {wrong}");
        }
        let long = vec![vec![]; 12];
        assert!(Ramification::new(long).unwrap_err().to_string().contains("12 rows"));
    }

    #[test]
    fn rounded_chances_are_scaled_to_one() {
        let matrix = Ramification::from_json("\u{feff}[[0, 1], [0.333, 0.333, 0.333]]").unwrap();
        assert_eq!(matrix.most_order(), 3);
        assert!(matrix.row(3).iter().all(|chance| (chance - 1.0 / 3.0).abs() < 1e-15));
    }

    #[test]
    fn columns_hold_their_shares() {
        let matrix = Ramification::from_json("[[0.25, 0.75], [0.5, 0, 0.5]]").unwrap();
        assert_eq!([0.0, 0.2499, 0.25, 0.9999].map(|u| matrix.pick(2, u)), [1, 1, 2, 2]);
        assert_eq!([0.0, 0.4999, 0.5, 0.9999].map(|u| matrix.pick(3, u)), [1, 1, 3, 3]);
    }
}
