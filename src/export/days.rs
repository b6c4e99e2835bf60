//! A growth in numbers, day by day.

use crate::mosaic::Pattern;
use crate::tissue::{CLAN_STEPS, Expected};
use serde::{Deserialize, Serialize};

/// A day in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
        let Pattern { count, area_shares, patches, largest_patches, mixed_edges } = &self.pattern;
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
}
