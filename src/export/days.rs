//! A growth in numbers, day by day.

use crate::mosaic::Pattern;
use crate::tissue::{CLAN_STEPS, DayCount, Expected};

/// A day in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct DayNumbers {
    pub day: u32,
    pub pattern: Pattern,
    /// Of the number of cells, where it is known.
    pub expected: Option<Expected>,
    /// Clans by the steps of their sizes (`tissue::clan_step`), and how many to expect where it is known.
    pub clans: [u32; CLAN_STEPS],
    pub expected_clans: Option<[f64; CLAN_STEPS]>,
}

impl DayNumbers {
    /// The columns of `to_csv`: cells of each type, shares of the area, patches of each type and the cells of their
    /// largest, the share of neighbours of unlike type, and the exact expectation of the number of cells with its
    /// standard deviation, empty where none is known.
    pub const HEADING: &str = "day,cells,F,B,M,area_F,area_B,area_M,patches_F,patches_B,patches_M,largest_F,\
                               largest_B,largest_M,mixed_edges,expected_cells,expected_sd";

    pub fn to_csv(&self) -> String {
        let Pattern { count, area_shares, patches, largest_patches, mixed_edges, .. } =
            &self.pattern;
        let mut columns = vec![self.day.to_string(), count.cells.to_string()];
        columns.extend(count.by_type.map(|x| x.to_string()));
        columns.extend(area_shares.map(|x| x.to_string()));
        columns.extend(patches.map(|x| x.to_string()));
        columns.extend(largest_patches.map(|x| x.to_string()));
        columns.push(mixed_edges.to_string());
        columns.extend(match self.expected {
            Some(Expected { mean, variance }) => [mean.to_string(), variance.sqrt().to_string()],
            None => [String::new(), String::new()],
        });
        columns.join(",")
    }

    /// All of it in a row of numbers, not a number where nothing is known to expect.
    pub fn to_row(&self) -> Vec<f64> {
        let Pattern { count, area_shares, patches, largest_patches, largest_areas, mixed_edges } =
            &self.pattern;
        let Expected { mean, variance } = self.expected.unwrap_or(UNKNOWN);
        let of = |numbers: &[u32]| numbers.iter().copied().map(f64::from).collect::<Vec<f64>>();
        [
            of(&[self.day, count.cells]),
            of(&count.by_type),
            area_shares.to_vec(),
            of(patches),
            of(largest_patches),
            largest_areas.to_vec(),
            vec![*mixed_edges, mean, variance],
            of(&self.clans),
            self.expected_clans.unwrap_or([f64::NAN; CLAN_STEPS]).to_vec(),
        ]
        .concat()
    }

    /// The day of a row; none where the row is too short.
    pub fn of_row(mut row: &[f64]) -> Option<DayNumbers> {
        let row = &mut row;
        let [day, cells] = whole(next(row)?);
        let by_type = whole(next(row)?);
        let area_shares = next(row)?;
        let [patches, largest_patches] = [whole(next(row)?), whole(next(row)?)];
        let largest_areas = next(row)?;
        let [mixed_edges, mean, variance] = next(row)?;
        let clans = whole(next(row)?);
        let expected_clans: [f64; CLAN_STEPS] = next(row)?;
        let count = DayCount { cells, by_type };
        Some(DayNumbers {
            day,
            pattern: Pattern {
                count,
                area_shares,
                patches,
                largest_patches,
                largest_areas,
                mixed_edges,
            },
            expected: (!mean.is_nan()).then_some(Expected { mean, variance }),
            clans,
            expected_clans: (!expected_clans[0].is_nan()).then_some(expected_clans),
        })
    }
}

const UNKNOWN: Expected = Expected { mean: f64::NAN, variance: f64::NAN };

/// The next numbers of a row.
fn next<const N: usize>(row: &mut &[f64]) -> Option<[f64; N]> {
    let (numbers, rest) = row.split_first_chunk()?;
    *row = rest;
    Some(*numbers)
}

fn whole<const N: usize>(numbers: [f64; N]) -> [u32; N] {
    numbers.map(|number| number as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_read_back() {
        let day = DayNumbers {
            day: 3,
            pattern: Pattern {
                count: DayCount { cells: 9, by_type: [5, 3, 1] },
                area_shares: [0.5, 0.25, 0.125],
                patches: [2, 1, 1],
                largest_patches: [4, 3, 1],
                largest_areas: [0.5, 0.25, 0.125],
                mixed_edges: 0.375,
            },
            expected: Some(Expected { mean: 8.5, variance: 2.25 }),
            clans: [1, 2, 3, 4, 5, 6, 7, 8],
            expected_clans: Some([0.5; CLAN_STEPS]),
        };
        let unknown = DayNumbers { expected: None, expected_clans: None, ..day.clone() };
        for day in [day, unknown] {
            let row = day.to_row();
            assert_eq!(DayNumbers::of_row(&row), Some(day));
            assert_eq!(DayNumbers::of_row(&row[1..]), None);
        }
    }
}
